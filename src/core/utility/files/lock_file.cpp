#include <argos3/core/utility/files/lock_file.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace argos {

namespace {

constexpr int kLockAttempts = 100;

std::string DescribeProcess(long process) {
  if (process == getpid()) {
    return "this process";
  }
  return process > 0 ? "process " + std::to_string(process) : "another process";
}

}  // namespace

bool TryToLock(int file, bool wait) {
  int result = 0;
  do {
    result = flock(file, wait ? LOCK_EX : LOCK_EX | LOCK_NB);
  } while (result != 0 && errno == EINTR);
  return result == 0 || errno != EWOULDBLOCK;
}

bool LeadsTo(const std::string& path, int file) {
  struct stat opened {};
  struct stat named {};
  return fstat(file, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

std::string DescribeLockHolder(int file) {
  struct stat information {};
  if (fstat(file, &information) != 0) {
    return DescribeProcess(0);
  }
  // "1: FLOCK  ADVISORY  WRITE 708 00:2d:1234 0 EOF"; some file systems have devices of their own
  CTextOutput device;
  device << std::hex << std::setfill('0') << std::setw(2) << major(information.st_dev) << ':'
         << std::setw(2) << minor(information.st_dev);
  long likely = 0;
  std::ifstream locks("/proc/locks");
  std::string line;
  while (std::getline(locks, line)) {
    std::istringstream words(line);
    std::string number;
    std::string kind;
    std::string mode;
    std::string access;
    std::string place;
    long process = 0;
    words >> number >> kind >> mode >> access >> process >> place;
    const std::size_t inode = place.rfind(':');
    if (kind == "FLOCK" && inode != std::string::npos &&
        place.substr(inode + 1) == std::to_string(information.st_ino)) {
      if (place.substr(0, inode) == device.str()) {
        return DescribeProcess(process);
      }
      likely = process;
    }
  }
  return DescribeProcess(likely);
}

CLockFile::CLockFile(const std::string& path) : m_path(path), m_owner(getpid()) {
  // repeated if a process that ends has removed the file after it was opened here
  for (int attempt = 0; attempt == 0 || (attempt < kLockAttempts && !LeadsTo(path, m_file));
       ++attempt) {
    if (m_file >= 0) {
      close(m_file);
    }
    m_file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (m_file < 0) {
      THROW_ARGOSEXCEPTION("the lock file \"" << path
                                              << "\" cannot be created: " << std::strerror(errno));
    }
    if (!TryToLock(m_file)) {
      char text[32] = {};
      const ssize_t size = pread(m_file, text, sizeof(text) - 1, 0);
      close(m_file);
      const long process = size > 0 ? std::strtol(text, nullptr, 10) : 0;
      THROW_ARGOSEXCEPTION(DescribeProcess(process)
                           << " is writing there: it has locked \"" << path << '"');
    }
  }
  WriteProcess();
}

// other processes name this one in their messages; a full disk does not matter
void CLockFile::WriteProcess() const {
  const std::string text = std::to_string(m_owner) + '\n';
  if (ftruncate(m_file, 0) != 0 || pwrite(m_file, text.data(), text.size(), 0) < 0) {
    return;
  }
}

CLockFile::~CLockFile() {
  if (getpid() == m_owner) {
    unlink(m_path.c_str());
  }
  close(m_file);
}

}  // namespace argos
