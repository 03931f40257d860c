#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_TYPES_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_TYPES_H

#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

struct lua_State;

namespace argos {

/** The Lua types vector2, vector3 and quaternion: userdata that hold a VALUE. */
template <typename VALUE>
class CLuaType {
 public:
  /** Makes the constructor, a global function, and the metatable. */
  static void Register(lua_State* state);

  /** Pushes a new value; registers the type if nobody has. */
  static void Push(lua_State* state, const VALUE& value);

  /** @return null if what is there is something else. */
  static VALUE* Test(lua_State* state, int index);
};

extern template class CLuaType<CVector2>;
extern template class CLuaType<CVector3>;
extern template class CLuaType<CQuaternion>;

/** The type of a value as a user would call it: "vector2", "number", "nothing" for no argument. */
const char* GetLuaTypeName(lua_State* state, int index);

}  // namespace argos

#endif
