#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_altitude_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>

namespace argos {

namespace {

/**
 * How high a robot is: a range finder that looks straight down from the centre of its base, at the
 * highest body below, or the ground at height 0.
 */
class CAltitudeDefaultSensor : public CSimulatedSensor, public CCI_AltitudeSensor {
 public:
  /** @throws CARGoSException if the robot has no "body" or "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `show_rays` and `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

 private:
  CRayCaster m_caster;
  bool m_showRays = false;
  CDeviceNoise m_noise;
};

}  // namespace

void CAltitudeDefaultSensor::SetRobot(CComposableEntity& robot) {
  m_caster.SetRobot(robot);
}

void CAltitudeDefaultSensor::Init(TConfigurationNode& tree) {
  CCI_AltitudeSensor::Init(tree);
  GetNodeAttributeOrDefault(tree, "show_rays", m_showRays, false);
  m_noise.Init(tree, m_caster.GetRobot(), {"height"});
  Enable();
}

void CAltitudeDefaultSensor::Update() {
  const CVector3& origin = m_caster.GetBody().GetOriginAnchor().Position;
  const CRay3 ray(origin, CVector3(origin.GetX(), origin.GetY(), 0.0));
  Real height = origin.GetZ();
  Real fraction = 1.0;
  if (height > 0.0 && m_caster.FindHit(ray, fraction)) {
    height *= fraction;
  }
  if (m_showRays) {
    m_caster.GetRobot().AddCheckedRay(fraction < 1.0, ray);
  }
  m_fReading = m_noise.Apply(0, height);
}

void CAltitudeDefaultSensor::Reset() {
  m_fReading = 0.0;
  m_noise.Reset();
}

REGISTER_SENSOR(
    CAltitudeDefaultSensor, "altitude", "default", "the authors of this project", "1.0",
    "How high a robot is above what lies below it.",
    R"(A range finder that looks straight down from the centre of the robot's base: it reads the height (m) of that
point above the highest body below it, or above the ground, which is the plane z = 0. The robot's own body does not count.
Below the ground it reads how deep, as a negative number. It looks along a line, and sees nothing beside it.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <altitude implementation="default" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

  <altitude implementation="default" show_rays="true" />

  show_rays  "true" or "false", default "false": visualizations that can show the line.

Children <noise on="height" model="uniform|gaussian|rayleigh" level|std_dev|sigma="..." bias="0" relative="false" />
add noise to the height (m).
)",
    "Usable")

}  // namespace argos
