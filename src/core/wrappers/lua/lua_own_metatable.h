#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_OWN_METATABLE_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_OWN_METATABLE_H

#include <argos3/core/wrappers/lua/lua_headers.h>

#include <memory>
#include <type_traits>

/**
 * @file
 * Arguments and results of the functions of a type of Lua. The functions have its metatable as
 * their first upvalue, which spares a look-up in the registry for each of them.
 */

namespace argos {

constexpr int kMetatable = 1; /**< upvalue of functions; CLuaType::Create() has none */
constexpr int kMethods = 2; /**< upvalue of __index */

/** Pushes the metatable; creates it if necessary. Defined where the type is. */
template <typename VALUE>
void PushMetatable(lua_State* state);

template <typename VALUE>
void PushOwnMetatable(lua_State* state) {
  lua_pushvalue(state, lua_upvalueindex(kMetatable));
  if (lua_isnil(state, -1)) {
    lua_pop(state, 1);
    PushMetatable<VALUE>(state);
  }
}

/** As CLuaType<VALUE>::Test(), in functions of the type. */
template <typename VALUE>
VALUE* TestOwn(lua_State* state, int index) {
  if (lua_type(state, index) != LUA_TUSERDATA || lua_getmetatable(state, index) == 0) {
    return nullptr;
  }
  PushOwnMetatable<VALUE>(state);
  const bool isSame = lua_topointer(state, -1) == lua_topointer(state, -2);
  lua_pop(state, 2);
  return isSame ? static_cast<VALUE*>(lua_touserdata(state, index)) : nullptr;
}

/** Pushes a copy, without its metatable. */
template <typename VALUE>
void PushBare(lua_State* state, const VALUE& value) {
  static_assert(std::is_trivially_destructible_v<VALUE>, "there is no __gc");
  const VALUE copy = value;  // the allocation may collect the userdata that holds it
  std::construct_at(static_cast<VALUE*>(lua_newuserdatauv(state, sizeof(VALUE), 0)), copy);
}

/** As CLuaType<VALUE>::Push(), in functions of the type. */
template <typename VALUE>
void PushOwn(lua_State* state, const VALUE& value) {
  PushBare(state, value);
  PushOwnMetatable<VALUE>(state);
  lua_setmetatable(state, -2);
}

}  // namespace argos

#endif
