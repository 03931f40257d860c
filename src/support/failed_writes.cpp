#include <argos3/support/failed_writes.h>

#include <signal.h>

namespace argos {

namespace {

extern "C" void IgnoreFailedWrite(int) {}

}  // namespace

void SurviveFailedWrites() {
  // other programs would inherit SIG_IGN, but inherit no handler
  struct sigaction action {};
  action.sa_handler = &IgnoreFailedWrite;
  action.sa_flags = SA_RESTART;
  sigaction(SIGPIPE, &action, nullptr);
  sigaction(SIGXFSZ, &action, nullptr);
}

}  // namespace argos
