// The attribute on_error: robots that are stopped or quarantined by errors, and the run goes on.

#include "../command_line/program_run.h"
#include "fault_experiment.h"

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <map>

namespace on_error_test {

using namespace argos;
using Catch::Contains;
using Catch::StartsWith;

namespace {

size_t Count(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

std::vector<std::string> Stopped(CTestWorld& world) {
  std::vector<std::string> ids;
  for (const CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    if (robot->IsStopped()) {
      ids.push_back(robot->GetRootEntity().GetId());
    }
  }
  return ids;
}

CEmbodiedEntity& BodyOf(CTestWorld& world, const std::string& robot) {
  return world.Get<CComposableEntity>(robot).GetComponent<CEmbodiedEntity>("body");
}

SFaultExperiment Failing(const std::string& onError, const std::string& robot = "ep1") {
  SFaultExperiment experiment;
  experiment.ControllerAttributes = "on_error='" + onError + "'";
  experiment.Params = "where='step' what='throw' tick='3' robot='" + robot + "'";
  return experiment;
}

}  // namespace

TEST_CASE("on_error: without it an error of a C++ controller ends the run", "[faults][on_error]") {
  SFaultExperiment experiment = Failing("end_run");
  if (GENERATE(true, false)) {
    experiment.ControllerAttributes = "";
  }
  CTestWorld world(experiment.ToXml());
  CHECK_THROWS_WITH(world.Step(5), Contains("robot \"ep1\": ControlStep() threw in tick 3") &&
                                       Contains("deliberate error"));
  CHECK(world.GetSimulator().GetRobotFailures().IsEmpty());
}

TEST_CASE("on_error: another value is an error with its line", "[faults][on_error]") {
  SFaultExperiment experiment = Failing("ignore");
  const bool ofController = GENERATE(true, false);
  if (!ofController) {
    experiment.ControllerAttributes = "";
    experiment.ExperimentAttributes = "on_error='ignore'";
  }
  CHECK_THROWS_WITH(
      CTestWorld(experiment.ToXml()),
      Contains(ofController ? ":4: <test_misbehaves>" : ":2: <experiment>") &&
          Contains("must be \"end_run\", \"stop_robot\" or \"quarantine\", got \"ignore\""));
}

TEST_CASE("on_error: a stopped robot is not controlled any more, and the run goes on",
          "[faults][on_error]") {
  SFaultExperiment experiment = Failing("stop_robot");
  experiment.Params = "where='step' what='throw' robot='ep1'";
  CTestWorld world(experiment.ToXml());
  world.Step(1);
  CHECK(TakeLogErr() ==
        "[FATAL] robot \"ep1\": ControlStep() threw in tick 1\n[FATAL] deliberate error\n");
  CHECK(Stopped(world) == std::vector<std::string>{"ep1"});
  const CVector3 start = BodyOf(world, "ep1").GetOriginAnchor().Position;
  world.Step(9);
  // it is reported once, because the controller is not called again
  CHECK(TakeLogErr() == "");
  CHECK(world.GetSpace().GetSimulationClock() == 10);
  // the wheels turn as it has ordered last: before the error
  CHECK(Distance(BodyOf(world, "ep1").GetOriginAnchor().Position, start) > 0.03);
  const auto& errors = world.GetSimulator().GetRobotFailures().GetErrors();
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].Count == 1);
  CHECK(errors[0].FirstTick == 1);
  CHECK(errors[0].Robots == std::vector<std::string>{"ep1"});
}

TEST_CASE("on_error: the attribute of <experiment> holds for controllers without one",
          "[faults][on_error]") {
  SFaultExperiment experiment = Failing("stop_robot");
  experiment.ExperimentAttributes = "on_error='quarantine'";
  CTestWorld own(experiment.ToXml());
  own.Step(4);
  CHECK_FALSE(own.GetSpace().GetControllableEntities()[1]->IsQuarantined());
  experiment.ControllerAttributes = "";
  CTestWorld inherited(experiment.ToXml());
  inherited.Step(4);
  CHECK(inherited.GetSpace().GetControllableEntities()[1]->IsQuarantined());
  TakeLogErr();
}

TEST_CASE("on_error: equal errors of many robots are logged once, for any number of threads",
          "[faults][on_error][threads]") {
  const UInt32 threads = GENERATE(0, 2, 4);
  SFaultExperiment experiment = Failing("stop_robot", "");
  experiment.Robots = 150;
  experiment.Threads = threads;
  CTestWorld world(experiment.ToXml());
  world.Step(5);
  const std::string log = TakeLogErr();
  CHECK_THAT(log, StartsWith("[FATAL] robot \"ep0\": ControlStep() threw in tick 3\n"));
  CHECK(Count(log, "[FATAL] robot") == 1);
  const auto& errors = world.GetSimulator().GetRobotFailures().GetErrors();
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].Count == 150);
  CHECK(Stopped(world).size() == 150);
  CHECK(world.GetSimulator().GetRobotFailures().Summarize() ==
        "[FATAL] 150 times, first in tick 3, of \"ep0\", \"ep1\", \"ep2\", \"ep3\", \"ep4\", "
        "\"ep5\", \"ep6\", \"ep7\", \"ep8\", \"ep9\" and 140 more: robot \"ep0\": ControlStep() "
        "threw in tick 3\n[FATAL]   deliberate error\n");
}

TEST_CASE("on_error: a device that fails stops its robot", "[faults][on_error]") {
  const std::string kind = GENERATE("sensor", "actuator");
  CAPTURE(kind);
  SFaultExperiment experiment;
  experiment.ControllerAttributes = "on_error='stop_robot'";
  (kind == "sensor" ? experiment.Sensors : experiment.Actuators) =
      "<test_misbehaving implementation='default' where='update' what='throw_int' robot='ep1'/>";
  CTestWorld world(experiment.ToXml());
  world.Step(5);
  CHECK_THAT(TakeLogErr(), StartsWith("[FATAL] robot \"ep1\": " +
                                      std::string(kind == "sensor" ? "a sensor" : "an actuator") +
                                      " threw in tick 1\n"));
  CHECK(Stopped(world) == std::vector<std::string>{"ep1"});
}

TEST_CASE("on_error: a quarantined robot is in no engine, no index and no medium",
          "[faults][on_error][quarantine]") {
  const std::string engine = GENERATE("dynamics2d", "dynamics3d", "kinematics2d", "pointmass3d");
  CAPTURE(engine);
  SFaultExperiment experiment = Failing("quarantine");
  experiment.Engine = "<" + engine + " id='engine'/>";
  CTestWorld world(experiment.ToXml());
  world.Step(2);
  CEmbodiedEntity& body = BodyOf(world, "ep1");
  REQUIRE(body.GetPhysicsModelsNum() == 1);
  const CVector3 place = body.GetOriginAnchor().Position;
  const CRay3 ray(place + CVector3(0.1, 0, 0.02), place + CVector3(-0.1, 0, 0.02));
  SEmbodiedEntityIntersectionItem hit;
  REQUIRE(world.GetSpace().GetBodyIndex().FindClosestHit(hit, ray));
  world.Step(1);
  CHECK(Stopped(world) == std::vector<std::string>{"ep1"});
  CHECK(body.GetPhysicsModelsNum() == 0);
  world.Step(5);
  CHECK_FALSE(world.GetSpace().GetBodyIndex().FindClosestHit(hit, ray));
  // all its components have left their media
  for (CEntity* component : world.Get<CComposableEntity>("ep1").GetExistingComponents()) {
    CHECK_FALSE(component->IsEnabled());
  }
  TakeLogErr();
}

TEST_CASE("on_error: Reset() takes stopped and quarantined robots back, bit-identically",
          "[faults][on_error][quarantine][threads]") {
  const std::string onError = GENERATE("stop_robot", "quarantine");
  const std::string engine = GENERATE("dynamics2d", "dynamics3d", "kinematics2d", "pointmass3d");
  const UInt32 threads = GENERATE(0, 2);
  CAPTURE(onError, engine, threads);
  SFaultExperiment experiment = Failing(onError, "");
  experiment.Params = "where='step' what='throw' tick='3'";
  experiment.Robots = 70;
  experiment.Threads = threads;
  experiment.Engine = "<" + engine + " id='engine'/>";
  experiment.Sensors = "<epuck_proximity implementation='default'/>";
  experiment.Media = "<led id='leds'/><range_and_bearing id='rab'/>";
  // only every other robot misbehaves: ep1 is one robot
  if (GENERATE(false, true)) {
    experiment.Params += " robot='ep1'";
  }
  std::vector<UInt64> digests;
  CTestWorld world(experiment.ToXml());
  digests.push_back(world.ComputeDigest());
  for (int tick = 0; tick < 6; ++tick) {
    world.Step();
    digests.push_back(world.ComputeDigest());
  }
  CHECK_FALSE(Stopped(world).empty());
  for (int run = 0; run < 2; ++run) {
    world.GetSimulator().Reset();
    CHECK(Stopped(world).empty());
    CHECK(world.ComputeDigest() == digests[0]);
    for (size_t tick = 1; tick < digests.size(); ++tick) {
      world.Step();
      CAPTURE(run, tick);
      CHECK(world.ComputeDigest() == digests[tick]);
    }
  }
  // the error of each of the three runs counts
  CHECK(world.GetSimulator().GetRobotFailures().GetErrors()[0].Count == 3 * Stopped(world).size());
  TakeLogErr();
}

TEST_CASE("on_error: a program whose robots were stopped says so and ends with status 3",
          "[faults][on_error][command_line]") {
  const CTestFolder folder;
  folder.Write("bad.lua",
               "function init() end\nfunction step() error('tired of ' .. robot.id) end\n"
               "function reset() end\nfunction destroy() end\n");
  SFaultExperiment experiment = Failing("quarantine", "");
  folder.Write("cpp.argos", experiment.ToXml());
  const SProgramRun cpp = folder.Run({"-c", "cpp.argos", "--digest", "--threads", "2"});
  CHECK(cpp.Status == 3);
  CHECK_THAT(cpp.Notices, Contains("simulated 1 s"));
  CHECK_THAT(cpp.Out, Contains("digest: "));
  CHECK_THAT(cpp.Err,
             Contains("[FATAL] 5 of 5 robots are stopped because of errors, 5 of them in "
                      "quarantine; all errors of robots in this run:\n[FATAL] 5 times, first in "
                      "tick 3, of \"ep0\", \"ep1\", \"ep2\", \"ep3\", \"ep4\": "));
  CHECK(Count(cpp.Err, "deliberate error") == 2);

  std::string lua = experiment.ToXml();
  const std::string cppController = "<test_misbehaves id='c'";
  lua.replace(lua.find(cppController), cppController.size(), "<lua_controller id='c'");
  lua.replace(lua.find("</test_misbehaves>"), 18, "</lua_controller>");
  lua.replace(lua.find("<params "), 8, "<params script='bad.lua' ");
  const auto [onError, status] = GENERATE(
      table<std::string, int>({{"", 3}, {"end_run", 1}, {"stop_robot", 3}, {"quarantine", 3}}));
  CAPTURE(onError);
  lua.replace(lua.find("on_error='quarantine'"), 21,
              onError.empty() ? "" : "on_error='" + onError + "'");
  folder.Write("lua.argos", lua);
  const SProgramRun run = folder.Run({"-c", "lua.argos"});
  CHECK(run.Status == status);
  CHECK_THAT(run.Err, Contains("robot \"ep0\": the Lua script \"bad.lua\" failed in step()"));
  if (status == 3) {
    CHECK(Count(run.Err, "tired of") == 2);
    CHECK_THAT(run.Err, Contains("5 of 5 robots are stopped"));
  }
}

TEST_CASE("on_error: the report of many failed robots takes linear time", "[faults][on_error]") {
  constexpr size_t kRobots = FewerIfSanitized(100000);
  CRobotFailures failures;
  for (size_t i = 0; i < kRobots; ++i) {
    const std::string robot = "ep" + std::to_string(i);
    failures.Note(robot, 1, "context", "the same");
    failures.Note(robot, 1, "context", "error " + std::to_string(i) + " of its kind");
  }
  // comparing each with all others takes minutes
  failures.Report();
  CHECK(failures.GetErrors().size() == kRobots + 1);
  CHECK(failures.GetErrors()[0].Count == kRobots);
  CHECK(failures.GetErrors()[0].Robots.size() == kRobots);
  CHECK(failures.GetErrors()[0].Robots[1] == "ep1");
  CHECK(Count(failures.Summarize(), "error ") == kRobots);
  TakeLogErr();
}

TEST_CASE("on_error: an error of loop functions ends the run with status 1, whatever hook",
          "[faults][on_error][command_line]") {
  const std::string hook = GENERATE("init", "pre_step", "post_step", "is_experiment_finished",
                                    "post_experiment", "destroy", "floor_color");
  const std::string onError = GENERATE("end_run", "quarantine");
  CAPTURE(hook, onError);
  SFaultExperiment experiment;
  experiment.Threads = 2;
  experiment.ControllerAttributes = "on_error='" + onError + "'";
  experiment.Sensors = "<ground implementation='rot_z_only'/>";
  experiment.Entities = "<floor id='floor' source='loop_functions' pixels_per_meter='1'/>";
  experiment.Loop = "where='" + hook + "' what='throw'";
  const CTestFolder folder;
  folder.Write("e.argos", experiment.ToXml());
  const SProgramRun run = folder.Run({"-c", "e.argos"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("deliberate error"));
  if (hook == "floor_color") {
    CHECK_THAT(run.Err, Contains("loop functions: GetFloorColor() in tick 1 threw"));
  }
}

}  // namespace on_error_test
