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

#include <string>
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
 * The path of the library, or of the program, that contains a function; "(unknown)" if none does.
 */
std::string GetLibraryOf(const void* function);

/**
 * Records that a library was built against another version of the headers, or with other options.
 * @return true if the ids differ.
 */
bool RecordIfBuildDiffers(const std::string& buildId, const std::string& library);

/** Records that a label is registered by two libraries, or twice by one. */
void RecordDuplicateLabel(const std::string& label, const std::string& kind,
                          const std::string& firstLibrary, const std::string& secondLibrary);

/**
 * Throws the recorded problems and clears the record.
 * @param context  start of the message. Does nothing if there are no problems.
 * @throws CARGoSException that lists every problem, one per line.
 */
void ThrowRegistrationProblems(const std::string& context);

/** The search paths of CDynamicLoading, for messages about unregistered labels. */
std::vector<std::string> GetPluginSearchPaths();

namespace detail {

/**
 * Loads all plug-ins if CDynamicLoading::LoadAllLibrariesOnDemand() was called and they were not
 * loaded before. Called for a label that is not registered; waits while another thread loads.
 * @throws CARGoSException if a plug-in does not load.
 */
void LoadPluginsFor(const std::string& label);

[[noreturn]] void ThrowUnknownLabel(const std::string& kind, const std::string& label,
                                    const std::vector<std::string>& registered);
}  // namespace detail

}  // namespace argos

#endif
