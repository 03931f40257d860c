#include <argos3/core/utility/logging/argos_log.h>

#include <argos3/core/utility/files/output_file.h>
#include <argos3/core/utility/logging/log_lines.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <new>
#include <sstream>
#include <streambuf>
#include <string_view>
#include <unistd.h>
#include <utility>
#include <vector>

namespace argos {

namespace {

constexpr const char* kColorReset = "\033[0m";

// consecutive messages of one thread with one key
struct SSegment {
  UInt64 Key;
  // orders segments with the same key: a phase that starts later has higher tickets
  UInt64 Ticket;
  std::size_t Start;
  // label of the thread at that time
  std::shared_ptr<const std::string> Label;
};

// a segment that is being flushed
struct SPiece {
  UInt64 Key;
  UInt64 Ticket;
  // index of the text, and the range in it
  std::size_t Text;
  std::size_t Start;
  std::size_t End;
  std::shared_ptr<const std::string> Label;
};

// appends to a string that can be read and truncated without a copy
class CStringAppender : public std::streambuf {
 public:
  std::string Text;

 protected:
  int_type overflow(int_type c) override {
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
      Text.push_back(traits_type::to_char_type(c));
    }
    return traits_type::not_eof(c);
  }
  std::streamsize xsputn(const char* text, std::streamsize length) override {
    Text.append(text, static_cast<std::size_t>(length));
    return length;
  }
};

/* A file behind std::cout or std::cerr, which must not throw: the latter writes in destructors. */
class CLogFile : public std::streambuf {
 public:
  COutputFile File;

 protected:
  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) {
      return traits_type::not_eof(c);
    }
    return Try([&] { File.put(traits_type::to_char_type(c)); }) ? c : traits_type::eof();
  }
  std::streamsize xsputn(const char* text, std::streamsize length) override {
    return Try([&] { File.write(text, length); }) ? length : 0;
  }
  int sync() override {
    return Try([&] { File.flush(); }) ? 0 : -1;
  }

 private:
  // the file keeps the reason of a failure
  template <typename WRITING>
  static bool Try(WRITING&& writing) {
    try {
      writing();
      return true;
    } catch (const std::exception&) {
      return false;
    }
  }
};

std::atomic<UInt64> nextLogId{0};
thread_local UInt64 sequenceKey = 0;

}  // namespace

struct CARGoSLog::SThreadBuffer {
  // recursive, because printing an item may log too
  std::recursive_mutex Mutex;
  CStringAppender Appender;
  std::ostream Stream{&Appender};
  std::vector<SSegment> Segments;

  SThreadBuffer() { Stream.imbue(std::locale::classic()); }

  // moves the contents out of the buffer
  void MoveTo(std::vector<std::string>& texts, std::vector<SPiece>& pieces) {
    const std::lock_guard<std::recursive_mutex> lock(Mutex);
    if (!Appender.Text.empty()) {
      for (std::size_t i = 0; i < Segments.size(); ++i) {
        const bool isLast = i + 1 == Segments.size();
        pieces.push_back({Segments[i].Key, Segments[i].Ticket, texts.size(), Segments[i].Start,
                          isLast ? Appender.Text.size() : Segments[i + 1].Start,
                          std::move(Segments[i].Label)});
      }
      texts.push_back(std::move(Appender.Text));
      Appender.Text.clear();
    }
    Segments.clear();
  }
};

struct CARGoSLog::SState {
  explicit SState(std::ostream& stream)
      : Lines(stream, &stream == &std::cerr ? ELogLevel::Error : ELogLevel::Info) {}

  const UInt64 Id = nextLogId++;
  std::atomic<UInt64> NextTicket{0};
  // guards the list, and writing to the stream
  std::mutex Mutex;
  // shared with the threads, because a thread may outlive the log and vice versa
  std::vector<std::shared_ptr<SThreadBuffer>> Buffers;
  // takes messages that are logged during the destruction of a thread
  std::shared_ptr<SThreadBuffer> LateBuffer;
  std::string Prefix;
  CLogLines Lines;
  // the file of RedirectToFile(); null: none
  std::unique_ptr<CLogFile> File;
  std::streambuf* OriginalBuffer = nullptr;
  std::atomic<bool> HasFailed{false};
  // empty after TakeFailure()
  std::string Failure;

  // the calling thread's buffers, by the id of the log; null if it has none
  struct SThreadTable {
    std::vector<std::shared_ptr<SThreadBuffer>> Buffers;
    ~SThreadTable();
  };
  static thread_local SThreadTable ThreadTable;
  // trivially destructible, so it can be read after the destructor of ThreadTable
  static thread_local bool ThreadTableIsGone;
};

thread_local CARGoSLog::SState::SThreadTable CARGoSLog::SState::ThreadTable;
thread_local bool CARGoSLog::SState::ThreadTableIsGone = false;

CARGoSLog::SState::SThreadTable::~SThreadTable() {
  ThreadTableIsGone = true;
}

// construction and destruction

CARGoSLog::CARGoSLog(std::ostream& stream, const SLogColor& color, bool colored)
    : m_stream(stream),
      m_color(color),
      m_colored(colored),
      m_state(std::make_unique<SState>(stream)) {
  CTextOutput prefix;
  prefix << m_color;
  m_state->Prefix = prefix.str();
}

CARGoSLog::~CARGoSLog() {
  try {
    EndRedirection();
  } catch (...) {
    // an exception at the end of the program cannot be reported
    return;
  }
}

void CARGoSLog::RedirectToFile(const std::string& name) {
  EndRedirection();
  auto file = std::make_unique<CLogFile>();
  try {
    file->File.Open(name);
  } catch (const CARGoSException&) {
    THROW_ARGOSEXCEPTION("Cannot write the log file \"" << name
                                                        << "\": " << file->File.GetReason());
  }
  DisableColoredOutput();
  const std::lock_guard<std::mutex> lock(m_state->Mutex);
  m_state->File = std::move(file);
  m_state->OriginalBuffer = m_stream.rdbuf(m_state->File.get());
}

void CARGoSLog::EndRedirection() {
  Flush();
  const std::lock_guard<std::mutex> lock(m_state->Mutex);
  m_state->Lines.Finish();
  if (m_state->File == nullptr) {
    return;
  }
  const bool redirectedAgain = m_stream.rdbuf() != m_state->File.get();
  try {
    m_state->File->File.Close();
  } catch (const CARGoSException&) {
    // noted below
  }
  if (!m_state->File->File.GetFailure().empty()) {
    NoteFailure(0);
  }
  if (!redirectedAgain) {
    m_stream.rdbuf(m_state->OriginalBuffer);
  }
  m_state->File.reset();
}

bool CARGoSLog::IsRedirected() const {
  return m_state->File != nullptr;
}

bool CARGoSLog::HasFailed() const {
  return m_state->HasFailed;
}

std::string CARGoSLog::TakeFailure() {
  const std::lock_guard<std::mutex> lock(m_state->Mutex);
  return std::exchange(m_state->Failure, {});
}

// the first failure counts; the state must be locked
void CARGoSLog::NoteFailure(int error) {
  if (m_state->HasFailed.exchange(true)) {
    return;
  }
  if (m_state->File != nullptr && !m_state->File->File.GetFailure().empty()) {
    m_state->Failure = "the log could not be written: " + m_state->File->File.GetFailure();
    return;
  }
  const bool isOut = &m_stream == &std::cout;
  const bool isErr = &m_stream == &std::cerr;
  m_state->Failure = isOut ? "the standard output" : isErr ? "the standard error" : "a log";
  m_state->Failure += " cannot be written completely";
  if (error != 0) {
    m_state->Failure += std::string(": ") + std::strerror(error);
  }
}

// order of messages

void CARGoSLog::SetSequence(UInt64 key) {
  sequenceKey = key;
}

UInt64 CARGoSLog::GetSequence() {
  return sequenceKey;
}

CARGoSLog::SThreadBuffer& CARGoSLog::GetThreadBuffer() {
  if (SState::ThreadTableIsGone) {
    const std::lock_guard<std::mutex> lock(m_state->Mutex);
    if (!m_state->LateBuffer) {
      m_state->LateBuffer = std::make_shared<SThreadBuffer>();
      m_state->Buffers.push_back(m_state->LateBuffer);
    }
    return *m_state->LateBuffer;
  }
  auto& table = SState::ThreadTable.Buffers;
  if (table.size() <= m_state->Id) {
    table.resize(m_state->Id + 1);
  }
  std::shared_ptr<SThreadBuffer>& buffer = table[m_state->Id];
  if (!buffer) {
    buffer = std::make_shared<SThreadBuffer>();
    const std::lock_guard<std::mutex> lock(m_state->Mutex);
    m_state->Buffers.push_back(buffer);
  }
  return *buffer;
}

void CARGoSLog::AddThreadSafeBuffer() {
  GetThreadBuffer();
}

// writing

CARGoSLog::CEntry::CEntry(CARGoSLog& log, bool colored) : m_buffer(log.GetThreadBuffer()) {
  std::unique_lock lock(m_buffer.Mutex);
  std::string& text = m_buffer.Appender.Text;
  std::shared_ptr<const std::string> label = GetThreadLabelOrNull();
  if (m_buffer.Segments.empty() || m_buffer.Segments.back().Key != sequenceKey ||
      m_buffer.Segments.back().Label != label) {
    m_buffer.Segments.push_back(
        {sequenceKey, log.m_state->NextTicket++, text.size(), std::move(label)});
  }
  m_start = text.size();
  if (colored) {
    text += log.m_state->Prefix;
  }
  m_prefixLength = text.size() - m_start;
  // a lack of memory, or a value that could not be printed, ends with its item
  m_buffer.Stream.clear();
  // the destructor unlocks it
  lock.release();
}

CARGoSLog::CEntry::~CEntry() {
  std::string& text = m_buffer.Appender.Text;
  if (m_prefixLength > 0) {
    // an item that printed nothing, such as std::setw(), needs no colour
    if (text.size() == m_start + m_prefixLength) {
      text.resize(m_start);
    } else {
      try {
        text += kColorReset;
      } catch (const std::bad_alloc&) {
        // if there is no memory, the colour goes on
      }
    }
  }
  m_buffer.Mutex.unlock();
}

std::ostream& CARGoSLog::CEntry::Stream() {
  return m_buffer.Stream;
}

CARGoSLog& CARGoSLog::operator<<(const std::vector<Real>& readings) {
  CEntry entry(*this, m_colored);
  for (size_t i = 0; i < readings.size(); ++i) {
    entry.Stream() << (i == 0 ? "{ " : " { ") << readings[i] << " }";
  }
  entry.Stream() << '\n';
  return *this;
}

CARGoSLog& CARGoSLog::operator<<(std::ostream& (*manipulator)(std::ostream&)) {
  // manipulators (escape sequences, line ends) are not coloured
  CEntry entry(*this, false);
  manipulator(entry.Stream());
  return *this;
}

void CARGoSLog::Flush() {
  const std::lock_guard<std::mutex> lock(m_state->Mutex);
  std::vector<std::string> texts;
  std::vector<SPiece> pieces;
  auto& buffers = m_state->Buffers;
  for (std::size_t i = 0; i < buffers.size();) {
    // the buffer of a terminated thread is referenced only here and gets no more text
    const bool isOrphan = buffers[i].use_count() == 1;
    buffers[i]->MoveTo(texts, pieces);
    if (isOrphan) {
      buffers.erase(buffers.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
  if (pieces.empty()) {
    // others write to the stream, too
    if (!m_stream) {
      NoteFailure(0);
    }
    return;
  }
  std::sort(pieces.begin(), pieces.end(), [](const SPiece& a, const SPiece& b) {
    return a.Key != b.Key ? a.Key < b.Key : a.Ticket < b.Ticket;
  });
  errno = 0;
  for (const SPiece& piece : pieces) {
    const std::string_view text = texts[piece.Text];
    m_state->Lines.Write(text.substr(piece.Start, piece.End - piece.Start), piece.Label.get());
  }
  m_stream.flush();
  if (!m_stream) {
    NoteFailure(errno);
  }
}

void CARGoSLog::WriteAfterCrash(int file) noexcept {
  const std::unique_lock<std::mutex> lock(m_state->Mutex, std::try_to_lock);
  if (!lock.owns_lock()) {
    return;
  }
  for (const std::shared_ptr<SThreadBuffer>& buffer : m_state->Buffers) {
    const std::unique_lock<std::recursive_mutex> bufferLock(buffer->Mutex, std::try_to_lock);
    if (bufferLock.owns_lock()) {
      const std::string& text = buffer->Appender.Text;
      for (std::size_t done = 0; done < text.size();) {
        const ssize_t written = write(file, text.data() + done, text.size() - done);
        if (written <= 0) {
          break;
        }
        done += static_cast<std::size_t>(written);
      }
    }
  }
}

// LOG and LOGERR, debugging

namespace {

// files and pipes get no escape sequences; https://no-color.org
bool WantsColors(int file) {
  return isatty(file) != 0 && std::getenv("NO_COLOR") == nullptr;
}

}  // namespace

CARGoSLog LOG(std::cout, SLogColor(ARGOS_LOG_ATTRIBUTE_BRIGHT, ARGOS_LOG_COLOR_GREEN),
              WantsColors(STDOUT_FILENO));
CARGoSLog LOGERR(std::cerr, SLogColor(ARGOS_LOG_ATTRIBUTE_BRIGHT, ARGOS_LOG_COLOR_RED),
                 WantsColors(STDERR_FILENO));

void CLogControl::Notify(const std::string& text) {
  CARGoSLog& log = LOG.IsRedirected() ? LOG : LOGERR;
  std::ostringstream line;
  if (log.IsColoredOutput()) {
    // within the colour of the log, which is that of errors
    line << green;
  }
  line << "[INFO] " << text;
  log << line.str() << std::endl;
  log.Flush();
}

std::size_t DEBUG_INDENTATION = 0;

void DebugPrint(const char* format, ...) {
  const CClassicLocale locale;
  std::fprintf(stderr, "%*s", static_cast<int>(DEBUG_INDENTATION), "");
  va_list arguments;
  va_start(arguments, format);
  std::vfprintf(stderr, format, arguments);
  va_end(arguments);
}

}  // namespace argos
