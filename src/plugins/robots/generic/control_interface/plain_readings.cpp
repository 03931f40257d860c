#include <argos3/plugins/robots/generic/control_interface/plain_readings.h>

#include <argos3/core/wrappers/lua/lua_table.h>

#include <algorithm>

namespace argos {

void CPlainReadings::WriteReadings(CLuaTable& table) const {
  table.SetNumbers(m_tReadings);
}

std::vector<CCI_Sensor::SColumn> CPlainReadings::GetReadingColumns() const {
  return MakeNumberedColumns(m_tReadings.size());
}

void CPlainReadings::CopyReadings(Real* numbers, std::size_t count) const {
  std::copy_n(m_tReadings.begin(), std::min(count, m_tReadings.size()), numbers);
}

}  // namespace argos
