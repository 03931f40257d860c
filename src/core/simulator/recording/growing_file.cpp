#include <argos3/core/simulator/recording/growing_file.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/core/utility/files/lock_file.h>

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
class CDescriptor {
 public:
  explicit CDescriptor(int file) : m_file(file) {}
  ~CDescriptor() {
    if (m_file >= 0) {
      ::close(m_file);
    }
  }
  CDescriptor(const CDescriptor&) = delete;
  CDescriptor& operator=(const CDescriptor&) = delete;
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
    m_file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (m_file < 0) {
      ThrowSystemError();
    }
    Append(start);
    return;
  }
  if (exists) {
    CheckReplaceable(path, magic);
  }
  m_isRegular = true;
  CreateRegular(path, start);
}

void CGrowingFile::CheckReplaceable(const std::string& path, std::string_view magic) {
  const CDescriptor old(::open(path.c_str(), O_RDWR | O_CLOEXEC));
  if (old.Get() < 0) {
    ThrowSystemError();
  }
  if (!TryToLock(old.Get())) {
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

// under another name until it can be read, so that there is no moment without a readable file
void CGrowingFile::CreateRegular(const std::string& path, std::string_view start) {
  const std::string part = path + kPartSuffix;
  m_file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (m_file < 0) {
    ThrowSystemError();
  }
  if (!TryToLock(m_file)) {
    const std::string holder = DescribeLockHolder(m_file);
    Abandon();
    THROW_ARGOSEXCEPTION(holder << " is writing it");
  }
  try {
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
  size_t done = 0;
  while (done < piece.size()) {
    const ssize_t count = ::write(m_file, piece.data() + done, piece.size() - done);
    if (count >= 0) {
      done += static_cast<size_t>(count);
    } else if (errno != EINTR) {
      std::string reason = std::strerror(errno);
      if (m_isRegular && ftruncate(m_file, static_cast<off_t>(m_size)) != 0) {
        reason += "; its end may be cut";
      }
      THROW_ARGOSEXCEPTION(reason);
    }
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
