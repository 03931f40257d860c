#ifndef ARGOS3_CORE_CONTROL_INTERFACE_CI_ACTUATOR_H
#define ARGOS3_CORE_CONTROL_INTERFACE_CI_ACTUATOR_H

#include <argos3/core/config.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>

#include <functional>
#include <map>
#include <string>

struct lua_State;

namespace argos {

/** Interface of an actuator for controllers, on the real robot and in the simulator. */
class CCI_Actuator : public CBaseConfigurableResource {
 public:
  /** Actuators by type, which is the tag in the experiment file. */
  typedef std::map<std::string, CCI_Actuator*, std::less<std::string> > TMap;

  ~CCI_Actuator() override;

  void Init(TConfigurationNode& node) override;
  void Reset() override;
  void Destroy() override;

  /**
   * For Lua controllers: adds the actuator's functions to the table "robot" on top of the stack.
   * Without an override an actuator is not available in Lua.
   */
  virtual void CreateLuaState(lua_State* state);

 protected:
  bool m_bEnabled = false;  // serves derived classes; actuators act in every tick
};

}  // namespace argos

#endif
