#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void Write(CLuaTable& table, const CCI_RangeAndBearingSensor::TReadings& readings) {
  table.SetNewRecords(readings,
                      [](CLuaTable& record, const CCI_RangeAndBearingSensor::SPacket& packet) {
                        record.Set("range", packet.Range);
                        record.Set("horizontal_bearing", packet.HorizontalBearing);
                        record.Set("vertical_bearing", packet.VerticalBearing);
                        CLuaTable data = record.GetTable("data");
                        for (size_t i = 0; i < packet.Data.Size(); ++i) {
                          data.Set(i + 1, static_cast<Real>(packet.Data.ToCArray()[i]));
                        }
                      });
}

}  // namespace

void CCI_RangeAndBearingSensor::CreateLuaState(lua_State* state) {
  CLuaTable table(state, *this, "range_and_bearing");
  Write(table, m_tReadings);
}

void CCI_RangeAndBearingSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable table(state, *this);
  Write(table, m_tReadings);
}

}  // namespace argos
