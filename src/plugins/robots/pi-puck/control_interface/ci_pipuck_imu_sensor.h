#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_IMU_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_IMU_SENSOR_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

namespace argos {

/** The inertial unit of the Pi-Puck; all readings are in the frame of the robot. */
class CCI_PiPuckImuSensor : public CTableSensor {
 public:
  /** Specific force, m/s^2: (0,0,9.81) at rest on level ground. */
  const CVector3& GetAccelerometer() const { return m_cAccelerometer; }
  /** Angular velocity, rad/s. The name is that of ARGoS 3. */
  const CVector3& GetGryoscope() const { return m_cGryoscope; }
  /** Always 0. */
  const CVector3& GetMagnetometer() const { return m_cMagnetometer; }

 protected:
  CVector3 m_cAccelerometer;
  CVector3 m_cGryoscope;
  CVector3 m_cMagnetometer;

 private:
  const char* GetLuaName() const override { return "imu"; }
  /** robot.imu = { accelerometer, gyroscope, magnetometer }, vectors */
  void WriteReadings(CLuaTable& table) const override;
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#endif
