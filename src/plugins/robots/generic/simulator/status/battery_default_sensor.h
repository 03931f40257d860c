#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STATUS_BATTERY_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STATUS_BATTERY_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_battery_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noisy_sensor.h>

namespace argos {

class CBatteryEquippedEntity;

/** The charge of a robot's battery, with optional noise. */
class CBatteryDefaultSensor : public CNoisySensor<CCI_BatterySensor> {
 public:
  void Update() override;

 private:
  /** Also enables the "battery". */
  void FindParts(CComposableEntity& robot) override;
  /** Also reads `noise_range`. */
  void Configure(TConfigurationNode& tree) override;
  void ResetReading() override;
  Real GetCharge() const;

  CBatteryEquippedEntity* m_battery = nullptr;
};

}  // namespace argos

#endif
