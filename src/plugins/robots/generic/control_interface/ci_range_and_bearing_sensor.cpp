#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/plugins/robots/generic/control_interface/table_bytes.h>

namespace argos {

void CCI_RangeAndBearingSensor::WriteReadings(CLuaTable& table) const {
  table.SetNewRecords(m_tReadings, [](CLuaTable& record, const SPacket& packet) {
    record.Set("range", packet.Range);
    record.Set("horizontal_bearing", packet.HorizontalBearing);
    record.Set("vertical_bearing", packet.VerticalBearing);
    SetBytes(record, "data", packet.Data);
  });
}

void CCI_RangeAndBearingSensor::ListNumbers(CNumberList& list) const {
  list.Add("count", "", static_cast<Real>(m_tReadings.size()));
}

}  // namespace argos
