#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_DIFFERENTIAL_DRIVE_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_DIFFERENTIAL_DRIVE_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_differential_drive_actuator.h>

namespace argos {

class CPiPuckDifferentialDriveEntity;

/** Sets the speeds of the wheels of a Pi-Puck, without limits and noise. */
class CPiPuckDifferentialDriveDefaultActuator : public CSimulatedActuator,
                                                public CCI_PiPuckDifferentialDriveActuator {
 public:
  /** @throws CARGoSException if the robot has no "differential_drive". */
  void SetRobot(CComposableEntity& robot) override;
  /** @throws CARGoSException if a speed is not finite. */
  void SetLinearVelocity(Real left, Real right) override;
  void Update() override;
  void Reset() override;

 private:
  CPiPuckDifferentialDriveEntity* m_drive = nullptr;
  Real m_left = 0.0;  // m/s
  Real m_right = 0.0;  // m/s
};

}  // namespace argos

#endif
