#ifndef ARGOS3_CORE_UTILITY_LOGGING_LOG_LINES_H
#define ARGOS3_CORE_UTILITY_LOGGING_LOG_LINES_H

#include <argos3/core/utility/logging/log_control.h>

#include <memory>
#include <ostream>
#include <string>
#include <string_view>

namespace argos {

/** The label of the calling thread's lines; null if it has none. */
std::shared_ptr<const std::string> GetThreadLabelOrNull();

/** Between a log and its stream: applies CLogControl to the lines. For one thread at a time. */
class CLogLines {
 public:
  /** @param unmarked  level of lines without a mark. */
  CLogLines(std::ostream& stream, ELogLevel unmarked) : m_stream(stream), m_unmarked(unmarked) {}

  /**
   * Writes a text that need not end with a line break.
   * @param label  of the thread that has logged it; may be null.
   */
  void Write(std::string_view text, const std::string* label);

  /** Writes the start of a line whose end is missing. */
  void Finish();

 private:
  void EndLine();
  void Observe(std::string_view text);

  std::ostream& m_stream;
  ELogLevel m_unmarked;
  std::string m_line;  // text so far
  std::string m_label;  // label of that line
  std::string m_observed;  // the line so far, while there is an observer
};

}  // namespace argos

#endif
