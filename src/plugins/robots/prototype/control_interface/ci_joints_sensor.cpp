#include <argos3/plugins/robots/prototype/control_interface/ci_joints_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

#include <algorithm>

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

std::vector<CCI_Sensor::SColumn> CCI_JointsSensor::GetReadingColumns() const {
  std::vector<SColumn> columns;
  for (const SInterface& interface : m_vecInterfaces) {
    columns.push_back({interface.Id, ""});
  }
  return columns;
}

void CCI_JointsSensor::CopyReadings(Real* numbers, std::size_t count) const {
  for (std::size_t i = 0; i < std::min(count, m_vecInterfaces.size()); ++i) {
    numbers[i] = m_vecInterfaces[i].Value;
  }
}

}  // namespace argos
