#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_PARAMETERS_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_PARAMETERS_H

#include <argos3/core/utility/configuration/argos_configuration.h>

struct lua_State;

namespace argos {

class CLuaState;
struct SLuaSource;

/**
 * The table "params" of a script, with the attributes of `<params>` as strings, and the check that
 * the script uses them: what it does not use is misspelt.
 *
 * While the script is loaded, the table has no fields; its metamethods note what is read. After
 * Finish() it is a plain table.
 */
class CLuaParameters {
 public:
  /** Adds the table to the one on top of the stack. Marks no attribute as read. */
  static void Add(lua_State* state, const TConfigurationNode& params);

  /**
   * Marks the attributes as read that the script has read, and those that its text may read later,
   * in step(). The names that it reads in vain are noted, too: messages about unread attributes
   * contain the nearest of them.
   */
  static void Finish(CLuaState& state, const TConfigurationNode& params, const SLuaSource& source);

  // For functions that access the fields of a table without its metamethods.

  /** Makes the value at an index a plain table if it is the table of Add(). @return true if so. */
  static bool Open(lua_State* state, int index);
  /** The same, and notes that all of it is read. */
  static void ReadAll(lua_State* state, int index);
};

}  // namespace argos

#endif
