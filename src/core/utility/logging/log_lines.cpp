#include <argos3/core/utility/logging/log_lines.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace argos {

namespace {

std::atomic<ELogLevel> g_level{ELogLevel::Info};

struct SReceiver {
  std::mutex Mutex;
  CLogControl::TLineReceiver Function;
  std::atomic<bool> IsSet{false};

  void Set(CLogControl::TLineReceiver function) {
    const std::lock_guard<std::mutex> lock(Mutex);
    Function = std::move(function);
    IsSet = static_cast<bool>(Function);
  }
};

// function-local: logs are flushed during the destruction of static objects
SReceiver& Receiver() {
  static SReceiver* const receiver = std::make_unique<SReceiver>().release();
  return *receiver;
}

struct SObservers {
  std::mutex Mutex;
  std::vector<const CLogObserver*> List;
  std::atomic<bool> IsAny{false};
};

SObservers& Observers() {
  static SObservers* const observers = std::make_unique<SObservers>().release();
  return *observers;
}

// trivially destructible, so it can be read after the destructor of g_label
thread_local bool g_labelIsSet = false;

struct SThreadLabel {
  std::shared_ptr<const std::string> Text;
  ~SThreadLabel() { g_labelIsSet = false; }
};

thread_local SThreadLabel g_label;

std::string WithoutColors(const std::string& line) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '\x1b') {
      text += line[i];
      continue;
    }
    i = std::min(line.find('m', i), line.size());
  }
  return text;
}

struct SMark {
  const char* Text;
  ELogLevel Level;
};

constexpr SMark kMarks[] = {{"[FATAL]", ELogLevel::Error},
                            {"[ERROR]", ELogLevel::Error},
                            {"[WARNING]", ELogLevel::Warning},
                            {"[INFO]", ELogLevel::Info},
                            {"[DEBUG]", ELogLevel::Debug}};

// the mark at the start of a line, after an escape sequence for its colour
const SMark* FindMark(const std::string& line, std::size_t& end) {
  std::size_t start = 0;
  while (start < line.size() && line[start] == '\x1b') {
    start = std::min(line.find('m', start), line.size() - 1) + 1;
  }
  for (const SMark& mark : kMarks) {
    const std::string_view text = mark.Text;
    if (line.compare(start, text.size(), text) == 0) {
      end = start + text.size();
      return &mark;
    }
  }
  end = start;
  return nullptr;
}

void AddLabel(std::string& line, std::size_t place, bool isMarked, const std::string& label) {
  line.insert(place, isMarked ? " [" + label + ']' : '[' + label + "] ");
}

}  // namespace

void CLogControl::SetLevel(ELogLevel level) {
  g_level = level;
}

ELogLevel CLogControl::GetLevel() {
  return g_level;
}

void CLogControl::SetLineReceiver(TLineReceiver receiver) {
  Receiver().Set(std::move(receiver));
}

CLogObserver::CLogObserver(CLogControl::TLineReceiver show) : m_show(std::move(show)) {
  SObservers& observers = Observers();
  const std::lock_guard<std::mutex> lock(observers.Mutex);
  observers.List.push_back(this);
  observers.IsAny = true;
}

CLogObserver::~CLogObserver() {
  SObservers& observers = Observers();
  const std::lock_guard<std::mutex> lock(observers.Mutex);
  std::erase(observers.List, this);
  observers.IsAny = !observers.List.empty();
}

void CLogControl::SetThreadLabel(const std::string& label) {
  g_label.Text = label.empty() ? nullptr : std::make_shared<const std::string>(label);
  g_labelIsSet = !label.empty();
}

std::string CLogControl::GetThreadLabel() {
  const std::shared_ptr<const std::string> label = GetThreadLabelOrNull();
  return label != nullptr ? *label : "";
}

std::shared_ptr<const std::string> GetThreadLabelOrNull() {
  return g_labelIsSet ? g_label.Text : nullptr;
}

void CLogLines::Observe(std::string_view text) {
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    m_observed += text.substr(0, end);
    std::size_t place = 0;
    const SMark* const mark = FindMark(m_observed, place);
    const ELogLevel level = mark != nullptr ? mark->Level : m_unmarked;
    const std::string line = WithoutColors(m_observed);
    SObservers& observers = Observers();
    const std::lock_guard<std::mutex> lock(observers.Mutex);
    for (const CLogObserver* observer : observers.List) {
      observer->Show(level, line);
    }
    m_observed.clear();
    text.remove_prefix(end + 1);
  }
  m_observed += text;
}

void CLogLines::Write(std::string_view text, const std::string* label) {
  if (Observers().IsAny) {
    Observe(text);
  } else {
    m_observed.clear();
  }
  const bool isPlain = g_level >= ELogLevel::Info && !Receiver().IsSet && label == nullptr;
  if (isPlain && m_line.empty()) {
    m_stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    return;
  }
  while (!text.empty()) {
    if (m_line.empty()) {
      m_label = label != nullptr ? *label : "";
    }
    const std::size_t end = text.find('\n');
    m_line += text.substr(0, end);
    if (end == std::string_view::npos) {
      return;
    }
    m_line += '\n';
    EndLine();
    text.remove_prefix(end + 1);
  }
}

void CLogLines::Finish() {
  if (!m_line.empty()) {
    EndLine();
  }
}

void CLogLines::EndLine() {
  std::string line;
  line.swap(m_line);
  std::size_t place = 0;
  const SMark* const mark = FindMark(line, place);
  const ELogLevel level = mark != nullptr ? mark->Level : m_unmarked;
  // Debug marks of users' code are dropped only where Info is
  if (std::min(level, ELogLevel::Info) > g_level) {
    return;
  }
  if (!m_label.empty()) {
    AddLabel(line, place, mark != nullptr, m_label);
  }
  SReceiver& receiver = Receiver();
  const std::lock_guard<std::mutex> lock(receiver.Mutex);
  if (!receiver.Function) {
    m_stream.write(line.data(), static_cast<std::streamsize>(line.size()));
    return;
  }
  std::string text = WithoutColors(line);
  if (!text.empty() && text.back() == '\n') {
    text.pop_back();
  }
  receiver.Function(level, text);
}

}  // namespace argos
