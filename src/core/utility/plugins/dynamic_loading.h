#ifndef ARGOS3_CORE_UTILITY_PLUGINS_DYNAMIC_LOADING_H
#define ARGOS3_CORE_UTILITY_PLUGINS_DYNAMIC_LOADING_H

#include <argos3/core/config.h>

#include <set>
#include <string>

namespace argos {

/**
 * Loads shared libraries, whose REGISTER_* macros then register their plug-ins.
 *
 * Search order of a library:
 *   1. a name that begins with '/': only that path;
 *   2. otherwise, in these directories, in this order:
 *      - those of the environment variable ARGOS_PLUGIN_PATH, separated by colons;
 *      - the folder of the experiment file, if there is one, and its folder build/; for a name with
 *        a slash also the folder above it, the root of many projects; the folder build/ there;
 *      - the default directories: lib/argos3 of the installation of the running core library, the
 *        folder of that library, and lib/argos3 below the configured installation prefix;
 *        then those with the libraries of the installed experiments, or of the build tree's, which
 *        only their names load;
 *      - the current directory.
 *
 * If the library is in the current directory and beside the experiment, in different files, that of
 * the current directory precedes: a user who has several build trees works in the one that is
 * meant. A warning names the files that are not loaded.
 *
 * In each directory the name is tried as given, then with ".so" (the suffixes of config.h). All
 * symbols are bound when a library is loaded, and are visible to libraries loaded later. A loaded
 * library stays in the process until its end.
 *
 * Libraries that it is linked with and that the dynamic linker does not find, as installed plug-ins
 * have no run path, are loaded before: they are searched beside it, in the default directories, and
 * in ARGOS_PLUGIN_PATH.
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
   *   that another library has registered for another class. For the same class there is a warning,
   *   and the later library counts.
   */
  static TDLHandle LoadLibrary(const std::string& lib);
  /** The same. @param experimentFile  the file that names the library. */
  static TDLHandle LoadLibrary(const std::string& lib, const std::string& experimentFile);

  /**
   * Marks a library as not loaded. It stays in memory, because objects created by its code may
   * still exist.
   * @throws CARGoSException if it was not loaded.
   */
  static void UnloadLibrary(const std::string& lib);

  /**
   * Loads every library in the default directories, then in the directories of ARGOS_PLUGIN_PATH,
   * by name within each: users' libraries need not be linked with those of this project. Libraries
   * that do not load are tried again after the others, whose symbols they may use. Skips a
   * library whose file name was found in an earlier directory of ARGOS_PLUGIN_PATH. Warns of a
   * directory that cannot be read.
   * @throws CARGoSException if a library does not load, or if the process has incompatible ones.
   */
  static void LoadAllLibraries();

  /**
   * The same, but opens each library that has an index of its labels (label_index.h), such as all
   * of this project, only when it is needed: when the first of its labels is looked up, when a
   * library that is linked with it or needs its symbols is loaded, or when a library registers one
   * of its labels, too. The labels of all are known. Errors of such libraries are thrown by these
   * look-ups.
   */
  static void LoadAllLibrariesByLabel();

  /** Opens the libraries that LoadAllLibrariesByLabel() has left and that have these labels. */
  static void LoadLibrariesOfLabels(const std::set<std::string>& labels);

  /**
   * From here on the first label that no factory knows calls LoadAllLibrariesByLabel(), once per
   * process and not if all libraries were loaded already. For programs that embed the simulator:
   * loading an experiment calls this function, so that a program needs to link no plug-in.
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
