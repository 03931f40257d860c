#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pan_tilt_camera_actuator.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// greatest angles to either side
constexpr CDegrees kMaxPan(180.0);
constexpr CDegrees kMaxTilt(90.0);

// numbers of the quantities that <noise> may be on
enum : size_t { QUANTITY_PAN, QUANTITY_TILT };

/** Rotates the view of a robot's perspective camera; see the manual below. */
class CPanTiltCameraDefaultActuator : public CSimulatedActuator, public CCI_PanTiltCameraActuator {
 public:
  /** @throws CARGoSException if the robot has no "perspective_camera". */
  void SetRobot(CComposableEntity& robot) override;
  /**
   * Reads `pan_range`, `tilt_range`, `max_speed` and `<noise>`.
   * @throws CARGoSException if a value is out of range.
   */
  void Init(TConfigurationNode& tree) override;
  /** Angles beyond the limits are clamped. @throws CARGoSException if they are not finite. */
  void SetPan(const CRadians& pan) override;
  void SetTilt(const CRadians& tilt) override;
  void Update() override;
  /** Both angles are 0. */
  void Reset() override;

 private:
  // one of the two axes
  struct SAxis {
    const char* Name;
    CRange<CRadians> Limits;
    CRadians Target;
  };

  static void ReadLimits(TConfigurationNode& tree, const std::string& attribute,
                         const CDegrees& maximum, SAxis& axis);
  void SetTarget(size_t quantity, SAxis& axis, const CRadians& angle);
  CRadians Approach(const CRadians& current, const CRadians& target) const;

  CPerspectiveCameraEquippedEntity* m_camera = nullptr;
  CControllableEntity* m_robot = nullptr;
  SAxis m_pan = {"pan", {}, CRadians()};
  SAxis m_tilt = {"tilt", {}, CRadians()};
  CRadians m_maxStep;  // greatest turn in one tick; 0: unlimited
  CDeviceNoise m_noise;
};

}  // namespace

void CPanTiltCameraDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_camera = &robot.GetComponent<CPerspectiveCameraEquippedEntity>("perspective_camera");
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
}

void CPanTiltCameraDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_PanTiltCameraActuator::Init(tree);
  ReadLimits(tree, "pan_range", kMaxPan, m_pan);
  ReadLimits(tree, "tilt_range", kMaxTilt, m_tilt);
  if (NodeAttributeExists(tree, "max_speed")) {
    Real degreesPerS = 0.0;
    ReadPositive(tree, "max_speed", "degrees/s", degreesPerS);
    m_maxStep = ToRadians(CDegrees(degreesPerS * m_robot->GetSimulator().GetTickLength()));
  }
  m_noise.Init(tree, *m_robot, {"pan", "tilt"});
}

void CPanTiltCameraDefaultActuator::ReadLimits(TConfigurationNode& tree,
                                               const std::string& attribute,
                                               const CDegrees& maximum, SAxis& axis) {
  CRange<CDegrees> limits(-maximum, maximum);
  GetNodeAttributeOrDefault(tree, attribute, limits, limits);
  if (limits.GetMin() < -maximum || limits.GetMax() > maximum || limits.GetMin() > CDegrees(0.0) ||
      limits.GetMax() < CDegrees(0.0)) {
    THROW_ARGOSEXCEPTION(OwnerOf(tree)
                         << ": attribute \"" << attribute << "\" (degrees) must be a range within "
                         << -maximum.GetValue() << ":" << maximum.GetValue()
                         << " that contains 0, got " << limits.GetMin().GetValue() << ":"
                         << limits.GetMax().GetValue());
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
    "1.0", "Rotates the perspective camera of a robot.",
    R"(The controller sets two angles, in rad: pan rotates the view of the camera sideways, about the z axis of
its mount (positive to the left); tilt rotates it about its y axis (positive is down). A foot-bot's camera that looks
ahead looks to the left with a pan of PI/2, and at the ground with a tilt of PI/2. The position of the camera does not
change. Both angles are 0 at the start and after a reset. Angles beyond the limits are clamped.

The camera has the new angle in the next tick; with max_speed, each of the two angles changes at that speed at most.
)" +
        RequiredActuatorXML(
            R"(<pan_tilt_camera implementation="default" />)",
            R"(<colored_blob_perspective_camera implementation="default" medium="leds" />)") +
        OptionalXML(
            R"(<pan_tilt_camera implementation="default" pan_range="-90:90" tilt_range="-30:45" max_speed="60">
    <noise on="pan" model="gaussian" std_dev="0.01" />
  </pan_tilt_camera>)") +
        R"(
  pan_range   "min:max", degrees within -180:180, must contain 0; default "-180:180".
  tilt_range  "min:max", degrees within -90:90, must contain 0; default "-90:90".
  max_speed   degrees/s, > 0; without it, angles change at once.
)" + NoiseManual("pan|tilt", "the angles (rad), once each time the controller sets one."),
    "Usable")

}  // namespace argos
