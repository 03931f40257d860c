#include <argos3/campaign/scheduling/stop_signals.h>

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
  sigaddset(&stops, SIGINT);
  sigaddset(&stops, SIGTERM);
  sigprocmask(SIG_BLOCK, &stops, &m_oldMask);
  struct sigaction action {};
  action.sa_handler = &CountStop;
  sigaction(SIGINT, &action, &m_oldInterrupt);
  sigaction(SIGTERM, &action, &m_oldTerminate);
}

CStopSignalCount::~CStopSignalCount() {
  sigaction(SIGINT, &m_oldInterrupt, nullptr);
  sigaction(SIGTERM, &m_oldTerminate, nullptr);
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
