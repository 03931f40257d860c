#include <argos3/plugins/simulator/outputs/recording/format/growing_file.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/files/lock_file.h>
#include <argos3/core/utility/files/writing.h>
#include <argos3/core/utility/non_copyable.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

namespace argos {

namespace {

[[noreturn]] void ThrowSystemError() {
  THROW_ARGOSEXCEPTION(std::strerror(errno));
}

/* Closes a file descriptor at the end. */
class CDescriptor : private CNonCopyable {
 public:
  explicit CDescriptor(int file) : m_file(file) {}
  ~CDescriptor() {
    if (m_file >= 0) {
      ::close(m_file);
    }
  }
  int Get() const { return m_file; }

 private:
  int m_file;
};

}  // namespace

void CGrowingFile::Create(const std::string& path, std::string_view magic, std::string_view start) {
  struct stat information {};
  const bool exists = stat(path.c_str(), &information) == 0;
  if (exists && S_ISDIR(information.st_mode)) {
    THROW_ARGOSEXCEPTION("it is a directory");
  }
  if (exists && !S_ISREG(information.st_mode)) {
    std::string problem;
    m_file = OpenForWriting(path, 0, problem);
    if (m_file < 0) {
      THROW_ARGOSEXCEPTION(problem);
    }
    Append(start);
    return;
  }
  m_isRegular = true;
  // a link stays, and leads to the new file
  CreateRegular(FollowLinks(path), magic, start);
}

void CGrowingFile::Check(const std::string& path, std::string_view magic) {
  const std::string problem = FindOutputProblem(path, EMissingFolder::IsAProblem);
  if (!problem.empty()) {
    THROW_ARGOSEXCEPTION(problem);
  }
  if (FindInputProblem(path).empty()) {
    CheckReplaceable(path, magic, true);
  }
}

void CGrowingFile::CheckReplaceable(const std::string& path, std::string_view magic,
                                    bool mayBeLocked) {
  const CDescriptor old(::open(path.c_str(), O_RDWR | O_CLOEXEC));
  if (old.Get() < 0) {
    ThrowSystemError();
  }
  if (!mayBeLocked && !TryToLock(old.Get())) {
    THROW_ARGOSEXCEPTION(DescribeLockHolder(old.Get()) << " is writing it");
  }
  std::string begin(magic.size(), '\0');
  const ssize_t size = ::read(old.Get(), begin.data(), begin.size());
  if (size != 0 && begin != magic) {
    THROW_ARGOSEXCEPTION(
        "there is a file of that name that is no recording, and it is not overwritten: remove it, "
        "or choose another name");
  }
}

// it has another name until it can be read, so that there is no moment without a readable file
void CGrowingFile::CreateRegular(const std::string& path, std::string_view magic,
                                 std::string_view start) {
  const std::string part = path + kPartSuffix;
  std::string problem;
  m_file = OpenPart(part, problem);
  if (m_file < 0) {
    THROW_ARGOSEXCEPTION(problem);
  }
  try {
    // nothing else can get the name from now on
    if (FindInputProblem(path).empty()) {
      CheckReplaceable(path, magic, false);
    }
    if (ftruncate(m_file, 0) != 0) {
      ThrowSystemError();
    }
    Append(start);
    if (std::rename(part.c_str(), path.c_str()) != 0) {
      ThrowSystemError();
    }
  } catch (const CARGoSException&) {
    ::unlink(part.c_str());
    Abandon();
    throw;
  }
}

void CGrowingFile::Append(std::string_view piece) {
  std::string reason;
  if (WriteBytes(m_file, piece, reason) < piece.size()) {
    if (m_isRegular && ftruncate(m_file, static_cast<off_t>(m_size)) != 0) {
      reason += "; its end may be cut";
    }
    THROW_ARGOSEXCEPTION(reason);
  }
  m_size += piece.size();
}

void CGrowingFile::Close() {
  // some file systems report a full disk only here
  if (::close(std::exchange(m_file, -1)) != 0 && errno != EINTR) {
    ThrowSystemError();
  }
}

void CGrowingFile::Abandon() {
  if (m_file >= 0) {
    ::close(std::exchange(m_file, -1));
  }
}

}  // namespace argos
