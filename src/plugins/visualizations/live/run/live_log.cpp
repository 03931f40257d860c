#include <argos3/plugins/simulator/visualizations/live/run/live_log.h>

#include <utility>

namespace argos {

namespace {

// Limit of a message with several lines, bytes.
constexpr size_t kMessageBytes = 16384;

const char* ToName(ELogLevel level) {
  switch (level) {
    case ELogLevel::Error:
      return "error";
    case ELogLevel::Warning:
      return "warning";
    case ELogLevel::Info:
      return "info";
    default:
      return "debug";
  }
}

}  // namespace

CLiveLog::CLiveLog()
    : m_observer([this](ELogLevel level, const std::string& line) { Add(level, line); }) {}

void CLiveLog::Add(ELogLevel level, const std::string& line) {
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (m_numBytes + line.size() > kMaxBytes) {
    ++m_numDropped;
  } else {
    m_numBytes += line.size();
    m_lines.push_back({level, line.substr(0, kMaxLineBytes)});
  }
  m_hasLines.store(true, std::memory_order_release);
}

void CLiveLog::HandOver(CLiveLink& link, UInt32 tick) {
  if (!m_hasLines.load(std::memory_order_acquire)) {
    return;
  }
  std::vector<SLine> lines;
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    lines.swap(m_lines);
    m_numBytes = 0;
    if (const size_t dropped = std::exchange(m_numDropped, 0); dropped > 0) {
      lines.push_back({ELogLevel::Warning, std::to_string(dropped) + " lines were too many"});
    }
    m_hasLines.store(false, std::memory_order_release);
  }
  TJson message = TJson::array();
  size_t size = 0;
  for (const SLine& line : lines) {
    message.push_back({{"level", ToName(line.Level)}, {"text", line.Text}, {"tick", tick}});
    size += line.Text.size();
    if (size > kMessageBytes) {
      link.PutEvent({0, ToText({{"log", std::exchange(message, TJson::array())}})});
      size = 0;
    }
  }
  if (!message.empty()) {
    link.PutEvent({0, ToText({{"log", message}})});
  }
}

}  // namespace argos
