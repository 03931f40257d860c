#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_REGISTRY_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_REGISTRY_H

#include <string>

namespace argos {

/** Keys of our entries in a state's registry: their addresses. */
inline constexpr char kLuaRobotKey = 0;  // the table "robot"
inline constexpr char kLuaDeviceKey = 0;  // SLuaDevice*: the current device
inline constexpr char kLuaClaimsKey = 0;  // table: "actuator wheels" -> the label of that actuator
// table: list of readings -> the tables of its entries, also of those that are not in use now; only
// if readings are reused
inline constexpr char kLuaReusedKey = 0;

inline constexpr char kLuaParametersKey = 0;  // see CLuaParameters; while the script is loaded

/** The device whose CreateLuaState() is running. */
struct SLuaDevice {
  const char* Kind;  // "actuator" or "sensor"
  const std::string& Label;
};

}  // namespace argos

#endif
