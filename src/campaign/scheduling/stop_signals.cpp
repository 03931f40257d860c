#include <argos3/campaign/scheduling/stop_signals.h>

#include <cstddef>
#include <ctime>

namespace argos {

namespace {

volatile std::sig_atomic_t g_stopCount = 0;
volatile std::sig_atomic_t g_firstStop = 0;

extern "C" void CountStop(int signal) {
  if (g_stopCount == 0) {
    g_firstStop = signal;
  }
  g_stopCount = g_stopCount + 1;
}

}  // namespace

CStopSignalCount::CStopSignalCount() {
  g_stopCount = 0;
  g_firstStop = 0;
  sigset_t stops;
  sigemptyset(&stops);
  for (const int signal : kSignals) {
    sigaddset(&stops, signal);
  }
  sigprocmask(SIG_BLOCK, &stops, &m_oldMask);
  struct sigaction action {};
  action.sa_handler = &CountStop;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &m_old[i]);
    if (m_old[i].sa_handler != SIG_IGN) {
      sigaction(kSignals[i], &action, nullptr);
    }
  }
}

CStopSignalCount::~CStopSignalCount() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &m_old[i], nullptr);
  }
  sigprocmask(SIG_SETMASK, &m_oldMask, nullptr);
}

int CStopSignalCount::Poll(std::vector<pollfd>& files, int timeout) {
  constexpr int kMilli = 1000;
  constexpr long kNanosecondsPerMillisecond = 1'000'000;
  const timespec time{timeout / kMilli, timeout % kMilli * kNanosecondsPerMillisecond};
  return ppoll(files.data(), files.size(), &time, &m_oldMask);
}

int CStopSignalCount::GetCount() const {
  return g_stopCount;
}

int CStopSignalCount::GetSignal() const {
  return g_firstStop;
}

}  // namespace argos
