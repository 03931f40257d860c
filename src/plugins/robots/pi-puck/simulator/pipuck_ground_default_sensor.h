#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_GROUND_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_GROUND_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_ground_sensor.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_simulated_sensor.h>

namespace argos {

class CControllableEntity;

/** Reads the floor below the front of a Pi-Puck. */
class CPiPuckGroundDefaultSensor : public CPiPuckSimulatedSensor<CCI_PiPuckGroundSensor> {
 public:
  /** @throws CARGoSException if the robot is no Pi-Puck. */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `show_rays`. @throws CARGoSException after loading, if there is no floor. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Sets all readings to 0. */
  void Reset() override;

 private:
  CControllableEntity* m_robot = nullptr;
};

}  // namespace argos

#endif
