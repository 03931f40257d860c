// Machines that give too few threads or too little memory: a message and status 1.

#include "../command_line/program_run.h"
#include "fault_experiment.h"

#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <sys/resource.h>

namespace threads_test {

using namespace argos;
using Catch::Contains;

namespace {

// limits a resource of programs that are started during its lifetime
class CLimit {
 public:
  CLimit(__rlimit_resource resource, rlim_t limit) : m_resource(resource) {
    REQUIRE(getrlimit(resource, &m_previous) == 0);
    const rlimit reduced{std::min(limit, m_previous.rlim_max), m_previous.rlim_max};
    REQUIRE(setrlimit(resource, &reduced) == 0);
  }
  ~CLimit() { setrlimit(m_resource, &m_previous); }
  CLimit(const CLimit&) = delete;
  CLimit& operator=(const CLimit&) = delete;

 private:
  __rlimit_resource m_resource;
  rlimit m_previous{};
};

constexpr rlim_t kMegabyte = 1024 * 1024;

// LLVM aborts while it is loaded; OSMesa uses what malloc() returns without looking at it, perhaps
// in a function of the C library
bool HasFailedInLibraryOfOthers(const std::string& errors) {
  const size_t stack = errors.find("  #0 ");
  const std::string top =
      stack == std::string::npos ? "" : errors.substr(stack, errors.find("  #2 ", stack) - stack);
  return errors.find("LLVM ERROR: out of memory") != std::string::npos ||
         top.find("/libOSMesa.so") != std::string::npos;
}

}  // namespace

TEST_CASE("memory: placing robots without enough memory ends with a message",
          "[faults][memory][command_line]") {
  if (!kCanLimitMemory) {
    return;
  }
  SFaultExperiment experiment;
  experiment.Robots = 20000;
  experiment.Sensors = "<epuck_proximity implementation='default'/>";
  experiment.Media = "<led id='leds'/><range_and_bearing id='rab'/>";
  experiment.Length = "0.3";
  const CTestFolder folder;
  folder.Write("e.argos", experiment.ToXml());
  int failed = 0;
  int succeeded = 0;
  for (rlim_t megabytes = 60; megabytes <= 420; megabytes += 8) {
    CAPTURE(megabytes);
    const CLimit limit(RLIMIT_AS, megabytes * kMegabyte);
    const SProgramRun run = folder.Run({"-c", "e.argos"});
    if (run.Status == 0) {
      ++succeeded;
      continue;
    }
    if (run.Status == 127) {
      // the dynamic linker has no memory for the libraries of the program
      continue;
    }
    if (HasFailedInLibraryOfOthers(run.Err)) {
      continue;
    }
    ++failed;
    INFO(run.Err);
    CHECK(run.Status == 1);
    CHECK_THAT(run.Err, Contains("memory") || Contains("failed to map segment"));
  }
  CHECK(failed > 3);
  CHECK(succeeded > 0);
}

// hidden: where the stacks of threads take all address space, the C library may abort a thread that
// starts, before any code of ours
TEST_CASE("memory: threads without enough memory for their stacks are an error with status 1",
          "[.][faults][memory][command_line][threads]") {
  if (!kCanLimitMemory) {
    return;
  }
  const CTestFolder folder;
  folder.Write("e.argos", SFaultExperiment().ToXml());
  const CLimit limit(RLIMIT_AS, 400 * kMegabyte);
  const SProgramRun run = folder.Run({"-c", "e.argos", "--threads", "500"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("the system started only ") && Contains(" of 500 threads"));
}

}  // namespace threads_test
