#include <argos3/testing/benchmark/in_child.h>

#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>

#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cstdio>
#include <sstream>

namespace argos::testing {

double SecondsSince(TBenchmarkClock::time_point start) {
  return std::chrono::duration<double>(TBenchmarkClock::now() - start).count();
}

double SecondsOfThisThread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool RunInChild(const std::function<void()>& measure) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    try {
      CDynamicLoading::LoadAllLibraries();
      std::ostringstream log;
      LOG.GetStream().rdbuf(log.rdbuf());
      measure();
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      _exit(1);
    }
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace argos::testing
