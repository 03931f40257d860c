#ifndef ARGOS3_TESTING_UNIT_CORE_UTILITY_LOGGING_LOG_TEXT_H
#define ARGOS3_TESTING_UNIT_CORE_UTILITY_LOGGING_LOG_TEXT_H

#include <argos3/core/utility/logging/argos_log.h>

#include <sstream>
#include <string>

namespace argos {

inline const SLogColor kGreen(ARGOS_LOG_ATTRIBUTE_BRIGHT, ARGOS_LOG_COLOR_GREEN);

/** A log that writes to a text. */
struct SLog {
  explicit SLog(bool colored = false) : Log(Stream, kGreen, colored) {}
  /** @return the output since the last call. */
  std::string Flushed() {
    Log.Flush();
    const std::string text = Stream.str();
    Stream.str("");
    return text;
  }
  std::ostringstream Stream;
  CARGoSLog Log;
};

}  // namespace argos

#endif
