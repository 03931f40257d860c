#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_MISSING_NAMES_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_MISSING_NAMES_H

#include <string>

struct lua_State;

namespace argos {

/**
 * Explains an error that a misspelt name has caused, such as "attempt to index a nil value", or
 * fields of numbers that a sensor gives.
 *
 * Reads the line of the script that failed; if the message names only a local variable, or nothing,
 * also the lines that give it a value, and those before it.
 *
 * @param message  Lua's message, without a traceback.
 * @param file     script; empty if the code is not in a file.
 * @param line     where the innermost function in Lua was.
 * @return '; robot has no "whels": did you mean "wheels"?', to follow the message; empty if no name
 *   in the script explains the error.
 */
std::string ExplainMissingName(lua_State* state, const std::string& message,
                               const std::string& file, int line);

}  // namespace argos

#endif
