#include <argos3/plugins/robots/pi-puck/simulator/pipuck_ground_default_sensor.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/floor_reader.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_entity.h>

namespace argos {

void CPiPuckGroundDefaultSensor::SetRobot(CComposableEntity& robot) {
  // throws unless the robot is a Pi-Puck
  robot.GetComponent<CPiPuckDifferentialDriveEntity>("differential_drive");
  m_anchor = &robot.GetComponent<CEmbodiedEntity>("body").GetOriginAnchor();
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
}

void CPiPuckGroundDefaultSensor::Init(TConfigurationNode& tree) {
  CPiPuckSimulatedSensor::Init(tree);
  RequireFloor(*m_robot, tree);
}

void CPiPuckGroundDefaultSensor::Update() {
  constexpr Real kWhite = 255.0;  // CColor::ToGrayScale() of white
  CFloorEntity& floor = m_robot->GetSpace().GetFloorEntity();
  for (SInterface& interface : m_interfaces) {
    CVector3 start = std::get<1>(interface.Configuration);
    CVector3 ray = CVector3::Z * std::get<3>(interface.Configuration);
    ray.Rotate(m_anchor->Orientation * std::get<2>(interface.Configuration));
    start.Rotate(m_anchor->Orientation) += m_anchor->Position;
    const CVector3 end = start + ray;
    // the floor is the plane z = 0
    const bool isHit = start.GetZ() >= 0.0 && end.GetZ() <= 0.0 && start.GetZ() > end.GetZ();
    interface.Reflected = 1.0;
    if (isHit) {
      const CVector3 hit = start + ray * (start.GetZ() / (start.GetZ() - end.GetZ()));
      interface.Reflected = floor.GetColorAtPoint(hit.GetX(), hit.GetY()).ToGrayScale() / kWhite;
    }
    if (m_bShowRays) {
      m_robot->AddCheckedRay(isHit, CRay3(start, end));
    }
  }
}

void CPiPuckGroundDefaultSensor::Reset() {
  for (SInterface& interface : m_interfaces) {
    interface.Reflected = 0.0;
  }
}

REGISTER_SENSOR(
    CPiPuckGroundDefaultSensor, "pipuck_ground", "default", "the authors of this project", "1.0",
    "The ground sensors of the Pi-Puck.",
    R"(Three sensors below the front, left, middle and right, read the grey level of the floor below them,
(0.299 red + 0.587 green + 0.114 blue) / 255: 0 is black, 1 is white. A sensor that is more than 5 mm from the floor
reads 1. The background is always 0.
)" + RequiredSensorXML(R"(<pipuck_ground implementation="default" />)") +
        OptionalXML(R"(<pipuck_ground implementation="default" show_rays="true" />)") + R"(
  show_rays  "true" or "false", default "false": visualizations show the rays.
)",
    "Usable")

}  // namespace argos
