#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STATUS_CLOCK_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STATUS_CLOCK_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_clock_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CControllableEntity;

/** The clock of the experiment, perhaps with noise. */
class CClockDefaultSensor : public CSimulatedSensor, public CCI_ClockSensor {
 public:
  /** @throws CARGoSException if the robot has no "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

 private:
  const CControllableEntity* m_robot = nullptr;
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
