#ifndef ARGOS3_PROGRAM_CATALOGUE_LOG_SILENCE_H
#define ARGOS3_PROGRAM_CATALOGUE_LOG_SILENCE_H

#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/non_copyable.h>

#include <sstream>
#include <streambuf>

namespace argos {

/** Discards what is written to LOG and LOGERR during its lifetime. */
class CLogSilence : private CNonCopyable {
 public:
  CLogSilence() : m_out(Redirect(LOG, &m_dropped)), m_err(Redirect(LOGERR, &m_dropped)) {}
  ~CLogSilence() {
    Redirect(LOG, m_out);
    Redirect(LOGERR, m_err);
  }

 private:
  static std::streambuf* Redirect(CARGoSLog& log, std::streambuf* target) {
    log.Flush();
    return log.GetStream().rdbuf(target);
  }

  std::stringbuf m_dropped;
  std::streambuf* m_out;
  std::streambuf* m_err;
};

}  // namespace argos

#endif
