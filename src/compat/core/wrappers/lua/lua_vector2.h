#ifndef ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_VECTOR2_H
#define ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_VECTOR2_H

#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/wrappers/lua/lua_user_type.h>

namespace argos {

/** The Lua type vector2. */
class CLuaVector2 : public CLuaVectorType<CVector2> {
 public:
  /** Pushes CVector2(arguments...). */
  template <typename... ARGUMENTS>
  static void PushVector2(lua_State* state, ARGUMENTS&&... arguments) {
    Push(state, std::forward<ARGUMENTS>(arguments)...);
  }
  /** The vector in the userdatum. Raises an error of Lua if the value has another type. */
  static CVector2& ToVector2(lua_State* state, int index) { return Get(state, index); }
};

}  // namespace argos

#endif
