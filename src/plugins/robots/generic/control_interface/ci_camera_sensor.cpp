#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

CCI_CameraSensor::SInterface::SInterface(const std::string& id,
                                         const std::vector<CCI_CameraSensorAlgorithm*>& algorithms)
    : Id(id), Algorithms(algorithms) {}

const CCI_CameraSensor::SInterface::TVector& CCI_CameraSensor::GetInterfaces() const {
  return m_vecInterfaces;
}

void CCI_CameraSensor::WriteConstants(CLuaTable& /*table*/) {
  Enable();
}

void CCI_CameraSensor::WriteReadings(CLuaTable& table) const {
  for (const SInterface& interface : m_vecInterfaces) {
    CLuaTable camera = table.GetTable(interface.Id.c_str());
    for (const CCI_CameraSensorAlgorithm* algorithm : interface.Algorithms) {
      CLuaTable readings = camera.GetTable(algorithm->GetLabel());
      algorithm->WriteReadings(readings);
    }
  }
}

}  // namespace argos
