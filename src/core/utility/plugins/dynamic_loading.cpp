#include <argos3/core/utility/plugins/dynamic_loading.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/errors/signal_safe_text.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/process_wide.h>
#include <argos3/core/utility/plugins/registration.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <cxxabi.h>
#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
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

fs::path Resolved(const fs::path& path) {
  std::error_code error;
  const fs::path resolved = fs::canonical(path, error);
  return error ? path : resolved;
}

/****************************************/
// search paths
/****************************************/

// the core library, or the program if the core is part of it
const fs::path& CoreLibrary() {
  static const fs::path path =
      Resolved(GetLibraryOf(reinterpret_cast<const void*>(&GetCoreBuildId)));
  return path;
}

std::vector<std::string> UserDirectories() {
  std::vector<std::string> directories;
  const char* variable = std::getenv("ARGOS_PLUGIN_PATH");
  if (variable != nullptr) {
    Tokenize(variable, directories, ":");
  }
  return directories;
}

// in the order of the search. The core's own folder is lib/argos3 of its installation, or the
// folder of all libraries in a build tree
std::vector<std::string> DefaultDirectories() {
  std::vector<std::string> directories;
  directories.push_back(CoreLibrary().parent_path().string());
  const fs::path besideProgram = CoreLibrary().parent_path().parent_path() / "lib" / "argos3";
  const fs::path installed = fs::path(ARGOS_INSTALL_PREFIX) / "lib" / "argos3";
  for (const fs::path& candidate : {besideProgram, installed}) {
    std::error_code error;
    const std::string path = Resolved(candidate).string();
    if (fs::is_directory(candidate, error) &&
        std::find(directories.begin(), directories.end(), path) == directories.end()) {
      directories.push_back(path);
    }
  }
  return directories;
}

bool IsLibraryName(const fs::path& file) {
  const std::string extension = file.extension().string();
  return extension == "." ARGOS_SHARED_LIBRARY_EXTENSION ||
         extension == "." ARGOS_MODULE_LIBRARY_EXTENSION;
}

std::vector<fs::path> ListLibraries(const std::string& directory, std::error_code& error) {
  std::vector<fs::path> files;
  fs::directory_iterator entry(directory, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (IsLibraryName(entry->path()) && entry->is_regular_file(ignored)) {
      files.push_back(entry->path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

// the first default directory with libraries of ours, so that a build tree is not mixed with an
// installation of another version
std::string PluginDirectory() {
  const std::vector<std::string> directories = DefaultDirectories();
  for (const std::string& directory : directories) {
    std::error_code error;
    for (const fs::path& file : ListLibraries(directory, error)) {
      if (file.filename().string().rfind("libargos3", 0) == 0) {
        return directory;
      }
    }
  }
  return directories.front();
}

/****************************************/
// loading
/****************************************/

// the possible paths of a library, in order
std::vector<std::string> Candidates(const std::string& lib) {
  std::vector<std::string> suffixes = {"", "." ARGOS_SHARED_LIBRARY_EXTENSION};
  if (std::string(ARGOS_MODULE_LIBRARY_EXTENSION) != ARGOS_SHARED_LIBRARY_EXTENSION) {
    suffixes.push_back("." ARGOS_MODULE_LIBRARY_EXTENSION);
  }
  std::vector<std::string> directories;
  if (!lib.empty() && lib[0] == '/') {
    directories.emplace_back("");
  } else {
    for (const std::string& directory : GetPluginSearchPaths()) {
      directories.push_back(directory + '/');
    }
    // before the working directory, which is the last
    for (const std::string& directory : DefaultDirectories()) {
      std::error_code error;
      if (fs::is_directory(directory + "/experiments", error)) {
        directories.insert(directories.end() - 1, directory + "/experiments/");
      }
    }
  }
  std::vector<std::string> candidates;
  for (const std::string& directory : directories) {
    for (const std::string& suffix : suffixes) {
      candidates.push_back(directory + lib + suffix);
    }
  }
  return candidates;
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

// opens a library; returns null and sets the reason on failure
CDynamicLoading::TDLHandle TryOpen(const std::string& path, std::string& reason) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    reason = "no such file";
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

}  // namespace

std::vector<std::string> GetPluginSearchPaths() {
  // the first call uses the dynamic linker
  const std::lock_guard<std::recursive_mutex> lock(detail::GetLoadingMutex());
  std::vector<std::string> paths = UserDirectories();
  const std::vector<std::string> defaults = DefaultDirectories();
  paths.insert(paths.end(), defaults.begin(), defaults.end());
  // last, so that a file in the working directory does not replace an installed library
  paths.emplace_back(".");
  return paths;
}

CDynamicLoading::TDLHandle CDynamicLoading::LoadLibrary(const std::string& lib) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetLoadingMutex());
  std::string attempts;
  for (const std::string& candidate : Candidates(lib)) {
    const std::string path = Resolved(candidate).string();
    const auto known = LoadedLibraries().find(path);
    if (known != LoadedLibraries().end()) {
      known->second.Names.insert(lib);
      return known->second.Handle;
    }
    std::string reason;
    const TDLHandle handle = TryOpen(candidate, reason);
    // registrations may be invalid even if the library failed to load
    ThrowRegistrationProblems("The library \"" + candidate + "\" cannot be used:");
    if (handle != nullptr) {
      LoadedLibraries()[path] = SLoadedLibrary{handle, {lib}};
      LOG << "[INFO] Loaded library \"" << candidate << "\"" << std::endl;
      return handle;
    }
    attempts += "\n  " + candidate + ": " + reason;
  }
  THROW_ARGOSEXCEPTION("The library \"" << lib << "\" cannot be loaded; tried:" << attempts);
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
  std::vector<std::string> directories = UserDirectories();
  directories.push_back(PluginDirectory());
  std::set<std::string> seen = {CoreLibrary().filename().string()};
  for (const std::string& directory : directories) {
    std::error_code error;
    const std::vector<fs::path> files = ListLibraries(directory, error);
    if (error) {
      LOGERR << "[WARNING] The plug-in directory \"" << directory
             << "\" cannot be read: " << error.message() << std::endl;
    }
    for (const fs::path& file : files) {
      if (seen.insert(file.filename().string()).second) {
        LoadLibrary(fs::absolute(file).string());
      }
    }
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
