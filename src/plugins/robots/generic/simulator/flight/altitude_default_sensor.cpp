#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_altitude_sensor.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>

namespace argos {

namespace {

/**
 * A range finder that looks straight down from the centre of a robot's base: measures the height
 * above the highest body below, or above the ground at height 0.
 */
class CAltitudeDefaultSensor : public CSimulatedSensor, public CCI_AltitudeSensor {
 public:
  /** @throws CARGoSException if the robot has no "body" or "controller". */
  void SetRobot(CComposableEntity& robot) override { m_caster.SetRobot(robot); }
  /** Reads `show_rays` and `<noise>`. */
  void Init(TConfigurationNode& tree) override {
    CCI_AltitudeSensor::Init(tree);
    GetNodeAttributeOrDefault(tree, "show_rays", m_showRays, false);
    m_noise.Init(tree, m_caster.GetRobot(), {"height"});
    Enable();
  }
  void Update() override {
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
  void Reset() override {
    m_fReading = 0.0;
    m_noise.Reset();
  }

 private:
  CRayCaster m_caster;
  bool m_showRays = false;
  CDeviceNoise m_noise;
};

}  // namespace

REGISTER_SENSOR(
    CAltitudeDefaultSensor, "altitude", "default", "the authors of this project", "1.0",
    "The height of a robot above the ground or the body below it.",
    R"(A range finder that looks straight down from the centre of the robot's base: it reads the height (m) of that
point above the highest body below it, or above the ground, which is the plane z = 0. It ignores the robot's own body.
Below the ground the height is negative. The sensor casts a single ray: it does not detect bodies beside that ray.
)" + RequiredSensorXML(R"(<altitude implementation="default" />)") +
        OptionalXML(R"(<altitude implementation="default" show_rays="true" />)") + R"(
  show_rays  "true" or "false", default "false": visualizations show the ray.
)" + NoiseManual("height", "the height (m)."),
    "Usable")

}  // namespace argos
