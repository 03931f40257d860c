#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_algorithm.h>

namespace argos {

CCI_CameraSensorAlgorithm::~CCI_CameraSensorAlgorithm() = default;

void CCI_CameraSensorAlgorithm::WriteReadings(CLuaTable& /*table*/) const {}

}  // namespace argos
