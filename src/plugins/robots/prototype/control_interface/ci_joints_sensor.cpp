#include <argos3/plugins/robots/prototype/control_interface/ci_joints_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

CCI_JointsSensor::SInterface::SInterface(const std::string& id, EMode mode)
    : Id(id), Mode(mode), Value(0.0) {}

const CCI_JointsSensor::SInterface::TVector& CCI_JointsSensor::GetInterfaces() const {
  return m_vecInterfaces;
}

void CCI_JointsSensor::WriteReadings(CLuaTable& table) const {
  for (const SInterface& interface : m_vecInterfaces) {
    CLuaTable joint = table.GetTable(interface.Id.c_str());
    joint.Set("encoder", interface.Value);
  }
}

void CCI_JointsSensor::ListNumbers(CNumberList& list) const {
  for (const SInterface& interface : m_vecInterfaces) {
    list.Add(interface.Id.c_str(), "", interface.Value);
  }
}

}  // namespace argos
