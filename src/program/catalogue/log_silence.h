#ifndef ARGOS3_PROGRAM_CATALOGUE_LOG_SILENCE_H
#define ARGOS3_PROGRAM_CATALOGUE_LOG_SILENCE_H

#include <argos3/core/utility/logging/argos_log.h>

#include <sstream>
#include <streambuf>

namespace argos {

/** Discards what is written to LOG and LOGERR during its lifetime. */
class CLogSilence {
 public:
  CLogSilence() : m_out(LOG), m_err(LOGERR) {}

 private:
  class COne {
   public:
    explicit COne(CARGoSLog& log) : m_log(log) {
      m_log.Flush();
      m_previous = m_log.GetStream().rdbuf(&m_dropped);
    }
    ~COne() {
      m_log.Flush();
      m_log.GetStream().rdbuf(m_previous);
    }
    COne(const COne&) = delete;
    COne& operator=(const COne&) = delete;

   private:
    CARGoSLog& m_log;
    std::stringbuf m_dropped;
    std::streambuf* m_previous = nullptr;
  };

  COne m_out;
  COne m_err;
};

}  // namespace argos

#endif
