// Errors of robots that do not end a run: which of them are one error, and what is said of them.

#include <argos3/core/simulator/context/robot_failures.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace robot_failures_test {

using namespace argos;
using Catch::Contains;

namespace {

using TNames = std::vector<std::string>;

void Note(CRobotFailures& failures, const std::string& robot, const std::string& cause,
          UInt32 tick = 3) {
  failures.Note(robot, tick, "[FATAL] robot \"" + robot + "\": ControlStep() threw", cause);
  failures.Report();
}

}  // namespace

TEST_CASE("robot failures: errors that differ in the robot's id only are one error",
          "[core][failures]") {
  TakeLogErr();
  CRobotFailures failures;
  CHECK(failures.IsEmpty());
  Note(failures, "fb1", "fb1 has lost its way");
  Note(failures, "fb12", "fb12 has lost its way", 5);
  // an id in another word is not meant
  Note(failures, "fb1", "fb12 has lost its way");
  REQUIRE(failures.GetErrors().size() == 2);
  CHECK(failures.GetErrors()[0].Count == 2);
  CHECK(failures.GetErrors()[0].FirstTick == 3);
  CHECK(failures.GetErrors()[0].Robots == TNames{"fb1", "fb12"});
  CHECK(failures.GetErrors()[1].Robots == TNames{"fb1"});
  const std::string log = TakeLogErr();
  CHECK_THAT(log, Contains("fb1 has lost its way") && Contains("robot \"fb1\""));
  // logged once
  CHECK_THAT(log, !Contains("robot \"fb12\": ControlStep()"));
  CHECK_THAT(failures.Summarize(),
             Contains("2 times, first in tick 3, of \"fb1\", \"fb12\": ") && Contains("once, "));
  failures.Clear();
  CHECK(failures.IsEmpty());
}

TEST_CASE("robot failures: an id of digits is a number where it has no quotes",
          "[core][failures]") {
  CRobotFailures failures;
  Note(failures, "5", "the distance is 5");
  Note(failures, "6", "the distance is 6");
  CHECK(failures.GetErrors().size() == 2);
  Note(failures, "7", "robot \"7\" is lost");
  Note(failures, "8", "robot \"8\" is lost");
  REQUIRE(failures.GetErrors().size() == 3);
  CHECK(failures.GetErrors()[2].Robots == TNames{"7", "8"});
  TakeLogErr();
}

TEST_CASE("robot failures: ten robots are named, and the others counted", "[core][failures]") {
  CRobotFailures failures;
  for (int i = 0; i < 10; ++i) {
    Note(failures, "fb" + std::to_string(i), "no");
  }
  CHECK_THAT(failures.Summarize(), Contains(", \"fb9\": ") && !Contains("more"));
  Note(failures, "fb10", "no");
  Note(failures, "fb0", "no");
  CHECK_THAT(failures.Summarize(),
             Contains("12 times") && Contains(", \"fb9\" and 1 more: ") && !Contains("fb10"));
  TakeLogErr();
}

}  // namespace robot_failures_test
