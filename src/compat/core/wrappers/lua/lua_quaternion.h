#ifndef ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_QUATERNION_H
#define ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_QUATERNION_H

#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/wrappers/lua/lua_user_type.h>

namespace argos {

/** The Lua type quaternion. */
class CLuaQuaternion : public CLuaUserType<CQuaternion> {
 public:
  /** Pushes CQuaternion(arguments...). */
  template <typename... ARGUMENTS>
  static void PushQuaternion(lua_State* state, ARGUMENTS&&... arguments) {
    Push(state, std::forward<ARGUMENTS>(arguments)...);
  }
  /** The quaternion in the userdatum. Raises an error of Lua if the value has another type. */
  static CQuaternion& ToQuaternion(lua_State* state, int index) { return Get(state, index); }

  static int Inverse(lua_State* state) { return Call(state, "inverse"); }
  static int ToAngleAxis(lua_State* state) { return Call(state, "toangleaxis"); }
  static int ToEulerAngles(lua_State* state) { return Call(state, "toeulerangles"); }
};

}  // namespace argos

#endif
