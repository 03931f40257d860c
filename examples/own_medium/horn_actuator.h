#ifndef OWN_MEDIUM_HORN_ACTUATOR_H
#define OWN_MEDIUM_HORN_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>

/** A horn as controllers see it. */
class CCI_HornActuator : public argos::CCI_Actuator {
 public:
  /** From the next tick on. @param volume >= 0; 0 is silence. */
  void SetVolume(argos::Real volume) { m_volume = volume; }

  // for Lua: robot.horn.set_volume(volume)
  void CreateLuaState(lua_State* state) override;

 protected:
  argos::Real m_volume = 0.0;
};

#endif
