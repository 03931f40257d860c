#include <argos3/core/utility/plugins/dynamic_loading.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/errors/signal_safe_text.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/core/utility/plugins/deferred_libraries.h>
#include <argos3/core/utility/plugins/elf_file.h>
#include <argos3/core/utility/plugins/library_search.h>
#include <argos3/core/utility/plugins/process_wide.h>
#include <argos3/core/utility/plugins/registered_labels.h>
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

// indexed by resolved path
std::map<std::string, SLoadedLibrary>& LoadedLibraries() {
  static std::map<std::string, SLoadedLibrary> libraries;
  return libraries;
}

// they are loaded when a factory lacks a label; guarded by the loading mutex
struct SLoadingOnDemand {
  bool IsEnabled = false;
  bool IsDone = false;
};

SLoadingOnDemand& LoadingOnDemand() {
  static SLoadingOnDemand state;
  return state;
}

// writes the name for the report of a crash
void DescribeLibrary(const void* path, CSignalSafeText& text) {
  text.Append("library \"").Append(*static_cast<const std::string*>(path)).Append("\"");
}

// the symbol in a text, from a position on
std::string SymbolAt(const std::string& text, size_t start) {
  constexpr char kNameCharacters[] =
      "_$.0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  return text.substr(start, text.find_first_not_of(kNameCharacters, start) - start);
}

// demangles the C++ symbols in a message of the dynamic linker
std::string WithReadableSymbols(const std::string& message) {
  const size_t start = message.find("_Z");
  if (start == std::string::npos) {
    return message;
  }
  const std::string symbol = SymbolAt(message, start);
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  return status == 0 ? std::string(message).replace(start, symbol.size(), name.get()) : message;
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
      reason = dlerror();
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

constexpr char kUndefinedSymbol[] = "undefined symbol: ";

// the symbol of the message "libx.so: undefined symbol: ..."; "" for other messages
std::string NameOfUndefined(const std::string& reason) {
  const size_t found = reason.find(kUndefinedSymbol);
  return found == std::string::npos ? "" : SymbolAt(reason, found + sizeof(kUndefinedSymbol) - 1);
}

// says what can be done about a failure to open a library
std::string DescribeWayOut(const std::string& reason) {
  const std::string missing = NameOfMissing(reason);
  if (!missing.empty()) {
    return "\n    It is linked with \"" + missing +
           "\", which is neither beside it nor among the plug-ins: put the folder of that library "
           "into ARGOS_PLUGIN_PATH or LD_LIBRARY_PATH, or link with -Wl,-rpath,FOLDER";
  }
  if (!NameOfUndefined(reason).empty()) {
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

CDynamicLoading::TDLHandle OpenWithNeeded(const std::string& path, std::string& reason);

// keeps a library that is open
void AddLoaded(const std::string& file, const std::string& name,
               CDynamicLoading::TDLHandle handle) {
  LoadedLibraries()[ResolvePath(file).string()] = SLoadedLibrary{handle, {name}};
  if (CLogControl::GetLevel() == ELogLevel::Debug) {
    LOG << "[DEBUG] Loaded library \"" << file << "\"" << std::endl;
  }
}

// Opens deferred libraries. The caller then throws the problems of their registrations.
void OpenDeferred(const std::vector<std::string>& paths) {
  const CLateRegistrations late;
  for (const std::string& path : paths) {
    // a library that is linked with it may have brought one of this name along
    const std::string name = fs::path(path).filename().string();
    CDynamicLoading::TDLHandle handle = dlopen(name.c_str(), RTLD_LAZY | RTLD_NOLOAD);
    std::string reason;
    if (handle == nullptr) {
      handle = OpenWithNeeded(path, reason);
    }
    if (handle == nullptr) {
      THROW_ARGOSEXCEPTION("The library \""
                           << path << "\" cannot be loaded: " << WithReadableSymbols(reason)
                           << DescribeWayOut(reason));
    }
    AddLoaded(path, path, handle);
  }
}

// the same, and throws these problems
void LoadDeferred(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    OpenDeferred({path});
    ThrowRegistrationProblems("The library \"" + path + "\" cannot be used:");
  }
}

// Opens deferred libraries in turn until one has a symbol. @return true if one has it.
bool OpenDeferredWithSymbol(const std::string& symbol) {
  for (;;) {
    const std::string path = CDeferredLibraries::TakeFirst();
    if (path.empty()) {
      return false;
    }
    OpenDeferred({path});
    if (dlsym(RTLD_DEFAULT, symbol.c_str()) != nullptr) {
      return true;
    }
  }
}

// Opens the deferred libraries that a library is linked with: the dynamic linker could find others
// of the same names.
void OpenDeferredNeededBy(const std::string& path) {
  for (const std::string& name : ListNeeded(path)) {
    OpenDeferred(CDeferredLibraries::TakeFile(name));
  }
}

// Opens a library after those that it needs; returns null and sets the reason on failure. Users'
// libraries need symbols of this project's libraries that they are often not linked with.
CDynamicLoading::TDLHandle OpenWithNeeded(const std::string& path, std::string& reason) {
  // deferred libraries have a run path
  if (!detail::IsRegisteringLate()) {
    OpenDeferredNeededBy(path);
  }
  CDynamicLoading::TDLHandle handle = TryOpen(path, reason);
  std::set<std::string> tried;
  while (handle == nullptr) {
    const std::string missing = NameOfMissing(reason);
    const std::string symbol = NameOfUndefined(reason);
    const bool isNew = tried.insert(missing + symbol).second;
    const bool hasChanged =
        isNew && (missing.empty() ? !symbol.empty() && OpenDeferredWithSymbol(symbol)
                                  : LoadNeeded(missing, path));
    if (!hasChanged) {
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
    if (!detail::IsRegisteringLate()) {
      // whose labels it has registered, too
      OpenDeferred(CDeferredLibraries::TakeContested());
    }
    // registrations may be invalid even if the library failed to load
    ThrowRegistrationProblems("The library \"" + candidate + "\" cannot be used:");
    if (handle != nullptr) {
      AddLoaded(candidate, lib, handle);
      return handle;
    }
    if (reason != kNoSuchFile) {
      problems += "\n  " + candidate + ": " + WithReadableSymbols(reason) + DescribeWayOut(reason);
    }
  }
  return nullptr;
}

constexpr char kIncompatible[] = "the libraries linked to the program are not compatible";

// A library may use symbols of one that follows: those that fail are tried again after the others.
void LoadInTurn(std::vector<fs::path> files) {
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
  // no library is loaded yet, because libraries may look labels up while they are loaded
  LoadingOnDemand().IsDone = true;
  ThrowRegistrationProblems(kIncompatible);
  LoadDeferred(CDeferredLibraries::TakeAll());
  LoadInTurn(ListAllLibraries());
}

void CDynamicLoading::LoadAllLibrariesByLabel() {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetLoadingMutex());
  LoadingOnDemand().IsDone = true;
  ThrowRegistrationProblems(kIncompatible);
  std::vector<fs::path> files = ListAllLibraries();
  std::erase_if(files, [](const fs::path& file) {
    const std::string path = fs::absolute(file).string();
    const auto& loaded = LoadedLibraries();
    return (loaded.empty() || loaded.count(ResolvePath(path).string()) == 0) &&
           CDeferredLibraries::Add(path);
  });
  LoadInTurn(std::move(files));
}

void CDynamicLoading::LoadLibrariesOfLabels(const std::set<std::string>& labels) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetLoadingMutex());
  LoadDeferred(CDeferredLibraries::TakeLabels(labels));
}

void CDynamicLoading::LoadAllLibrariesOnDemand() {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetLoadingMutex());
  LoadingOnDemand().IsEnabled = true;
}

namespace detail {

void LoadPluginsFor(const std::type_info& kind, const std::string& label) {
  const std::lock_guard<std::recursive_mutex> lock(GetLoadingMutex());
  const std::vector<std::string> deferred = CDeferredLibraries::Take(kind, label);
  LoadDeferred(deferred);
  if (!deferred.empty()) {
    return;
  }
  if (!LoadingOnDemand().IsEnabled || LoadingOnDemand().IsDone) {
    return;
  }
  LOG << "[INFO] Loading all plug-ins, because \"" << label << "\" is not registered" << std::endl;
  try {
    CDynamicLoading::LoadAllLibrariesByLabel();
    LoadPluginsFor(kind, label);
  } catch (CARGoSException& error) {
    THROW_ARGOSEXCEPTION_NESTED(
        "\"" << label << "\" is not registered, and not all plug-ins can be loaded", error);
  }
}

void LoadPluginsOfKind(const std::type_info& kind) {
  const std::lock_guard<std::recursive_mutex> lock(GetLoadingMutex());
  LoadDeferred(CDeferredLibraries::TakeKind(kind));
}

std::vector<std::string> ListUnopenedLabels(const std::type_info& kind) {
  return CDeferredLibraries::ListLabels(kind);
}

void ForgetUnopenedLabels(const std::type_info& kind) {
  CDeferredLibraries::Forget(kind);
}

}  // namespace detail

void CDynamicLoading::UnloadAllLibraries() {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetLoadingMutex());
  LoadedLibraries().clear();
}

}  // namespace argos
