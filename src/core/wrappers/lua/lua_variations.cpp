#include <argos3/core/wrappers/lua/lua_variations.h>

#include <argos3/core/wrappers/lua/lua_parameters.h>
#include <argos3/core/wrappers/lua/lua_state.h>

// Lua leaves a C function with longjmp() when it raises an error: no object in this file may need a
// destructor.

namespace argos {

namespace {

/** True for values that are identified by their addresses. */
bool IsAddress(int type) {
  return type >= LUA_TTABLE || type == LUA_TLIGHTUSERDATA;
}

/** True if the place of such keys in a table depends on the run: strings have seeded hashes. */
bool IsHashed(int type) {
  return type == LUA_TSTRING || IsAddress(type);
}

/** A value that is converted to a text. */
void CheckText(lua_State* state, int index) {
  if (!IsAddress(lua_type(state, index))) {
    return;
  }
  if (luaL_getmetafield(state, index, "__tostring") != LUA_TNIL) {
    lua_pop(state, 1);
    return;
  }
  CLuaState::Of(state).WarnOnce(
      state, ELuaVariation::Address,
      "the text of a table or function is its address, which differs from run to run");
}

constexpr const char* kClock =
    " depends on the clock of the machine, so runs differ in all that depends on it";

}  // namespace

int CLuaVariations::Next(lua_State* state, lua_CFunction /*original*/) {
  luaL_checktype(state, 1, LUA_TTABLE);
  CLuaParameters::ReadAll(state, 1);
  lua_settop(state, 2);
  // if there is no key, the caller may only test whether the table is empty
  const bool continues = !lua_isnil(state, 2);
  bool isHashed = IsHashed(lua_type(state, 2));
  if (lua_next(state, 1) == 0) {
    lua_pushnil(state);
    return 1;
  }
  isHashed = isHashed || IsHashed(lua_type(state, -2));
  if (continues && isHashed) {
    CLuaState::Of(state).WarnOnce(
        state, ELuaVariation::Next,
        "next() visits strings, tables and functions in an order that differs from run to run; use "
        "pairs(), which visits strings in a fixed order");
  }
  return 2;
}

template <int FIRST>
int CLuaVariations::ConvertToText(lua_State* state, lua_CFunction original) {
  for (int i = lua_gettop(state); i >= FIRST; --i) {
    CheckText(state, i);
  }
  return original(state);
}

int CLuaVariations::SeedRandom(lua_State* state) {
  if (lua_isnone(state, 1)) {
    CLuaState::Of(state).WarnOnce(
        state, ELuaVariation::Seed,
        "math.randomseed() without a number draws a seed that differs from run to run; without the "
        "call, math.random() has the seed of the experiment");
  }
  // it is not replaced in place: it has upvalues
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  lua_call(state, lua_gettop(state) - 1, LUA_MULTRET);
  return lua_gettop(state);
}

int CLuaVariations::ReadTime(lua_State* state, lua_CFunction original) {
  if (lua_isnoneornil(state, 1)) {
    CLuaState::Of(state).WarnOnce(state, ELuaVariation::Time, "os.time()", kClock);
  }
  return original(state);
}

int CLuaVariations::ReadClock(lua_State* state, lua_CFunction original) {
  CLuaState::Of(state).WarnOnce(state, ELuaVariation::Clock, "os.clock()", kClock);
  return original(state);
}

int CLuaVariations::FormatDate(lua_State* state, lua_CFunction original) {
  if (lua_isnoneornil(state, 2)) {
    CLuaState::Of(state).WarnOnce(state, ELuaVariation::Date, "os.date()", kClock);
  }
  return original(state);
}

template int CLuaVariations::ConvertToText<1>(lua_State*, lua_CFunction);
template int CLuaVariations::ConvertToText<2>(lua_State*, lua_CFunction);

}  // namespace argos
