#include <argos3/support/live_runs.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <tuple>

extern char** environ;

namespace argos {

namespace {

namespace fs = std::filesystem;

constexpr char kExtension[] = ".live";

bool HasVariable(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

std::string GetFolder() {
  if (HasVariable("XDG_RUNTIME_DIR")) {
    return std::string(std::getenv("XDG_RUNTIME_DIR")) + "/argos3-live";
  }
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error);
  return (error ? std::string("/tmp") : temporary.string()) + "/argos3-live-" +
         std::to_string(getuid());
}

// of this user alone: another one could have created it, to learn secrets
bool IsPrivate(const std::string& folder) {
  struct stat status {};
  constexpr mode_t kOthers = S_IRWXG | S_IRWXO;
  return lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
         status.st_uid == getuid() && (status.st_mode & kOthers) == 0;
}

std::string MakePath() {
  const std::string folder = GetFolder();
  if (mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST) {
    THROW_ARGOSEXCEPTION("cannot create the folder \""
                         << folder << "\" for URLs of live views: " << std::strerror(errno));
  }
  if (!IsPrivate(folder)) {
    THROW_ARGOSEXCEPTION("the folder \"" << folder
                                         << "\" for URLs of live views is not this user's alone");
  }
  std::string path;
  for (UInt32 number = 1;; ++number) {
    path = folder + '/' + std::to_string(getpid()) + '-' + std::to_string(number) + kExtension;
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
      return path;
    }
  }
}

std::string ToText(const SLiveRunEntry& entry) {
  std::string experiment = entry.Experiment;
  std::replace(experiment.begin(), experiment.end(), '\n', ' ');
  std::ostringstream text;
  text << "url " << entry.URL << "\nexperiment " << experiment << "\nseed " << entry.Seed
       << "\nprocess " << entry.Process << '\n';
  return text.str();
}

bool Read(const std::string& path, SLiveRunEntry& entry) {
  std::ifstream file(path);
  entry.File = path;
  for (std::string line; std::getline(file, line);) {
    const size_t space = std::min(line.find(' '), line.size());
    const std::string name = line.substr(0, space);
    const std::string value = line.substr(std::min(space + 1, line.size()));
    if (name == "url") {
      entry.URL = value;
    } else if (name == "experiment") {
      entry.Experiment = value;
    } else if (name == "seed") {
      entry.Seed = static_cast<UInt32>(std::strtoul(value.c_str(), nullptr, 10));
    } else if (name == "process") {
      entry.Process = std::strtoull(value.c_str(), nullptr, 10);
    }
  }
  return entry.URL.rfind("http://", 0) == 0;
}

// no process holds its lock
bool IsLeftOver(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0) {
    return false;
  }
  const bool isFree = flock(file, LOCK_SH | LOCK_NB) == 0;
  close(file);
  return isFree;
}

}  // namespace

CLiveRunFile::CLiveRunFile(const std::string& path, const SLiveRunEntry& entry)
    : m_path(path == "auto" ? MakePath() : path) {
  std::error_code ignored;
  if (path != "auto" && fs::is_regular_file(m_path, ignored) && IsLeftOver(m_path)) {
    // an earlier run with the same file was killed
    SLiveRunEntry former;
    if (Read(m_path, former)) {
      fs::remove(m_path, ignored);
    }
  }
  m_file =
      open(m_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR);
  if (m_file < 0) {
    THROW_ARGOSEXCEPTION("cannot create the file \""
                         << m_path << "\" for the URL of the live view: " << std::strerror(errno));
  }
  flock(m_file, LOCK_EX | LOCK_NB);
  const std::string text = ToText(entry);
  if (write(m_file, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    const int error = errno;
    close(m_file);
    unlink(m_path.c_str());
    THROW_ARGOSEXCEPTION("cannot write the file \""
                         << m_path << "\" for the URL of the live view: " << std::strerror(error));
  }
}

CLiveRunFile::~CLiveRunFile() {
  unlink(m_path.c_str());
  close(m_file);
}

std::vector<SLiveRunEntry> ListLiveRuns() {
  std::vector<SLiveRunEntry> runs;
  const std::string folder = GetFolder();
  if (!IsPrivate(folder)) {
    return runs;
  }
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
    const std::string path = file.path().string();
    SLiveRunEntry entry;
    if (file.path().extension() != kExtension) {
      continue;
    }
    if (IsLeftOver(path)) {
      unlink(path.c_str());
    } else if (Read(path, entry)) {
      runs.push_back(entry);
    }
  }
  std::sort(runs.begin(), runs.end(), [](const SLiveRunEntry& a, const SLiveRunEntry& b) {
    return std::tie(a.Experiment, a.Seed, a.Process) < std::tie(b.Experiment, b.Seed, b.Process);
  });
  return runs;
}

bool OpenInBrowser(const std::string& url) {
  if (!HasVariable("DISPLAY") && !HasVariable("WAYLAND_DISPLAY")) {
    return false;
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  }
  std::string program = "xdg-open";
  std::string argument = url;
  char* arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const bool isStarted =
      posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  return isStarted;
}

}  // namespace argos
