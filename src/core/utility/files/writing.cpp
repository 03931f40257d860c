#include <argos3/core/utility/files/writing.h>

#include <argos3/core/utility/errors/output_timeout.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <thread>

namespace argos {

namespace {

using TClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kAttemptPeriod{20};

bool IsFifo(const std::string& path) {
  struct stat information {};
  return stat(path.c_str(), &information) == 0 && S_ISFIFO(information.st_mode);
}

// open() would wait for a reader without end
int OpenFifo(const std::string& path, int flags, std::string& problem) {
  const TClock::time_point end = TClock::now() + GetOutputTimeout();
  int file = -1;
  do {
    file = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | flags, 0666);
    if (file < 0 && errno == ENXIO) {
      std::this_thread::sleep_for(kAttemptPeriod);
    }
  } while (file < 0 && (errno == ENXIO || errno == EINTR) && TClock::now() < end);
  if (file < 0) {
    problem = errno == ENXIO ? "it is a FIFO, and no program has opened it for reading within " +
                                   DescribeOutputTimeout()
                             : std::strerror(errno);
    return -1;
  }
  fcntl(file, F_SETFL, fcntl(file, F_GETFL) & ~O_NONBLOCK);
  return file;
}

// @return false at the end of the time
bool WaitUntilWritable(int file) {
  pollfd waiting = {file, POLLOUT, 0};
  const TClock::time_point end = TClock::now() + GetOutputTimeout();
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - TClock::now());
    const int count = left.count() > 0 ? poll(&waiting, 1, static_cast<int>(left.count())) : 0;
    if (count == 0 || (count < 0 && errno != EINTR)) {
      return count != 0;
    }
    if (count > 0) {
      return true;
    }
  }
}

}  // namespace

std::string FindFolderProblem(const std::string& folder, EMissingFolder missingFolder) {
  namespace fs = std::filesystem;
  fs::path checked = folder.empty() ? "." : folder;
  std::error_code error;
  if (missingFolder == EMissingFolder::IsCreated) {
    fs::create_directories(checked, error);
    if (error && !fs::is_directory(checked)) {
      return "the folder \"" + checked.string() + "\" cannot be created: " + error.message();
    }
  } else if (missingFolder == EMissingFolder::WillBeCreated) {
    while (!fs::exists(checked, error)) {
      checked = checked.has_parent_path() && checked.parent_path() != checked
                    ? checked.parent_path()
                    : fs::path(".");
    }
  }
  if (!fs::exists(checked, error)) {
    return "there is no folder \"" + checked.string() + '"';
  }
  if (!fs::is_directory(checked, error)) {
    return '"' + checked.string() + "\" is no folder";
  }
  if (access(checked.c_str(), W_OK | X_OK) != 0) {
    return "the folder \"" + checked.string() + "\" cannot be written: " + std::strerror(errno);
  }
  return "";
}

std::string FindOutputProblem(const std::string& path, EMissingFolder missingFolder) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::is_directory(path, error)) {
    return "it is a folder";
  }
  if (fs::exists(path, error)) {
    return access(path.c_str(), W_OK) == 0 ? "" : std::strerror(errno);
  }
  return FindFolderProblem(fs::path(path).parent_path().string(), missingFolder);
}

int OpenForWriting(const std::string& path, int flags, std::string& problem) {
  problem.clear();
  if (IsFifo(path)) {
    return OpenFifo(path, flags, problem);
  }
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
  if (file < 0) {
    problem = std::strerror(errno);
  }
  return file;
}

std::size_t WriteBytes(int file, std::string_view bytes, std::string& problem) {
  // an atomic piece of a FIFO: one that can be written takes so many without waiting
  constexpr std::size_t kPiece = 4096;
  struct stat information {};
  const bool mayWait = fstat(file, &information) == 0 && !S_ISREG(information.st_mode);
  std::size_t done = 0;
  problem.clear();
  while (done < bytes.size()) {
    if (mayWait && !WaitUntilWritable(file)) {
      problem = "its reader has taken nothing for " + DescribeOutputTimeout();
      break;
    }
    const std::size_t size = mayWait ? std::min(kPiece, bytes.size() - done) : bytes.size() - done;
    const ssize_t count = write(file, bytes.data() + done, size);
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      problem = std::strerror(errno);
      break;
    }
  }
  return done;
}

}  // namespace argos
