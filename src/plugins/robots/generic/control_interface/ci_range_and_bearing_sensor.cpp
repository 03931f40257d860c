#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_RangeAndBearingSensor::WriteReadings(CLuaTable& table) const {
  table.SetNewRecords(m_tReadings, [](CLuaTable& record, const SPacket& packet) {
    record.Set("range", packet.Range);
    record.Set("horizontal_bearing", packet.HorizontalBearing);
    record.Set("vertical_bearing", packet.VerticalBearing);
    CLuaTable data = record.GetTable("data");
    for (size_t i = 0; i < packet.Data.Size(); ++i) {
      data.Set(i + 1, static_cast<Real>(packet.Data.ToCArray()[i]));
    }
  });
}

}  // namespace argos
