#ifndef ARGOS3_CORE_UTILITY_PLUGINS_REGISTRATION_H
#define ARGOS3_CORE_UTILITY_PLUGINS_REGISTRATION_H

/*
 * Shared by all factories: the build id of plug-ins, and problems found while a library registers
 * its plug-ins. Registration happens inside dlopen(), where nothing can be thrown, so problems are
 * recorded here and thrown by CDynamicLoading::LoadLibrary(), or by ThrowRegistrationProblems() for
 * libraries that are linked to the program.
 */

#include <argos3/core/build_id.h>
#include <argos3/core/config.h>

#include <cstddef>
#include <string>
#include <typeinfo>
#include <vector>

namespace argos {

#ifdef ARGOS_USE_DOUBLE
#define ARGOS_BUILD_ID_REAL_ "real=double"
#else
#define ARGOS_BUILD_ID_REAL_ "real=float"
#endif

// both change the layout of the standard library's classes
#if defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI
#define ARGOS_BUILD_ID_STRING_ ";string=old"
#else
#define ARGOS_BUILD_ID_STRING_ ";string=new"
#endif
#ifdef _GLIBCXX_DEBUG
#define ARGOS_BUILD_ID_CONTAINERS_ ";containers=debug"
#else
#define ARGOS_BUILD_ID_CONTAINERS_ ";containers=release"
#endif

#ifndef ARGOS_BUILD_ID
/**
 * The properties that a plug-in and the core must have in common, as a std::string: "name=value"
 * pairs, separated by ';'. First the options that change layouts; then, for each library of this
 * ARGoS, the hash of its public headers. A macro, so that it describes the compilation of the
 * including source.
 */
#define ARGOS_BUILD_ID                                                                   \
  (std::string(ARGOS_BUILD_ID_REAL_ ARGOS_BUILD_ID_STRING_ ARGOS_BUILD_ID_CONTAINERS_) + \
   ARGOS_HEADERS_ID)
#endif

/** The build id of the core library. */
const char* GetCoreBuildId();

/**
 * The path of the library, or of the program, that contains a function or an object; "(unknown)" if
 * none does.
 */
std::string GetLibraryOf(const void* address);

/**
 * Records that a library was built against another version of the headers, or with other options.
 * @return true if the ids differ.
 */
bool RecordIfBuildDiffers(const std::string& buildId, const std::string& library);

/** What is compared of two classes that are registered under one label. */
struct SRegisteredClass {
  const std::type_info* Type = nullptr;
  /**
   * Bytes of an object. Two versions of a class differ in it: libraries that contain both must not
   * be loaded together, because the dynamic linker gives them the functions of one version.
   */
  std::size_t Size = 0;

  /** By name and size, because each library may have its own type_info of a class. */
  bool operator==(const SRegisteredClass& other) const;
};

/** A class, and the library that has registered it. */
struct SRegistration {
  std::string Library;
  SRegisteredClass Class;
};

/**
 * Records that a label is registered by two libraries, or twice by one: as a warning if the classes
 * are the same, else as a problem.
 */
void RecordDuplicateLabel(const std::string& label, const std::string& kind,
                          const SRegistration& first, const SRegistration& second);

/**
 * Records that a registered class has the name of a class of a library that was loaded before: the
 * dynamic linker gives it the functions of that one. A problem if the sizes differ, else a warning,
 * because both may have the same source. Does nothing if the library itself has no such class.
 */
void RecordIfOfOtherLibrary(const std::string& label, const SRegistration& registration);

/**
 * Writes the recorded warnings to LOGERR, throws the recorded problems, and clears both records.
 * @param context  start of the message. Does nothing if there are no problems.
 * @throws CARGoSException that lists every problem, one per line.
 */
void ThrowRegistrationProblems(const std::string& context);

/** The search paths of CDynamicLoading, for messages about unregistered labels. */
std::vector<std::string> GetPluginSearchPaths();

namespace detail {

/**
 * Opens the library with a label of a kind, which is typeid() of the factory's base class, if it is
 * not open. If no known library has it, loads all plug-ins, if
 * CDynamicLoading::LoadAllLibrariesOnDemand() was called and they were not loaded before. Called
 * for a label that is not registered; waits while another thread loads.
 * @throws CARGoSException if a plug-in does not load.
 */
void LoadPluginsFor(const std::type_info& kind, const std::string& label);

/** Opens all libraries that have labels of a kind. @throws CARGoSException if one does not load. */
void LoadPluginsOfKind(const std::type_info& kind);

/** The labels of a kind in libraries that are not open yet. */
std::vector<std::string> ListUnopenedLabels(const std::type_info& kind);

/** Forgets the labels of a kind in libraries that are not open yet. */
void ForgetUnopenedLabels(const std::type_info& kind);

/** Keeps that a library has registered a label of a kind. */
void NoteRegistration(const std::type_info& kind, const std::string& label,
                      const std::string& library);

/**
 * @return true if this thread is opening a library at the first use of one of its labels: what it
 *   registers counts as registered before everything else.
 */
bool IsRegisteringLate();

[[noreturn]] void ThrowUnknownLabel(const std::string& kind, const std::string& label,
                                    const std::vector<std::string>& registered);
}  // namespace detail

}  // namespace argos

#endif
