#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_SOURCE_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_SOURCE_H

#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace argos {

/**
 * What the text of a script mentions, and that of the files that it loads by require() and
 * dofile(). Found without running it, so functions that run later count, too.
 */
struct SLuaSource {
  /** Fields that are read of a table "params": params.speed, params["speed"]. */
  std::set<std::string> Parameters;
  /** All fields and all texts: x.speed, "speed". */
  std::set<std::string> Words;
  /** How often a name is there, as a variable or a field. */
  std::map<std::string, std::size_t> NumUses;
  /** "params" is passed on, or has a computed index: each of the words may be a parameter. */
  bool PassesParameters = false;
  /** All parameters are visited, or there is code that cannot be read. */
  bool UsesAllParameters = false;

  /** @return true if the script may read that field of the table "params". */
  bool MayUseParameter(const std::string& name) const;
  std::size_t CountUses(const std::string& name) const;

  /**
   * @param text    of the script; bytecode uses all parameters.
   * @param folder  of the script, where require() searches first.
   */
  static SLuaSource Read(const std::string& text, const std::string& folder);
};

}  // namespace argos

#endif
