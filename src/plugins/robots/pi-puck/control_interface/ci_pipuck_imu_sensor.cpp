#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_imu_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_PiPuckImuSensor::WriteReadings(CLuaTable& table) const {
  table.Set("accelerometer", m_cAccelerometer);
  table.Set("gyroscope", m_cGryoscope);
  table.Set("magnetometer", m_cMagnetometer);
}

void CCI_PiPuckImuSensor::ListNumbers(CNumberList& list) const {
  list.Add("acceleration_x", "m/s2", m_cAccelerometer.GetX());
  list.Add("acceleration_y", "m/s2", m_cAccelerometer.GetY());
  list.Add("acceleration_z", "m/s2", m_cAccelerometer.GetZ());
  list.Add("turn_rate_x", "rad/s", m_cGryoscope.GetX());
  list.Add("turn_rate_y", "rad/s", m_cGryoscope.GetY());
  list.Add("turn_rate_z", "rad/s", m_cGryoscope.GetZ());
}

}  // namespace argos
