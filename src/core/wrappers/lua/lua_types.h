#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_TYPES_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_TYPES_H

#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

#include <string>

struct lua_State;

namespace argos {

/** The Lua types vector2, vector3 and quaternion: userdata that hold a VALUE. */
template <typename VALUE>
class CLuaType {
 public:
  /** Creates the constructor, a global function, and the metatable. */
  static void Register(lua_State* state);

  /** Pushes a new value; registers the type if necessary. */
  static void Push(lua_State* state, const VALUE& value);

  /** @return null if the value at the index has another type. */
  static VALUE* Test(lua_State* state, int index);

  /** Raises an error of Lua if the value at the index has another type. */
  static VALUE& Get(lua_State* state, int index);

  /** The constructor, as Lua calls it. */
  static int Create(lua_State* state);

  /**
   * Calls a method of this type with the values on the stack, which it replaces by the results.
   * @param method  "length", or a metamethod such as "__add". @return the number of results.
   */
  static int Call(lua_State* state, const char* method);

  /** The name of the metatable in the registry: "argos3.vector2". */
  static const std::string& GetTypeId();
};

extern template class CLuaType<CVector2>;
extern template class CLuaType<CVector3>;
extern template class CLuaType<CQuaternion>;

/** Name of a value's type for messages: "vector2", "number"; "nothing" if there is no value. */
const char* GetLuaTypeName(lua_State* state, int index);

}  // namespace argos

#endif
