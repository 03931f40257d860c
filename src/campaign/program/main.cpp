#include <argos3/campaign/program/campaign_program.h>

#include <signal.h>

namespace {

extern "C" void DoNothing(int) {}

// with a handler, writing to a closed pipe is an error of the write instead of the end of the
// process; as in argos3, runs inherit it
void SurviveFailedWrites() {
  struct sigaction action {};
  action.sa_handler = &DoNothing;
  action.sa_flags = SA_RESTART;
  sigaction(SIGPIPE, &action, nullptr);
  sigaction(SIGXFSZ, &action, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  SurviveFailedWrites();
  return argos::RunCampaignProgram(argc, argv);
}
