#include <argos3/plugins/robots/generic/simulator/described_robot_entity.h>

#include <argos3/core/simulator/space/space_operations.h>

#include <algorithm>
#include <cstring>

namespace argos {

CDescribedRobotEntity::CDescribedRobotEntity(const SDescribedRobotType& type)
    : CDifferentialDriveRobotEntity(type, "", CVector3(), CQuaternion()), m_described(type) {}

void CDescribedRobotEntity::Init(TConfigurationNode& tree) {
  InitParts(tree);
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
