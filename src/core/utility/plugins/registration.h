#ifndef ARGOS3_CORE_UTILITY_PLUGINS_REGISTRATION_H
#define ARGOS3_CORE_UTILITY_PLUGINS_REGISTRATION_H

/*
 * What every factory shares: the build id of a plug-in, and the problems met while a library
 * registers its plug-ins. Those happen inside dlopen(), where nothing can be thrown, so they are
 * recorded here and thrown by CDynamicLoading::LoadLibrary(), or by ThrowRegistrationProblems() for
 * libraries that the program was linked with.
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
 * All that must be equal for a plug-in to fit the core: "name=value" pairs, ';' between them, as a
 * std::string. The options that change layouts come first; then, for each library of this ARGoS,
 * the hash of its public headers. A macro, so that it describes the including source.
 */
#define ARGOS_BUILD_ID                                                                   \
  (std::string(ARGOS_BUILD_ID_REAL_ ARGOS_BUILD_ID_STRING_ ARGOS_BUILD_ID_CONTAINERS_) + \
   ARGOS_HEADERS_ID)
#endif

/** The build id that the core library was compiled with. */
const char* GetCoreBuildId();

/** The path of the library, or of the program, that holds a function; "(unknown)" if none does. */
std::string GetLibraryOf(const void* function);

/**
 * Records that a library was built against another version of the headers, or with other options.
 * @return false if the id is the core's, and nothing was recorded.
 */
bool RecordIfBuildDiffers(const std::string& buildId, const std::string& library);

/** Records that a label is registered by two libraries, or twice by one. */
void RecordDuplicateLabel(const std::string& label, const std::string& kind,
                          const std::string& firstLibrary, const std::string& secondLibrary);

/**
 * Throws what was recorded, and forgets it.
 * @param context  how the message begins; without problems, nothing happens.
 * @throws CARGoSException that lists every problem, one a line.
 */
void ThrowRegistrationProblems(const std::string& context);

/** Where CDynamicLoading looks for libraries: for messages about a label that nobody registered. */
std::vector<std::string> GetPluginSearchPaths();

namespace detail {
[[noreturn]] void ThrowUnknownLabel(const std::string& kind, const std::string& label,
                                    const std::vector<std::string>& registered);
}

}  // namespace argos

#endif
