#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void Write(CLuaTable& cameras, const CCI_CameraSensor::SInterface::TVector& interfaces) {
  for (const CCI_CameraSensor::SInterface& interface : interfaces) {
    CLuaTable camera = cameras.GetTable(interface.Id.c_str());
    for (const CCI_CameraSensorAlgorithm* algorithm : interface.Algorithms) {
      CLuaTable readings = camera.GetTable(algorithm->GetLabel());
      algorithm->WriteReadings(readings);
    }
  }
}

}  // namespace

CCI_CameraSensor::SInterface::SInterface(const std::string& id,
                                         const std::vector<CCI_CameraSensorAlgorithm*>& algorithms)
    : Id(id), Algorithms(algorithms) {}

const CCI_CameraSensor::SInterface::TVector& CCI_CameraSensor::GetInterfaces() const {
  return m_vecInterfaces;
}

void CCI_CameraSensor::CreateLuaState(lua_State* state) {
  // Lua has no function to enable it
  Enable();
  CLuaTable cameras(state, *this, "cameras");
  Write(cameras, m_vecInterfaces);
}

void CCI_CameraSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable cameras(state, *this);
  Write(cameras, m_vecInterfaces);
}

}  // namespace argos
