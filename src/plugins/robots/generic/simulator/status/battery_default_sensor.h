#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STATUS_BATTERY_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STATUS_BATTERY_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_battery_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CBatteryEquippedEntity;
class CControllableEntity;

/** The charge of a robot's battery, with optional noise. */
class CBatteryDefaultSensor : public CSimulatedSensor, public CCI_BatterySensor {
 public:
  /** Enables the battery. @throws CARGoSException if the robot has no "battery" or "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `noise_range` and `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

 private:
  Real GetCharge() const;

  CBatteryEquippedEntity* m_battery = nullptr;  // of the robot
  const CControllableEntity* m_robot = nullptr;
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
