#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_CONTROLLER_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_CONTROLLER_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/wrappers/lua/lua_limits.h>
#include <argos3/core/wrappers/lua/lua_random.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

struct lua_State;

namespace argos {

class CLuaState;
struct SLuaScript;

/**
 * A controller written in Lua, "lua_controller": runs the functions init(), step(), reset() and
 * destroy() of a script, in a Lua state that belongs to the robot. Users' manual: doc/lua.md.
 */
class CLuaController : public CCI_Controller {
 public:
  CLuaController();
  ~CLuaController() override;

  /**
   * Reads `script` (a file; without it the robot does nothing), `on_error` (see EOnError; before
   * that of the controller's element) and the limits of SLuaLimits; every attribute is a string in
   * robot.params. Runs the script and its init().
   * @throws CARGoSException if there is no such script, or if it fails: with file, line, traceback.
   */
  void Init(TConfigurationNode& params) override;
  /** Does nothing after an error. @throws CARGoSException if the script fails. */
  void ControlStep() override;
  /** After an error, loads the script again. @throws CARGoSException if the script fails. */
  void Reset() override;
  /** @throws CARGoSException if the script fails. */
  void Destroy() override;
  /** By default a robot whose script fails is stopped. */
  EOnError ChooseOnError(std::optional<EOnError> configured) const override;

  /** Gives the robot another script and runs it with its init(). @throws CARGoSException as Init()
   */
  void SetLuaScript(const std::string& script);

  /**
   * Runs another script with the same devices and parameters, from its init() on; Reset() keeps it.
   * If the script cannot be started, the robot keeps the one that it has.
   * @throws CARGoSException as Init().
   */
  void Restart(std::shared_ptr<const SLuaScript> script);
  /** Null without a script. */
  const std::shared_ptr<const SLuaScript>& GetScript() const { return m_script; }
  /** Whether the script may do what SLuaLimits::IsUnsafe says. */
  bool IsUnsafe() const { return m_limits.IsUnsafe; }

  /**
   * Messages about functions that a run will call and that the script lacks: step(), destroy(), and
   * reset() if a function has a similar name. Empty without a script.
   */
  std::vector<std::string> FindMissingFunctions() const;

  /** Null before Init(), after Destroy(), and without a script. */
  lua_State* GetLuaState() const;
  /** True unless the script has failed. */
  bool IsOK() const { return m_error.empty(); }
  /** The error of the script; empty if there was none. */
  const std::string& GetErrorMessage() const { return m_error; }

 private:
  void Load();
  void Run(std::shared_ptr<const SLuaScript> script);
  void FillRobotTable(lua_State* state);
  void AddParameters(lua_State* state) const;
  void AddRandom(lua_State* state);
  void AddDevices(lua_State* state);
  void ReadSensors(lua_State* state, bool isAfterReset) const;
  void Seed(const char* phase);
  [[noreturn]] void Fail(const char* function, const std::string& message);
  std::string DescribeFailure(const char* function, const std::string& message) const;

  TConfigurationNode m_params;
  std::shared_ptr<const SLuaScript> m_script;  // shared by all robots that run it
  bool m_isReplaced = false;  // by Restart(): m_script is not that of the file
  std::unique_ptr<CLuaState> m_state;
  std::optional<CLuaRandom> m_random;
  std::vector<CCI_Sensor*> m_sensors;
  std::string m_scriptName;
  SLuaLimits m_limits;
  bool m_reusesReadings = false;  // see CLuaTable::ReuseReadings()
  std::optional<EOnError> m_onError;  // attribute of <params>
  std::string m_error;
};

}  // namespace argos

#endif
