#include <argos3/plugins/robots/pi-puck/simulator/pipuck_rangefinders_default_sensor.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_entity.h>

#include <memory>

namespace argos {

namespace {

SRayLayout MakeLayout(
    const std::map<UInt8, CCI_PiPuckRangefindersSensor::TConfiguration>& configuration) {
  SRayLayout layout;
  for (const auto& [label, sensor] : configuration) {
    CVector3 direction = CVector3::Z;
    direction.Rotate(std::get<2>(sensor));
    // horizontal, without what rounding left of z
    direction.SetZ(0.0);
    layout.AddSensor(std::get<1>(sensor), direction, std::get<3>(sensor));
  }
  return layout;
}

}  // namespace

void CPiPuckRangefindersDefaultSensor::SetRobot(CComposableEntity& robot) {
  // throws unless the robot is a Pi-Puck
  robot.GetComponent<CPiPuckDifferentialDriveEntity>("differential_drive");
  m_caster.SetRobot(robot);
  m_anchor = &m_caster.GetBody().GetOriginAnchor();
}

void CPiPuckRangefindersDefaultSensor::Update() {
  static const SRayLayout layout = MakeLayout(MAP_SENSOR_CONFIG);
  const SRayBundle bundle{
      layout.Rays.data(), layout.Blocks.data(), layout.Rays.size(), layout, &m_anchor, *m_anchor};
  Real fractions[CRayCaster::kMaxRays];
  m_caster.Cast(bundle, fractions);
  for (size_t i = 0; i < m_interfaces.size(); ++i) {
    m_interfaces[i].Proximity = (fractions[i] <= 1.0 ? fractions[i] : 1.0) * layout.Lengths[i];
  }
  if (m_bShowRays) {
    m_caster.Show(bundle, fractions);
  }
}

void CPiPuckRangefindersDefaultSensor::Reset() {
  for (SInterface& interface : m_interfaces) {
    interface.Proximity = std::get<3>(interface.Configuration);
  }
}

REGISTER_SENSOR(
    CPiPuckRangefindersDefaultSensor, "pipuck_rangefinders", "default",
    "the authors of this project", "1.0", "The range sensors of the Pi-Puck.",
    R"(Eight sensors around the robot read the distance to the nearest other body, in m: 0.1 if there is none within 0.1 m. From
the right of the front clockwise, their directions are -12.6, -46.9, -90, -140.9, 140.9, 90, 46.9 and 12.6 degrees from
ahead, counter-clockwise. The illuminance is always 0.
)" + RequiredSensorXML(R"(<pipuck_rangefinders implementation="default" />)") +
        OptionalXML(R"(<pipuck_rangefinders implementation="default" show_rays="true" />)") + R"(
  show_rays  "true" or "false", default "false": visualizations show the rays.
)",
    "Usable")

}  // namespace argos
