#include <argos3/core/wrappers/lua/lua_parameters.h>

#include <argos3/core/wrappers/lua/lua_registry.h>
#include <argos3/core/wrappers/lua/lua_source.h>
#include <argos3/core/wrappers/lua/lua_state.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <string>
#include <vector>

// Lua leaves a C function with longjmp() when it raises an error: no object of the functions that
// scripts call may need a destructor.

namespace argos {

namespace {

// places in the metatable, which the registry refers to until Finish()
constexpr int kTable = 1;
constexpr int kValues = 2;  // name -> text
constexpr int kNames = 3;  // name -> true, of those that were read

/** __index(table, name); upvalues: values, names */
int ReadParameter(lua_State* state) {
  if (lua_type(state, 2) == LUA_TSTRING) {
    lua_pushvalue(state, 2);
    lua_pushboolean(state, 1);
    lua_rawset(state, lua_upvalueindex(2));
  }
  lua_settop(state, 2);
  lua_rawget(state, lua_upvalueindex(1));
  return 1;
}

/** __newindex(table, name, value); upvalue: values */
int WriteParameter(lua_State* state) {
  luaL_checkany(state, 3);
  if (lua_isnil(state, 2)) {
    return luaL_error(state, "index is nil");
  }
  lua_settop(state, 3);
  lua_rawset(state, lua_upvalueindex(1));
  return 0;
}

/** Copies the values into the table, which loses its metatable. The metatable is on top. */
void Fill(lua_State* state) {
  lua_rawgeti(state, -1, kTable);
  lua_rawgeti(state, -2, kValues);
  for (lua_pushnil(state); lua_next(state, -2) != 0;) {
    lua_pushvalue(state, -2);
    lua_insert(state, -2);
    lua_rawset(state, -5);
  }
  lua_pop(state, 1);
  lua_pushnil(state);
  lua_setmetatable(state, -2);
  lua_pop(state, 1);
}

/** Pushes the metatable if the value at an index is the table. */
bool PushIfOpen(lua_State* state, int index) {
  if (lua_getmetatable(state, index) == 0) {
    return false;
  }
  lua_rawgetp(state, LUA_REGISTRYINDEX, &kLuaParametersKey);
  const bool isTable = lua_rawequal(state, -1, -2) != 0;
  lua_pop(state, isTable ? 1 : 2);
  if (isTable) {
    luaL_checkstack(state, 6, "too many nested tables");
  }
  return isTable;
}

/** @return the names that were read so far. */
std::vector<std::string> Close(CLuaState& lua) {
  std::vector<std::string> names;
  lua.Run([&names](lua_State* state) {
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kLuaParametersKey);
    lua_rawgeti(state, -1, kNames);
    for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1)) {
      if (lua_type(state, -2) == LUA_TSTRING) {
        names.emplace_back(lua_tostring(state, -2));
      }
    }
    lua_pop(state, 1);
    lua_rawgeti(state, -1, kTable);
    CLuaParameters::Open(state, -1);
    lua_pushnil(state);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kLuaParametersKey);
  });
  return names;
}

}  // namespace

void CLuaParameters::Add(lua_State* state, const TConfigurationNode& params) {
  const int owner = lua_gettop(state);
  lua_createtable(state, 3, 2);
  lua_newtable(state);
  lua_newtable(state);
  for (const auto& [name, text] : params.CopyAttributes()) {
    lua_pushlstring(state, text.data(), text.size());
    lua_setfield(state, -2, name.c_str());
  }
  lua_newtable(state);
  // the stack: owner, metatable, table, values, names
  const int metatable = owner + 1;
  lua_pushvalue(state, -2);
  lua_pushvalue(state, -2);
  lua_pushcclosure(state, ReadParameter, 2);
  lua_setfield(state, metatable, "__index");
  lua_pushvalue(state, -2);
  lua_pushcclosure(state, WriteParameter, 1);
  lua_setfield(state, metatable, "__newindex");
  lua_rawseti(state, metatable, kNames);
  lua_rawseti(state, metatable, kValues);
  lua_pushvalue(state, -1);
  lua_rawseti(state, metatable, kTable);
  lua_pushvalue(state, metatable);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &kLuaParametersKey);
  lua_pushvalue(state, metatable);
  lua_setmetatable(state, -2);
  lua_setfield(state, owner, "params");
  lua_settop(state, owner);
}

void CLuaParameters::Finish(CLuaState& state, const TConfigurationNode& params,
                            const SLuaSource& source) {
  for (const std::string& name : Close(state)) {
    params.FindAttribute(name);
  }
  for (const std::string& name : source.Parameters) {
    params.FindAttribute(name);
  }
  for (const std::string& name : params.GetAttributeNames()) {
    if (source.MayUseParameter(name)) {
      params.FindAttribute(name);
    }
  }
}

bool CLuaParameters::Open(lua_State* state, int index) {
  if (!PushIfOpen(state, index)) {
    return false;
  }
  Fill(state);
  lua_pop(state, 1);
  return true;
}

void CLuaParameters::ReadAll(lua_State* state, int index) {
  if (!PushIfOpen(state, index)) {
    return;
  }
  lua_rawgeti(state, -1, kNames);
  lua_rawgeti(state, -2, kValues);
  for (lua_pushnil(state); lua_next(state, -2) != 0;) {
    lua_pop(state, 1);
    lua_pushvalue(state, -1);
    lua_pushboolean(state, 1);
    lua_rawset(state, -5);
  }
  lua_pop(state, 2);
  Fill(state);
  lua_pop(state, 1);
}

}  // namespace argos
