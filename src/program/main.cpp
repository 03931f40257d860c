#include <argos3/program/command_line.h>
#include <argos3/support/failed_writes.h>

#include <fcntl.h>
#include <unistd.h>

namespace {

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

}  // namespace

int main(int argc, char** argv) {
  if (!OpenStandardStreams()) {
    return 1;
  }
  argos::SurviveFailedWrites();
  return argos::RunCommandLine(argc, argv, "/proc/self/exe");
}
