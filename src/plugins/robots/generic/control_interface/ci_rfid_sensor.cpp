#include <argos3/plugins/robots/generic/control_interface/ci_rfid_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void Write(CLuaTable& table, const CCI_RFIDSensor::TReadings& readings) {
  table.SetNewRecords(readings, [](CLuaTable& record, const CCI_RFIDSensor::SReading& reading) {
    record.Set("id", reading.Id);
    record.Set("distance", reading.Distance);
    record.Set("angle", reading.Angle);
    CLuaTable data = record.GetTable("data");
    for (size_t i = 0; i < reading.Data.Size(); ++i) {
      data.Set(i + 1, static_cast<Real>(reading.Data.ToCArray()[i]));
    }
  });
}

}  // namespace

void CCI_RFIDSensor::CreateLuaState(lua_State* state) {
  CLuaTable table(state, *this, "rfid");
  Write(table, m_tReadings);
}

void CCI_RFIDSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable table(state, *this);
  Write(table, m_tReadings);
}

}  // namespace argos
