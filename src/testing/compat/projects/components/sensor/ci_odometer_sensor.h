#ifndef CI_ODOMETER_SENSOR_H
#define CI_ODOMETER_SENSOR_H

namespace argos {
class CCI_OdometerSensor;
}

#include <argos3/core/control_interface/ci_sensor.h>

namespace argos {

/* The distance that the robot has moved so far, in m. */
class CCI_OdometerSensor : public CCI_Sensor {
 public:
  CCI_OdometerSensor() : m_fReading(0.0) {}
  virtual ~CCI_OdometerSensor() {}
  Real GetReading() const { return m_fReading; }

#ifdef ARGOS_WITH_LUA
  virtual void CreateLuaState(lua_State* pt_lua_state) {}
  virtual void ReadingsToLuaState(lua_State* pt_lua_state) {}
#endif

 protected:
  Real m_fReading;
};

}  // namespace argos

#endif
