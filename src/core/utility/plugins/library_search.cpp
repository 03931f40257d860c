#include <argos3/core/utility/plugins/library_search.h>

#include <argos3/core/config.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/registration.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <set>
#include <system_error>

namespace fs = std::filesystem;

namespace argos {

fs::path ResolvePath(const fs::path& path) {
  std::error_code error;
  const fs::path resolved = fs::canonical(path, error);
  return error ? path : resolved;
}

namespace {

// the core library, or the program if the core is part of it
const fs::path& CoreLibrary() {
  static const fs::path path =
      ResolvePath(GetLibraryOf(reinterpret_cast<const void*>(&GetCoreBuildId)));
  return path;
}

}  // namespace

std::vector<std::string> ListUserDirectories() {
  std::vector<std::string> directories;
  const char* variable = std::getenv("ARGOS_PLUGIN_PATH");
  if (variable != nullptr) {
    Tokenize(variable, directories, ":");
  }
  return directories;
}

std::vector<std::string> ListDefaultDirectories() {
  std::vector<std::string> directories;
  directories.push_back(CoreLibrary().parent_path().string());
  const fs::path besideProgram = CoreLibrary().parent_path().parent_path() / "lib" / "argos3";
  const fs::path installed = fs::path(ARGOS_INSTALL_PREFIX) / "lib" / "argos3";
  for (const fs::path& candidate : {besideProgram, installed}) {
    std::error_code error;
    const std::string path = ResolvePath(candidate).string();
    if (fs::is_directory(candidate, error) &&
        std::find(directories.begin(), directories.end(), path) == directories.end()) {
      directories.push_back(path);
    }
  }
  return directories;
}

namespace {

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
  for (const std::string& directory : ListDefaultDirectories()) {
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
  const std::vector<std::string> directories = ListDefaultDirectories();
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

}  // namespace

std::vector<fs::path> ListAllLibraries() {
  std::set<std::string> seen = {CoreLibrary().filename().string()};
  const auto isNew = [&seen](const fs::path& file) {
    return seen.insert(file.filename().string()).second;
  };
  std::vector<fs::path> files;
  for (const std::string& directory : ListUserDirectories()) {
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

std::vector<std::string> ListSuffixes(const std::string& lib) {
  std::vector<std::string> suffixes = {""};
  if (!IsLibraryName(lib)) {
    suffixes.emplace_back("." ARGOS_SHARED_LIBRARY_EXTENSION);
    if (std::string(ARGOS_MODULE_LIBRARY_EXTENSION) != ARGOS_SHARED_LIBRARY_EXTENSION) {
      suffixes.emplace_back("." ARGOS_MODULE_LIBRARY_EXTENSION);
    }
  }
  return suffixes;
}

namespace {

bool IsAbsolute(const std::string& lib) {
  return !lib.empty() && lib[0] == '/';
}

// the first file of the library in the folder
std::optional<SNearFile> FindIn(const std::string& directory, const std::string& lib) {
  for (const std::string& suffix : ListSuffixes(lib)) {
    std::error_code error;
    const fs::path file = directory + '/' + lib + suffix;
    if (fs::is_regular_file(file, error)) {
      return SNearFile{directory + '/' + lib, ResolvePath(file)};
    }
  }
  return std::nullopt;
}

}  // namespace

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
    if (found.has_value() &&
        std::ranges::find(files, found->File, &SNearFile::File) == files.end()) {
      files.push_back(*found);
    }
  }
  return files;
}

std::vector<std::string> ListPlaces(const std::string& lib, const std::string& experimentFile) {
  if (IsAbsolute(lib)) {
    return {lib};
  }
  std::vector<std::string> directories = ListUserDirectories();
  for (const auto& more : {ExperimentDirectories(lib, experimentFile), ListDefaultDirectories(),
                           OwnExperiments(), std::vector<std::string>{"."}}) {
    directories.insert(directories.end(), more.begin(), more.end());
  }
  std::vector<std::string> places;
  std::set<std::string> seen;
  for (const std::string& directory : directories) {
    if (seen.insert(ResolvePath(directory).string()).second) {
      places.push_back(directory + '/' + lib);
    }
  }
  return places;
}

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

std::string DescribeSuffixes(const std::string& lib) {
  std::string text;
  for (const std::string& suffix : ListSuffixes(lib)) {
    text += suffix.empty() ? "" : '[' + suffix + ']';
  }
  return text;
}

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

}  // namespace argos
