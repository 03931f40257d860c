// RFID tags: reading and writing, on every robot with a body.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_sensor.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/entities/rfid_tag_equipped_entity.h>
#include <argos3/plugins/simulator/media/rfid_medium.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace argos::rfid_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

using TReadings = CCI_RFIDSensor::TReadings;

SRobotExperiment WithRFID(const std::string& arena, const std::string& attributes = "",
                          const std::string& mediumAttributes = "",
                          const std::string& children = "") {
  SRobotExperiment experiment;
  const std::string device = "<rfid implementation=\"medium\" medium=\"rfid\" " + attributes + ">";
  experiment.Actuators = device + "</rfid>";
  experiment.Sensors = device + children + "</rfid>";
  experiment.Media = "<rfid id=\"rfid\" " + mediumAttributes + "/>";
  experiment.Arena = arena;
  return experiment;
}

// an experiment without the actuator, which does not have these attributes
SRobotExperiment WithSensor(const std::string& arena, const std::string& attributes,
                            const std::string& children = "") {
  SRobotExperiment experiment = WithRFID(arena, attributes, "", children);
  experiment.Actuators = "";
  return experiment;
}

std::string Tag(const std::string& id, const CVector3& position, const std::string& more = "") {
  return "<rfid_tag id=\"" + id + "\" position=\"" + ToText(position) + "\" medium=\"rfid\" " +
         more + "/>";
}

const TReadings& Readings(CRobotWorld& world, const std::string& robot = "r") {
  return world.GetSensor<CCI_RFIDSensor>(robot, "rfid").GetReadings();
}

CCI_RFIDActuator& Actuator(CRobotWorld& world, const std::string& robot = "r") {
  return world.GetActuator<CCI_RFIDActuator>(robot, "rfid");
}

std::vector<std::string> IdsOf(const TReadings& readings) {
  std::vector<std::string> ids;
  for (const auto& reading : readings) {
    ids.push_back(reading.Id);
  }
  return ids;
}

CByteArray Bytes(std::initializer_list<UInt8> bytes) {
  return CByteArray(bytes.begin(), bytes.size());
}

using TIds = std::vector<std::string>;

}  // namespace

TEST_CASE("rfid: any robot with a body reads tags within the range", "[contract][media]") {
  const std::string tag = GENERATE("foot-bot", "e-puck", "eye-bot", "toy-robot");
  const std::string index = GENERATE("", "index=\"hash\"", "grid_size=\"2,90,1\"");
  CAPTURE(tag, index);
  // The reader is 1 cm ahead of the centre of the base, which is at (1,2); the range is 0.125.
  CRobotWorld world(WithRFID(
      Robot(tag, "r", "position=\"1,2,0\" orientation=\"90,0,0\"") +
          Tag("edge", CVector3(1.0, 2.125, 0.0)) + Tag("beyond", CVector3(1.125, 2.01, 0.0)) +
          Tag("high", CVector3(1.0, 2.0, 0.125)) + Tag("ahead", CVector3(1.0, 2.1, 0.05)) +
          Tag("left", CVector3(0.9, 2.0, 0.0)),
      "range=\"0.125\" position=\"0.01,0,0\"", index));
  world.Step();
  // Distances from the reader at (1,2.01): 0.115; 0.125 with or without a
  // rounding; 0.1254; 0.103; 0.1005.
  TIds ids = IdsOf(Readings(world));
  ids.erase(std::remove(ids.begin(), ids.end(), "beyond"), ids.end());
  CHECK(ids == TIds{"edge", "ahead", "left"});
  for (const auto& reading : Readings(world)) {
    CHECK(reading.Data == CByteArray(16, 0));
    // relative to the centre of the robot, which faces along y
    if (reading.Id == "ahead") {
      CHECK_THAT(reading.Distance, WithinAbs(10.0, 1e-12));
      CHECK_THAT(reading.Angle.GetValue(), WithinAbs(0.0, 1e-14));
    }
    if (reading.Id == "left") {
      CHECK_THAT(reading.Distance, WithinAbs(10.0, 1e-12));
      CHECK_THAT(reading.Angle.GetValue(), WithinAbs(M_PI / 2.0, 1e-14));
    }
  }
}

TEST_CASE("rfid: a tag exactly at the range is read", "[contract][media]") {
  CRobotWorld world(WithRFID(Robot("foot-bot", "r", "position=\"0,0,0\"") +
                                 Tag("at", CVector3(0.25, 0.0, 0.0)) +
                                 Tag("behind", CVector3(-0.2500001, 0.0, 0.0)),
                             "range=\"0.25\""));
  world.Step();
  CHECK(IdsOf(Readings(world)) == TIds{"at"});
}

TEST_CASE("rfid: no sensor reads a tag whose position is not a number", "[contract][media]") {
  CRobotWorld world(WithRFID(Robot("foot-bot", "r", "position=\"0,0,0\"") +
                                 Tag("lost", CVector3(0.1, 0.0, 0.0)) +
                                 Tag("here", CVector3(-0.1, 0.0, 0.0)),
                             "range=\"0.25\""));
  auto& lost = world.Get<CRFIDTagEntity>("lost");
  for (UInt32 axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    CVector3 nowhere(0.1, 0.0, 0.0);
    nowhere[axis] = std::nan("");
    lost.SetPosition(nowhere);
    world.Step();
    CHECK(IdsOf(Readings(world)) == TIds{"here"});
    lost.SetPosition(CVector3(0.1, 0.0, 0.0));
    world.Step();
    CHECK(IdsOf(Readings(world)) == TIds{"lost", "here"});
  }
}

TEST_CASE("rfid: robots with different ranges read different tags", "[contract][media]") {
  // the shorter range first or last
  const std::string first = GENERATE("0.1", "2");
  CAPTURE(first);
  SRobotExperiment experiment =
      WithSensor("<foot-bot id='a'><body position='0,0,0'/><controller config='c'/></foot-bot>" +
                     Tag("near", CVector3(0.05, 0.0, 0.0)) + Tag("far", CVector3(1.5, 0.0, 0.0)),
                 "range=\"" + first + "\"");
  CRobotWorld world(experiment);
  world.Step();
  CHECK(IdsOf(Readings(world, "a")) == (first == "2" ? TIds{"near", "far"} : TIds{"near"}));
}

TEST_CASE("rfid: tags are listed in the order of their addition to the space",
          "[contract][media]") {
  std::string arena;
  TIds expected;
  const Real places[] = {0.3, -0.1, 0.2, 0.0, -0.4, 0.1};
  for (const Real place : places) {
    expected.push_back("t" + std::to_string(expected.size()));
    arena += Tag(expected.back(), CVector3(place, 0.02, 0.0));
  }
  CRobotWorld world(WithRFID(Robot("foot-bot", "r", "position=\"0,0,0\"") + arena, "range=\"1\""));
  world.Step();
  CHECK(IdsOf(Readings(world)) == expected);
  world.GetSimulator().GetLoopFunctions().RemoveEntity("t2");
  world.Step();
  CHECK(Readings(world).size() == 5);
}

TEST_CASE("rfid: an order is executed once, in the next tick, on the nearest tag",
          "[contract][media]") {
  CRobotWorld world(
      WithRFID(Robot("e-puck", "r", "position=\"0,0,0\"") +
               Tag("far", CVector3(0.05, 0.0, 0.0), "memory=\"4\"") +
               Tag("near", CVector3(-0.03, 0.0, 0.0), "memory=\"4\" data=\"9,8,7,6\"")));
  auto& near = world.Get<CRFIDTagEntity>("near");
  world.Step();
  CHECK(Actuator(world).GetWrittenTag().empty());
  Actuator(world).Write(Bytes({1, 2}), 1);
  CHECK(near.GetData() == Bytes({9, 8, 7, 6}));
  world.Step();
  CHECK(near.GetData() == Bytes({9, 1, 2, 6}));
  CHECK(Actuator(world).GetWrittenTag() == "near");
  // the sensor reads the new data in the same tick
  CHECK(Readings(world)[1].Data == Bytes({9, 1, 2, 6}));
  CHECK(world.Get<CRFIDTagEntity>("far").GetData() == CByteArray(4, 0));
  near.SetData(Bytes({0, 0, 0, 0}));
  world.Step();
  CHECK(near.GetData() == CByteArray(4, 0));
  CHECK(Actuator(world).GetWrittenTag().empty());

  SECTION("a cancelled order") {
    Actuator(world).Write(Bytes({1}));
    Actuator(world).Cancel();
    world.Step();
    CHECK(near.GetData() == CByteArray(4, 0));
  }
  SECTION("data that does not fit is not written at all") {
    Actuator(world).Write(Bytes({1, 2}), 3);
    world.Step();
    CHECK(near.GetData() == CByteArray(4, 0));
    CHECK(Actuator(world).GetWrittenTag().empty());
    Actuator(world).Write(Bytes({1}), 5);
    world.Step();
    CHECK(near.GetData() == CByteArray(4, 0));
  }
  SECTION("no tag in reach") {
    world.Get<CComposableEntity>("r").GetComponent<CEmbodiedEntity>("body").MoveTo(
        CVector3(2.0, 0.0, 0.0), CQuaternion());
    Actuator(world).Write(Bytes({1}));
    world.Step();
    CHECK(Actuator(world).GetWrittenTag().empty());
    // the order has expired
    world.Get<CComposableEntity>("r").GetComponent<CEmbodiedEntity>("body").MoveTo(CVector3(),
                                                                                   CQuaternion());
    world.Step();
    CHECK(near.GetData() == CByteArray(4, 0));
  }
  SECTION("a reset restores data and cancels orders") {
    Actuator(world).Write(Bytes({5}));
    world.Step();
    Actuator(world).Write(Bytes({6}));
    world.GetSimulator().Reset();
    CHECK(near.GetData() == Bytes({9, 8, 7, 6}));
    CHECK(Readings(world).empty());
    CHECK(Actuator(world).GetWrittenTag().empty());
    world.Step();
    CHECK(near.GetData() == Bytes({9, 8, 7, 6}));
  }
}

TEST_CASE("rfid: of robots that write to one tag in one tick the last one created overwrites",
          "[contract][media]") {
  // one tag between two robots
  const bool swapped = GENERATE(false, true);
  const std::string a = Robot("e-puck", "a", "position=\"-0.05,0,0\"");
  const std::string b = Robot("e-puck", "b", "position=\"0.05,0,0\"");
  CRobotWorld world(WithRFID((swapped ? b + a : a + b) + Tag("t", CVector3(), "memory=\"3\"")));
  Actuator(world, "a").Write(Bytes({1, 1}), 0);
  Actuator(world, "b").Write(Bytes({2, 2}), 1);
  world.Step();
  // the order matters only for bytes that both write
  CHECK(world.Get<CRFIDTagEntity>("t").GetData() ==
        (swapped ? Bytes({1, 1, 2}) : Bytes({1, 2, 2})));
  CHECK(Actuator(world, "a").GetWrittenTag() == "t");
  CHECK(Actuator(world, "b").GetWrittenTag() == "t");
}

TEST_CASE("rfid: of tags at equal distances the first one created is written",
          "[contract][media]") {
  const bool swapped = GENERATE(false, true);
  const std::string left = Tag("left", CVector3(0.0, 0.05, 0.0));
  const std::string right = Tag("right", CVector3(0.0, -0.05, 0.0));
  CRobotWorld world(WithRFID(Robot("e-puck", "r", "position=\"0,0,0\"") +
                             (swapped ? right + left : left + right)));
  Actuator(world).Write(Bytes({1}));
  world.Step();
  CHECK(Actuator(world).GetWrittenTag() == (swapped ? "right" : "left"));
}

TEST_CASE("rfid: boxes, cylinders and robots can carry tags", "[contract][media]") {
  const std::string tags =
      "<rfid_tags medium=\"rfid\"><rfid_tag id=\"t\" position=\"0.1,0,0.2\" memory=\"2\" "
      "data=\"7\"/><rfid_tag position=\"0,0,0\"/></rfid_tags>";
  CRobotWorld world(WithRFID(
      "<foot-bot id=\"r\"><body position=\"0,0,0\"/><controller config=\"c\"/>" + tags +
          "</foot-bot>"
          "<box id=\"box\" size=\"0.2,0.2,0.2\" movable=\"true\" mass=\"1\"><body "
          "position=\"1,0,0\" orientation=\"90,0,0\"/>" +
          tags +
          "</box><cylinder id=\"cyl\" radius=\"0.1\" height=\"0.2\" movable=\"false\"><body "
          "position=\"0,1,0\"/>" +
          tags + "</cylinder>",
      "range=\"1.05\""));
  world.Step();
  // the box is turned: its tag is at (1,0.1,0.2), 1.0247 away; that of
  // the cylinder is at (0.1,1,0.2)
  CHECK(IdsOf(Readings(world)) == TIds{"box.rfid_tags_0.t", "box.rfid_tags_0.rfid_tag_1",
                                       "cyl.rfid_tags_0.t", "cyl.rfid_tags_0.rfid_tag_1"});
  CHECK(Readings(world)[0].Data == Bytes({7, 0}));
  CHECK_THAT(Readings(world)[0].Distance, WithinAbs(100.0 * std::hypot(1.0, 0.1), 1e-12));
  auto& box = world.Get<CBoxEntity>("box");
  box.GetEmbodiedEntity().MoveTo(CVector3(0.5, 0.0, 0.0), CQuaternion());
  world.Step();
  CHECK_THAT(Readings(world)[0].Distance, WithinAbs(60.0, 1e-12));
  // the robot's own tags are neither read nor written
  Actuator(world).Write(Bytes({1}));
  world.Step();
  CHECK(Actuator(world).GetWrittenTag() == "box.rfid_tags_0.rfid_tag_1");
  // tags are drawn with the body that carries them
  CHECK(box.GetAppearance()->Parts.size() == 3);

  box.GetRFIDTagEquippedEntity().Disable();
  world.Step();
  CHECK(Readings(world).size() == 2);
  world.GetSimulator().GetLoopFunctions().RemoveEntity("cyl");
  world.Step();
  CHECK(Readings(world).empty());
}

TEST_CASE("rfid: programs can add tags", "[contract][media]") {
  CRobotWorld world(WithRFID(Robot("foot-bot", "r", "position=\"0,0,0\"")));
  world.Step();
  CHECK(Readings(world).empty());
  auto& medium = world.GetSimulator().GetMedium<CRFIDMedium>("rfid");
  auto& tag = world.Add(
      std::make_unique<CRFIDTagEntity>(nullptr, "new", CVector3(0.05, 0.0, 0.0), Bytes({1, 2, 3})));
  world.Step();
  CHECK(Readings(world).empty());
  tag.SetMedium(medium);
  tag.Enable();
  world.Step();
  CHECK(IdsOf(Readings(world)) == TIds{"new"});
  CHECK(&tag.GetMedium() == &medium);
  // a tag attached to an anchor of an existing body
  auto& box = world.Add(std::make_unique<CBoxEntity>("box", CVector3(0.2, 0.0, 0.0), CQuaternion(),
                                                     false, CVector3(0.05, 0.05, 0.05)));
  CRFIDTagEquippedEntity& carried = box.GetRFIDTagEquippedEntity();
  carried.AddTag("first", CVector3(-0.15, 0.0, 0.0), box.GetEmbodiedEntity().GetOriginAnchor(),
                 Bytes({4}));
  carried.SetMedium(medium);
  carried.Enable();
  world.Step();
  CHECK(IdsOf(Readings(world)) == TIds{"new", "box.rfid_tags_0.first"});
  CHECK_THROWS_WITH(carried.GetTag(1), Contains("no RFID tag 1"));
}

TEST_CASE("rfid: AddEntity() of users puts a tag into a medium once", "[contract][media]") {
  SRobotExperiment experiment = WithRFID(Robot("foot-bot", "r", "position=\"0,0,0\"") +
                                         Tag("known", CVector3(0.02, 0.0, 0.0)));
  experiment.Media += "<rfid id=\"others\"/>";
  CRobotWorld world(experiment);
  auto& medium = world.GetSimulator().GetMedium<CRFIDMedium>("rfid");
  auto& others = world.GetSimulator().GetMedium<CRFIDMedium>("others");
  // one that the file has registered
  auto& known = world.Get<CRFIDTagEntity>("known");
  medium.AddEntity(known);
  medium.AddEntity(known);
  // before and after it is added to the space, as loop functions do
  auto owned =
      std::make_unique<CRFIDTagEntity>(nullptr, "new", CVector3(0.05, 0.0, 0.0), Bytes({1}));
  medium.AddEntity(*owned);
  CRFIDTagEntity& tag = world.Add(std::move(owned));
  medium.AddEntity(tag);
  world.Step();
  CHECK(IdsOf(Readings(world)) == TIds{"known", "new"});
  others.AddEntity(tag);
  world.Step();
  CHECK(IdsOf(Readings(world)) == TIds{"known"});
  CHECK(&tag.GetMedium() == &others);
  // it is not in this one
  medium.RemoveEntity(tag);
  CHECK(tag.HasMedium());
  others.RemoveEntity(tag);
  others.RemoveEntity(tag);
  CHECK_FALSE(tag.HasMedium());
  medium.AddEntity(tag);
  world.Step();
  CHECK(IdsOf(Readings(world)) == TIds{"known", "new"});
}

TEST_CASE("rfid: tags without a body are drawn", "[contract][media]") {
  CRobotWorld world(
      WithRFID(Robot("foot-bot", "r", "position=\"0,0,0\"") + Tag("t", CVector3(1.0, 0.0, 0.0))));
  const SAppearance* appearance = world.Get<CRFIDTagEntity>("t").GetAppearance();
  REQUIRE(appearance != nullptr);
  REQUIRE(appearance->Parts.size() == 1);
  CHECK(appearance->Parts[0].Size.GetX() > 0.0);
}

namespace {

constexpr int kDraws = 20000;

}  // namespace

TEST_CASE("rfid noise: distance and angle have the stated distribution", "[contract][media]") {
  CRobotWorld world(
      WithSensor(Robot("e-puck", "r", "position=\"0,0,0\"") + Tag("t", CVector3(0.0, -0.08, 0.0)),
                 "miss_prob=\"0.25\"",
                 "<noise on=\"distance\" model=\"gaussian\" std_dev=\"0.5\"/>"
                 "<noise on=\"angle\" model=\"uniform\" level=\"0.2\"/>"));
  int numRead = 0;
  Real sum = 0.0;
  Real squares = 0.0;
  Real angleSquares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    world.Step();
    if (Readings(world).empty()) {
      continue;
    }
    ++numRead;
    const Real error = Readings(world)[0].Distance - 8.0;
    const Real angle = Readings(world)[0].Angle.GetValue() + M_PI / 2.0;
    REQUIRE(std::abs(angle) <= 0.2 + 1e-12);
    sum += error;
    squares += error * error;
    angleSquares += angle * angle;
  }
  // tolerance of five standard deviations of each estimate: 1 failure in 10^6
  CHECK_THAT(numRead, WithinAbs(0.75 * kDraws, 5.0 * std::sqrt(0.25 * 0.75 * kDraws)));
  const Real five = 5.0 / std::sqrt(numRead);
  CHECK_THAT(sum / numRead, WithinAbs(0.0, five * 0.5));
  CHECK_THAT(squares / numRead, WithinAbs(0.25, five * 0.25 * std::sqrt(2.0)));
  CHECK_THAT(angleSquares / numRead, WithinAbs(0.04 / 3.0, five * 0.04 * std::sqrt(4.0 / 45.0)));
}

TEST_CASE("rfid noise: repeats after a reset", "[contract][media]") {
  CRobotWorld world(
      WithSensor(Robot("e-puck", "r", "position=\"0,0,0\"") + Tag("t", CVector3(0.0, -0.08, 0.0)),
                 "miss_prob=\"0.5\""));
  const auto draw = [&world] {
    std::vector<bool> read;
    for (int i = 0; i < 40; ++i) {
      world.Step();
      read.push_back(!Readings(world).empty());
    }
    return read;
  };
  const std::vector<bool> first = draw();
  world.GetSimulator().Reset();
  CHECK(draw() == first);
  world.GetSimulator().Reset(2);
  CHECK(draw() != first);
}

TEST_CASE("rfid: a tick in steady state allocates nothing", "[contract][media][allocation]") {
  std::string arena;
  for (int i = 0; i < 100; ++i) {
    arena += Tag("t" + std::to_string(i), CVector3(0.1 * (i % 10), 0.1 * (i / 10), 0.0));
  }
  CRobotWorld world(WithRFID(arena + Robot("e-puck", "a", "position=\"0.2,0.2,0\"") +
                                 Robot("e-puck", "b", "position=\"0.6,0.7,0\""),
                             "range=\"0.25\""));
  const CByteArray bytes = Bytes({1, 2, 3});
  CCI_RFIDActuator& a = Actuator(world, "a");
  CCI_RFIDActuator& b = Actuator(world, "b");
  const auto step = [&] {
    a.Write(bytes, 2);
    b.Write(bytes, 5);
    world.Step();
  };
  step();
  step();
  CheckAllocatesNothing([&] {
    for (int i = 0; i < 5; ++i) {
      step();
    }
  });
  CHECK(Readings(world, "a").size() > 5);
}

TEST_CASE("rfid: invalid experiments are refused with the reason", "[contract][media][errors]") {
  const std::string robot = Robot("e-puck", "r", "position=\"0,0,0\"");
  SECTION("invalid tags") {
    const SInvalidAttributes c = GENERATE(
        SInvalidAttributes{"memory=\"2\" data=\"1,2,3\"", "3 bytes, which exceed the memory of 2"},
        SInvalidAttributes{"data=\"1,256\"", "from 0 to 255"},
        SInvalidAttributes{"data=\"1,-1\"", "from 0 to 255"},
        SInvalidAttributes{"data=\"1,\"", "from 0 to 255"},
        SInvalidAttributes{"data=\"a\"", "from 0 to 255"},
        SInvalidAttributes{"memory=\"-1\"", "memory"},
        SInvalidAttributes{"memory=\"2000000\"", "at most 1048576"});
    CAPTURE(c.Attributes);
    CHECK_THAT(LoadError(WithRFID(robot + Tag("t", CVector3(), c.Attributes))),
               Contains(c.Reason) && Contains("test.argos:"));
    CHECK_THAT(LoadError(WithRFID(robot + "<rfid_tag id=\"t\"/>")), Contains("medium"));
    CHECK_THAT(LoadError(WithRFID(robot + "<rfid_tag id=\"t\" medium=\"rifd\"/>")),
               Contains("rifd") && Contains("rfid"));
  }
  SECTION("invalid devices") {
    CHECK_THAT(LoadError(WithRFID(robot, "range=\"-1\"")), Contains(">= 0, got -1"));
    CHECK_THAT(LoadError(WithSensor(robot, "miss_prob=\"2\"")), Contains("[0,1], got 2"));
    SRobotExperiment experiment = WithRFID(robot);
    experiment.Media = "<led id=\"rfid\"/>";
    CHECK_THAT(LoadError(experiment), Contains("an RFID medium"));
    experiment = WithRFID(robot, "", "index=\"dummy\"");
    CHECK_THAT(LoadError(experiment), Contains("\"grid\" or \"hash\""));
  }
  SECTION("data of another size") {
    CRobotWorld world(WithRFID(robot + Tag("t", CVector3())));
    CHECK_THROWS_WITH(world.Get<CRFIDTagEntity>("t").SetData(CByteArray(3)),
                      Contains("16 bytes, got 3"));
  }
}

}  // namespace argos::rfid_test
