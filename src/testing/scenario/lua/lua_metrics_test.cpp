// metrics.record() of robots and loop functions.

#include <argos3/core/simulator/space/metrics.h>

#include "lua_world.h"

#include <catch2/catch.hpp>

namespace lua_metrics_test {

using namespace argos;
using Catch::Contains;

namespace {

// a robot whose step() runs a statement, and an error ends the run
SLuaExperiment Step(const std::string& statement) {
  return {.Script =
              "function init() end function reset() end function destroy() end\n"
              "function step() " +
              statement + " end",
          .Params = "on_error='end_run'"};
}

}  // namespace

TEST_CASE("lua metrics: a script records numbers of its robot", "[lua][metrics]") {
  CLuaWorld world(Step("metrics.record('depth', 2.5, 'm') metrics.record('depth', 3)"));
  world.Step(3);
  const CMetrics::SMetric* const depth = world.GetSimulator().GetMetrics().Find("depth");
  REQUIRE(depth != nullptr);
  CHECK(depth->Value == 2.75);
  CHECK(depth->Count == 2);
  CHECK(depth->Tick == 3);
  CHECK(depth->Unit == "m");
}

TEST_CASE("lua metrics: loop functions record in every hook", "[lua][metrics]") {
  SLuaExperiment experiment = Step("");
  experiment.LoopScript =
      "function init() metrics.record('start', 1) end\n"
      "function pre_step() metrics.record('half', 1) end\n"
      "function post_step() metrics.record('half', 2) simulation.metric('replaced', 5) end\n"
      "function reset() metrics.record('start', 4) end\n";
  CLuaWorld world(experiment);
  CMetrics& metrics = world.GetSimulator().GetMetrics();
  CHECK(metrics.Find("start")->Value == 1.0);
  world.Step(2);
  CHECK(metrics.Find("half")->Value == 1.5);
  CHECK(metrics.Find("replaced")->Value == 5.0);
  world.GetSimulator().Reset();
  CHECK(metrics.Find("start")->Value == 4.0);
  CHECK(metrics.Find("half")->Count == 0);
}

TEST_CASE("lua metrics: wrong calls are errors with robot, line and argument", "[lua][metrics]") {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"metrics.record()", "argument 1 must be a string"},
      {"metrics.record('a')", "argument 2 must be a number"},
      {"metrics.record('a', '1')", "argument 2 must be a number, got string \"1\""},
      {"metrics.record('a', 1, 2)", "argument 3 must be a string, got 2"},
      {"metrics.record('a', 1, 'm', 4)", "too many arguments: expected 3, got 4"},
      {"metrics.record('a', 0/0)", "the metric \"a\" must be a finite number"},
      {"metrics.record('a', math.huge)", "the metric \"a\" must be a finite number"},
      {"metrics.record('a b', 1)", "letters, digits and '_'"}};
  for (const auto& [statement, message] : cases) {
    CAPTURE(statement);
    CLuaWorld world(Step(statement));
    std::string error;
    try {
      world.Step();
    } catch (const std::exception& exception) {
      error = exception.what();
    }
    CHECK_THAT(error,
               Contains("robot \"fb\"") && Contains("metrics.record: ") && Contains("robot.lua:2"));
    CHECK_THAT(error, Contains(message));
  }
}

TEST_CASE("lua metrics: the unit cannot change, and pcall catches that", "[lua][metrics]") {
  CLuaWorld world(
      Step("metrics.record('a', 1, 'm') if not first then first = true else "
           "_, message = pcall(metrics.record, 'a', 1, 'cm') end"));
  world.Step(2);
  CHECK_THAT(world.Get("message"), Contains("has the unit \"m\", found \"cm\""));
  CHECK(world.GetSimulator().GetMetrics().Find("a")->Count == 1);
}

}  // namespace lua_metrics_test
