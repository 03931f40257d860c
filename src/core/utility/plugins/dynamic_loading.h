#ifndef ARGOS3_CORE_UTILITY_PLUGINS_DYNAMIC_LOADING_H
#define ARGOS3_CORE_UTILITY_PLUGINS_DYNAMIC_LOADING_H

#include <argos3/core/config.h>

#include <string>

namespace argos {

/**
 * Loads shared libraries, whose REGISTER_* macros then register their plug-ins.
 *
 * A library is looked for in this order:
 *   1. a name that begins with '/': only there;
 *   2. otherwise, in each directory of the environment variable ARGOS_PLUGIN_PATH (colons between
 * them), then in the current directory, then in the default directories: lib/argos3 of the
 * installation that the running core library belongs to, the folder of that library, and lib/argos3
 * below the configured installation prefix. In each place the name is tried as it is, then with
 * ".so" (the suffixes of config.h). Symbols are bound lazily and are visible to libraries loaded
 * later. A library that was loaded once stays in the process until its end.
 *
 * Thread safe; a thread waits while another one loads a library.
 */
class CDynamicLoading {
 public:
  typedef void* TDLHandle;

  /**
   * Loads a library. One that is loaded already, under this name or another, is not loaded again.
   * @return the operating system's handle.
   * @throws CARGoSException if no attempt succeeds, listing each with its reason; if the library
   * was built against another version or with other options than the core; if it registers a label
   *         that another library has.
   */
  static TDLHandle LoadLibrary(const std::string& lib);

  /**
   * Forgets that a library was loaded. It stays in memory, because objects made by its code may
   * live on.
   * @throws CARGoSException if it was not loaded.
   */
  static void UnloadLibrary(const std::string& lib);

  /**
   * Loads every library in the directories of ARGOS_PLUGIN_PATH, then in the default directories,
   * by name within each. A library whose file name an earlier directory had is skipped. A directory
   * that cannot be read is a warning.
   * @throws CARGoSException if a library does not load.
   */
  static void LoadAllLibraries();

  /** Forgets all libraries. */
  static void UnloadAllLibraries();
};

}  // namespace argos

#endif
