#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_SYSTEM_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_SYSTEM_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_system_sensor.h>

namespace argos {

class CControllableEntity;

/** The time since the start of the experiment. */
class CPiPuckSystemDefaultSensor : public CSimulatedSensor, public CCI_PiPuckSystemSensor {
 public:
  /** @throws CARGoSException if the robot is no Pi-Puck. */
  void SetRobot(CComposableEntity& robot) override;
  void Update() override;
  void Reset() override;

 private:
  const CControllableEntity* m_robot = nullptr;
};

}  // namespace argos

#endif
