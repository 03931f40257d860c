#ifndef ARGOS3_CAMPAIGN_SCHEDULING_STOP_SIGNALS_H
#define ARGOS3_CAMPAIGN_SCHEDULING_STOP_SIGNALS_H

#include <argos3/core/utility/non_copyable.h>

#include <poll.h>

#include <array>
#include <csignal>
#include <vector>

namespace argos {

/**
 * Counts the signals that ask a process to end instead of dying of them: SIGINT, SIGTERM, SIGHUP,
 * SIGUSR1 and SIGUSR2. They are blocked except in Poll(), so that none arrives between a check and
 * the wait. Those that are ignored stay ignored.
 */
class CStopSignalCount : private CNonCopyable {
 public:
  CStopSignalCount();
  ~CStopSignalCount();

  /** As poll(); a signal ends the wait. @param timeout  ms. */
  int Poll(std::vector<pollfd>& files, int timeout);
  int GetCount() const;
  /** The first; 0: none. */
  int GetSignal() const;

 private:
  static constexpr std::array<int, 5> kSignals = {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2};

  sigset_t m_oldMask{};
  std::array<struct sigaction, kSignals.size()> m_old{};
};

}  // namespace argos

#endif
