#include <argos3/core/wrappers/lua/lua_sandbox.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_keys.h>
#include <argos3/core/wrappers/lua/lua_limits.h>
#include <argos3/core/wrappers/lua/lua_parameters.h>
#include <argos3/core/wrappers/lua/lua_state.h>
#include <argos3/core/wrappers/lua/lua_types.h>
#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/core/wrappers/lua/lua_variations.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>

// Lua leaves a C function with longjmp() when it raises an error: no object in this file may need a
// destructor. Most functions here check, and then run Lua's own function in place: its arguments
// and results stay where they are.

namespace argos {

namespace {

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
  // Lua's own order of numbers depends only on the history of the table
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

/** rawget(table, key) */
int GetRaw(lua_State* state, lua_CFunction original) {
  CLuaParameters::Open(state, 1);
  return original(state);
}

// Functions that loop in C. What they copy costs about as much as an instruction for each value.

/** string.rep(s, n [, sep]) */
int RepeatString(lua_State* state, lua_CFunction original) {
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
  return original(state);
}

/** Counts the values from one number to another; Lua's function checks the arguments. */
void CountValues(lua_State* state, lua_Integer from, lua_Integer to) {
  if (from < to) {
    CountWork(state, static_cast<UInt64>(to) - static_cast<UInt64>(from));
  }
}

/** table.move(a, from, to, t [, b]) */
int MoveValues(lua_State* state, lua_CFunction original) {
  CountValues(state, lua_tointeger(state, 2), lua_tointeger(state, 3));
  return original(state);
}

/** table.insert(t, position, value), 3 arguments, and table.remove(t, position), 2 */
template <int ARGUMENTS>
int ShiftValues(lua_State* state, lua_CFunction original) {
  if (lua_gettop(state) == ARGUMENTS && lua_istable(state, 1)) {
    CountValues(state, lua_tointeger(state, 2), luaL_len(state, 1));
  }
  return original(state);
}

/** table.concat(t [, separator [, from [, to]]]) */
int ConcatenateValues(lua_State* state, lua_CFunction original) {
  if (lua_istable(state, 1)) {
    CountValues(state, lua_tointeger(state, 3),
                lua_isnoneornil(state, 4) ? luaL_len(state, 1) : lua_tointeger(state, 4));
  }
  return original(state);
}

// Coroutines.

int CreateCoroutine(lua_State* state, lua_CFunction original) {
  CountWork(state, CLuaSandbox::kInstructionsOfCoroutine);
  return original(state);
}

/** coroutine.close(co) */
int CloseCoroutine(lua_State* state, lua_CFunction original) {
  if (CLuaState::Of(state).WasInterrupted()) {
    CountWork(state, 1);
  }
  return original(state);
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
int WrapCoroutine(lua_State* state, lua_CFunction original) {
  CreateCoroutine(state, original);
  lua_pushcclosure(state, ResumeWrapped, 1);
  return 1;
}

// What acts on the whole process.

int Exit(lua_State* state, lua_CFunction /*original*/) {
  return luaL_error(state,
                    "os.exit() ends the whole process; to stop this script, call error(), and to "
                    "end the run, simulation.finish() in Lua loop functions");
}

int SetLocale(lua_State* state, lua_CFunction original) {
  if (!lua_isnoneornil(state, 1)) {
    return luaL_error(state,
                      "os.setlocale() changes the locale of the whole process; numbers always have "
                      "a decimal point here");
  }
  return original(state);
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
int LoadText(lua_State* state, lua_CFunction original) {
  ForceText(state, 3);
  return original(state);
}

/** loadfile([name [, mode [, environment]]]) */
int LoadTextFile(lua_State* state, lua_CFunction original) {
  ForceText(state, 2);
  return original(state);
}

int FinishFile(lua_State* state, int, lua_KContext) {
  return lua_gettop(state) - 1;
}

/** dofile([name]) */
int RunTextFile(lua_State* state, lua_CFunction /*original*/) {
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

int Refuse(lua_State* state, const char* library, const char* name) {
  return luaL_error(state, "%s.%s() is off; it needs unsafe=\"true\" in <params>", library, name);
}

int RefuseHook(lua_State* state) {
  return luaL_error(state,
                    "debug.sethook() would replace the limit of instructions; it needs "
                    "max_instructions=\"0\" in <params>");
}

// Finalizers.

/** setmetatable(table, metatable) */
int SetMetatable(lua_State* state, lua_CFunction original) {
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
  return original(state);
}

/** Makes getmetatable() return false for values with the metatable on top; pops it. */
void HideMetatable(lua_State* state) {
  lua_pushboolean(state, 0);
  lua_setfield(state, -2, "__metatable");
  lua_pop(state, 1);
}

// Installation.

// A robot has a state of its own, and what is in it costs time whenever garbage is collected. So
// all functions that need nothing of a state are plain C functions, which are no objects there.

/** A function that replaces one of Lua, which it may call. */
struct SReplacement {
  const char* Library;
  const char* Name;
  int (*Function)(lua_State*, lua_CFunction original);
  const char* Original = nullptr;  // is set if the original has another name
};

constexpr SReplacement kAlways[] = {{"string", "rep", RepeatString},
                                    {"table", "move", MoveValues},
                                    {"table", "insert", ShiftValues<3>},
                                    {"table", "remove", ShiftValues<2>},
                                    {"table", "concat", ConcatenateValues},
                                    {LUA_COLIBNAME, "wrap", WrapCoroutine, "create"},
                                    {LUA_COLIBNAME, "create", CreateCoroutine},
                                    {LUA_COLIBNAME, "close", CloseCoroutine},
                                    {"os", "setlocale", SetLocale},
                                    {"os", "exit", Exit},
                                    {LUA_GNAME, "next", CLuaVariations::Next},
                                    {LUA_GNAME, "tostring", CLuaVariations::ConvertToText<1>},
                                    {LUA_GNAME, "print", CLuaVariations::ConvertToText<1>},
                                    {"string", "format", CLuaVariations::ConvertToText<2>},
                                    {"os", "time", CLuaVariations::ReadTime},
                                    {"os", "clock", CLuaVariations::ReadClock},
                                    {"os", "date", CLuaVariations::FormatDate},
                                    {LUA_GNAME, "rawget", GetRaw},
                                    {LUA_GNAME, "setmetatable", SetMetatable}};

constexpr SReplacement kSafe[] = {{LUA_GNAME, "load", LoadText},
                                  {LUA_GNAME, "loadfile", LoadTextFile},
                                  {LUA_GNAME, "dofile", RunTextFile}};

// functions with upvalues, which the replacement has as its own upvalue
struct SClosure {
  const char* Library;
  const char* Name;
  const char* Original;
  lua_CFunction Function;
};

constexpr SClosure kClosures[] = {{LUA_GNAME, "pairs", "next", Pairs},
                                  {LUA_GNAME, "log", "log", CountLog},
                                  {LUA_GNAME, "logerr", "logerr", CountLog},
                                  {"math", "randomseed", "randomseed", CLuaVariations::SeedRandom}};

constexpr const char* kRefusedOfDebug[] = {
    "debug",        "getlocal",       "getmetatable", "getregistry", "getupvalue",
    "getuservalue", "setcstacklimit", "sethook",      "setlocal",    "setmetatable",
    "setupvalue",   "setuservalue",   "upvalueid",    "upvaluejoin"};

template <const auto& REPLACEMENTS>
auto FindOriginals() {
  std::array<lua_CFunction, std::size(REPLACEMENTS)> originals;
  const std::unique_ptr<lua_State, decltype(&lua_close)> state(luaL_newstate(), lua_close);
  if (state == nullptr) {
    throw std::bad_alloc();
  }
  luaL_openlibs(state.get());
  for (size_t i = 0; i < originals.size(); ++i) {
    const SReplacement& entry = REPLACEMENTS[i];
    lua_getglobal(state.get(), entry.Library);
    lua_getfield(state.get(), -1, entry.Original != nullptr ? entry.Original : entry.Name);
    originals[i] = lua_tocfunction(state.get(), -1);
    ARGOS_ASSERT(originals[i] != nullptr && lua_getupvalue(state.get(), -1, 1) == nullptr,
                 "Lua's function " << entry.Name << " has upvalues");
    lua_pop(state.get(), 2);
  }
  return originals;
}

/** Functions of Lua's libraries, which are the same in all states. */
template <const auto& REPLACEMENTS>
const auto& GetOriginals() {
  static const auto kOriginals = FindOriginals<REPLACEMENTS>();
  return kOriginals;
}

template <const auto& REPLACEMENTS, size_t ENTRY>
int RunReplacement(lua_State* state) {
  return REPLACEMENTS[ENTRY].Function(state, GetOriginals<REPLACEMENTS>()[ENTRY]);
}

/** Replaces a field of a global table. */
void SetFunction(lua_State* state, const char* library, const char* name, lua_CFunction function) {
  lua_getglobal(state, library);
  lua_pushcfunction(state, function);
  lua_setfield(state, -2, name);
  lua_pop(state, 1);
}

template <const auto& REPLACEMENTS>
void ReplaceAll(lua_State* state) {
  GetOriginals<REPLACEMENTS>();  // must not run in a function that a script calls
  [state]<size_t... ENTRIES>(std::index_sequence<ENTRIES...>) {
    (SetFunction(state, REPLACEMENTS[ENTRIES].Library, REPLACEMENTS[ENTRIES].Name,
                 RunReplacement<REPLACEMENTS, ENTRIES>),
     ...);
  }
  (std::make_index_sequence<std::size(REPLACEMENTS)>());
}

void ReplaceClosures(lua_State* state) {
  for (const SClosure& entry : kClosures) {
    lua_getglobal(state, entry.Library);
    lua_getfield(state, -1, entry.Original);
    lua_pushcclosure(state, entry.Function, 1);
    lua_setfield(state, -2, entry.Name);
    lua_pop(state, 1);
  }
}

int RefuseLoadlib(lua_State* state) {
  return Refuse(state, LUA_LOADLIBNAME, "loadlib");
}

template <size_t ENTRY>
int RefuseOfDebug(lua_State* state) {
  return Refuse(state, LUA_DBLIBNAME, kRefusedOfDebug[ENTRY]);
}

void RefuseLibraries(lua_State* state) {
  SetFunction(state, LUA_LOADLIBNAME, "loadlib", RefuseLoadlib);
  lua_getglobal(state, LUA_LOADLIBNAME);
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
  [state]<size_t... ENTRIES>(std::index_sequence<ENTRIES...>) {
    (SetFunction(state, LUA_DBLIBNAME, kRefusedOfDebug[ENTRIES], RefuseOfDebug<ENTRIES>), ...);
  }
  (std::make_index_sequence<std::size(kRefusedOfDebug)>());
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
  ReplaceClosures(state);
  ReplaceAll<kAlways>(state);
  if (!limits.IsUnsafe) {
    ReplaceAll<kSafe>(state);
    RefuseLibraries(state);
    RefuseDebug(state);
    HideMetatables(state);
  } else if (limits.MaxInstructions > 0) {
    SetFunction(state, LUA_DBLIBNAME, "sethook", RefuseHook);
  }
}

}  // namespace argos
