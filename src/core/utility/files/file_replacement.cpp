#include <argos3/core/utility/files/file_replacement.h>

#include <argos3/core/utility/files/lock_file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace argos {

namespace {

namespace fs = std::filesystem;

constexpr int kPartAttempts = 100;

// closed by the destructor, which releases the lock, too
class CDescriptor {
 public:
  explicit CDescriptor(int number) : m_number(number) {}
  CDescriptor(CDescriptor&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
  ~CDescriptor() {
    if (m_number >= 0) {
      close(m_number);
    }
  }
  CDescriptor(const CDescriptor&) = delete;
  CDescriptor& operator=(const CDescriptor&) = delete;
  CDescriptor& operator=(CDescriptor&&) = delete;

  int Get() const { return m_number; }

 private:
  int m_number;
};

// some file systems report a full disk only when a file is closed; this keeps it locked
bool CheckByClosing(int file) {
  const int copy = fcntl(file, F_DUPFD_CLOEXEC, 0);
  return copy < 0 || close(copy) == 0 || errno == EINTR;
}

bool WriteAll(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = write(file, content.data(), content.size());
    if (count >= 0) {
      content.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

// @return the reason if that failed
std::string WriteDirectly(const std::string& path, std::string_view content) {
  const CDescriptor file(open(path.c_str(), O_WRONLY | O_CLOEXEC));
  const bool isDone =
      file.Get() >= 0 && WriteAll(file.Get(), content) && CheckByClosing(file.Get());
  return isDone ? "" : std::strerror(errno);
}

// @return what symbolic links lead to; the path itself if there is no such file
std::string FollowLinks(const std::string& path) {
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target.string();
}

// opens a new part, or one that a killed process has left, and locks it
CDescriptor OpenPart(const std::string& part, std::string& problem) {
  problem.clear();
  for (int attempt = 0; attempt < kPartAttempts; ++attempt) {
    CDescriptor file(open(part.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
    if (file.Get() < 0) {
      problem = std::strerror(errno);
      return file;
    }
    if (!TryToLock(file.Get())) {
      problem = DescribeLockHolder(file.Get()) + " is writing it";
      return file;
    }
    // before it was locked, another writer of the path may have renamed or removed it
    if (LeadsTo(part, file.Get())) {
      return file;
    }
  }
  problem = "others replace \"" + part + "\" again and again";
  return CDescriptor(-1);
}

}  // namespace

bool ReplaceFile(const std::string& path, std::string_view content, std::string& problem) {
  struct stat information {};
  if (stat(path.c_str(), &information) == 0 && !S_ISREG(information.st_mode)) {
    problem = WriteDirectly(path, content);
    return problem.empty();
  }
  const std::string target = FollowLinks(path);
  const std::string part = target + kPartSuffix;
  const CDescriptor file = OpenPart(part, problem);
  if (!problem.empty()) {
    return false;
  }
  if (ftruncate(file.Get(), 0) != 0 || !WriteAll(file.Get(), content) ||
      !CheckByClosing(file.Get()) || std::rename(part.c_str(), target.c_str()) != 0) {
    problem = std::strerror(errno);
    unlink(part.c_str());
    return false;
  }
  return true;
}

void RemoveStaleParts(const std::string& folder) {
  const std::string_view suffix = kPartSuffix;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string path = entry->path().string();
    std::error_code ignored;
    if (path.size() <= suffix.size() ||
        path.compare(path.size() - suffix.size(), suffix.size(), suffix) != 0 ||
        !fs::is_regular_file(entry->symlink_status(ignored))) {
      continue;
    }
    const CDescriptor file(open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW));
    if (file.Get() >= 0 && TryToLock(file.Get())) {
      unlink(path.c_str());
    }
  }
}

}  // namespace argos
