#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_VARIATIONS_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_VARIATIONS_H

#include <argos3/core/wrappers/lua/lua_headers.h>

namespace argos {

/**
 * Functions of Lua whose results differ from run to run: these run them, and warn once for each
 * script. CLuaSandbox makes scripts call them.
 */
class CLuaVariations {
 public:
  /** next(table [, key]) */
  static int Next(lua_State* state, lua_CFunction original);
  /** tostring(value), print(...), and string.format(format, ...) with FIRST = 2 */
  template <int FIRST>
  static int ConvertToText(lua_State* state, lua_CFunction original);
  /** math.randomseed([number [, number]]); its upvalue is Lua's function. */
  static int SeedRandom(lua_State* state);
  /** os.time([table]) */
  static int ReadTime(lua_State* state, lua_CFunction original);
  /** os.clock() */
  static int ReadClock(lua_State* state, lua_CFunction original);
  /** os.date([format [, time]]) */
  static int FormatDate(lua_State* state, lua_CFunction original);
};

}  // namespace argos

#endif
