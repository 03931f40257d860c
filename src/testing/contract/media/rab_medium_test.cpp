// Tests which messages a medium for range and bearing delivers.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/simulator/media/rab_medium.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/invariants.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace rab_medium_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

const char* const kSensor = "<range_and_bearing implementation=\"medium\" medium=\"rab\"/>";
const char* const kActuator = "<range_and_bearing implementation=\"default\"/>";

SRobotExperiment WithRAB(const std::string& arena, const std::string& attributes = "") {
  SRobotExperiment experiment;
  experiment.Actuators = kActuator;
  experiment.Sensors = kSensor;
  experiment.Media = "<range_and_bearing id=\"rab\" " + attributes + "/>";
  experiment.Arena = arena;
  return experiment;
}

std::string EPuck(const std::string& id, Real x, Real y, Real range, size_t dataSize = 2) {
  return "<e-puck id=\"" + id + "\" rab_range=\"" + ToText(range) + "\" rab_data_size=\"" +
         std::to_string(dataSize) + "\"><body position=\"" + ToText(CVector3(x, y, 0.0)) +
         "\"/><controller config=\"c\"/></e-puck>";
}

// replaces the controller of an e-puck
std::string With(const std::string& controller, std::string robot) {
  return robot.replace(robot.find("config=\"c\""), 10, "config=\"" + controller + "\"");
}

CRABMedium& Medium(CRobotWorld& world, const std::string& id = "rab") {
  return world.GetSimulator().GetMedium<CRABMedium>(id);
}

// ids of the robots whose messages a robot receives, in order
std::vector<std::string> HeardBy(CRobotWorld& world, const std::string& robot,
                                 const std::string& medium = "rab") {
  std::vector<std::string> ids;
  for (CRABEquippedEntity* device :
       Medium(world, medium)
           .GetRABsCommunicatingWith(world.Get<CEPuckEntity>(robot).GetRABEquippedEntity())) {
    ids.push_back(device->GetRootEntity().GetId());
  }
  return ids;
}

size_t NumPackets(CRobotWorld& world, const std::string& robot) {
  return world.GetSensor<CCI_RangeAndBearingSensor>(robot, "range_and_bearing")
      .GetReadings()
      .size();
}

using TIds = std::vector<std::string>;

}  // namespace

TEST_CASE("rab medium: a message reaches as far as the range of its sender", "[contract][media]") {
  const std::string index =
      GENERATE("", "index=\"hash\"", "index=\"dummy\"", "index=\"grid\" grid_size=\"3,200,1\"");
  CAPTURE(index);
  CRobotWorld world(WithRAB(
      EPuck("near", 0.0, 0.0, 0.5) + EPuck("far", 1.0, 0.0, 2.0) + EPuck("up", 0.0, 1.0, 1.0),
      index));
  world.Step();
  // |near far| = |near up| = 1, |far up| = sqrt(2); a range of exactly the distance is too short
  CHECK(HeardBy(world, "near") == TIds{"far"});
  CHECK(HeardBy(world, "far").empty());
  CHECK(HeardBy(world, "up") == TIds{"far"});
  CHECK(NumPackets(world, "near") == 1);
  CHECK(NumPackets(world, "far") == 0);
  world.Get<CEPuckEntity>("up").GetRABEquippedEntity().SetRange(1.5);
  world.Step();
  CHECK(HeardBy(world, "near") == TIds{"far", "up"});
  CHECK(HeardBy(world, "far") == TIds{"up"});
}

TEST_CASE("rab medium: messages of another size are not received", "[contract][media]") {
  CRobotWorld world(WithRAB(EPuck("a", 0.0, 0.0, 2.0, 2) + EPuck("b", 0.5, 0.0, 2.0, 4) +
                            EPuck("c", 0.0, 0.5, 2.0, 2)));
  CHECK_THAT(TakeLogErr(), Contains("differ in size"));
  world.Step();
  CHECK(HeardBy(world, "a") == TIds{"c"});
  CHECK(HeardBy(world, "b").empty());
  CHECK(HeardBy(world, "c") == TIds{"a"});
}

TEST_CASE("rab medium: bodies occlude on request", "[contract][media]") {
  const bool check = GENERATE(true, false);
  const std::string wall =
      "<box id=\"wall\" size=\"0.1,1,0.5\" movable=\"false\"><body position=\"0.5,0,0\"/></box>";
  CRobotWorld world(WithRAB(EPuck("a", 0.0, 0.0, 3.0) + EPuck("behind_wall", 1.0, 0.0, 3.0) +
                                EPuck("middle", 0.0, 1.0, 3.0) +
                                EPuck("behind_middle", 0.0, 2.0, 3.0) + wall,
                            check ? "" : "check_occlusions=\"false\""));
  world.Step();
  if (check) {
    CHECK(HeardBy(world, "a") == TIds{"middle"});
    // the line from (1,0) to (0,1) passes the wall's end, x = 0.45 to 0.55 and y < 0.5, at y > 0.45
    CHECK(HeardBy(world, "behind_wall") == TIds{"behind_middle"});
    CHECK(HeardBy(world, "behind_middle") == TIds{"behind_wall", "middle"});
  } else {
    CHECK(HeardBy(world, "a") == TIds{"behind_wall", "middle", "behind_middle"});
  }
}

TEST_CASE("rab medium: robots in contact receive each other", "[contract][media]") {
  // in a row, 0.069 m apart: bodies of 0.035 m radius overlap by 1 mm
  CRobotWorld world(WithRAB(EPuck("a", 0.0, 0.0, 1.0) + EPuck("b", 0.069, 0.0, 1.0) +
                            EPuck("c", 0.138, 0.0, 1.0) + EPuck("d", 0.207, 0.0, 1.0)));
  world.Step();
  CHECK(HeardBy(world, "a") == TIds{"b"});
  CHECK(HeardBy(world, "b") == TIds{"a", "c"});
  CHECK(HeardBy(world, "c") == TIds{"b", "d"});
  CHECK(HeardBy(world, "d") == TIds{"c"});
}

TEST_CASE("rab medium: senders are listed in the order of their addition to the space",
          "[contract][media]") {
  CRobotWorld world(WithRAB(EPuck("z", 0.3, 0.0, 2.0) + EPuck("a", 0.0, 0.3, 2.0) +
                            EPuck("m", -0.3, 0.0, 2.0) + EPuck("here", 0.0, 0.0, 2.0)));
  world.Add(std::make_unique<CEPuckEntity>("b", "c", CVector3(0.0, -0.3, 0.0), CQuaternion(), 2.0));
  world.Step();
  CHECK(HeardBy(world, "here") == TIds{"z", "a", "m", "b"});
  const auto& packets =
      world.GetSensor<CCI_RangeAndBearingSensor>("here", "range_and_bearing").GetReadings();
  REQUIRE(packets.size() == 4);
  const CVector2 directions[4] = {CVector2(1.0, 0.0), CVector2(0.0, 1.0), CVector2(-1.0, 0.0),
                                  CVector2(0.0, -1.0)};
  for (size_t i = 0; i < 4; ++i) {
    const CVector2 heard(1.0, packets[i].HorizontalBearing);
    CHECK_THAT(Distance(heard, directions[i]), WithinAbs(0.0, 1e-15));
  }
}

TEST_CASE("rab medium: robots can be added and removed during the experiment",
          "[contract][media]") {
  CRobotWorld world(WithRAB(EPuck("a", 0.0, 0.0, 2.0) + EPuck("b", 0.3, 0.0, 2.0)));
  world.Step();
  CHECK(HeardBy(world, "a") == TIds{"b"});
  CEPuckEntity& added = world.Add(
      std::make_unique<CEPuckEntity>("new", "c", CVector3(0.0, 0.3, 0.0), CQuaternion(), 2.0));
  CHECK(HeardBy(world, "new").empty());
  world.Step();
  CHECK(HeardBy(world, "a") == TIds{"b", "new"});
  added.GetRABEquippedEntity().Disable();
  CHECK(HeardBy(world, "a") == TIds{"b"});
  CHECK_THROWS_WITH(HeardBy(world, "new"), Contains("new") && Contains("not in the medium"));
  world.Step();
  CHECK(HeardBy(world, "b") == TIds{"a"});
  added.GetRABEquippedEntity().Enable();
  world.Step();
  CHECK(HeardBy(world, "b") == TIds{"a", "new"});
  world.GetSimulator().GetLoopFunctions().RemoveEntity("a");
  CHECK(HeardBy(world, "b") == TIds{"new"});
  world.Step();
  CHECK(HeardBy(world, "b") == TIds{"new"});
  CHECK(NumPackets(world, "b") == 1);
}

TEST_CASE("rab medium: a robot removed before sensing is not received any more",
          "[contract][media]") {
  SRobotExperiment experiment = WithRAB(EPuck("a", 0.0, 0.0, 2.0) + EPuck("b", 0.3, 0.0, 2.0));
  CRobotWorld world(experiment);
  world.Step();
  CHECK(NumPackets(world, "b") == 1);
  // routed in this tick, removed, and then sensed: loop functions may do so in PreStep()
  auto& medium = Medium(world);
  auto& listener = world.Get<CEPuckEntity>("b").GetRABEquippedEntity();
  medium.Update();
  world.GetSimulator().GetLoopFunctions().RemoveEntity("a");
  for (const UInt32 number : medium.GetSenders(listener)) {
    CHECK(medium.GetDevice(number) == nullptr);
  }
  world.GetRobot("b").Sense();
  CHECK(NumPackets(world, "b") == 0);
}

TEST_CASE("rab medium: a robot with the actuator alone is received", "[contract][media]") {
  SExperiment experiment;
  experiment.Engines = "<toy_engine id=\"engine\"/>";
  experiment.Media = "<range_and_bearing id=\"rab\"/>";
  const auto controller = [](const std::string& id, const std::string& actuators,
                             const std::string& sensors) {
    return "<robot_world_controller id=\"" + id + "\"><actuators>" + actuators +
           "</actuators><sensors>" + sensors + "</sensors><params/></robot_world_controller>";
  };
  experiment.Controllers = controller("mouth", kActuator, "") + controller("ear", "", kSensor) +
                           controller("mute", "", "");
  experiment.Arena =
      With("mouth", EPuck("mouth", 0.0, 0.0, 2.0)) + With("ear", EPuck("ear", 0.3, 0.0, 2.0)) +
      With("ear", EPuck("ear2", 0.0, 0.3, 2.0)) + With("mute", EPuck("mute", 0.3, 0.3, 2.0));
  CTestWorld world(experiment);
  const CSimulator::CScope scope(world.GetSimulator());
  auto& robot = world.Get<CEPuckEntity>("mouth");
  robot.GetControllableEntity()
      .GetController()
      .GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing")
      ->SetData(1, 42);
  auto& sensor = *world.Get<CEPuckEntity>("ear")
                      .GetControllableEntity()
                      .GetController()
                      .GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
  world.Step();
  REQUIRE(sensor.GetReadings().size() == 2);
  CHECK(sensor.GetReadings()[0].Data[1] == 42);
  // a robot with the sensor alone sends zeros
  CHECK(sensor.GetReadings()[1].Data == CByteArray(2, 0));
  SECTION("a disabled sensor does not stop sending") {
    world.Get<CEPuckEntity>("ear2")
        .GetControllableEntity()
        .GetController()
        .GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing")
        ->Disable();
    world.Step();
    CHECK(sensor.GetReadings().size() == 2);
  }
}

TEST_CASE(
    "rab medium: of several media the actuator takes that of the sensor, or needs an attribute",
    "[contract][media][errors]") {
  SRobotExperiment experiment = WithRAB(EPuck("a", 0.0, 0.0, 2.0) + EPuck("b", 0.3, 0.0, 2.0));
  experiment.Media = "<range_and_bearing id=\"other\"/><range_and_bearing id=\"rab\"/>";
  SECTION("the medium of the sensor") {
    CRobotWorld world(experiment);
    world.Step();
    CHECK(HeardBy(world, "a") == TIds{"b"});
    CHECK_THROWS_AS(HeardBy(world, "a", "other"), CARGoSException);
  }
  SECTION("a medium given by the attribute") {
    experiment.Sensors = "";
    experiment.Actuators = "<range_and_bearing implementation=\"default\" medium=\"other\"/>";
    CRobotWorld world(experiment);
    world.Step();
    CHECK(HeardBy(world, "a", "other") == TIds{"b"});
  }
  SECTION("a missing attribute") {
    experiment.Sensors = "";
    CHECK_THAT(LoadError(experiment), Contains("several media") && Contains("\"other\"") &&
                                          Contains("\"rab\"") && Contains("\"medium\"") &&
                                          Contains("test.argos:"));
  }
  SECTION("without any medium messages are sent nowhere") {
    experiment.Media = "";
    experiment.Sensors = "";
    CRobotWorld world(experiment);
    world.Step(2);
  }
}

TEST_CASE("rab medium: after a reset nothing is received until the next tick",
          "[contract][media]") {
  CRobotWorld world(WithRAB(EPuck("a", 0.0, 0.0, 2.0) + EPuck("b", 0.3, 0.0, 2.0)));
  CHECK(HeardBy(world, "a").empty());
  world.Step();
  world.GetActuator<CCI_RangeAndBearingActuator>("b", "range_and_bearing").SetData(0, 9);
  world.Step();
  const auto& sensor = world.GetSensor<CCI_RangeAndBearingSensor>("a", "range_and_bearing");
  REQUIRE(sensor.GetReadings().size() == 1);
  CHECK(sensor.GetReadings()[0].Data[0] == 9);
  world.GetSimulator().Reset();
  CHECK(HeardBy(world, "a").empty());
  CHECK(sensor.GetReadings().empty());
  world.Step();
  REQUIRE(sensor.GetReadings().size() == 1);
  CHECK(sensor.GetReadings()[0].Data[0] == 0);
}

TEST_CASE("rab medium: invalid attributes are refused with the reason",
          "[contract][media][errors]") {
  const SInvalidAttributes c =
      GENERATE(SInvalidAttributes{"index=\"tree\"", "\"grid\", \"hash\" or \"dummy\""},
               SInvalidAttributes{"grid_size=\"1,2\"", "grid_size"},
               SInvalidAttributes{"grid_size=\"0,2,1\"", "at least 1"},
               SInvalidAttributes{"check_occlusions=\"maybe\"", "check_occlusions"});
  CHECK_THAT(LoadError(WithRAB("", c.Attributes)),
             Contains(c.Reason) && Contains("test.argos:") && Contains("range_and_bearing"));
}

TEST_CASE(
    "rab medium: a device that was switched off receives nothing, also if its number is reused",
    "[contract][media]") {
  CRobotWorld world(
      WithRAB(EPuck("a", 0.0, 0.0, 2.0) + EPuck("b", 0.3, 0.0, 2.0) + EPuck("c", 0.3, 0.3, 2.0)));
  world.Step();
  CHECK(NumPackets(world, "b") == 2);
  auto& device = world.Get<CEPuckEntity>("b").GetRABEquippedEntity();
  const UInt32 number = device.GetNumberInMedium();
  device.SetEnabled(false);
  world.Step();
  CHECK(world.Get<CEPuckEntity>("c").GetRABEquippedEntity().GetNumberInMedium() == number);
  CHECK(NumPackets(world, "c") == 1);
  CHECK(NumPackets(world, "b") == 0);
  device.SetEnabled(true);
  world.Step();
  CHECK(NumPackets(world, "b") == 2);
}

TEST_CASE("rab medium: the number of another device is noticed", "[contract][media][invariants]") {
  CRobotWorld world(WithRAB(EPuck("a", 0.0, 0.0, 2.0) + EPuck("b", 0.3, 0.0, 2.0)));
  world.Step();
  CRABMedium& medium = Medium(world);
  auto& device = world.Get<CEPuckEntity>("a").GetRABEquippedEntity();
  const UInt32 number = device.GetNumberInMedium();
  for (const UInt32 stale : {number + 1, number + 2}) {
    device.SetNumberInMedium(stale);
    CheckCaught([&] { medium.GetSenders(device); }, "\"rab_0\" in the medium \"rab\" is stale");
    CheckCaught([&] { medium.RemoveEntity(device); }, "is stale");
  }
  device.SetNumberInMedium(number);
  CheckCaught([&] { medium.GetDevice(2); }, "no entity with the number 2");
}

TEST_CASE("rab medium: messages of different sizes are reported once, with the robots",
          "[contract][media][errors]") {
  {
    CRobotWorld same(WithRAB(EPuck("a", 0.0, 0.0, 1.0) + EPuck("b", 0.5, 0.0, 1.0)));
    CHECK(TakeLogErr() == "");
  }
  CRobotWorld world(WithRAB(EPuck("a", 0.0, 0.0, 1.0, 4) + EPuck("b", 0.5, 0.0, 1.0, 2) +
                            EPuck("c", 1.0, 0.0, 1.0, 2) + EPuck("d", 1.5, 0.0, 1.0, 2) +
                            Robot("foot-bot", "fb", "position=\"2,0,0\"")));
  const std::string warning = TakeLogErr();
  CHECK_THAT(warning, Contains("[WARNING] medium \"rab\"") && Contains("do not hear each other") &&
                          Contains("2 bytes of e-puck \"b\" and 2 other devices, 4 bytes of e-puck "
                                   "\"a\", 10 bytes of foot-bot \"fb\"") &&
                          Contains("rab_data_size"));
  CHECK(std::count(warning.begin(), warning.end(), '\n') == 1);
  world.Step(3);
  CHECK(TakeLogErr() == "");
}

TEST_CASE("rab medium: messages of a device that users have added come once", "[contract][media]") {
  CRobotWorld world(WithRAB(EPuck("a", 0.0, 0.0, 2.0) + EPuck("b", 0.3, 0.0, 2.0)));
  CRABMedium& medium = Medium(world);
  auto& device = world.Get<CEPuckEntity>("a").GetRABEquippedEntity();
  medium.AddEntity(device);
  medium.AddEntity(device);
  world.Step();
  CHECK(NumPackets(world, "b") == 1);
  medium.RemoveEntity(device);
  medium.RemoveEntity(device);
  world.Step();
  CHECK(NumPackets(world, "b") == 0);
  CHECK_FALSE(device.HasMedium());
  medium.AddEntity(device);
  world.Step();
  CHECK(NumPackets(world, "b") == 1);
  CHECK(HeardBy(world, "b") == TIds{"a"});
}

}  // namespace rab_medium_test
