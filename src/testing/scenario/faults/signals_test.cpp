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
    REQUIRE(std::regex_search(result.Notices, match, message));
    CHECK(match[1].str() == (isInterrupt ? "SIGINT" : "SIGTERM"));
    CheckSteps(result.Out, experiment.Robots, std::stoul(match[2].str()));
    CHECK_THAT(result.Notices, Contains("simulated "));
    CHECK_THAT(result.Out, Contains("digest: "));
  }
}

TEST_CASE("signals: those of terminals and batch systems end a run in order", "[faults][signals]") {
  SFaultExperiment experiment;
  experiment.Params = "logs='true'";
  experiment.Length = "0";
  const auto [signal, name] = GENERATE(
      table<int, std::string>({{SIGHUP, "SIGHUP"}, {SIGUSR1, "SIGUSR1"}, {SIGUSR2, "SIGUSR2"}}));
  CAPTURE(name);
  const CTestFolder folder;
  folder.Write("e.argos", experiment.ToXml());
  const SProgramRun run = folder.Run({"-c", "e.argos", "--csv", "o"}, signal, "ep1 steps");
  CHECK(run.Status == 128 + signal);
  CHECK(run.Err == "");
  std::smatch match;
  REQUIRE(std::regex_search(run.Notices, match,
                            std::regex("stopped by (SIG[A-Z0-9]+) after tick ([0-9]+)")));
  CHECK(match[1].str() == name);
  CHECK_THAT(folder.Read("o/metrics.csv"), Contains("\n0," + match[2].str() + ","));
}

TEST_CASE("signals: one that is ignored stays so", "[faults][signals]") {
  const auto old = std::signal(SIGINT, SIG_IGN);
  SFaultExperiment experiment;
  experiment.Params = "logs='true'";
  experiment.Length = "20";
  const CTestFolder folder;
  folder.Write("e.argos", experiment.ToXml());
  const SProgramRun run = folder.Run({"-c", "e.argos"}, SIGINT, "ep1 steps");
  std::signal(SIGINT, old);
  CHECK(run.Status == 0);
  CHECK_THAT(run.Notices, !Contains("stopped by"));
}

TEST_CASE("exit: where code calls it, the run ends in order, with the status of the call",
          "[faults][signals]") {
  SFaultExperiment experiment;
  const bool isRobot = GENERATE(false, true);
  const std::string threads = GENERATE("0", "2");
  CAPTURE(isRobot, threads);
  const std::string deed = "what='exit' tick='3'";
  if (isRobot) {
    experiment.Params = "where='step' robot='ep2' " + deed;
  } else {
    experiment.Loop = "where='post_step' " + deed;
  }
  const CTestFolder folder;
  folder.Write("e.argos", experiment.ToXml());
  const SProgramRun run =
      folder.Run({"-c", "e.argos", "--threads", threads, "--csv", "o", "--record", "run.rec"});
  CHECK(run.Status == 7);
  CHECK_THAT(run.Err,
             Contains("exit(7) was called: the run ends at tick 3") &&
                 Contains(isRobot ? "robot \"ep2\", controller \"c\": ControlStep() in tick 3"
                                  : "PostStep() in tick 3"));
  // the state of a tick is complete when hooks run, but not while robots do
  const std::string last = isRobot ? "2" : "3";
  for (const char* const table : {"o/robots.csv", "o/metrics.csv"}) {
    const std::string text = folder.Read(table);
    CHECK_THAT(text, Contains("\n0," + last + ",0." + last + ","));
    CHECK_THAT(text, !Contains("\n0," + std::to_string(std::stoi(last) + 1) + ","));
    CHECK(text.back() == '\n');
  }
  const SProgramRun replay = folder.Run({"-z", "--replay", "run.rec"});
  CHECK(replay.Status == 0);
  CHECK(replay.Err == "");
  CHECK_THAT(replay.Out, Contains("Replaying ticks 0 to " + last));
}

TEST_CASE("exit: a call while the experiment is loaded is reported", "[faults][signals]") {
  SFaultExperiment experiment;
  experiment.Loop = "where='init' what='exit'";
  const CTestFolder folder;
  folder.Write("e.argos", experiment.ToXml());
  const std::vector<std::string> arguments = {"-c", "e.argos"};
  for (const bool isCheck : {false, true}) {
    CAPTURE(isCheck);
    const SProgramRun run =
        folder.Run(isCheck ? std::vector<std::string>{"-c", "e.argos", "--check"} : arguments);
    CHECK(run.Status == 7);
    CHECK_THAT(run.Err, Contains("Init()") && Contains("exit(7) was called"));
  }
}

}  // namespace signals_test
