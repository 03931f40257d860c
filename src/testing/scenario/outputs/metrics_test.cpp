// <metrics builtin="..."/>: built-in metrics in tables and recordings; metrics of Lua scripts.

#include "../command_line/program_run.h"
#include "table_reading.h"

#include <argos3/core/simulator/space/metrics.h>
#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace outputs_metrics_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr char kRobotScript[] = R"(
ticks = 0
function init() metrics.record("begun", 1) end
function reset() ticks = 0 end
function destroy() end
function step()
  ticks = ticks + 1
  metrics.record("ticks", ticks * robot.id:byte(2), "s")
  if robot.id == "f2" then metrics.record("of_one_robot_only", -ticks) end
  robot.range_and_bearing.set_data(1, ticks)
  robot.wheels.set_velocity(5, 5)
end
)";

constexpr char kLoopScript[] = R"(
function post_step()
  metrics.record("twice", simulation.clock(), "m")
  metrics.record("twice", 2 * simulation.clock())
  simulation.metric("set", simulation.clock())
end
)";

// three foot-bots: two hear each other, the third is out of range
SExperiment MakeExperiment(const CTestFolder& folder) {
  SExperiment experiment;
  experiment.Length = 0.5;
  experiment.Controllers =
      "<lua_controller id='c'><actuators><range_and_bearing implementation='default'/>"
      "<differential_steering implementation='default'/></actuators>"
      "<sensors/><params script='" +
      folder.Write("robot.lua", kRobotScript) + "'/></lua_controller>";
  experiment.Engines = "<dynamics2d id='dyn2d'/>";
  experiment.Media = "<range_and_bearing id='rab'/>";
  experiment.LoopFunctions = "<loop_functions label='lua'><params script='" +
                             folder.Write("loop.lua", kLoopScript) + "'/></loop_functions>";
  const std::string controller = "<controller config='c'/></foot-bot>";
  experiment.Arena = "<foot-bot id='f1'><body position='-3,0,0'/>" + controller +
                     "<foot-bot id='f2'><body position='-3,0.5,0'/>" + controller +
                     "<foot-bot id='f3'><body position='3,3,0'/>" + controller;
  return experiment;
}

std::string WithOutputs(const SExperiment& experiment, const std::string& outputs) {
  std::string xml = experiment.ToXml();
  xml.insert(xml.rfind("</argos-configuration>"), "<outputs>" + outputs + "</outputs>");
  return xml;
}

std::string ErrorOf(const std::string& xml) {
  try {
    const CTestWorld world(xml);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

// without the lines about the run
std::string ReadRows(const CTestFolder& folder, const std::string& name) {
  std::istringstream in(folder.Read(name));
  std::string rows;
  for (std::string line; std::getline(in, line);) {
    rows += line[0] != '#' ? line + '\n' : "";
  }
  return rows;
}

}  // namespace

TEST_CASE("metrics output: built-in metrics and those of Lua scripts, also in a replay",
          "[outputs][metrics]") {
  const CTestFolder folder;
  folder.Write("e.argos",
               WithOutputs(MakeExperiment(folder),
                           "<metrics file='m.csv' builtin='dispersion, messages,collisions'/>"
                           "<recording file='run.rec'/>"));
  const SProgramRun run = folder.Run({"-zc", "e.argos"});
  CHECK(run.Err == "");
  REQUIRE(run.Status == 0);
  const SReadTable table = ReadCSV(folder.Read("m.csv"));
  CHECK(table.Names == std::vector<std::string>{"run", "tick", "time", "robots", "stopped", "begun",
                                                "dispersion", "messages", "collisions", "ticks",
                                                "of_one_robot_only", "twice", "set"});
  CHECK_THAT(folder.Read("m.csv"), Contains("dispersion [m]") && Contains("ticks [s]"));
  CHECK(table.Columns.at("begun") == std::vector<std::string>(6, "1"));
  CHECK(table.Columns.at("messages") == std::vector<std::string>{"0", "2", "2", "2", "2", "2"});
  CHECK(table.Columns.at("collisions") == std::vector<std::string>(6, "0"));
  // the digits of f1, f2, f3 are the bytes 49, 50, 51
  CHECK(table.Columns.at("ticks") ==
        std::vector<std::string>{"", "50", "100", "150", "200", "250"});
  CHECK(table.Columns.at("of_one_robot_only") ==
        std::vector<std::string>{"", "-1", "-2", "-3", "-4", "-5"});
  CHECK(table.Columns.at("twice") == std::vector<std::string>{"", "1.5", "3", "4.5", "6", "7.5"});
  CHECK(table.Columns.at("set") == std::vector<std::string>{"", "1", "2", "3", "4", "5"});
  // centroid (-1, 7/6): squares of distances 4 + 49/36, 4 + 16/36, 16 + 121/36
  const Real expected = std::sqrt((24.0 + 186.0 / 36.0) / 3.0);
  for (const double dispersion : table.GetNumbers("dispersion")) {
    // all drive to the same side
    CHECK_THAT(dispersion, WithinAbs(expected, 1e-9));
  }

  const std::string rows = ReadRows(folder, "m.csv");
  folder.Write("views.argos",
               "<argos-configuration><outputs><metrics file='r.csv' builtin='messages'/>"
               "</outputs></argos-configuration>");
  const SProgramRun replay = folder.Run({"-z", "--replay", "run.rec", "-c", "views.argos"});
  CHECK(replay.Err == "");
  CHECK(replay.Status == 0);
  CHECK(ReadRows(folder, "r.csv") == rows);
  folder.Write("more.argos",
               "<argos-configuration><outputs><metrics file='r.csv' builtin='real_time_factor'/>"
               "</outputs></argos-configuration>");
  const SProgramRun more = folder.Run({"-z", "--replay", "run.rec", "-c", "more.argos"});
  CHECK(more.Status == 0);
  CHECK_THAT(more.Err, Contains("the recorded run had no metric \"real_time_factor\""));
}

namespace {

// records "late" from tick 3 on, and results when the run is over
constexpr char kLateScript[] = R"(
function post_step()
  metrics.record("steps", simulation.clock())
  if simulation.clock() >= 3 then metrics.record("late", 10 * simulation.clock(), "m") end
end
function post_experiment()
  metrics.record("score", 41)
  metrics.record("score", 43)
  metrics.record("steps", 1000)
end
)";

std::string LateExperiment(const CTestFolder& folder, const std::string& outputs) {
  SExperiment experiment;
  experiment.Length = 0.5;
  experiment.LoopFunctions = "<loop_functions label='lua'><params script='" +
                             folder.Write("late.lua", kLateScript) + "'/></loop_functions>";
  return WithOutputs(experiment, outputs);
}

}  // namespace

TEST_CASE(
    "metrics output: a metric gets its column when it is first recorded, and results of "
    "PostExperiment() replace those of the last tick",
    "[outputs][metrics]") {
  const CTestFolder folder;
  folder.Write("e.argos", LateExperiment(folder,
                                         "<metrics file='m.csv'/><metrics file='m.csv.gz'/>"
                                         "<metrics file='m.h5'/><recording file='run.rec'/>"));
  const SProgramRun run = folder.Run({"-zc", "e.argos"});
  CHECK(run.Err == "");
  REQUIRE(run.Status == 0);
  const SReadTable table = ReadCSV(folder.Read("m.csv"));
  CHECK(table.Names == std::vector<std::string>{"run", "tick", "time", "robots", "stopped", "steps",
                                                "late", "score"});
  CHECK_THAT(folder.Read("m.csv"), Contains("late [m]"));
  CHECK(table.Columns.at("tick") == std::vector<std::string>{"0", "1", "2", "3", "4", "5"});
  CHECK(table.Columns.at("late") == std::vector<std::string>{"", "", "", "30", "40", "50"});
  // the mean of what PostExperiment() records
  CHECK(table.Columns.at("score") == std::vector<std::string>{"", "", "", "", "", "42"});
  CHECK(table.Columns.at("steps") == std::vector<std::string>{"", "1", "2", "3", "4", "1000"});
  CHECK(Unzip(folder.Path("m.csv.gz")) == folder.Read("m.csv"));
  const std::vector<double> late = ReadHDF5Numbers(folder.Path("m.h5"), "late");
  REQUIRE(late.size() == 6);
  CHECK((std::isnan(late[0]) && std::isnan(late[2])));
  CHECK(late[3] == 30.0);
  CHECK(late[5] == 50.0);
  CHECK(ReadHDF5Numbers(folder.Path("m.h5"), "steps").back() == 1000.0);
  // a replay has them, too
  const std::string rows = ReadRows(folder, "m.csv");
  CHECK(folder.Run({"-z", "--replay", "run.rec", "--csv", "o"}).Status == 0);
  CHECK(ReadRows(folder, "o/metrics.csv") == rows);
}

TEST_CASE("metrics output: a replay counts the robots that errors had stopped",
          "[outputs][metrics]") {
  const CTestFolder folder;
  folder.Write("e.argos", WithOutputs(MakeExperiment(folder),
                                      "<metrics file='m.csv'/>"
                                      "<recording file='run.rec'/>"));
  folder.Write("robot.lua",
               "n = 0 function init() end function reset() end function destroy() end "
               "function step() n = n + 1 "
               "if n == 3 and robot.id ~= 'f2' then error('stop') end end");
  REQUIRE(folder.Run({"-zc", "e.argos"}).Status == 3);
  const SReadTable table = ReadCSV(folder.Read("m.csv"));
  CHECK(table.Columns.at("stopped") == std::vector<std::string>{"0", "0", "0", "2", "2", "2"});
  REQUIRE(folder.Run({"-z", "--replay", "run.rec", "--csv", "o"}).Status == 0);
  CHECK(ReadRows(folder, "o/metrics.csv") == ReadRows(folder, "m.csv"));
}

TEST_CASE("metrics output: results of PostExperiment() have a row even if the last tick has none",
          "[outputs][metrics]") {
  const CTestFolder folder;
  folder.Write("e.argos", LateExperiment(folder, "<metrics file='m.csv' every='3'/>"));
  REQUIRE(folder.Run({"-zc", "e.argos"}).Status == 0);
  const SReadTable table = ReadCSV(folder.Read("m.csv"));
  CHECK(table.Columns.at("tick") == std::vector<std::string>{"0", "3", "5"});
  CHECK(table.Columns.at("score") == std::vector<std::string>{"", "", "42"});
  CHECK(table.Columns.at("steps") == std::vector<std::string>{"", "3", "1000"});
}

TEST_CASE("metrics output: names of columns that each table has are refused",
          "[outputs][metrics]") {
  const CTestFolder folder;
  CTestWorld world(MakeExperiment(folder));
  CMetrics& metrics = world.GetSimulator().GetMetrics();
  for (const char* const name : {"run", "tick", "time", "robots", "stopped"}) {
    CAPTURE(name);
    const std::string quoted = '"' + std::string(name) + '"';
    CHECK_THROWS_WITH(metrics.Record(name, 1.0), Contains("must not have the name " + quoted));
    CHECK_THROWS_WITH(metrics.Set(name, 1.0), Contains(quoted));
    CHECK(metrics.Find(name) == nullptr);
  }
}

TEST_CASE("metrics output: built-in metrics do not change a run", "[outputs][metrics]") {
  const CTestFolder folder;
  const SExperiment experiment = MakeExperiment(folder);
  CTestWorld with(experiment);
  for (const std::string& name : CMetrics::ListBuiltIns()) {
    with.GetSimulator().GetMetrics().EnableBuiltIn(name);
  }
  CTestWorld without(experiment);
  with.Step(20);
  without.Step(20);
  CHECK(with.ComputeDigest() == without.ComputeDigest());
  // twenty ticks of 0.1 s take less than a minute
  const CMetrics::SMetric& factor = *with.GetSimulator().GetMetrics().Find("real_time_factor");
  CHECK(factor.Value > 2.0 / 60.0);
  CHECK_FALSE(factor.IsReproducible);
  with.GetSimulator().Reset();
  CHECK(std::isnan(factor.Value));
  CHECK(with.GetSimulator().GetMetrics().Find("messages")->Value == 0.0);
  with.Step();
  CHECK(with.GetSimulator().GetMetrics().Find("messages")->Value == 2.0);
}

TEST_CASE("metrics output: errors of built-in metrics have the file, and the nearest name",
          "[outputs][metrics]") {
  const CTestFolder folder;
  SExperiment experiment = MakeExperiment(folder);
  const auto error = [&](const std::string& builtIns) {
    return ErrorOf(WithOutputs(
        experiment, "<metrics file='" + folder.Path("m.csv") + "' builtin='" + builtIns + "'/>"));
  };
  CHECK(error("messages") == "");
  CHECK_THAT(
      error("dispersion,colisions"),
      Contains("<metrics>: \"builtin\"") &&
          Contains("there is no built-in metric \"colisions\"; did you mean \"collisions\"?"));
  experiment.Media = "<led id='leds'/>";
  experiment.Controllers.replace(
      experiment.Controllers.find("<range_and_bearing implementation='default'/>"),
      std::string("<range_and_bearing implementation='default'/>").size(), "");
  CHECK_THAT(error("messages"),
             Contains("the built-in metric \"messages\" cannot be computed in this experiment") &&
                 Contains("neither <range_and_bearing> nor <simple_radio>"));
  experiment.Media += "<simple_radio id='radios'/>";
  CHECK(error("messages") == "");
  CHECK(error("collisions") == "");
}

TEST_CASE("metrics output: a built-in metric cannot be recorded by code", "[outputs][metrics]") {
  const CTestFolder folder;
  CTestWorld world(MakeExperiment(folder));
  CMetrics& metrics = world.GetSimulator().GetMetrics();
  metrics.Record("collisions", 3.0);
  CHECK_THROWS_WITH(metrics.EnableBuiltIn("collisions"), Contains("of its own with the name"));
  metrics.EnableBuiltIn("dispersion");
  metrics.EnableBuiltIn("dispersion");
  CHECK(metrics.Find("dispersion")->IsBuiltIn);
  CHECK_THROWS_WITH(metrics.Record("dispersion", 3.0), Contains("record yours under another name"));
  CHECK_THROWS_WITH(metrics.Set("dispersion", 3.0), Contains("is built in"));
  world.GetSimulator().Destroy();
  CHECK_THROWS_WITH(world.GetSimulator().GetMetrics(), Contains("no experiment is loaded"));
}

TEST_CASE("metrics output: argos3 -q lists built-in metrics", "[outputs][metrics]") {
  const CTestFolder folder;
  const SProgramRun list = folder.Run({"-q", "built_in_metrics"});
  CHECK(list.Status == 0);
  for (const char* const name :
       {"collisions", "dispersion", "loop_cpu_time", "loop_wall_time", "messages", "other_load",
        "real_time_factor", "resident_memory", "speedup"}) {
    CHECK_THAT(list.Out, Contains("   [ " + std::string(name) + " ]\n"));
  }
  CHECK_THAT(folder.Run({"-q", "collisions"}).Out, Contains("closer than 1 mm"));
}

}  // namespace outputs_metrics_test
