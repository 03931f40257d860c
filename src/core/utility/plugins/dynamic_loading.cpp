#include <argos3/core/utility/plugins/dynamic_loading.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/errors/signal_safe_text.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
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

// beside the experiment file, and where projects are usually built
std::vector<std::string> ExperimentDirectories(const std::string& lib,
                                               const std::string& experimentFile) {
  if (experimentFile.empty()) {
    return {};
  }
  const fs::path folder = fs::path(experimentFile).parent_path();
  const fs::path beside = folder.empty() ? "." : folder;
  const fs::path above = beside == "." ? fs::path("..") : beside / "..";
  std::vector<std::string> directories = {beside.string(), (beside / "build").string()};
  if (lib.find('/') != std::string::npos) {
    directories.push_back(above.string());
  }
  directories.push_back((above / "build").string());
  return directories;
}

// libraries of this project's experiments, which only their names load: installed ones, and those
// of the build tree that has the core
std::vector<std::string> OwnExperiments() {
  std::vector<fs::path> candidates;
  for (const std::string& directory : DefaultDirectories()) {
    candidates.push_back(fs::path(directory) / "experiments");
  }
  const fs::path root = CoreLibrary().parent_path().parent_path().parent_path();
  std::error_code ignored;
  if (fs::exists(root / "CMakeCache.txt", ignored)) {
    candidates.push_back(root / "experiments");
  }
  std::vector<std::string> directories;
  for (const fs::path& candidate : candidates) {
    if (fs::is_directory(candidate, ignored)) {
      directories.push_back(candidate.string());
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

std::vector<fs::path> ListWithWarning(const std::string& directory) {
  std::error_code error;
  std::vector<fs::path> files = ListLibraries(directory, error);
  if (error) {
    LOGERR << "[WARNING] The plug-in directory \"" << directory
           << "\" cannot be read: " << error.message() << std::endl;
  }
  return files;
}

// Each file name once, in the order of loading: ours before users' libraries, which need symbols of
// ours that they are often not linked with; before all of them those that replace one of ours.
std::vector<fs::path> ListAllLibraries() {
  std::set<std::string> seen = {CoreLibrary().filename().string()};
  const auto isNew = [&seen](const fs::path& file) {
    return seen.insert(file.filename().string()).second;
  };
  std::vector<fs::path> files;
  for (const std::string& directory : UserDirectories()) {
    const std::vector<fs::path> found = ListWithWarning(directory);
    std::copy_if(found.begin(), found.end(), std::back_inserter(files), isNew);
  }
  const std::vector<fs::path> own = ListWithWarning(PluginDirectory());
  std::set<std::string> ownNames;
  for (const fs::path& file : own) {
    ownNames.insert(file.filename().string());
  }
  const auto others = std::stable_partition(
      files.begin(), files.end(),
      [&ownNames](const fs::path& file) { return ownNames.count(file.filename().string()) > 0; });
  std::vector<fs::path> ordered(files.begin(), others);
  std::copy_if(own.begin(), own.end(), std::back_inserter(ordered), isNew);
  ordered.insert(ordered.end(), others, files.end());
  return ordered;
}

/****************************************/
// loading
/****************************************/

// what may follow the name of a library
std::vector<std::string> Suffixes(const std::string& lib) {
  std::vector<std::string> suffixes = {""};
  if (!IsLibraryName(lib)) {
    suffixes.emplace_back("." ARGOS_SHARED_LIBRARY_EXTENSION);
    if (std::string(ARGOS_MODULE_LIBRARY_EXTENSION) != ARGOS_SHARED_LIBRARY_EXTENSION) {
      suffixes.emplace_back("." ARGOS_MODULE_LIBRARY_EXTENSION);
    }
  }
  return suffixes;
}

bool IsAbsolute(const std::string& lib) {
  return !lib.empty() && lib[0] == '/';
}

// of a library that is searched: a path without suffixes, which has a file
struct SNearFile {
  std::string Place;
  fs::path File;
};

// the first file of the library in the folder
std::optional<SNearFile> FindIn(const std::string& directory, const std::string& lib) {
  for (const std::string& suffix : Suffixes(lib)) {
    std::error_code error;
    const fs::path file = directory + '/' + lib + suffix;
    if (fs::is_regular_file(file, error)) {
      return SNearFile{directory + '/' + lib, Resolved(file)};
    }
  }
  return std::nullopt;
}

// Libraries of several build trees: in the working directory and beside the experiment. The
// working directory is nearest: a user who has several trees works in the one that is meant.
std::vector<SNearFile> FindNearFiles(const std::string& lib, const std::string& experimentFile) {
  if (IsAbsolute(lib)) {
    return {};
  }
  std::vector<std::string> directories = {"."};
  const std::vector<std::string> more = ExperimentDirectories(lib, experimentFile);
  directories.insert(directories.end(), more.begin(), more.end());
  std::vector<SNearFile> files;
  for (const std::string& directory : directories) {
    const std::optional<SNearFile> found = FindIn(directory, lib);
    const auto isSame = [&found](const SNearFile& file) { return file.File == found->File; };
    if (found.has_value() && std::none_of(files.begin(), files.end(), isSame)) {
      files.push_back(*found);
    }
  }
  return files;
}

// the paths that a library may have, without suffixes, in order
std::vector<std::string> Places(const std::string& lib, const std::string& experimentFile) {
  if (IsAbsolute(lib)) {
    return {lib};
  }
  std::vector<std::string> directories = UserDirectories();
  for (const auto& more : {ExperimentDirectories(lib, experimentFile), DefaultDirectories(),
                           OwnExperiments(), std::vector<std::string>{"."}}) {
    directories.insert(directories.end(), more.begin(), more.end());
  }
  std::vector<std::string> places;
  std::set<std::string> seen;
  for (const std::string& directory : directories) {
    if (seen.insert(Resolved(directory).string()).second) {
      places.push_back(directory + '/' + lib);
    }
  }
  return places;
}

// if there are several near files, puts the place of the nearest before those of the others
void PutNearestFirst(std::vector<std::string>& places, const std::vector<SNearFile>& near) {
  if (near.size() < 2) {
    return;
  }
  const std::string& nearest = near.front().Place;
  const auto other = std::find_if(places.begin(), places.end(), [&near](const std::string& place) {
    return std::any_of(near.begin() + 1, near.end(),
                       [&place](const SNearFile& file) { return file.Place == place; });
  });
  if (other != places.end()) {
    places.insert(other, nearest);
  }
}

// of near files that are not loaded, for example because they are of another build tree
void WarnOfOthers(const std::string& lib, const std::string& place,
                  const std::vector<SNearFile>& near) {
  const std::optional<SNearFile> loaded =
      FindIn(fs::path(place).parent_path().string(), fs::path(place).filename().string());
  std::string others;
  for (const SNearFile& file : near) {
    if (loaded.has_value() && file.File != loaded->File) {
      others += (others.empty() ? "\"" : ", \"") + file.File.string() + '"';
    }
  }
  if (!others.empty()) {
    LOGERR << "[WARNING] There are several libraries \"" << lib << "\": \"" << loaded->File.string()
           << "\" is loaded, not " << others << std::endl;
  }
}

// "[.so]", for messages
std::string DescribeSuffixes(const std::string& lib) {
  std::string text;
  for (const std::string& suffix : Suffixes(lib)) {
    text += suffix.empty() ? "" : '[' + suffix + ']';
  }
  return text;
}

// libraries with similar names in the places that were searched
std::string DescribeSimilar(const std::string& lib, const std::vector<std::string>& places) {
  std::set<std::string> folders;
  for (const std::string& place : places) {
    folders.insert(fs::path(place).parent_path().string());
    folders.insert(place.substr(0, place.size() - lib.size()));
  }
  std::vector<std::string> names;
  for (const std::string& folder : folders) {
    std::error_code ignored;
    for (const fs::path& file : ListLibraries(folder, ignored)) {
      names.push_back(file.stem().string());
    }
  }
  const std::string name = fs::path(lib).stem().string();
  return NearestNames(name, names).empty() ? "" : DidYouMean(name, names);
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
  for (const auto& more : {DefaultDirectories(), UserDirectories()}) {
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
  for (const std::string& suffix : Suffixes(lib)) {
    const std::string candidate = place + suffix;
    const std::string path = Resolved(candidate).string();
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
  for (const std::string& place : Places("", "")) {
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
  std::vector<std::string> places = Places(lib, experimentFile);
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
