#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_KEYS_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_KEYS_H

struct lua_State;

namespace argos {

/** Free slots that PushOrderedKeys() needs on the stack, the list that it pushes included. */
inline constexpr int kOrderedKeysStack = 4;

/**
 * Pushes a list of the keys of a table in a fixed order: numbers ascending, then strings by their
 * bytes, false, true; last, in Lua's own order, values that are identified by their addresses.
 *
 * Lua's own order of strings changes from run to run, because it mixes the time and an address into
 * their hashes. Memory comes from the state alone.
 * @param index  of the table on the stack.
 * @return true if the order is the same in each run: at most one key is identified by its address.
 */
bool PushOrderedKeys(lua_State* state, int index);

}  // namespace argos

#endif
