#include <argos3/campaign/execution/run_check.h>

#include <argos3/campaign/execution/run_execution.h>
#include <argos3/campaign/execution/worker.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/line_marks.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/support/scratch_folder.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace argos {

namespace {

[[noreturn]] void CheckInFork(const SRunSetup& setup, const SRunRequest& request) {
  bool isGood = false;
  try {
    PrepareWorker(setup);
    isGood = LoadRun(setup, request);
  } catch (...) {
    LOGERR << MarkLines(DescribeCurrentException()) << std::endl;
    LOGERR.Flush();
  }
  _exit(isGood ? 0 : 1);
}

}  // namespace

bool CheckRun(const SRunSetup& setup, SRunRequest request) {
  const CScratchFolder folder("argos3_check_");
  request.Folder = folder.GetPath().string();
  // what is buffered would be written twice
  LOG.Flush();
  LOGERR.Flush();
  std::fflush(nullptr);
  const pid_t process = fork();
  if (process == 0) {
    CheckInFork(setup, request);
  }
  if (process < 0) {
    THROW_ARGOSEXCEPTION("a process cannot be started: " << std::strerror(errno));
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) {
    std::fprintf(stderr, "[FATAL] loading was ended by signal %d (%s)\n", WTERMSIG(status),
                 strsignal(WTERMSIG(status)));
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace argos
