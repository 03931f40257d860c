#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_SCRIPT_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_SCRIPT_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/wrappers/lua/lua_source.h>

#include <atomic>
#include <memory>
#include <string>

namespace argos {

/** A script, compiled once and shared by all robots that run it. */
struct SLuaScript {
  std::string Path; /**< is as the user wrote it, or where it was found instead */
  std::string Folder; /**< folder of the file, for require() */
  std::string Bytecode;
  SLuaSource Source;
  /** Bits of ELuaVariation: the warnings that were logged. */
  std::shared_ptr<std::atomic<UInt32>> Variations = std::make_shared<std::atomic<UInt32>>(0);

  /**
   * Finds and compiles a script. Returns the compiled script again while it is in use and the file
   * has not changed. Safe on any thread.
   * @param name            relative names start at the working directory or, if there is no such
   *                        file, at the folder of the experiment file.
   * @param experimentFile  may be empty.
   * @param allowBytecode   the file may be precompiled, as by luac; wrong bytecode crashes Lua.
   * @throws CARGoSException if there is no such file, with the places that were searched, or if it
   * has a syntax error, with Lua's message.
   */
  static std::shared_ptr<const SLuaScript> Load(const std::string& name,
                                                const std::string& experimentFile,
                                                bool allowBytecode = false);

  /**
   * Compiles another text in place of the file of a script. No file is read or written.
   * @param text  source, no bytecode.
   * @throws CARGoSException for a syntax error, with Lua's message, or for bytecode.
   */
  std::shared_ptr<const SLuaScript> MakeVariant(const std::string& text) const;

  /**
   * The text of the file, without a byte order mark or a first line for the shell, which leaves
   * the numbers of lines as they are.
   * @throws CARGoSException if it cannot be read.
   */
  std::string ReadText() const;
};

}  // namespace argos

#endif
