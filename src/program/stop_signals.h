#ifndef ARGOS3_PROGRAM_STOP_SIGNALS_H
#define ARGOS3_PROGRAM_STOP_SIGNALS_H

#include <argos3/core/utility/non_copyable.h>

#include <array>
#include <csignal>

namespace argos {

/**
 * During its lifetime, the first of the signals that ask a process to end is stored, so that the
 * run ends in order after the tick: SIGINT, SIGTERM, SIGHUP (the terminal was closed), SIGUSR1 and
 * SIGUSR2 (batch systems announce the end of a job by them), SIGXCPU. A second one, or a tick that
 * takes longer than 30 s, kills the process.
 *
 * A signal that is ignored stays ignored, as by nohup and in the background of a shell script; a
 * handler that users' code has installed stays, too.
 */
class CStopSignals : private CNonCopyable {
 public:
  CStopSignals();
  ~CStopSignals();

  /** To be called after each tick. @return true if a signal was received. */
  static bool WasStopped();
  /** The number of the signal that was received; 0: none. */
  static int GetSignal();

 private:
  static constexpr std::array<int, 6> kSignals = {SIGINT,  SIGTERM, SIGHUP,
                                                  SIGUSR1, SIGUSR2, SIGXCPU};

  std::array<struct sigaction, kSignals.size()> m_old{};
  struct sigaction m_oldAlarm {};
};

}  // namespace argos

#endif
