// Exceptions of users' code, also those that are not std::exceptions, name where they come from.

#include "fault_experiment.h"

#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

namespace foreign_exceptions_test {

using namespace argos;
using Catch::Contains;

namespace {

const std::string kInt = "not a std::exception, but of the type int";

// loads, runs three ticks, resets and destroys; the text of the first error
std::string ErrorOf(const SFaultExperiment& experiment) {
  std::string error;
  const auto attempt = [&error](auto&& step) {
    try {
      step();
    } catch (const std::exception& exception) {
      error = error.empty() ? exception.what() : error;
    } catch (...) {
      error = "foreign exception";
    }
  };
  attempt([&] {
    CTestWorld world(experiment.ToXml());
    attempt([&] { world.Step(3); });
    if (error.empty()) {
      attempt([&] { world.GetSimulator().Execute(); });
    }
    if (error.empty()) {
      attempt([&] { world.GetSimulator().Reset(); });
    }
    attempt([&] { world.GetSimulator().Destroy(); });
  });
  TakeLogErr();
  return error;
}

}  // namespace

TEST_CASE("faults: throw 42 in a controller names robot, controller, call and tick", "[faults]") {
  const auto [where, call] = GENERATE(table<std::string, std::string>({{"init", "set up"},
                                                                       {"step", "ControlStep()"},
                                                                       {"reset", "Reset()"},
                                                                       {"destroy", "Destroy()"}}));
  CAPTURE(where);
  SFaultExperiment experiment;
  experiment.Params = "where='" + where + "' what='throw_int' robot='ep3'";
  const std::string error = ErrorOf(experiment);
  CHECK_THAT(error, Contains("robot \"ep3\"") && Contains(call) && Contains(kInt));
  if (where == "step") {
    CHECK_THAT(error, Contains("tick 1"));
  } else {
    CHECK_THAT(error, Contains("controller \"c\""));
  }
}

TEST_CASE("faults: throw 42 in a device names robot, device or call, and tick", "[faults]") {
  const std::string kind = GENERATE("sensor", "actuator");
  const std::string where = GENERATE("init", "update", "reset", "destroy");
  CAPTURE(kind, where);
  SFaultExperiment experiment;
  const std::string device =
      "<test_misbehaving implementation='default' what='throw_int' where='" + where + "'/>";
  (kind == "sensor" ? experiment.Sensors : experiment.Actuators) = device;
  const std::string error = ErrorOf(experiment);
  CHECK_THAT(error, Contains("robot \"ep") && Contains(kind) && Contains(kInt));
  if (where == "init") {
    CHECK_THAT(error, Contains("<test_misbehaving>") && Contains("controller \"c\""));
  } else if (where == "update") {
    CHECK_THAT(error, Contains("in tick 1"));
  }
}

TEST_CASE("faults: exceptions in loop functions name hook and tick", "[faults]") {
  const auto [where, call, tick] = GENERATE(table<std::string, std::string, std::string>(
      {{"init", "Init()", "tick 0"},
       {"pre_step", "PreStep()", "tick 2"},
       {"post_step", "PostStep()", "tick 2"},
       {"is_experiment_finished", "IsExperimentFinished()", "tick 3"},
       {"post_experiment", "PostExperiment()", "tick 10"},
       {"reset", "Reset()", "tick 0"},
       {"destroy", "Destroy()", "tick"}}));
  const auto [what, text] = GENERATE(
      table<std::string, std::string>({{"throw", "deliberate error"}, {"throw_int", kInt}}));
  CAPTURE(where, what);
  SFaultExperiment experiment;
  const bool isStep = where == "pre_step" || where == "post_step";
  experiment.Loop = "where='" + where + "' what='" + what + "'" + (isStep ? " tick='2'" : "");
  CHECK_THAT(ErrorOf(experiment),
             Contains("loop functions: " + call) && Contains(tick) && Contains(text));
}

TEST_CASE("faults: throw 42 in a medium names it and the tick", "[faults]") {
  const std::string where = GENERATE("init", "update");
  SFaultExperiment experiment;
  experiment.Media = "<test_misbehaving_medium id='air' what='throw_int' where='" + where + "'/>";
  CHECK_THAT(ErrorOf(experiment), Contains("medium") && Contains(kInt) &&
                                      Contains(where == "init" ? "<test_misbehaving_medium>"
                                                               : "\"air\": Update() in tick 1"));
}

TEST_CASE("faults: a lack of memory in a controller is named as such", "[faults]") {
  SFaultExperiment experiment;
  experiment.Params = "where='step' what='throw_bad_alloc' robot='ep3' tick='2'";
  CHECK_THAT(ErrorOf(experiment),
             Contains("robot \"ep3\"") && Contains("tick 2") && Contains("not enough memory"));
}

}  // namespace foreign_exceptions_test
