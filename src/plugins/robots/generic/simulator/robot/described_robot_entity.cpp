#include <argos3/plugins/robots/generic/simulator/described_robot_entity.h>

#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/new_component.h>
#include <argos3/plugins/simulator/entities/planar_drive_entity.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>

#include <algorithm>
#include <cstring>

namespace argos {

CDescribedRobotEntity::CDescribedRobotEntity(const SDescribedRobotType& type)
    : CRobotEntity(type, "", CVector3(), CQuaternion()), m_described(type) {
  const SBodyDescription& body = type.Bodies.GetDefault();
  GetEmbodiedEntity().SetBodyDescription(type.Bodies.GetSharedDefault());
  if (body.Drive) {
    AddWheels(*this, *body.Drive);
  } else if (body.PlanarDrive) {
    NewComponent<CPlanarDriveEntity>(*this, "planar_drive_0");
  } else {
    NewComponent<CQuadRotorEntity>(*this, "quadrotor_0");
  }
  AddController();
}

// limits of a differential drive
void CDescribedRobotEntity::ReadDrive(TConfigurationNode& tree) {
  const CSharedBodies& bodies = m_described.Bodies;
  if (!bodies.GetDefault().Drive) {
    return;
  }
  SDifferentialDriveDescription drive = *bodies.GetDefault().Drive;
  if (ReadDriveLimits(tree, drive)) {
    GetEmbodiedEntity().SetBodyDescription(bodies.Get(drive));
  }
}

void CDescribedRobotEntity::Init(TConfigurationNode& tree) {
  InitParts(tree);
  ReadDrive(tree);
  const auto& onDemand = m_described.OnDemand;
  // attributes of devices that the type lacks stay unread, which is warned of
  const auto has = [&onDemand](const char* component) {
    return std::any_of(onDemand.begin(), onDemand.end(), [component](const auto& entry) {
      return std::strcmp(entry.Type, component) == 0;
    });
  };
  SDeviceParameters parameters = m_described.Parameters;
  if (has("rab")) {
    parameters.RAB.Read(tree);
  }
  if (has("omnidirectional_camera")) {
    parameters.OmnidirectionalCamera.Read(tree);
  }
  if (has("perspective_camera")) {
    parameters.PerspectiveCamera.Read(tree);
  }
  parameters.Battery.Read(tree);
  SetDeviceParameters(parameters);
  InitController(tree);
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CDescribedRobotEntity)

}  // namespace argos
