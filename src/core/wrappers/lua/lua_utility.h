#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_UTILITY_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_UTILITY_H

#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/core/wrappers/lua/lua_headers.h>

#include <string>

namespace argos {

/**
 * Exposes the control interfaces of plug-ins to Lua; as published with ARGoS 3.
 *
 * Our devices are bound with lua_table.h, which is shorter, checks the arguments of every function,
 * and works even if a script changes the global "robot"; use that for new code.
 *
 * Unless said otherwise, "the table" is the one on top of the stack, functions leave the stack
 * unchanged, and keys that are numbers count from 1, as in Lua.
 */
class CLuaUtility {
 public:
  /**
   * Loads a script and runs its top-level chunk.
   * @return false if that failed; then Lua's message, with file and line, is on top of the stack.
   */
  static bool LoadScript(lua_State* state, const std::string& filename);

  /**
   * Calls a global function without arguments and discards its results.
   * @return false if there is no such function or if it failed; then the message is on top of the
   * stack.
   */
  static bool CallLuaFunction(lua_State* state, const std::string& function);

  /** Writes the global variables and their values, tables in depth, in the order of their names. */
  static void PrintGlobals(CARGoSLog& log, lua_State* state);

  /** Writes the values on the stack, the top last. */
  static void PrintStack(CARGoSLog& log, lua_State* state);

  /** Creates the global functions log(...) and logerr(...), which write to LOG and LOGERR. */
  static void RegisterLoggerWrapper(lua_State* state);

  /**
   * Creates the functions of robot.random.
   * @param state  has the table "robot" on top of the stack.
   * @param rng    their generator; must live as long as the state.
   */
  static void RegisterRNG(lua_State* state, CRandom::CRNG* rng);

  /** Creates the types vector2, vector3 and quaternion with their global constructors. */
  static void RegisterTypes(lua_State* state);

  /**
   * In CreateLuaState(): opens the table robot.<name>, which is created if it does not exist; it is
   * then on top of the stack. An actuator and a sensor may share a table.
   * @throws CARGoSException if another actuator (for an actuator) or sensor (for a sensor) of the
   * robot has opened this table; the text names both.
   */
  static void OpenRobotStateTable(lua_State* state, const std::string& name);

  /** Closes the table that OpenRobotStateTable() has opened. */
  static void CloseRobotStateTable(lua_State* state);

  /** Begins a table inside the table; it is then on top of the stack until EndTable(). */
  static void StartTable(lua_State* state, const std::string& key);
  static void StartTable(lua_State* state, int key);
  static void EndTable(lua_State* state);

  /** table[key] = value. Colours become tables { red, green, blue }, angles numbers in radians. */
  static void AddToTable(lua_State* state, const std::string& key, void* value);
  static void AddToTable(lua_State* state, const std::string& key, lua_CFunction value);
  static void AddToTable(lua_State* state, const std::string& key, const std::string& value);
  static void AddToTable(lua_State* state, int key, const std::string& value);
  static void AddToTable(lua_State* state, const std::string& key, Real value);
  static void AddToTable(lua_State* state, int key, Real value);
  static void AddToTable(lua_State* state, const std::string& key, const CRadians& value);
  static void AddToTable(lua_State* state, int key, const CRadians& value);
  static void AddToTable(lua_State* state, const std::string& key, const CVector2& value);
  static void AddToTable(lua_State* state, int key, const CVector2& value);
  static void AddToTable(lua_State* state, const std::string& key, const CVector3& value);
  static void AddToTable(lua_State* state, int key, const CVector3& value);
  static void AddToTable(lua_State* state, const std::string& key, const CQuaternion& value);
  static void AddToTable(lua_State* state, int key, const CQuaternion& value);
  static void AddToTable(lua_State* state, const std::string& key, const CColor& value);
  static void AddToTable(lua_State* state, int key, const CColor& value);

  /**
   * In a function that Lua calls: the device whose CreateLuaState() called
   * AddToTable(state, "_instance", this) in the table robot.<key>.
   *
   * It is found even if the script has overwritten the global "robot", but not if it has
   * overwritten robot.<key>.
   * @param key  may be a path, such as "simple_radios.wifi".
   * @return null if there is no such table, or if it has no "_instance".
   */
  template <class T>
  static T* GetDeviceInstance(lua_State* state, const std::string& key) {
    return reinterpret_cast<T*>(GetInstance(state, key));
  }

  /** Gives the table on top of the stack the metatable registered under a name. */
  static void SetMetatable(lua_State* state, const std::string& name);

  /**
   * Appends a table to a byte array: keys and values that are strings,
   * numbers, booleans, tables, vectors and quaternions, in a fixed order of the keys; others are
   * skipped.
   * @param offset  where the table is on the stack; -1: on top.
   * @throws CARGoSException if tables are nested more than 32 deep.
   */
  static void LuaSerializeTable(CByteArray& data, lua_State* state, SInt32 offset = -1);

  /**
   * Takes a table off the front of a byte array and pushes it.
   * @return false if LuaSerializeTable() did not write the bytes; then nothing is pushed.
   */
  static bool LuaDeserializeTable(CByteArray& data, lua_State* state);

 private:
  static void* GetInstance(lua_State* state, const std::string& key);
};

}  // namespace argos

#endif
