// The stack on which a thread handles signals.

#include <argos3/core/utility/threads/signal_stack.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <memory>
#include <thread>

namespace signal_stack_test {

using namespace argos;

namespace {

bool HasStack() {
  stack_t stack{};
  return sigaltstack(nullptr, &stack) == 0 && (stack.ss_flags & SS_DISABLE) == 0;
}

// the exit status of a process that calls a function
template <typename FUNCTION>
int RunInProcess(FUNCTION function) {
  const pid_t process = fork();
  if (process == 0) {
    _exit(function());
  }
  int status = 0;
  REQUIRE(waitpid(process, &status, 0) == process);
  REQUIRE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

}  // namespace

TEST_CASE("signal stack: a thread that asks for one has it until its end", "[threads]") {
  if (!kCanLimitMemory) {
    WARN("skipped: a sanitizer has stacks and threads of its own");
    return;
  }
  // in a process of its own, because it stays enabled
  CHECK(RunInProcess([] {
          CSignalStack::Enable();
          bool before = true, during = false;
          std::thread([&] {
            before = HasStack();
            CSignalStack::Use();
            during = HasStack();
          }).join();
          return before || !during ? 1 : 0;
        }) == 0);
}

TEST_CASE("signal stack: without memory the thread goes on without one", "[threads]") {
  if (!kCanLimitMemory) {
    WARN("skipped: a sanitizer leaves no room for a limit of memory");
    return;
  }
  CHECK(RunInProcess([] {
          CSignalStack::Enable();
          int result = 1;
          std::thread([&] {
            // afterwards the thread has room for small blocks
            std::make_unique<char[]>(1000).reset();
            rlimit limit{};
            getrlimit(RLIMIT_AS, &limit);
            limit.rlim_cur = 1;
            setrlimit(RLIMIT_AS, &limit);
            CSignalStack::Use();
            result = HasStack() ? 2 : 0;
          }).join();
          return result;
        }) == 0);
}

}  // namespace signal_stack_test
