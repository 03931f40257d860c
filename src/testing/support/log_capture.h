#ifndef ARGOS3_TESTING_SUPPORT_LOG_CAPTURE_H
#define ARGOS3_TESTING_SUPPORT_LOG_CAPTURE_H

#include <argos3/core/utility/logging/argos_log.h>

#include <sstream>
#include <streambuf>
#include <string>

namespace argos {

/** Collects the output of a log during its lifetime, without colours. */
class CLogCapture {
 public:
  explicit CLogCapture(CARGoSLog& log = LOG)
      : m_log(log), m_previous(log.GetStream().rdbuf(m_text.rdbuf())) {
    m_log.DisableColoredOutput();
  }
  ~CLogCapture() {
    m_log.Flush();
    m_log.GetStream().rdbuf(m_previous);
    m_log.EnableColoredOutput();
  }
  CLogCapture(const CLogCapture&) = delete;
  CLogCapture& operator=(const CLogCapture&) = delete;

  std::string GetText() {
    m_log.Flush();
    return m_text.str();
  }

 private:
  CARGoSLog& m_log;
  std::ostringstream m_text;
  std::streambuf* m_previous;
};

}  // namespace argos

#endif
