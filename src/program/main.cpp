#include <argos3/program/command_line.h>

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

namespace {

extern "C" void DoNothing(int) {}

// a file that the program opens must not get the number of a standard stream that was closed, or
// the logs would be written into it
bool OpenStandardStreams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    // the lowest free number is this one: those below are open
    if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", O_RDWR) != stream) {
      return false;
    }
  }
  return true;
}

// with a handler, writing to a closed pipe, or beyond the limit of a file's size, is an error of
// the write instead of the end of the process. Programs that users' code starts do not inherit it
void SurviveFailedWrites() {
  struct sigaction action {};
  action.sa_handler = &DoNothing;
  action.sa_flags = SA_RESTART;
  sigaction(SIGPIPE, &action, nullptr);
  sigaction(SIGXFSZ, &action, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  if (!OpenStandardStreams()) {
    return 1;
  }
  SurviveFailedWrites();
  return argos::RunCommandLine(argc, argv, "/proc/self/exe");
}
