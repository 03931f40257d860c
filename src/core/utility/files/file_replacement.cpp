#include <argos3/core/utility/files/file_replacement.h>

#include <argos3/core/utility/files/lock_file.h>
#include <argos3/core/utility/files/writing.h>
#include <argos3/core/utility/non_copyable.h>

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
class CDescriptor : private CNonCopyable {
 public:
  explicit CDescriptor(int number) : m_number(number) {}
  ~CDescriptor() {
    if (m_number >= 0) {
      close(m_number);
    }
  }

  int Get() const { return m_number; }

 private:
  int m_number;
};

// some file systems report a full disk only when a file is closed; this keeps it locked
bool CheckByClosing(int file) {
  const int copy = fcntl(file, F_DUPFD_CLOEXEC, 0);
  return copy < 0 || close(copy) == 0 || errno == EINTR;
}

// @return the reason if that failed
std::string WriteDirectly(const std::string& path, std::string_view content) {
  std::string problem;
  const CDescriptor file(OpenForWriting(path, 0, problem));
  if (file.Get() >= 0 && WriteBytes(file.Get(), content, problem) == content.size() &&
      !CheckByClosing(file.Get())) {
    problem = std::strerror(errno);
  }
  return problem;
}

}  // namespace

std::string FollowLinks(const std::string& path) {
  constexpr int kMaxLinks = 40;  // limit of the system
  fs::path target = path;
  std::error_code error;
  for (int links = 0; links < kMaxLinks && fs::is_symlink(target, error); ++links) {
    const fs::path next = fs::read_symlink(target, error);
    if (error) {
      return path;
    }
    target = target.parent_path() / next;
  }
  return target.string();
}

int OpenPart(const std::string& part, std::string& problem) {
  problem.clear();
  for (int attempt = 0; attempt < kPartAttempts; ++attempt) {
    const int file = open(part.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0) {
      problem = std::strerror(errno);
      return -1;
    }
    if (!TryToLock(file)) {
      problem = DescribeLockHolder(file) + " is writing it";
      close(file);
      return -1;
    }
    // before it was locked, another writer of the path may have renamed or removed it
    if (LeadsTo(part, file)) {
      return file;
    }
    close(file);
  }
  problem = "others replace \"" + part + "\" again and again";
  return -1;
}

bool ReplaceFile(const std::string& path, std::string_view content, std::string& problem) {
  struct stat information {};
  if (stat(path.c_str(), &information) == 0 && !S_ISREG(information.st_mode)) {
    problem = WriteDirectly(path, content);
    return problem.empty();
  }
  const std::string target = FollowLinks(path);
  const std::string part = target + kPartSuffix;
  const CDescriptor file(OpenPart(part, problem));
  if (!problem.empty()) {
    return false;
  }
  if (ftruncate(file.Get(), 0) != 0 ||
      (WriteBytes(file.Get(), content, problem) == content.size() &&
       (!CheckByClosing(file.Get()) || std::rename(part.c_str(), target.c_str()) != 0))) {
    problem = std::strerror(errno);
  }
  if (!problem.empty()) {
    unlink(part.c_str());
  }
  return problem.empty();
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
