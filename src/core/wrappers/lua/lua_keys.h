#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_KEYS_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_KEYS_H

struct lua_State;

namespace argos {

/**
 * Pushes a list of the keys of a table in a fixed order: numbers ascending, then strings by their
 * bytes, false, true; last, in Lua's own order, what is identified by its address.
 *
 * Lua's own order of strings changes from run to run, because it mixes the time and an address into
 * their hashes.
 * @param index  of the table on the stack.
 */
void PushOrderedKeys(lua_State* state, int index);

}  // namespace argos

#endif
