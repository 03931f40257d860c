#ifndef ARGOS3_CORE_UTILITY_PLUGINS_DYNAMIC_LOADING_H
#define ARGOS3_CORE_UTILITY_PLUGINS_DYNAMIC_LOADING_H

#include <argos3/core/config.h>

#include <string>

namespace argos {

/**
 * Loads shared libraries, whose REGISTER_* macros then register their plug-ins.
 *
 * Search order of a library:
 *   1. a name that begins with '/': only that path;
 *   2. otherwise, in each directory of the environment variable ARGOS_PLUGIN_PATH (separated by
 * colons), then in the default directories: lib/argos3 of the installation of the running core
 * library, the folder of that library, and lib/argos3 below the configured installation prefix;
 * then in their subfolder experiments, whose libraries only their names load; then in the current
 * directory. It comes last so that a file there does not replace an installed library. In each
 * directory the name is tried as given, then with ".so" (the suffixes of config.h). Symbols are
 * bound lazily and are visible to libraries loaded later. A loaded library stays in the process
 * until its end.
 *
 * Thread safe; a thread waits while another one loads a library.
 */
class CDynamicLoading {
 public:
  typedef void* TDLHandle;

  /**
   * Loads a library, unless it is already loaded, under this name or another.
   * @return the operating system's handle.
   * @throws CARGoSException if no attempt succeeds, with the reason of each; if the library was
   *   built against another version or with other options than the core; if it registers a label
   *   that another library has registered.
   */
  static TDLHandle LoadLibrary(const std::string& lib);

  /**
   * Marks a library as not loaded. It stays in memory, because objects created by its code may
   * still exist.
   * @throws CARGoSException if it was not loaded.
   */
  static void UnloadLibrary(const std::string& lib);

  /**
   * Loads every library in the directories of ARGOS_PLUGIN_PATH, then in the default directories,
   * by name within each. Skips a library whose file name was found in an earlier directory. Warns
   * of a directory that cannot be read.
   * @throws CARGoSException if a library does not load, or if the process has incompatible ones.
   */
  static void LoadAllLibraries();

  /**
   * From here on the first label that no factory knows calls LoadAllLibraries(), once per process
   * and not if it was called already. For programs that embed the simulator: loading an experiment
   * calls this function, so that a program needs to link no plug-in.
   */
  static void LoadAllLibrariesOnDemand();

  /** Marks all libraries as not loaded. */
  static void UnloadAllLibraries();
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/logging/argos_log.h>
#endif

#endif
