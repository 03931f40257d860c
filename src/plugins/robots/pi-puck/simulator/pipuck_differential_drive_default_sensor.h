#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_DIFFERENTIAL_DRIVE_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_DIFFERENTIAL_DRIVE_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_differential_drive_sensor.h>

namespace argos {

class CPiPuckDifferentialDriveEntity;

/** Reads the speeds of the wheels of a Pi-Puck. */
class CPiPuckDifferentialDriveDefaultSensor : public CSimulatedSensor,
                                              public CCI_PiPuckDifferentialDriveSensor {
 public:
  /** @throws CARGoSException if the robot has no "differential_drive". */
  void SetRobot(CComposableEntity& robot) override;
  void Update() override;
  void Reset() override;
  Real GetLeftVelocity() override { return m_left; }
  Real GetRightVelocity() override { return m_right; }

 private:
  const CPiPuckDifferentialDriveEntity* m_drive = nullptr;
  Real m_left = 0.0;  // m/s
  Real m_right = 0.0;  // m/s
};

}  // namespace argos

#endif
