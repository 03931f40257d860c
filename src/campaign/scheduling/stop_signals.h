#ifndef ARGOS3_CAMPAIGN_SCHEDULING_STOP_SIGNALS_H
#define ARGOS3_CAMPAIGN_SCHEDULING_STOP_SIGNALS_H

#include <poll.h>

#include <csignal>
#include <vector>

namespace argos {

/**
 * Counts SIGINT and SIGTERM during its lifetime instead of dying of them. They are blocked except
 * in Poll(), so that none arrives between a check and the wait.
 */
class CStopSignalCount {
 public:
  CStopSignalCount();
  ~CStopSignalCount();
  CStopSignalCount(const CStopSignalCount&) = delete;
  CStopSignalCount& operator=(const CStopSignalCount&) = delete;

  /** As poll(); a signal ends the wait. @param timeout  ms. */
  int Poll(std::vector<pollfd>& files, int timeout);
  int GetCount() const;
  /** The first; 0: none. */
  int GetSignal() const;

 private:
  sigset_t m_oldMask{};
  struct sigaction m_oldInterrupt {};
  struct sigaction m_oldTerminate {};
};

}  // namespace argos

#endif
