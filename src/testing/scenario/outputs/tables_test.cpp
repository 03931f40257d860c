// Tables: what they contain is the state of the space, in every format; robots come and go; resets;
// metrics; errors.

#include "../command_line/program_run.h"
#include "table_reading.h"

#include <argos3/core/simulator/space/metrics.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/testing/support/allocation_count.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <optional>
#include <utility>

namespace outputs_tables_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

typedef std::vector<std::pair<std::string, std::string>> TAttributes;

struct STableWorld {
  std::string Arena = Robot("e-puck", "a", PoseText({1.0, 2.0, 0.0}, 30.0)) +
                      Robot("e-puck", "b", PoseText({-1.0, 0.1, 0.0}, -100.0));
  std::vector<std::pair<std::string, TAttributes>> Outputs;
};

/* Robots that drive in circles; its end closes the files. */
class CRunningWorld {
 public:
  explicit CRunningWorld(const STableWorld& table) {
    SRobotExperiment experiment;
    experiment.Actuators = "<differential_steering implementation=\"default\"/>";
    experiment.Sensors = "<epuck_proximity implementation=\"default\"/>";
    experiment.Engine = "<dynamics2d id=\"engine\"/>";
    experiment.Arena = table.Arena;
    m_world.emplace(experiment.ToExperiment(), [&](CSimulator& simulator) {
      for (const auto& [tag, attributes] : table.Outputs) {
        simulator.AddOutput(tag, attributes);
      }
    });
    m_scope.emplace(m_world->GetSimulator());
    for (CControllableEntity* robot : m_world->GetSpace().GetControllableEntities()) {
      Drive(*robot);
    }
  }

  CTestWorld& Get() { return *m_world; }
  static void Drive(CControllableEntity& robot) {
    robot.GetController()
        .GetActuator<CCI_DifferentialSteeringActuator>("differential_steering")
        ->SetLinearVelocity(5.0, 7.0);
  }
  void Close() { m_world->GetSimulator().Destroy(); }

 private:
  std::optional<CTestWorld> m_world;
  std::optional<CSimulator::CScope> m_scope;
};

std::string ErrorOf(const std::string& tag, const TAttributes& attributes) {
  STableWorld table;
  table.Outputs = {{tag, attributes}};
  try {
    CRunningWorld world(table);
  } catch (const CARGoSException& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("tables: numbers are those of the space, in every format", "[outputs][tables]") {
  const CTestFolder folder;
  const std::string fields = "pose,orientation,wheels,leds,readings:epuck_proximity,stopped";
  STableWorld table;
  for (const char* ending : {"csv", "csv.gz", "h5"}) {
    table.Outputs.push_back({"table", {{"file", folder.Path("t.") + ending}, {"fields", fields}}});
  }
  struct SState {
    CVector3 Position;
    CQuaternion Orientation;
    Real Left;
  };
  std::vector<SState> states;
  {
    CRunningWorld world(table);
    const auto note = [&] {
      for (const char* id : {"a", "b"}) {
        auto& robot = world.Get().Get<CEPuckEntity>(id);
        const SAnchor& anchor = robot.GetEmbodiedEntity().GetOriginAnchor();
        states.push_back({anchor.Position, anchor.Orientation,
                          robot.GetComponent<CWheeledEntity>("wheels").GetWheelVelocity(0)});
      }
    };
    note();
    for (int tick = 0; tick < 30; ++tick) {
      world.Get().Step();
      note();
    }
    world.Close();
  }
  const SReadTable csv = ReadCSV(folder.Read("t.csv"));
  REQUIRE(csv.GetNumRows() == states.size());
  CHECK(csv.Names[3] == "robot");
  CHECK(csv.Columns.at("robot")[61] == "b");
  CHECK(csv.Columns.at("time")[6] == "0.3");
  const auto x = csv.GetNumbers("x");
  const auto yaw = csv.GetNumbers("yaw");
  const auto qw = csv.GetNumbers("qw");
  const auto left = csv.GetNumbers("wheel_1");
  for (std::size_t i = 0; i < states.size(); ++i) {
    CAPTURE(i);
    CHECK(x[i] == states[i].Position.GetX());
    CHECK(qw[i] == states[i].Orientation.GetW());
    CHECK(left[i] == states[i].Left);
    // a planar rotation by 2 atan2(z, w), rounded
    const double angle =
        2.0 * std::atan2(states[i].Orientation.GetZ(), states[i].Orientation.GetW());
    CHECK_THAT(std::remainder(yaw[i] - angle, 2.0 * M_PI), WithinAbs(0.0, 1e-14));
  }
  CHECK(x[60] != x[0]);
  CHECK(left[60] == 0.05);
  CHECK(Unzip(folder.Path("t.csv.gz")) == folder.Read("t.csv"));
  for (const std::string& name : csv.Names) {
    CAPTURE(name);
    if (name != "robot") {
      CHECK(ReadHDF5Numbers(folder.Path("t.h5"), name) == csv.GetNumbers(name));
    }
  }
  CHECK(ReadHDF5Texts(folder.Path("t.h5"), "robots") == std::vector<std::string>{"a", "b"});
  CHECK(ReadHDF5Numbers(folder.Path("t.h5"), "robot")[61] == 1.0);
}

TEST_CASE("tables: what controllers keep, and what touches, are fields", "[outputs][tables]") {
  const CTestFolder folder;
  STableWorld table;
  // the third one touches the second
  table.Arena += Robot("e-puck", "c", PoseText({-1.0, 0.1705, 0.0}, 0.0));
  table.Outputs = {{"table", {{"file", folder.Path("t.csv")}, {"fields", "value:food,colliding"}}}};
  {
    CRunningWorld world(table);
    auto& robot = world.Get().Get<CEPuckEntity>("b").GetControllableEntity().GetController();
    CHECK(std::isnan(robot.GetRecordedValue("food")));
    world.Get().Step();
    robot.RecordValue("food", 2.5);
    robot.RecordValue("other", 1.0);
    world.Get().Step();
    robot.RecordValue("food", -1.0);
    CHECK(robot.GetRecordedValue("food") == -1.0);
    world.Get().Step();
    robot.RecordValue("food", -0.0);
    world.Get().Step();
    CHECK_THROWS_WITH(robot.RecordValue("a b", 1.0), Contains("\"a b\" is no name"));
    CHECK_THROWS_WITH(robot.RecordValue("", 1.0), Contains("is no name"));
    CHECK_THROWS_WITH(robot.RecordValue("1a", 1.0), Contains("is no name"));
    world.Get().GetSimulator().Reset();
    CHECK(robot.GetRecordedValues().empty());
    world.Close();
  }
  const SReadTable read = ReadCSV(folder.Read("t.csv"));
  // ticks 0 to 4
  REQUIRE(read.GetNumRows() == 15);
  CHECK(read.Columns.at("food") == std::vector<std::string>{"", "", "", "", "", "", "", "2.5", "",
                                                            "", "-1", "", "", "-0", ""});
  const auto colliding = read.GetNumbers("colliding");
  CHECK(colliding[0] == 0.0);
  CHECK(colliding[1] == 1.0);
  CHECK(colliding[2] == 1.0);
}

TEST_CASE("tables: the head says from which run they are", "[outputs][tables]") {
  const CTestFolder folder;
  STableWorld table;
  table.Arena += BoxText("wall", {1.0, 2.0, 0.5}, {3.0, 0.0, 0.0}) +
                 PillarText("pillar", -3.0, 1.5, 0.25, 1.0);
  table.Outputs = {{"table", {{"file", folder.Path("t.csv")}, {"every", "3"}, {"digits", "4"}}}};
  {
    CRunningWorld world(table);
    world.Get().Step(7);
    world.Close();
  }
  const SReadTable csv = ReadCSV(folder.Read("t.csv"));
  const std::string text = folder.Read("t.csv");
  CHECK(text.rfind("# argos3 ", 0) == 0);
  CHECK_THAT(text, Contains("\n# seed: 1\n") && Contains("\n# every: 3\n") &&
                       Contains("\n# arena: -5,-5 5,5\n") &&
                       Contains("\n# polygon: 2.5,-1 3.5,-1 3.5,1 2.5,1\n") &&
                       Contains("\n# circle: -3,1.5,0.25\n") && Contains("yaw [rad]"));
  CHECK(csv.Columns.at("tick") == std::vector<std::string>{"0", "0", "3", "3", "6", "6"});
  // 30 degrees in rad, four digits
  CHECK(csv.Columns.at("yaw")[0] == "0.5236");
}

TEST_CASE("tables: robots have rows while they exist", "[outputs][tables]") {
  const CTestFolder folder;
  STableWorld table;
  table.Outputs = {
      {"table", {{"file", folder.Path("t.csv")}}},
      {"table", {{"file", folder.Path("t.h5")}}},
      {"table", {{"file", folder.Path("of.csv")}, {"of", "e-puck,box"}}},
      {"table", {{"file", folder.Path("b.csv")}, {"robots", "b"}}},
      {"table", {{"file", folder.Path("a.csv")}, {"of", "e-puck"}, {"robots", "b, a"}}}};
  {
    CRunningWorld world(table);
    world.Get().Step(1);
    auto& functions = world.Get().GetSimulator().GetLoopFunctions();
    functions.RemoveEntity("a");
    functions.AddEntity(*new CEPuckEntity("a_robot_with_an_id_that_is_longer_than_others", "c",
                                          CVector3(0.5, -2.0, 0.0)));
    world.Get().Step(1);
    world.Close();
  }
  const std::vector<std::string> expected = {
      "a", "b", "a", "b", "b", "a_robot_with_an_id_that_is_longer_than_others"};
  CHECK(ReadCSV(folder.Read("t.csv")).Columns.at("robot") == expected);
  CHECK(ReadCSV(folder.Read("of.csv")).Columns.at("robot") == expected);
  CHECK(ReadCSV(folder.Read("b.csv")).Columns.at("robot") ==
        std::vector<std::string>{"b", "b", "b"});
  CHECK(ReadCSV(folder.Read("a.csv")).Columns.at("robot") ==
        std::vector<std::string>{"a", "b", "a", "b", "b"});
  const auto ids = ReadHDF5Texts(folder.Path("t.h5"), "robots");
  std::vector<std::string> robots;
  for (const double robot : ReadHDF5Numbers(folder.Path("t.h5"), "robot")) {
    robots.push_back(ids[static_cast<std::size_t>(robot)]);
  }
  CHECK(robots == expected);
}

TEST_CASE("tables: after a reset the rows of the next run follow", "[outputs][tables]") {
  const CTestFolder folder;
  STableWorld table;
  table.Outputs = {{"table", {{"file", folder.Path("t.csv")}}},
                   {"table", {{"file", folder.Path("t.h5")}}}};
  {
    CRunningWorld world(table);
    world.Get().Step(1);
    world.Get().GetSimulator().Reset(7);
    world.Get().Step(1);
    world.Close();
  }
  const SReadTable csv = ReadCSV(folder.Read("t.csv"));
  CHECK(csv.Columns.at("run") == std::vector<std::string>{"0", "0", "0", "0", "1", "1", "1", "1"});
  CHECK(csv.Columns.at("tick") == std::vector<std::string>{"0", "0", "1", "1", "0", "0", "1", "1"});
  CHECK(csv.Header.back() == "# run 1: seed 7");
  CHECK(ReadHDF5Numbers(folder.Path("t.h5"), "seeds") == std::vector<double>{1.0, 7.0});
}

TEST_CASE("tables: metrics have a row for each tick", "[outputs][tables]") {
  const CTestFolder folder;
  STableWorld table;
  table.Outputs = {{"metrics", {{"file", folder.Path("m.csv")}}},
                   {"metrics", {{"file", folder.Path("m.h5")}}}};
  TakeLogErr();
  {
    CRunningWorld world(table);
    CLoopFunctions& functions = world.Get().GetSimulator().GetLoopFunctions();
    // Init() of loop functions would do this
    functions.SetMetric("area", 0.25, "m^2");
    world.Get().Step(1);
    functions.SetMetric("area", 0.5);
    functions.SetMetric("late", 1.0);
    world.Get().Step(1);
    CHECK_THROWS_WITH(functions.SetMetric("area", 1.0, "cm^2"), Contains("m^2"));
    CHECK_THROWS_WITH(functions.SetMetric("a b", 1.0), Contains("letters"));
    world.Close();
  }
  const SReadTable csv = ReadCSV(folder.Read("m.csv"));
  CHECK(csv.Names ==
        std::vector<std::string>{"run", "tick", "time", "robots", "stopped", "area", "late"});
  CHECK(csv.Columns.at("late") == std::vector<std::string>{"", "", "1"});
  CHECK(csv.Columns.at("area") == std::vector<std::string>{"0.25", "0.25", "0.5"});
  CHECK(csv.Columns.at("robots") == std::vector<std::string>{"2", "2", "2"});
  CHECK_THAT(folder.Read("m.csv"), Contains("area [m^2]"));
  CHECK(ReadHDF5Numbers(folder.Path("m.h5"), "area") == std::vector<double>{0.25, 0.25, 0.5});
  CHECK(TakeLogErr() == "");
}

TEST_CASE("tables: a metric cannot have the name of a data set of HDF5 files",
          "[outputs][tables]") {
  const CTestFolder folder;
  STableWorld table;
  table.Outputs = {{"metrics", {{"file", folder.Path("m.h5")}}}};
  const auto run = [&] {
    CRunningWorld world(table);
    world.Get().GetSimulator().GetLoopFunctions().SetMetric("seeds", 1.0);
    world.Get().Step(2);
    world.Close();
  };
  CHECK_THROWS_WITH(run(), Contains("the file has a data set \"seeds\" of its own"));
}

TEST_CASE("tables: robots that are disabled do not count in the dispersion", "[outputs][tables]") {
  STableWorld table;
  table.Arena = Robot("e-puck", "a", PoseText({1.0, 0.0, 0.0}, 0.0)) +
                Robot("e-puck", "b", PoseText({-1.0, 0.0, 0.0}, 0.0)) +
                Robot("e-puck", "c", PoseText({4.0, 0.0, 0.0}, 0.0));
  CRunningWorld world(table);
  CMetrics& metrics = world.Get().GetSimulator().GetMetrics();
  metrics.EnableBuiltIn("dispersion");
  world.Get().Get<CEPuckEntity>("c").Disable();
  world.Get().Step();
  CHECK_THAT(metrics.Find("dispersion")->Value, WithinAbs(1.0, 0.01));
}

TEST_CASE("tables: they do not change the run", "[outputs][tables]") {
  const CTestFolder folder;
  STableWorld with;
  with.Outputs = {
      {"table",
       {{"file", folder.Path("t.csv")}, {"fields", "pose,wheels,leds,readings:epuck_proximity"}}},
      {"metrics", {{"file", folder.Path("m.h5")}}}};
  CRunningWorld observed(with);
  observed.Get().Step(20);
  const UInt64 digest = observed.Get().ComputeDigest();
  observed.Close();
  CRunningWorld alone(STableWorld{});
  alone.Get().Step(20);
  CHECK(alone.Get().ComputeDigest() == digest);
}

TEST_CASE("tables: a settled run allocates nothing", "[outputs][tables]") {
  if (!CAllocationCount::IsAvailable()) {
    return;
  }
  const CTestFolder folder;
  STableWorld table;
  table.Outputs = {
      {"table", {{"file", folder.Path("t.csv")}, {"fields", "pose,wheels,leds,stopped"}}}};
  CRunningWorld world(table);
  // enough for a block of rows to be handed over, and for another one to take its place
  world.Get().Step(3 * 8192 / 2);
  const CAllocationCount count;
  world.Get().Step(100);
  const std::size_t allocations = count.GetCount();
  CAPTURE(count.DescribeFirst());
  CHECK(allocations == 0);
}

TEST_CASE("tables: wrong attributes are errors", "[outputs][tables]") {
  const CTestFolder folder;
  const std::string file = folder.Path("t.csv");
  const auto [name, value, message] = GENERATE(table<std::string, std::string, std::string>(
      {{"fields", "poses", "did you mean \"pose\"?"},
       {"fields", "readings:epuck_proximty", "did you mean \"readings:epuck_proximity\"?"},
       {"fields", "readings", "readings:NAME"},
       {"fields", "pose:x", "has no \":\""},
       {"fields", "pose,pose", "listed twice"},
       {"fields", " , ", "lists no field"},
       {"fields", "lua:x", "no robot has the field \"lua:x\""},
       {"of", "epuck", "did you mean \"e-puck\" or \"pipuck\"?"},
       {"robots", "a, no", "\"robots\": there is no robot \"no\" at the start"},
       {"every", "0", "at least 1"},
       {"digits", "18", "from 1 to 17"},
       {"digits", "0", "from 1 to 17"},
       {"file", "t.xls", ".csv.gz"},
       {"file", "/dev/null/t.csv", "/dev/null/t.csv"}}));
  CAPTURE(name, value);
  TAttributes attributes = {{"file", file}};
  if (name == "file") {
    attributes.clear();
  }
  attributes.emplace_back(name, value);
  const std::string error = ErrorOf("table", attributes);
  CHECK_THAT(error, Contains(message));
  CHECK_THAT(error, Contains("<table>"));
}

TEST_CASE("tables: two of them cannot write one file", "[outputs][tables]") {
  const CTestFolder folder;
  const std::string ending = GENERATE("csv", "h5");
  STableWorld table;
  const std::string file = folder.Path("t." + ending);
  table.Outputs = {{"table", {{"file", file}}}, {"table", {{"file", file}}}};
  CRunningWorld world(table);
  CHECK_THROWS_WITH(world.Get().Step(1), Contains(file));
}

}  // namespace outputs_tables_test
