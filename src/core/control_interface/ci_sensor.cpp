#include <argos3/core/control_interface/ci_sensor.h>

#include <algorithm>

namespace argos {

CCI_Sensor::~CCI_Sensor() = default;

void CCI_Sensor::Init(TConfigurationNode&) {}

void CCI_Sensor::Reset() {}

void CCI_Sensor::Destroy() {}

void CCI_Sensor::Enable() {
  m_bEnabled = true;
  m_switchedOff = false;
}

void CCI_Sensor::Disable() {
  m_bEnabled = false;
  m_switchedOff = true;
}

void CCI_Sensor::MarkStart() {
  m_enabledAtStart = m_bEnabled;
  m_switchedOffAtStart = m_switchedOff;
}

// A derived class may do more in Enable() and Disable().
void CCI_Sensor::ReturnToStart() {
  if (m_bEnabled != m_enabledAtStart) {
    m_enabledAtStart ? Enable() : Disable();
  }
  m_bEnabled = m_enabledAtStart;
  m_switchedOff = m_switchedOffAtStart;
}

void CCI_Sensor::CreateLuaState(lua_State*) {}

void CCI_Sensor::ReadingsToLuaState(lua_State*) {}

std::vector<CCI_Sensor::SColumn> CCI_Sensor::GetReadingColumns() const {
  return {};
}

void CCI_Sensor::CopyReadings(Real* /*numbers*/, std::size_t /*count*/) const {}

std::vector<CCI_Sensor::SColumn> CCI_Sensor::MakeNumberedColumns(std::size_t count,
                                                                 const std::string& unit) {
  std::vector<SColumn> columns;
  columns.reserve(count);
  for (std::size_t i = 1; i <= count; ++i) {
    columns.push_back({std::to_string(i), unit});
  }
  return columns;
}

void CCI_Sensor::CopyNumbers(std::initializer_list<Real> from, Real* numbers, std::size_t count) {
  std::copy_n(from.begin(), std::min(count, from.size()), numbers);
}

}  // namespace argos
