#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_imu_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_PiPuckImuSensor::WriteReadings(CLuaTable& table) const {
  table.Set("accelerometer", m_cAccelerometer);
  table.Set("gyroscope", m_cGryoscope);
  table.Set("magnetometer", m_cMagnetometer);
}

std::vector<CCI_Sensor::SColumn> CCI_PiPuckImuSensor::GetReadingColumns() const {
  return {{"acceleration_x", "m/s2"}, {"acceleration_y", "m/s2"}, {"acceleration_z", "m/s2"},
          {"turn_rate_x", "rad/s"},   {"turn_rate_y", "rad/s"},   {"turn_rate_z", "rad/s"}};
}

void CCI_PiPuckImuSensor::CopyReadings(Real* numbers, std::size_t count) const {
  CopyNumbers({m_cAccelerometer.GetX(), m_cAccelerometer.GetY(), m_cAccelerometer.GetZ(),
               m_cGryoscope.GetX(), m_cGryoscope.GetY(), m_cGryoscope.GetZ()},
              numbers, count);
}

}  // namespace argos
