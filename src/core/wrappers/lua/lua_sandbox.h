#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_SANDBOX_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_SANDBOX_H

#include <argos3/core/utility/datatypes/datatypes.h>

struct lua_State;

namespace argos {

struct SLuaLimits;

/**
 * Changes the standard libraries of a CLuaState, so that a script does not affect others and its
 * limits hold:
 *
 * - pairs() visits keys in a fixed order.
 * - What differs from run to run (os.time(), addresses, ...) gives a warning: see ELuaVariation.
 * - os.exit() and os.setlocale() with a locale are errors: they act on the whole process.
 * - Calls that loop in C (table.move, string.rep, ...) count as instructions, and so does the
 *   creation of a coroutine, which has a counter of its own.
 * - An interrupted coroutine is not closed: no limit interrupts its __close metamethods.
 *
 * Unless the script is unsafe:
 *
 * - load(), loadfile(), dofile() and require() accept source text only; package.loadlib() is an
 *   error, and require() finds no libraries. Wrong bytecode crashes Lua.
 * - Of "debug", only traceback(), getinfo() and gethook() are there: the others change types,
 *   upvalues and the stack of C functions.
 * - A metatable with __gc is an error, and those of vectors and files are hidden: Lua counts no
 *   instructions in finalizers.
 */
class CLuaSandbox {
 public:
  /** What the creation of a coroutine counts: as long as its own counter may run. */
  static constexpr UInt64 kInstructionsOfCoroutine = 1000;

  /** @param state  belongs to a CLuaState; its libraries are open. */
  static void Install(lua_State* state, const SLuaLimits& limits);
};

}  // namespace argos

#endif
