#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pan_tilt_camera_actuator.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// to either side
constexpr CDegrees kUtmostPan(180.0);
constexpr CDegrees kUtmostTilt(90.0);

// numbers of the quantities that <noise> may be on
enum EQuantity : size_t { QUANTITY_PAN, QUANTITY_TILT };

/** Turns the view of a robot's perspective camera; see its long description. */
class CPanTiltCameraDefaultActuator : public CSimulatedActuator, public CCI_PanTiltCameraActuator {
 public:
  /** @throws CARGoSException unless the robot has a "perspective_camera". */
  void SetRobot(CComposableEntity& robot) override;
  /**
   * Reads `pan_range`, `tilt_range`, `max_speed` and `<noise>`.
   * @throws CARGoSException if a value is out of range.
   */
  void Init(TConfigurationNode& tree) override;
  /** Angles beyond the limits are cut to them. @throws CARGoSException if they are not finite. */
  void SetPan(const CRadians& pan) override;
  void SetTilt(const CRadians& tilt) override;
  void Update() override;
  /** Looks straight out of the mount, at once. */
  void Reset() override;

 private:
  // one of the two axes
  struct SAxis {
    const char* Name;
    CRange<CRadians> Limits;
    CRadians Target;
  };

  static void ReadLimits(TConfigurationNode& tree, const std::string& attribute,
                         const CDegrees& utmost, SAxis& axis);
  void SetTarget(size_t quantity, SAxis& axis, const CRadians& angle);
  CRadians Approach(const CRadians& current, const CRadians& target) const;

  CPerspectiveCameraEquippedEntity* m_camera = nullptr;  // of the robot
  CControllableEntity* m_robot = nullptr;
  SAxis m_pan = {"pan", {}, CRadians()};
  SAxis m_tilt = {"tilt", {}, CRadians()};
  CRadians m_maxStep;  // in one tick; 0: at once
  CDeviceNoise m_noise;
};

}  // namespace

void CPanTiltCameraDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_camera = &robot.GetComponent<CPerspectiveCameraEquippedEntity>("perspective_camera");
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
}

void CPanTiltCameraDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_PanTiltCameraActuator::Init(tree);
  ReadLimits(tree, "pan_range", kUtmostPan, m_pan);
  ReadLimits(tree, "tilt_range", kUtmostTilt, m_tilt);
  if (NodeAttributeExists(tree, "max_speed")) {
    Real degreesPerS = 0.0;
    ReadPositive(tree, "max_speed", "degrees/s", degreesPerS);
    m_maxStep = ToRadians(CDegrees(degreesPerS * m_robot->GetSimulator().GetTickLength()));
  }
  m_noise.Init(tree, *m_robot, {"pan", "tilt"});
}

void CPanTiltCameraDefaultActuator::ReadLimits(TConfigurationNode& tree,
                                               const std::string& attribute, const CDegrees& utmost,
                                               SAxis& axis) {
  CRange<CDegrees> limits(-utmost, utmost);
  GetNodeAttributeOrDefault(tree, attribute, limits, limits);
  if (limits.GetMin() < -utmost || limits.GetMax() > utmost || limits.GetMin() > CDegrees(0.0) ||
      limits.GetMax() < CDegrees(0.0)) {
    THROW_ARGOSEXCEPTION(
        OwnerOf(tree) << ": attribute \"" << attribute << "\" (degrees) must be a range within "
                      << -utmost.GetValue() << ":" << utmost.GetValue() << " that has 0 in it, got "
                      << limits.GetMin().GetValue() << ":" << limits.GetMax().GetValue());
  }
  axis.Limits = CRange<CRadians>(ToRadians(limits.GetMin()), ToRadians(limits.GetMax()));
}

void CPanTiltCameraDefaultActuator::SetPan(const CRadians& pan) {
  SetTarget(QUANTITY_PAN, m_pan, pan);
}

void CPanTiltCameraDefaultActuator::SetTilt(const CRadians& tilt) {
  SetTarget(QUANTITY_TILT, m_tilt, tilt);
}

void CPanTiltCameraDefaultActuator::SetTarget(size_t quantity, SAxis& axis, const CRadians& angle) {
  if (!std::isfinite(angle.GetValue())) {
    THROW_ARGOSEXCEPTION("pan_tilt_camera: " << axis.Name << " must be finite, got "
                                             << angle.GetValue());
  }
  axis.Target = CRadians(m_noise.Apply(quantity, angle.GetValue()));
  axis.Limits.TruncValue(axis.Target);
}

void CPanTiltCameraDefaultActuator::Update() {
  if (m_camera->GetPan() != m_pan.Target || m_camera->GetTilt() != m_tilt.Target) {
    m_camera->SetPanTilt(Approach(m_camera->GetPan(), m_pan.Target),
                         Approach(m_camera->GetTilt(), m_tilt.Target));
  }
}

CRadians CPanTiltCameraDefaultActuator::Approach(const CRadians& current,
                                                 const CRadians& target) const {
  const CRadians way = target - current;
  if (m_maxStep == CRadians() || Abs(way) <= m_maxStep) {
    return target;
  }
  return current + (way > CRadians() ? m_maxStep : -m_maxStep);
}

void CPanTiltCameraDefaultActuator::Reset() {
  m_pan.Target = CRadians();
  m_tilt.Target = CRadians();
  m_camera->SetPanTilt(CRadians(), CRadians());
  m_noise.Reset();
}

REGISTER_ACTUATOR(
    CPanTiltCameraDefaultActuator, "pan_tilt_camera", "default", "the authors of this project",
    "1.0", "Turns the perspective camera of a robot.",
    R"(The controller sets two angles, in rad: pan turns the view of the camera sideways, about the z axis of
its mount (positive to the left); tilt turns it about its y axis (positive is down). For a foot-bot's camera that looks
ahead, a pan of PI/2 looks to the left, and a tilt of PI/2 at the ground. The camera stays where it is. Both angles are
0 at the start and after a reset. Angles beyond the limits are cut to them.

An angle set in one step is taken at once in the next tick, or, with max_speed, at most so fast, both axes on their own.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators>
        <pan_tilt_camera implementation="default" />
      </actuators>
      <sensors>
        <colored_blob_perspective_camera implementation="default" medium="leds" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

  <pan_tilt_camera implementation="default" pan_range="-90:90" tilt_range="-30:45" max_speed="60">
    <noise on="pan" model="gaussian" std_dev="0.01" />
  </pan_tilt_camera>

  pan_range   "min:max", degrees within -180:180, with 0 in it; default "-180:180".
  tilt_range  "min:max", degrees within -90:90, with 0 in it; default "-90:90".
  max_speed   degrees/s, > 0; without it, angles are taken at once.
  noise       any number of children, on "pan" or "tilt" (rad), or without "on" on both; drawn each time an angle is
              set: model "uniform" (level), "gaussian" (std_dev) or "rayleigh" (sigma), with bias and relative="true" if
              need be.
)",
    "Usable")

}  // namespace argos
