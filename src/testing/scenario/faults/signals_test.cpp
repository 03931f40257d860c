// Signals that stop a run in any tick: the status, the message, and all outputs are as after a run.

#include "../command_line/program_run.h"
#include "fault_experiment.h"

#include <catch2/catch.hpp>

#include <csignal>
#include <random>
#include <regex>
#include <sstream>

namespace signals_test {

using namespace argos;
using Catch::Contains;

namespace {

constexpr int kRuns = 12;

// the robots log one line in each step; the last tick must be complete
void CheckSteps(const std::string& out, size_t robots, size_t ticks) {
  std::istringstream lines(out);
  std::string line;
  size_t steps = 0;
  while (std::getline(lines, line)) {
    if (line.find(" steps") != std::string::npos) {
      CHECK(line == "ep" + std::to_string(steps % robots) + " steps");
      ++steps;
    }
  }
  CHECK(steps == robots * ticks);
}

}  // namespace

TEST_CASE("signals: a run that is stopped in any tick ends in order", "[faults][signals]") {
  SFaultExperiment experiment;
  experiment.Params = "logs='true'";
  experiment.Length = "0";
  // post-experiment hooks run, too
  experiment.Loop = "where='post_experiment' what='add_box'";
  std::mt19937 random(13);
  for (int run = 0; run < kRuns; ++run) {
    // a new folder: the output of the run before has the text that triggers the signal
    const CTestFolder folder;
    folder.Write("e.argos", experiment.ToXml());
    const bool isInterrupt = run % 2 == 0;
    const std::string threads = std::to_string(run % 3);
    // the signal is sent when this many lines were written
    const std::string trigger = "ep" + std::to_string(random() % experiment.Robots) + " steps";
    CAPTURE(run, threads, trigger);
    const SProgramRun result = folder.Run({"-c", "e.argos", "--threads", threads, "--digest"},
                                          isInterrupt ? SIGINT : SIGTERM, trigger);
    CHECK(result.Status == (isInterrupt ? 130 : 143));
    CHECK(result.Err == "");
    std::smatch match;
    const std::regex message("stopped by (SIGINT|SIGTERM) after tick ([0-9]+)\n");
    REQUIRE(std::regex_search(result.Out, match, message));
    CHECK(match[1].str() == (isInterrupt ? "SIGINT" : "SIGTERM"));
    CheckSteps(result.Out, experiment.Robots, std::stoul(match[2].str()));
    CHECK_THAT(result.Out, Contains("simulated ") && Contains("digest: "));
  }
}

}  // namespace signals_test
