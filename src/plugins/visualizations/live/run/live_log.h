#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_LIVE_LOG_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_LIVE_LOG_H

#include <argos3/core/utility/logging/log_control.h>
#include <argos3/plugins/simulator/visualizations/live/link/live_link.h>

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

namespace argos {

/** Passes the lines of all logs to viewers, during its lifetime. */
class CLiveLog {
 public:
  /** Lines that wait for the end of a tick, bytes; of more, the number is said. */
  static constexpr size_t kMaxBytes = size_t(1) << 20;
  /** Of a line, bytes; longer ones are cut. */
  static constexpr size_t kMaxLineBytes = 4096;

  CLiveLog();

  /** Main thread, between ticks. Takes no lock if there are no lines. */
  void HandOver(CLiveLink& link, UInt32 tick);

 private:
  struct SLine {
    ELogLevel Level;
    std::string Text;
  };

  void Add(ELogLevel level, const std::string& line);

  std::atomic<bool> m_hasLines{false};
  std::mutex m_mutex;  // guards what follows
  std::vector<SLine> m_lines;
  size_t m_numBytes = 0;
  size_t m_numDropped = 0;
  CLogObserver m_observer;  // last: it calls Add() at once
};

}  // namespace argos

#endif
