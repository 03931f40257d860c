#include <argos3/plugins/robots/generic/control_interface/ci_rfid_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/plugins/robots/generic/control_interface/table_bytes.h>

namespace argos {

void CCI_RFIDSensor::WriteReadings(CLuaTable& table) const {
  table.SetNewRecords(m_tReadings, [](CLuaTable& record, const SReading& reading) {
    record.Set("id", reading.Id);
    record.Set("distance", reading.Distance);
    record.Set("angle", reading.Angle);
    SetBytes(record, "data", reading.Data);
  });
}

void CCI_RFIDSensor::ListNumbers(CNumberList& list) const {
  list.Add("count", "", static_cast<Real>(m_tReadings.size()));
}

}  // namespace argos
