#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CLOCK_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CLOCK_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** Tells a robot the time. */
class CCI_ClockSensor : public CCI_Sensor {
 public:
  struct SReading {
    UInt32 Tick = 0; /**< control steps since the start, this one included: 1 in the first */
    Real Time = 0.0; /**< since the start of the experiment, s */
  };

  const SReading& GetReading() const;

  /** robot.clock.tick, .time (s) */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  SReading m_sReading;
};

}  // namespace argos

#endif
