#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_BATTERY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_BATTERY_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** The charge of the battery of a robot. */
class CCI_BatterySensor : public CCI_Sensor {
 public:
  struct SReading {
    Real AvailableCharge = 1.0; /**< share of the full charge, in [0,1] */
    Real TimeLeft = 0.0; /**< until it is empty at the rate of the last tick, s; may be infinite */

    SReading() = default;
    SReading(Real availableCharge, Real timeLeft)
        : AvailableCharge(availableCharge), TimeLeft(timeLeft) {}
  };

  const SReading& GetReading() const;

  /** robot.battery.available_charge, .time_left (s) */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  SReading m_sReading;
};

}  // namespace argos

#endif
