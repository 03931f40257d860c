#ifndef ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_VECTOR3_H
#define ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_VECTOR3_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/core/wrappers/lua/lua_user_type.h>

namespace argos {

/** The Lua type vector3. */
class CLuaVector3 : public CLuaVectorType<CVector3> {
 public:
  /** Pushes CVector3(arguments...). */
  template <typename... ARGUMENTS>
  static void PushVector3(lua_State* state, ARGUMENTS&&... arguments) {
    Push(state, std::forward<ARGUMENTS>(arguments)...);
  }
  /** The vector in the userdatum. Raises an error of Lua if the value has another type. */
  static CVector3& ToVector3(lua_State* state, int index) { return Get(state, index); }
};

}  // namespace argos

#endif
