#include <argos3/core/utility/plugins/dynamic_loading.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/errors/signal_safe_text.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/core/utility/plugins/library_search.h>
#include <argos3/core/utility/plugins/process_wide.h>
#include <argos3/core/utility/plugins/registration.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <cxxabi.h>
#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <system_error>

namespace fs = std::filesystem;

namespace argos {

namespace {

struct SLoadedLibrary {
  CDynamicLoading::TDLHandle Handle = nullptr;
  // names under which it was requested
  std::set<std::string> Names;
};

// by resolved path
std::map<std::string, SLoadedLibrary>& LoadedLibraries() {
  static std::map<std::string, SLoadedLibrary> libraries;
  return libraries;
}

// when a factory lacks a label; guarded by the loading mutex
struct SLoadingOnDemand {
  bool IsEnabled = false;
  bool IsDone = false;
};

SLoadingOnDemand& LoadingOnDemand() {
  static SLoadingOnDemand state;
  return state;
}

// for the report of a crash
void DescribeLibrary(const void* path, CSignalSafeText& text) {
  text.Append("library \"").Append(*static_cast<const std::string*>(path)).Append("\"");
}

// demangles the C++ symbols in a message of the dynamic linker
std::string WithReadableSymbols(const std::string& message) {
  constexpr char kNameCharacters[] =
      "_$.0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  const size_t start = message.find("_Z");
  if (start == std::string::npos) {
    return message;
  }
  const size_t end = std::min(message.find_first_not_of(kNameCharacters, start), message.size());
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(message.substr(start, end - start).c_str(), nullptr, nullptr, &status),
      &std::free);
  return status == 0 ? message.substr(0, start) + name.get() + message.substr(end) : message;
}

constexpr char kNoSuchFile[] = "no such file";

// opens a library; returns null and sets the reason on failure
CDynamicLoading::TDLHandle TryOpen(const std::string& path, std::string& reason) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    reason = kNoSuchFile;
    return nullptr;
  }
  reason = FindInputProblem(path);
  if (!reason.empty()) {
    return nullptr;
  }
  // the library's constructors of static objects run now
  const CRunningCodeScope running(
      {"its static objects are being constructed", &DescribeLibrary, &path, nullptr});
  try {
    // all symbols are bound now: a missing one is an error here and not in the middle of a run. Its
    // declaration says that dlopen() never throws, which constructors do
    void* (*const volatile open)(const char*, int) = &dlopen;
    CDynamicLoading::TDLHandle handle = open(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (handle == nullptr) {
      reason = WithReadableSymbols(dlerror());
    }
    return handle;
  } catch (...) {
    ThrowWithCause("The library \"" + path +
                   "\" cannot be used: the construction of one of its "
                   "static objects threw");
  }
}

// the library of the message "libx.so: cannot open shared object file: ..."; "" for other messages
std::string NameOfMissing(const std::string& reason) {
  const size_t end = reason.find(": cannot open shared object file");
  return end == std::string::npos ? "" : reason.substr(0, end);
}

// what can be done about a failure to open a library
std::string DescribeWayOut(const std::string& reason) {
  const std::string missing = NameOfMissing(reason);
  if (!missing.empty()) {
    return "\n    It is linked with \"" + missing +
           "\", which is neither beside it nor among the plug-ins: put the folder of that library "
           "into ARGOS_PLUGIN_PATH or LD_LIBRARY_PATH, or link with -Wl,-rpath,FOLDER";
  }
  if (reason.find("undefined symbol") != std::string::npos) {
    return "\n    Link it with the library that has this symbol, or load that one before";
  }
  return "";
}

CDynamicLoading::TDLHandle TryPlace(const std::string& lib, const std::string& place,
                                    std::string& problems);

// Loads a library that another one is linked with, and which the dynamic linker does not find,
// because installed plug-ins have no run path. @return false if there is none that loads.
bool LoadNeeded(const std::string& name, const std::string& neededBy) {
  // libraries may be linked with each other
  static std::set<std::string> beingLoaded;
  if (!beingLoaded.insert(name).second) {
    return false;
  }
  struct SEnd {
    const std::string& Name;
    ~SEnd() { beingLoaded.erase(Name); }
  } const end{name};
  std::vector<std::string> directories = {fs::path(neededBy).parent_path().string()};
  for (const auto& more : {ListDefaultDirectories(), ListUserDirectories()}) {
    directories.insert(directories.end(), more.begin(), more.end());
  }
  for (const std::string& directory : directories) {
    std::error_code error;
    const std::string file = directory + '/' + name;
    std::string ignored;
    if (fs::is_regular_file(file, error) && TryPlace(file, file, ignored) != nullptr) {
      return true;
    }
  }
  return false;
}

// Opens a library after those that it is linked with; returns null and sets the reason on failure.
CDynamicLoading::TDLHandle OpenWithNeeded(const std::string& path, std::string& reason) {
  CDynamicLoading::TDLHandle handle = TryOpen(path, reason);
  std::set<std::string> tried;
  while (handle == nullptr) {
    const std::string missing = NameOfMissing(reason);
    if (missing.empty() || !tried.insert(missing).second || !LoadNeeded(missing, path)) {
      break;
    }
    handle = TryOpen(path, reason);
  }
  return handle;
}

// @param problems  of each file that is there
CDynamicLoading::TDLHandle TryPlace(const std::string& lib, const std::string& place,
                                    std::string& problems) {
  for (const std::string& suffix : ListSuffixes(lib)) {
    const std::string candidate = place + suffix;
    const std::string path = ResolvePath(candidate).string();
    const auto known = LoadedLibraries().find(path);
    if (known != LoadedLibraries().end()) {
      known->second.Names.insert(lib);
      return known->second.Handle;
    }
    std::string reason;
    const CDynamicLoading::TDLHandle handle = OpenWithNeeded(candidate, reason);
    // registrations may be invalid even if the library failed to load
    ThrowRegistrationProblems("The library \"" + candidate + "\" cannot be used:");
    if (handle != nullptr) {
      LoadedLibraries()[path] = SLoadedLibrary{handle, {lib}};
      if (CLogControl::GetLevel() == ELogLevel::Debug) {
        LOG << "[DEBUG] Loaded library \"" << candidate << "\"" << std::endl;
      }
      return handle;
    }
    if (reason != kNoSuchFile) {
      problems += "\n  " + candidate + ": " + reason + DescribeWayOut(reason);
    }
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> GetPluginSearchPaths() {
  // the first call uses the dynamic linker
  const std::lock_guard<std::recursive_mutex> lock(detail::GetLoadingMutex());
  std::vector<std::string> paths;
  for (const std::string& place : ListPlaces("", "")) {
    paths.push_back(place.substr(0, place.size() - 1));
  }
  return paths;
}

CDynamicLoading::TDLHandle CDynamicLoading::LoadLibrary(const std::string& lib) {
  return LoadLibrary(lib, "");
}

CDynamicLoading::TDLHandle CDynamicLoading::LoadLibrary(const std::string& lib,
                                                        const std::string& experimentFile) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetLoadingMutex());
  std::vector<std::string> places = ListPlaces(lib, experimentFile);
  const std::vector<SNearFile> near = FindNearFiles(lib, experimentFile);
  PutNearestFirst(places, near);
  const size_t numLoaded = LoadedLibraries().size();
  std::string searched;
  std::string problems;
  for (const std::string& place : places) {
    const TDLHandle handle = TryPlace(lib, place, problems);
    if (handle != nullptr) {
      if (LoadedLibraries().size() > numLoaded) {
        WarnOfOthers(lib, place, near);
      }
      return handle;
    }
    searched += "\n  " + place + DescribeSuffixes(lib) + ": no such file";
  }
  // a file that is there and does not load explains more than the places without one
  THROW_ARGOSEXCEPTION("The library \"" << lib << "\" cannot be loaded"
                                        << (problems.empty() ? DescribeSimilar(lib, places) : "")
                                        << "; tried:" << (problems.empty() ? searched : problems));
}

void CDynamicLoading::UnloadLibrary(const std::string& lib) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetLoadingMutex());
  auto& libraries = LoadedLibraries();
  std::vector<std::string> known;
  for (auto library = libraries.begin(); library != libraries.end(); ++library) {
    if (library->first == lib || library->second.Names.count(lib) > 0) {
      libraries.erase(library);
      return;
    }
    known.push_back(library->first);
  }
  THROW_ARGOSEXCEPTION("The library \"" << lib << "\" cannot be unloaded, because it was not loaded"
                                        << DidYouMean(lib, known));
}

void CDynamicLoading::LoadAllLibraries() {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetLoadingMutex());
  // before the first library, because libraries may look labels up while they are loaded
  LoadingOnDemand().IsDone = true;
  ThrowRegistrationProblems("the libraries linked to the program are not compatible");
  // a library may use symbols of one that follows: those that fail are tried again after the others
  std::vector<fs::path> files = ListAllLibraries();
  while (!files.empty()) {
    std::vector<fs::path> failed;
    std::string problems;
    for (const fs::path& file : files) {
      const std::string path = fs::absolute(file).string();
      if (TryPlace(path, path, problems) == nullptr) {
        failed.push_back(file);
      }
    }
    if (failed.size() == files.size()) {
      THROW_ARGOSEXCEPTION("The library \"" << fs::absolute(failed.front()).string()
                                            << "\" cannot be loaded; tried:" << problems);
    }
    files.swap(failed);
  }
}

void CDynamicLoading::LoadAllLibrariesOnDemand() {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetLoadingMutex());
  LoadingOnDemand().IsEnabled = true;
}

void detail::LoadPluginsFor(const std::string& label) {
  const std::lock_guard<std::recursive_mutex> lock(GetLoadingMutex());
  if (!LoadingOnDemand().IsEnabled || LoadingOnDemand().IsDone) {
    return;
  }
  LOG << "[INFO] Loading all plug-ins, because \"" << label << "\" is not registered" << std::endl;
  try {
    CDynamicLoading::LoadAllLibraries();
  } catch (CARGoSException& error) {
    THROW_ARGOSEXCEPTION_NESTED(
        "\"" << label << "\" is not registered, and not all plug-ins can be loaded", error);
  }
}

void CDynamicLoading::UnloadAllLibraries() {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetLoadingMutex());
  LoadedLibraries().clear();
}

}  // namespace argos
