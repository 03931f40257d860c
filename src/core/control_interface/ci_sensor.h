#ifndef ARGOS3_CORE_CONTROL_INTERFACE_CI_SENSOR_H
#define ARGOS3_CORE_CONTROL_INTERFACE_CI_SENSOR_H

#include <argos3/core/config.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>

#include <functional>
#include <map>
#include <string>

struct lua_State;

namespace argos {

/** Interface of a sensor for controllers, on the real robot and in the simulator. */
class CCI_Sensor : public CBaseConfigurableResource {
 public:
  /** Sensors by type, which is the tag in the experiment file. */
  typedef std::map<std::string, CCI_Sensor*, std::less<std::string> > TMap;

  ~CCI_Sensor() override;

  void Init(TConfigurationNode& node) override;
  void Reset() override;
  void Destroy() override;

  /**
   * A sensor is updated in every tick unless Disable() was called after the last Enable(). So one
   * for which neither was called is updated, although IsEnabled() is false.
   */
  virtual void Enable();
  virtual void Disable();
  bool IsEnabled() const { return m_bEnabled; }
  bool IsDisabled() const { return !m_bEnabled; }
  /** @return true if the sensor is updated. */
  bool IsSwitchedOn() const { return !m_switchedOff; }
  /** Called at the start of the run: stores the state that Reset() restores. */
  void MarkStart();
  void ReturnToStart();

  /**
   * For Lua controllers: adds the sensor's functions and readings to the table "robot" on top of
   * the stack. Without an override a sensor is not available in Lua.
   */
  virtual void CreateLuaState(lua_State* state);

  /** For Lua controllers: copies the readings into the table that CreateLuaState() created. */
  virtual void ReadingsToLuaState(lua_State* state);

 protected:
  bool m_bEnabled = false;

 private:
  bool m_switchedOff = false;
  bool m_enabledAtStart = false;
  bool m_switchedOffAtStart = false;
};

}  // namespace argos

#endif
