#include <argos3/core/wrappers/lua/lua_sandbox.h>

#include <argos3/core/wrappers/lua/lua_keys.h>
#include <argos3/core/wrappers/lua/lua_limits.h>
#include <argos3/core/wrappers/lua/lua_parameters.h>
#include <argos3/core/wrappers/lua/lua_state.h>
#include <argos3/core/wrappers/lua/lua_types.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <algorithm>
#include <iterator>
#include <string_view>

// Lua leaves a C function with longjmp() when it raises an error: no object in this file may need a
// destructor. Most functions here check, and then run Lua's own function, which is an upvalue, in
// place: its arguments and results stay where they are.

namespace argos {

namespace {

/** Runs the function that the caller replaces; it must have no upvalues. */
int RunOriginal(lua_State* state) {
  return lua_tocfunction(state, lua_upvalueindex(1))(state);
}

void CountWork(lua_State* state, UInt64 instructions) {
  CLuaState::Of(state).CountWork(state, instructions);
}

// pairs().

bool HasOnlyNumbers(lua_State* state, int table) {
  for (lua_pushnil(state); lua_next(state, table) != 0; lua_pop(state, 1)) {
    if (lua_type(state, -2) != LUA_TNUMBER) {
      lua_pop(state, 2);
      return false;
    }
  }
  return true;
}

/** The iterator that pairs() returns: the next key of a list, and its value in the table. */
int NextOrdered(lua_State* state) {
  // upvalues: the keys, and the number of those returned so far
  luaL_checktype(state, 1, LUA_TTABLE);
  auto place = lua_tointeger(state, lua_upvalueindex(2));
  lua_settop(state, 1);
  while (true) {
    lua_settop(state, 1);
    if (lua_rawgeti(state, lua_upvalueindex(1), ++place) == LUA_TNIL) {
      return 1;
    }
    lua_pushvalue(state, -1);
    // skip keys that the loop itself has removed
    if (lua_rawget(state, 1) != LUA_TNIL) {
      lua_pushinteger(state, place);
      lua_replace(state, lua_upvalueindex(2));
      return 2;
    }
  }
}

/** pairs(); its upvalue is next(). */
int Pairs(lua_State* state) {
  luaL_checkany(state, 1);
  if (luaL_getmetafield(state, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(state, 1);
    lua_call(state, 1, 3);
    return 3;
  }
  lua_settop(state, 1);
  CLuaParameters::ReadAll(state, 1);
  // for numbers, Lua's own order depends only on the history of the table
  if (!lua_istable(state, 1) || HasOnlyNumbers(state, 1)) {
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_pushvalue(state, 1);
    return 2;
  }
  if (!PushOrderedKeys(state, 1)) {
    CLuaState::Of(state).WarnOnce(
        state, ELuaVariation::KeyOrder,
        "pairs() visits several keys that are tables or functions in the order of their addresses, "
        "which differs from run to run; use numbers or strings as keys, or a list");
  }
  lua_pushinteger(state, 0);
  lua_pushcclosure(state, NextOrdered, 2);
  lua_pushvalue(state, 1);
  return 2;
}

// What differs from run to run.

/** True for values that are identified by their addresses. */
bool IsAddress(int type) {
  return type >= LUA_TTABLE || type == LUA_TLIGHTUSERDATA;
}

/** True if the place of such keys in a table depends on the run: strings have seeded hashes. */
bool IsHashed(int type) {
  return type == LUA_TSTRING || IsAddress(type);
}

/** next(table [, key]) */
int Next(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  CLuaParameters::ReadAll(state, 1);
  lua_settop(state, 2);
  // without a key, the caller may only test whether the table is empty
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

/** tostring(value), print(...), and string.format(format, ...) with FIRST = 2 */
template <int FIRST>
int ConvertToText(lua_State* state) {
  for (int i = lua_gettop(state); i >= FIRST; --i) {
    CheckText(state, i);
  }
  return RunOriginal(state);
}

/** math.randomseed([number [, number]]) */
int SeedRandom(lua_State* state) {
  if (lua_isnone(state, 1)) {
    CLuaState::Of(state).WarnOnce(
        state, ELuaVariation::Seed,
        "math.randomseed() without a number draws a seed that differs from run to run; without the "
        "call, math.random() has the seed of the experiment");
  }
  // not in place: it has upvalues
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  lua_call(state, lua_gettop(state) - 1, LUA_MULTRET);
  return lua_gettop(state);
}

constexpr const char* kClock =
    " depends on the clock of the machine, so runs differ in all that depends on it";

/** os.time([table]) */
int ReadTime(lua_State* state) {
  if (lua_isnoneornil(state, 1)) {
    CLuaState::Of(state).WarnOnce(state, ELuaVariation::Time, "os.time()", kClock);
  }
  return RunOriginal(state);
}

/** os.clock() */
int ReadClock(lua_State* state) {
  CLuaState::Of(state).WarnOnce(state, ELuaVariation::Clock, "os.clock()", kClock);
  return RunOriginal(state);
}

/** os.date([format [, time]]) */
int FormatDate(lua_State* state) {
  if (lua_isnoneornil(state, 2)) {
    CLuaState::Of(state).WarnOnce(state, ELuaVariation::Date, "os.date()", kClock);
  }
  return RunOriginal(state);
}

/** rawget(table, key) */
int GetRaw(lua_State* state) {
  CLuaParameters::Open(state, 1);
  return RunOriginal(state);
}

// Functions that loop in C. What they copy costs about as much as an instruction for each value.

/** string.rep(s, n [, sep]) */
int RepeatString(lua_State* state) {
  std::size_t length = 0;
  luaL_checklstring(state, 1, &length);
  const lua_Integer count = luaL_checkinteger(state, 2);
  std::size_t separator = 0;
  luaL_optlstring(state, 3, "", &separator);
  if (length + separator == 0) {
    // Lua would copy nothing, n times
    lua_pushliteral(state, "");
    return 1;
  }
  // Lua refuses at once what does not fit into the memory
  constexpr UInt64 kPiecesPerInstruction = 4;
  const auto pieces = static_cast<UInt64>(std::max<lua_Integer>(count, 0));
  if (pieces <= CLuaState::Of(state).GetLargestBlock() / (length + separator)) {
    CountWork(state, pieces / kPiecesPerInstruction);
  }
  return RunOriginal(state);
}

/** Counts the values from one number to another; Lua's function checks the arguments. */
void CountValues(lua_State* state, lua_Integer from, lua_Integer to) {
  if (from < to) {
    CountWork(state, static_cast<UInt64>(to) - static_cast<UInt64>(from));
  }
}

/** table.move(a, from, to, t [, b]) */
int MoveValues(lua_State* state) {
  CountValues(state, lua_tointeger(state, 2), lua_tointeger(state, 3));
  return RunOriginal(state);
}

/** table.insert(t, position, value), 3 arguments, and table.remove(t, position), 2 */
template <int ARGUMENTS>
int ShiftValues(lua_State* state) {
  if (lua_gettop(state) == ARGUMENTS && lua_istable(state, 1)) {
    CountValues(state, lua_tointeger(state, 2), luaL_len(state, 1));
  }
  return RunOriginal(state);
}

/** table.concat(t [, separator [, from [, to]]]) */
int ConcatenateValues(lua_State* state) {
  if (lua_istable(state, 1)) {
    CountValues(state, lua_tointeger(state, 3),
                lua_isnoneornil(state, 4) ? luaL_len(state, 1) : lua_tointeger(state, 4));
  }
  return RunOriginal(state);
}

// Coroutines.

int CreateCoroutine(lua_State* state) {
  CountWork(state, CLuaSandbox::kInstructionsOfCoroutine);
  return RunOriginal(state);
}

/** coroutine.close(co) */
int CloseCoroutine(lua_State* state) {
  if (CLuaState::Of(state).WasInterrupted()) {
    CountWork(state, 1);
  }
  return RunOriginal(state);
}

/** Moves the values on top of one stack to another. */
bool MoveOnStack(lua_State* from, lua_State* to, int count, const char* error) {
  if (lua_checkstack(to, count + 1) == 0) {
    lua_pop(from, count);
    lua_pushstring(to, error);
    return false;
  }
  lua_xmove(from, to, count);
  return true;
}

/** The function that coroutine.wrap() returns; its upvalue is the coroutine. */
int ResumeWrapped(lua_State* state) {
  lua_State* const coroutine = lua_tothread(state, lua_upvalueindex(1));
  const int numArguments = lua_gettop(state);
  if (lua_checkstack(coroutine, numArguments) == 0) {
    return luaL_error(state, "too many arguments to resume");
  }
  lua_xmove(state, coroutine, numArguments);
  int numResults = 0;
  int status = lua_resume(coroutine, state, numArguments, &numResults);
  if (status == LUA_OK || status == LUA_YIELD) {
    if (!MoveOnStack(coroutine, state, numResults, "too many results to resume")) {
      return lua_error(state);
    }
    return numResults;
  }
  const int ownStatus = lua_status(coroutine);
  if (ownStatus != LUA_OK && ownStatus != LUA_YIELD && !CLuaState::Of(state).WasInterrupted()) {
    // the coroutine has failed: close its variables
    status = lua_resetthread(coroutine);
  }
  lua_xmove(coroutine, state, 1);
  if (status != LUA_ERRMEM && lua_type(state, -1) == LUA_TSTRING) {
    luaL_where(state, 1);
    lua_insert(state, -2);
    lua_concat(state, 2);
  }
  return lua_error(state);
}

/** coroutine.wrap(); its upvalue is coroutine.create(). */
int WrapCoroutine(lua_State* state) {
  CreateCoroutine(state);
  lua_pushcclosure(state, ResumeWrapped, 1);
  return 1;
}

// What acts on the whole process.

int Exit(lua_State* state) {
  return luaL_error(state,
                    "os.exit() ends the whole process; to stop this script, call error(), and to "
                    "end the run, simulation.finish() in Lua loop functions");
}

int SetLocale(lua_State* state) {
  if (!lua_isnoneornil(state, 1)) {
    return luaL_error(state,
                      "os.setlocale() changes the locale of the whole process; numbers always have "
                      "a decimal point here");
  }
  return RunOriginal(state);
}

/** log(...) and logerr(...) */
int CountLog(lua_State* state) {
  std::size_t bytes = 0;
  for (int i = lua_gettop(state); i > 0; --i) {
    constexpr std::size_t kUsualSize = 16;
    bytes += lua_type(state, i) == LUA_TSTRING ? lua_rawlen(state, i) : kUsualSize;
  }
  CLuaState::Of(state).CountText(state, bytes + 1);
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  lua_call(state, lua_gettop(state) - 1, 0);
  return 0;
}

// Bytecode and libraries.

constexpr const char* kTextOnly = "t";

/** Replaces the mode of a function that loads, "bt" by default, by "t". */
void ForceText(lua_State* state, int index) {
  const std::string_view mode = luaL_optstring(state, index, kTextOnly);
  if (mode.find('t') == std::string_view::npos) {
    luaL_error(state, "bytecode is off; it needs unsafe=\"true\" in <params>");
  }
  lua_settop(state, std::max(lua_gettop(state), index));
  lua_pushstring(state, kTextOnly);
  lua_replace(state, index);
}

/** load(chunk [, name [, mode [, environment]]]) */
int LoadText(lua_State* state) {
  ForceText(state, 3);
  return RunOriginal(state);
}

/** loadfile([name [, mode [, environment]]]) */
int LoadTextFile(lua_State* state) {
  ForceText(state, 2);
  return RunOriginal(state);
}

int FinishFile(lua_State* state, int, lua_KContext) {
  return lua_gettop(state) - 1;
}

/** dofile([name]) */
int RunTextFile(lua_State* state) {
  const char* const name = luaL_optstring(state, 1, nullptr);
  lua_settop(state, 1);
  if (luaL_loadfilex(state, name, kTextOnly) != LUA_OK) {
    return luaL_error(state, "dofile: %s", lua_tostring(state, -1));
  }
  lua_callk(state, 0, LUA_MULTRET, 0, FinishFile);
  return FinishFile(state, LUA_OK, 0);
}

/** The searcher of require() for files; its upvalues are package.searchpath() and "package". */
int SearchTextFile(lua_State* state) {
  const char* const module = luaL_checkstring(state, 1);
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_pushvalue(state, 1);
  if (lua_getfield(state, lua_upvalueindex(2), "path") != LUA_TSTRING) {
    return luaL_error(state, "package.path must be a string");
  }
  lua_call(state, 2, 2);
  if (lua_isnil(state, -2)) {
    return 1;  // the places that were searched
  }
  lua_pop(state, 1);
  const char* const file = lua_tostring(state, -1);
  if (luaL_loadfilex(state, file, kTextOnly) != LUA_OK) {
    return luaL_error(state, "error loading module '%s' from file '%s':\n\t%s", module, file,
                      lua_tostring(state, -1));
  }
  lua_pushstring(state, file);
  return 2;
}

/** A function that is off; its upvalue is its name. */
int Refuse(lua_State* state) {
  return luaL_error(state, "%s() is off; it needs unsafe=\"true\" in <params>",
                    lua_tostring(state, lua_upvalueindex(1)));
}

int RefuseHook(lua_State* state) {
  return luaL_error(state,
                    "debug.sethook() would replace the limit of instructions; it needs "
                    "max_instructions=\"0\" in <params>");
}

// Finalizers.

/** setmetatable(table, metatable) */
int SetMetatable(lua_State* state) {
  CLuaParameters::Open(state, 1);
  if (!CLuaState::Of(state).IsUnsafe() && lua_istable(state, 2)) {
    lua_pushliteral(state, "__gc");
    if (lua_rawget(state, 2) != LUA_TNIL) {
      return luaL_error(state,
                        "setmetatable: finalizers (__gc) are off, because no limit interrupts "
                        "them; they need unsafe=\"true\" in <params>");
    }
    lua_pop(state, 1);
  }
  return RunOriginal(state);
}

/** Makes getmetatable() return false for values with the metatable on top; pops it. */
void HideMetatable(lua_State* state) {
  lua_pushboolean(state, 0);
  lua_setfield(state, -2, "__metatable");
  lua_pop(state, 1);
}

// Installation.

struct SReplacement {
  const char* Library;
  const char* Name;
  lua_CFunction Function;
};

// the original function becomes an upvalue
constexpr SReplacement kAlways[] = {{"string", "rep", RepeatString},
                                    {"table", "move", MoveValues},
                                    {"table", "insert", ShiftValues<3>},
                                    {"table", "remove", ShiftValues<2>},
                                    {"table", "concat", ConcatenateValues},
                                    {"coroutine", "close", CloseCoroutine},
                                    {"os", "setlocale", SetLocale},
                                    {"os", "exit", Exit},
                                    {LUA_GNAME, "log", CountLog},
                                    {LUA_GNAME, "logerr", CountLog},
                                    {LUA_GNAME, "next", Next},
                                    {LUA_GNAME, "tostring", ConvertToText<1>},
                                    {LUA_GNAME, "print", ConvertToText<1>},
                                    {"string", "format", ConvertToText<2>},
                                    {"math", "randomseed", SeedRandom},
                                    {"os", "time", ReadTime},
                                    {"os", "clock", ReadClock},
                                    {"os", "date", FormatDate},
                                    {LUA_GNAME, "rawget", GetRaw},
                                    {LUA_GNAME, "setmetatable", SetMetatable}};

constexpr SReplacement kSafe[] = {{LUA_GNAME, "load", LoadText},
                                  {LUA_GNAME, "loadfile", LoadTextFile},
                                  {LUA_GNAME, "dofile", RunTextFile}};

constexpr const char* kRefusedOfDebug[] = {
    "debug",        "getlocal",       "getmetatable", "getregistry", "getupvalue",
    "getuservalue", "setcstacklimit", "sethook",      "setlocal",    "setmetatable",
    "setupvalue",   "setuservalue",   "upvalueid",    "upvaluejoin"};

/** The library must be on top of the stack. */
void Replace(lua_State* state, const char* name, const char* original, lua_CFunction function) {
  lua_getfield(state, -1, original);
  lua_pushcclosure(state, function, 1);
  lua_setfield(state, -2, name);
}

void ReplaceAll(lua_State* state, const SReplacement* first, const SReplacement* last) {
  for (const SReplacement* entry = first; entry != last; ++entry) {
    lua_getglobal(state, entry->Library);
    Replace(state, entry->Name, entry->Name, entry->Function);
    lua_pop(state, 1);
  }
}

/** The library must be on top of the stack. */
void RefuseFunction(lua_State* state, const char* library, const char* name) {
  lua_pushfstring(state, "%s.%s", library, name);
  lua_pushcclosure(state, Refuse, 1);
  lua_setfield(state, -2, name);
}

void RefuseLibraries(lua_State* state) {
  lua_getglobal(state, LUA_LOADLIBNAME);
  RefuseFunction(state, LUA_LOADLIBNAME, "loadlib");
  lua_pushliteral(state, "");
  lua_setfield(state, -2, "cpath");
  // the searchers are: package.preload, files, libraries, libraries of all packages
  lua_getfield(state, -1, "searchers");
  lua_getfield(state, -2, "searchpath");
  lua_pushvalue(state, -3);
  lua_pushcclosure(state, SearchTextFile, 2);
  lua_rawseti(state, -2, 2);
  for (int searcher = 4; searcher > 2; --searcher) {
    lua_pushnil(state);
    lua_rawseti(state, -2, searcher);
  }
  lua_pop(state, 2);
}

void RefuseDebug(lua_State* state) {
  lua_getglobal(state, LUA_DBLIBNAME);
  for (const char* const name : kRefusedOfDebug) {
    RefuseFunction(state, LUA_DBLIBNAME, name);
  }
  lua_pop(state, 1);
}

void HideMetatables(lua_State* state) {
  luaL_getmetatable(state, LUA_FILEHANDLE);
  HideMetatable(state);
  CLuaType<CVector2>::Push(state, CVector2());
  CLuaType<CVector3>::Push(state, CVector3());
  CLuaType<CQuaternion>::Push(state, CQuaternion());
  for (int i = 0; i < 3; ++i) {
    lua_getmetatable(state, -1);
    HideMetatable(state);
    lua_pop(state, 1);
  }
}

}  // namespace

void CLuaSandbox::Install(lua_State* state, const SLuaLimits& limits) {
  lua_pushglobaltable(state);
  Replace(state, "pairs", "next", Pairs);
  lua_getglobal(state, LUA_COLIBNAME);
  Replace(state, "wrap", "create", WrapCoroutine);
  Replace(state, "create", "create", CreateCoroutine);
  lua_pop(state, 2);
  ReplaceAll(state, std::begin(kAlways), std::end(kAlways));
  if (!limits.IsUnsafe) {
    ReplaceAll(state, std::begin(kSafe), std::end(kSafe));
    RefuseLibraries(state);
    RefuseDebug(state);
    HideMetatables(state);
  } else if (limits.MaxInstructions > 0) {
    lua_getglobal(state, LUA_DBLIBNAME);
    lua_pushcfunction(state, RefuseHook);
    lua_setfield(state, -2, "sethook");
    lua_pop(state, 1);
  }
}

}  // namespace argos
