#ifndef CI_MICROPHONE_SENSOR_H
#define CI_MICROPHONE_SENSOR_H

namespace argos {
class CCI_MicrophoneSensor;
}

#include <argos3/core/control_interface/ci_sensor.h>

namespace argos {

/* Hears how loud it is at the robot. */
class CCI_MicrophoneSensor : virtual public CCI_Sensor {
 public:
  virtual ~CCI_MicrophoneSensor() {}
  Real GetLoudness() const { return m_fLoudness; }

#ifdef ARGOS_WITH_LUA
  virtual void CreateLuaState(lua_State* pt_lua_state) {}
  virtual void ReadingsToLuaState(lua_State* pt_lua_state) {}
#endif

 protected:
  Real m_fLoudness = 0.0;
};

}  // namespace argos

#endif
