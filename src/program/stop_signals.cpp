#include <argos3/program/stop_signals.h>

#include <unistd.h>

#include <cstddef>

namespace argos {

namespace {

// s; a tick that takes longer after a signal is assumed to hang
constexpr unsigned kStopTimeout = 30;

volatile std::sig_atomic_t g_stopSignal = 0;

extern "C" void KillAfterTimeout(int) {
  // the stop signal now has its default action
  raise(g_stopSignal);
}

extern "C" void NoteStopSignal(int signal) {
  g_stopSignal = signal;
  alarm(kStopTimeout);
}

// @param always  replaces what ignores or handles the signal, too
void Catch(int signal, void (*handler)(int), bool always, struct sigaction& old) {
  sigaction(signal, nullptr, &old);
  const bool isDefault = (old.sa_flags & SA_SIGINFO) == 0 && old.sa_handler == SIG_DFL;
  if (isDefault || always) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESETHAND;
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace

CStopSignals::CStopSignals() {
  g_stopSignal = 0;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    Catch(kSignals[i], &NoteStopSignal, false, m_old[i]);
  }
  Catch(SIGALRM, &KillAfterTimeout, true, m_oldAlarm);
}

CStopSignals::~CStopSignals() {
  alarm(0);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &m_old[i], nullptr);
  }
  sigaction(SIGALRM, &m_oldAlarm, nullptr);
}

bool CStopSignals::WasStopped() {
  if (g_stopSignal == 0) {
    return false;
  }
  alarm(0);
  return true;
}

int CStopSignals::GetSignal() {
  return g_stopSignal;
}

}  // namespace argos
