#include <argos3/core/utility/files/output_file.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/core/utility/files/lock_file.h>
#include <argos3/core/utility/files/writing.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <streambuf>
#include <system_error>
#include <utility>

namespace argos {

namespace {

constexpr std::size_t kBufferSize = 1 << 15;  // bytes
constexpr std::size_t kMaxLineBytes = 1 << 20;  // bytes; longer lines are written in parts

struct SOutputFailures {
  std::mutex Mutex;
  std::vector<std::string> Texts;
};

SOutputFailures& GetOutputFailures() {
  // never deleted, because static output files may be destroyed later
  static SOutputFailures& failures = *std::make_unique<SOutputFailures>().release();
  return failures;
}

}  // namespace

/* The text that was not written yet, and the file. */
class COutputFile::CBuffer : public std::streambuf {
 public:
  ~CBuffer() override {
    if (m_file >= 0) {
      ::close(m_file);
    }
  }

  void Open(const std::string& path, EStart start) {
    const bool append = start == EStart::Append;
    m_path = path;
    // code may change the working directory
    std::error_code error;
    m_target = std::filesystem::absolute(FollowLinks(path), error).string();
    m_reason.clear();
    m_failure.clear();
    m_isRegular = false;
    m_pending.clear();
    m_size = 0;
    std::string problem;
    m_file = OpenForWriting(path, O_CREAT | (append ? O_APPEND : 0), problem);
    struct stat information {};
    if (m_file < 0 || fstat(m_file, &information) != 0) {
      Fail(problem.empty() ? std::strerror(errno) : problem);
    }
    m_isRegular = S_ISREG(information.st_mode);
    if (m_isRegular && !TryToLock(m_file, append)) {
      const std::string holder = DescribeLockHolder(m_file);
      ::close(std::exchange(m_file, -1));
      Fail(holder + " is writing it");
    }
    if (m_isRegular && !append && ftruncate(m_file, 0) != 0) {
      Fail(std::strerror(errno));
    }
    if (m_isRegular && append && fstat(m_file, &information) == 0) {
      m_size = static_cast<std::uint64_t>(information.st_size);
    }
    m_endOfLine = m_size;
  }

  void Close() {
    if (m_file < 0) {
      return;
    }
    const bool hadFailed = !m_failure.empty();
    if (!hadFailed) {
      try {
        Write(m_pending.size());
      } catch (const CARGoSException&) {
        ::close(std::exchange(m_file, -1));
        throw;
      }
    }
    // some file systems report a full disk only here
    if (::close(std::exchange(m_file, -1)) != 0 && errno != EINTR && !hadFailed) {
      Fail(std::strerror(errno));
    }
  }

  void WriteRecord(std::string_view record) {
    Write(m_pending.size());
    if (!IsOpen()) {
      return;
    }
    m_endOfLine = m_size;
    std::string problem;
    if (WriteBytes(m_file, record, problem) < record.size()) {
      Fail(problem);
    }
    m_size += record.size();
    m_endOfLine = m_size;
  }

  bool CanReplace() const { return m_isRegular; }
  const std::string& GetTarget() const { return m_target; }

  // the other file is locked before it has the name, so that there is no moment without a lock
  void Replace(std::string_view content) {
    const std::string part = m_target + kPartSuffix;
    std::string problem;
    const int file = OpenPart(part, problem);
    if (file < 0) {
      Fail(problem);
    }
    if (ftruncate(file, 0) != 0 || (WriteBytes(file, content, problem) == content.size() &&
                                    std::rename(part.c_str(), m_target.c_str()) != 0)) {
      problem = std::strerror(errno);
    }
    if (!problem.empty()) {
      ::unlink(part.c_str());
      ::close(file);
      Fail(problem);
    }
    ::close(std::exchange(m_file, file));
    m_pending.clear();
    m_size = content.size();
    m_endOfLine = m_size;
  }

  bool IsOpen() const { return m_file >= 0; }
  std::uint64_t GetSize() const { return IsOpen() ? m_size + m_pending.size() : 0; }
  const std::string& GetReason() const { return m_reason; }
  const std::string& GetFailure() const { return m_failure; }

 protected:
  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) {
      return traits_type::not_eof(c);
    }
    if (!IsOpen()) {
      return traits_type::eof();
    }
    m_pending.push_back(traits_type::to_char_type(c));
    WriteWholeLines();
    return c;
  }

  std::streamsize xsputn(const char* text, std::streamsize length) override {
    if (!IsOpen()) {
      return 0;
    }
    m_pending.append(text, static_cast<std::size_t>(length));
    WriteWholeLines();
    return length;
  }

  int sync() override {
    if (IsOpen()) {
      Write(m_pending.size());
    }
    return 0;
  }

 private:
  void WriteWholeLines() {
    if (m_pending.size() < kBufferSize) {
      return;
    }
    const std::size_t lastBreak = m_pending.rfind('\n');
    if (lastBreak != std::string::npos) {
      Write(lastBreak + 1);
    } else if (m_pending.size() >= kMaxLineBytes) {
      Write(m_pending.size());
    }
  }

  // writes the first part of the pending text
  void Write(std::size_t length) {
    std::string problem;
    const std::size_t done =
        WriteBytes(m_file, std::string_view(m_pending).substr(0, length), problem);
    NoteWritten(done);
    if (done < length) {
      Fail(problem);
    }
  }

  // moves the ends of the file and of its last line
  void NoteWritten(std::size_t length) {
    const std::size_t lastBreak =
        length == 0 ? std::string::npos : m_pending.rfind('\n', length - 1);
    if (lastBreak != std::string::npos) {
      m_endOfLine = m_size + lastBreak + 1;
    }
    m_size += length;
    m_pending.erase(0, length);
  }

  [[noreturn]] void Fail(const std::string& reason) {
    m_reason = reason;
    m_pending.clear();
    if (m_file >= 0 && m_isRegular && ftruncate(m_file, static_cast<off_t>(m_endOfLine)) != 0) {
      m_reason += "; its last line may be cut";
    }
    m_failure = "cannot write the file \"" + m_path + "\": " + m_reason;
    THROW_ARGOSEXCEPTION(m_failure);
  }

  std::string m_path;
  std::string m_target;  // absolute, without a link
  std::string m_reason;
  std::string m_failure;
  std::string m_pending;
  int m_file = -1;
  bool m_isRegular = false;
  std::uint64_t m_size = 0;  // bytes, without those that are pending
  std::uint64_t m_endOfLine = 0;  // end of the last whole line in the file, bytes
};

COutputFile::COutputFile() : std::ostream(nullptr), m_buffer(std::make_unique<CBuffer>()) {
  rdbuf(m_buffer.get());
  // rethrows what the buffer throws
  exceptions(std::ios::badbit);
}

COutputFile::COutputFile(const std::string& path, EStart start) : COutputFile() {
  m_buffer->Open(path, start);
}

COutputFile::~COutputFile() {
  try {
    Close();
  } catch (const CARGoSException&) {
    try {
      SOutputFailures& failures = GetOutputFailures();
      const std::lock_guard<std::mutex> lock(failures.Mutex);
      failures.Texts.push_back(GetFailure());
    } catch (...) {
      // no memory for a message
      return;
    }
  }
}

void COutputFile::Open(const std::string& path, EStart start) {
  Close();
  clear();
  m_buffer->Open(path, start);
}

void COutputFile::WriteRecord(std::string_view record) {
  if (!GetFailure().empty()) {
    THROW_ARGOSEXCEPTION(GetFailure());
  }
  m_buffer->WriteRecord(record);
}

bool COutputFile::CanReplace() const {
  return m_buffer->CanReplace();
}

const std::string& COutputFile::GetTarget() const {
  return m_buffer->GetTarget();
}

void COutputFile::Replace(std::string_view content) {
  if (!GetFailure().empty()) {
    THROW_ARGOSEXCEPTION(GetFailure());
  }
  m_buffer->Replace(content);
}

void COutputFile::Close() {
  m_buffer->Close();
}

bool COutputFile::IsOpen() const {
  return m_buffer->IsOpen();
}

std::uint64_t COutputFile::GetSize() const {
  return m_buffer->GetSize();
}

const std::string& COutputFile::GetFailure() const {
  return m_buffer->GetFailure();
}

const std::string& COutputFile::GetReason() const {
  return m_buffer->GetReason();
}

std::vector<std::string> TakeOutputFailures() {
  SOutputFailures& failures = GetOutputFailures();
  const std::lock_guard<std::mutex> lock(failures.Mutex);
  return std::exchange(failures.Texts, {});
}

}  // namespace argos
