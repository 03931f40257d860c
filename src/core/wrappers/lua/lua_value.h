#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_VALUE_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_VALUE_H

#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

#include <string>
#include <type_traits>

struct lua_State;

namespace argos {

/** A number that becomes an integer in Lua, shown as 5; others become floats, shown as 5.0. */
struct SLuaInteger {
  SInt64 Value;
};

/** Returned by a function that has pushed its results itself: their number. */
struct SLuaResults {
  int Count;
};

/** Converts C++ values to Lua values. */
class CLuaValue {
 public:
  static void Push(lua_State* state, bool value);
  static void Push(lua_State* state, Real value);
  static void Push(lua_State* state, SLuaInteger value);
  static void Push(lua_State* state, const char* value);
  static void Push(lua_State* state, const std::string& value);
  /** A number, rad. */
  static void Push(lua_State* state, const CRadians& value);
  static void Push(lua_State* state, const CVector2& value);
  static void Push(lua_State* state, const CVector3& value);
  static void Push(lua_State* state, const CQuaternion& value);
  /** A table { red, green, blue }, each from 0 to 255. */
  static void Push(lua_State* state, const CColor& value);

  /**
   * Pops the value on top of the stack, and writes @p value into it if it has that type.
   * @return false if it has not.
   */
  static bool Overwrite(lua_State* state, const CVector2& value);
  static bool Overwrite(lua_State* state, const CVector3& value);
  static bool Overwrite(lua_State* state, const CQuaternion& value);
  static bool Overwrite(lua_State* state, const CColor& value);

  /** Every number becomes a float. */
  template <typename T>
  static std::enable_if_t<std::is_arithmetic_v<T> > Push(lua_State* state, T value) {
    Push(state, static_cast<Real>(value));
  }
};

}  // namespace argos

#endif
