#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_SCRIPT_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_SCRIPT_H

#include <memory>
#include <string>

namespace argos {

/** A script, compiled once for all who run it. */
struct SLuaScript {
  std::string Path; /**< as in messages: what the user wrote, or where it was found instead */
  std::string Folder; /**< where it lies, for require() */
  std::string Bytecode;

  /**
   * Finds and compiles a script; gives the compiled one again if somebody has it and the file has
   * not changed since. Safe on any thread.
   * @param name            relative names start at the working directory or, if there is no such
   *                        file, at the folder of the experiment file.
   * @param experimentFile  may be empty.
   * @throws CARGoSException if there is no such file, with the places looked at, or if it has a
   * syntax error, with Lua's message.
   */
  static std::shared_ptr<const SLuaScript> Load(const std::string& name,
                                                const std::string& experimentFile);
};

}  // namespace argos

#endif
