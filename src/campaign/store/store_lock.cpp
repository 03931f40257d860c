#include <argos3/campaign/store/store_lock.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/lock_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>

namespace argos {

namespace {

/** The locks of this process, which fcntl() does not keep from each other. */
struct SOwnLocks {
  std::mutex Mutex;
  std::set<std::string> Paths;  // absolute
};

SOwnLocks& GetOwnLocks() {
  static SOwnLocks locks;
  return locks;
}

std::string DescribeThisProcess() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  return "process " + std::to_string(getpid()) + " on " + host.data();
}

[[noreturn]] void ThrowLocked(const std::string& resultsFile, const std::string& owner) {
  THROW_ARGOSEXCEPTION("the results file \"" << resultsFile << "\" is being written by " << owner
                                             << ": wait until it ends, or stop it; status, export "
                                                "and report work meanwhile");
}

[[noreturn]] void ThrowNotWritable(const std::string& resultsFile, const std::string& lock,
                                   int error) {
  const std::string folder = std::filesystem::path(lock).parent_path().string();
  THROW_ARGOSEXCEPTION("the results file \""
                       << resultsFile << "\" cannot be written: \"" << folder
                       << "\": " << std::strerror(error)
                       << (error == ENOENT ? "; create this folder, or choose another name"
                                           : "; check the rights of this folder"));
}

bool IsLockedByOther(int file) {
  struct flock range {};
  range.l_type = F_WRLCK;
  range.l_whence = SEEK_SET;
  return fcntl(file, F_SETLK, &range) != 0 && (errno == EACCES || errno == EAGAIN);
}

std::string ReadOwner(int file) {
  std::array<char, 512> text{};
  const ssize_t size = pread(file, text.data(), text.size() - 1, 0);
  std::string owner(text.data(), size > 0 ? size : 0);
  owner.erase(owner.find_last_not_of('\n') + 1);
  return owner.empty() ? "another process" : owner;
}

}  // namespace

CStoreLock::CStoreLock(const std::string& resultsFile)
    : m_path(std::filesystem::absolute(resultsFile + ".lock").lexically_normal().string()) {
  SOwnLocks& own = GetOwnLocks();
  const std::lock_guard<std::mutex> guard(own.Mutex);
  if (own.Paths.count(m_path) > 0) {
    ThrowLocked(resultsFile, "this process");
  }
  // repeated if a process that ends has removed the file after it was opened here
  do {
    if (m_file >= 0) {
      close(m_file);
    }
    m_file = open(m_path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (m_file < 0) {
      ThrowNotWritable(resultsFile, m_path, errno);
    }
    if (IsLockedByOther(m_file)) {
      const std::string owner = ReadOwner(m_file);
      close(m_file);
      ThrowLocked(resultsFile, owner);
    }
  } while (!LeadsTo(m_path, m_file));
  own.Paths.insert(m_path);
  // other processes name this one in their messages; a full disk does not matter
  const std::string text = DescribeThisProcess() + '\n';
  if (ftruncate(m_file, 0) == 0 && pwrite(m_file, text.data(), text.size(), 0) < 0) {
    return;
  }
}

CStoreLock::~CStoreLock() {
  SOwnLocks& own = GetOwnLocks();
  const std::lock_guard<std::mutex> guard(own.Mutex);
  unlink(m_path.c_str());
  close(m_file);
  own.Paths.erase(m_path);
}

}  // namespace argos
