#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_IMU_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_IMU_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_imu_sensor.h>
#include <argos3/plugins/simulator/entities/body_motion.h>
#include <argos3/plugins/simulator/entities/tick_watch.h>

namespace argos {

/** Computes acceleration and angular velocity from the motion of the robot's body. */
class CPiPuckImuDefaultSensor : public CSimulatedSensor, public CCI_PiPuckImuSensor {
 public:
  /** @throws CARGoSException if the robot is no Pi-Puck. */
  void SetRobot(CComposableEntity& robot) override;
  void Update() override;
  /** Sets all readings to 0. */
  void Reset() override;

 private:
  CBodyMotion m_motion;  // motion since the last tick
  CTickWatch m_tick;
  CVector3 m_velocity;  // mean of the last tick, m/s, world frame
};

}  // namespace argos

#endif
