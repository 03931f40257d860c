// Simple radios: range, time and order of delivery.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_sensor.h>
#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>
#include <argos3/plugins/simulator/media/simple_radio_medium.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <set>

namespace simple_radio_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

SRobotExperiment WithRadios(const std::string& arena, const std::string& attributes = "") {
  SRobotExperiment experiment;
  experiment.Actuators = "<simple_radios implementation=\"default\"/>";
  experiment.Sensors = "<simple_radios implementation=\"default\"/>";
  experiment.Media = "<simple_radio id=\"radios\" " + attributes + "/>";
  experiment.Arena = arena;
  return experiment;
}

std::string Radio(const std::string& id, Real range, const std::string& more = "") {
  return "<simple_radio id=\"" + id + "\" medium=\"radios\" range=\"" + ToText(range) + "\" " +
         more + "/>";
}

std::string RobotAt(const std::string& tag, const std::string& id, const CVector3& position,
                    const std::string& radios) {
  return "<" + tag + " id=\"" + id + "\"><body position=\"" + ToText(position) +
         "\"/><controller config=\"c\"/><simple_radios>" + radios + "</simple_radios></" + tag +
         ">";
}

void Send(CRobotWorld& world, const std::string& robot, const std::string& text, size_t radio = 0) {
  CByteArray message;
  message << text;
  world.GetActuator<CCI_SimpleRadiosActuator>(robot, "simple_radios")
      .GetInterfaces()
      .at(radio)
      .Messages.push_back(message);
}

std::vector<std::string> Received(CRobotWorld& world, const std::string& robot, size_t radio = 0) {
  std::vector<std::string> texts;
  for (CByteArray message : world.GetSensor<CCI_SimpleRadiosSensor>(robot, "simple_radios")
                                .GetInterfaces()
                                .at(radio)
                                .Messages) {
    texts.push_back(message.PopFront<std::string>());
  }
  return texts;
}

CSimpleRadioEntity& RadioOf(CRobotWorld& world, const std::string& robot) {
  return world.Get<CComposableEntity>(robot)
      .GetComponent<CSimpleRadioEquippedEntity>("simple_radios")
      .GetRadio(0);
}

using TTexts = std::vector<std::string>;

// three robots in a row, 1 m apart, of all types
std::string Row(Real range) {
  return RobotAt("foot-bot", "a", CVector3(0.0, 0.0, 0.0), Radio("wifi", range)) +
         RobotAt("e-puck", "b", CVector3(1.0, 0.0, 0.0), Radio("wifi", range)) +
         RobotAt("foot-bot", "c", CVector3(2.0, 0.0, 0.0), Radio("wifi", range));
}

}  // namespace

TEST_CASE("simple radio: a message is received once, in the tick after the order",
          "[contract][media]") {
  CRobotWorld world(WithRadios(Row(10.0)));
  const auto& actuator = world.GetActuator<CCI_SimpleRadiosActuator>("a", "simple_radios");
  world.Step();
  CHECK(Received(world, "b").empty());
  Send(world, "a", "hello");
  Send(world, "a", "world");
  CHECK(Received(world, "b").empty());
  world.Step();
  CHECK(Received(world, "b") == TTexts{"hello", "world"});
  CHECK(Received(world, "c") == TTexts{"hello", "world"});
  // a radio does not receive its own messages, and sent messages are removed
  CHECK(Received(world, "a").empty());
  CHECK(const_cast<CCI_SimpleRadiosActuator&>(actuator).GetInterfaces()[0].Messages.empty());
  world.Step();
  CHECK(Received(world, "b").empty());
}

TEST_CASE("simple radio: the sender's range is exclusive, and bodies do not occlude",
          "[contract][media]") {
  const std::string index = GENERATE("", "index=\"hash\"", "grid_size=\"1,70,2\"");
  SRobotExperiment experiment =
      WithRadios(RobotAt("e-puck", "short", CVector3(0.0, 0.0, 0.0), Radio("r", 1.0)) +
                     RobotAt("foot-bot", "middle", CVector3(1.0, 0.0, 0.0), Radio("r", 1.5)) +
                     RobotAt("eye-bot", "long", CVector3(2.0, 0.0, 0.0), Radio("r", 2.5)) +
                     "<box id=\"wall\" size=\"0.1,5,1\" movable=\"false\"><body "
                     "position=\"1.5,0,0\"/></box>",
                 index);
  CRobotWorld world(experiment);
  for (const char* robot : {"short", "middle", "long"}) {
    Send(world, robot, robot);
  }
  world.Step();
  // the distance from "short" to "middle" is exactly its range: too far
  CHECK(Received(world, "short") == TTexts{"middle", "long"});
  CHECK(Received(world, "middle") == TTexts{"long"});
  CHECK(Received(world, "long") == TTexts{"middle"});
  const auto& medium = world.GetSimulator().GetMedium<CSimpleRadioMedium>("radios");
  CHECK(medium.GetNumDelivered() == 4);
  world.Step();
  CHECK(medium.GetNumDelivered() == 0);
}

TEST_CASE("simple radio: messages arrive in the order of the senders' creation",
          "[contract][media]") {
  std::string arena;
  TTexts expected;
  // places in no order of distance
  const Real places[] = {3.0, -2.0, 0.5, 1.0, -0.2, 2.0};
  for (const Real place : places) {
    const std::string id = "r" + std::to_string(expected.size());
    arena += RobotAt("e-puck", id, CVector3(place, 0.0, 0.0), Radio("r", 10.0));
    expected.push_back(id);
  }
  arena += RobotAt("e-puck", "here", CVector3(0.0, 1.0, 0.0), Radio("r", 10.0));
  CRobotWorld world(WithRadios(arena));
  for (const std::string& robot : expected) {
    Send(world, robot, robot);
  }
  world.Step();
  CHECK(Received(world, "here") == expected);
}

TEST_CASE("simple radio: radios of a robot are separate and can receive each other",
          "[contract][media]") {
  SRobotExperiment experiment = WithRadios(
      RobotAt("foot-bot", "a", CVector3(),
              Radio("near", 0.3, "position=\"0.05,0,0.1\"") +
                  "<simple_radio id=\"far\" medium=\"other\" range=\"5\"/>" +
                  Radio("second", 1.0)) +
      RobotAt("foot-bot", "b", CVector3(0.5, 0.0, 0.0),
              Radio("near", 0.3) + "<simple_radio id=\"far\" medium=\"other\" range=\"5\"/>"));
  experiment.Media += "<simple_radio id=\"other\"/>";
  CRobotWorld world(experiment);
  const auto& interfaces =
      world.GetSensor<CCI_SimpleRadiosSensor>("a", "simple_radios").GetInterfaces();
  REQUIRE(interfaces.size() == 3);
  CHECK(interfaces[0].Id == "near");
  CHECK(interfaces[1].Id == "far");
  Send(world, "a", "too far", 0);
  Send(world, "a", "other medium", 1);
  world.Step();
  CHECK(Received(world, "b", 0).empty());
  CHECK(Received(world, "b", 1) == TTexts{"other medium"});
  CHECK(Received(world, "a", 2) == TTexts{"too far"});
}

TEST_CASE("simple radio: positions at the time of the Act phase count", "[contract][media]") {
  CRobotWorld world(WithRadios(Row(1.2)));
  Send(world, "a", "one");
  // moves the robot before the actuators act
  world.Get<CComposableEntity>("b").GetComponent<CEmbodiedEntity>("body").MoveTo(
      CVector3(0.0, 3.0, 0.0), CQuaternion());
  world.Step();
  CHECK(Received(world, "b").empty());
  CHECK_THAT(Distance(RadioOf(world, "b").GetPosition(), CVector3(0.0, 3.0, 0.0)),
             WithinAbs(0.0, 1e-15));
}

TEST_CASE("simple radio: a disabled sensor misses messages", "[contract][media]") {
  CRobotWorld world(WithRadios(Row(10.0)));
  auto& sensor = world.GetSensor<CCI_SimpleRadiosSensor>("b", "simple_radios");
  sensor.Disable();
  for (int i = 0; i < 5; ++i) {
    Send(world, "a", "message " + std::to_string(i));
    world.Step();
  }
  // the radio keeps the messages of the last tick only
  CHECK(RadioOf(world, "b").GetMessages().size() == 1);
  sensor.Enable();
  Send(world, "a", "last");
  world.Step();
  CHECK(Received(world, "b") == TTexts{"last"});
  world.Step();
  CHECK(Received(world, "b").empty());
}

TEST_CASE("simple radio: programs can deliver messages to radios", "[contract][media]") {
  CRobotWorld world(WithRadios(Row(10.0)));
  world.Step();
  CByteArray message;
  message << std::string("from above");
  RadioOf(world, "b").ReceiveMessage(CVector3(1.0, 2.0, 3.0), message);
  Send(world, "a", "from a");
  world.Step();
  CHECK(Received(world, "b") == TTexts{"from above", "from a"});
  CHECK(Received(world, "c") == TTexts{"from a"});
}

TEST_CASE("simple radio: the medium's index contains all radios", "[contract][media]") {
  class CCollect : public CPositionalIndex<CSimpleRadioEntity>::COperation {
   public:
    bool operator()(CSimpleRadioEntity& radio) override {
      Robots.insert(radio.GetRootEntity().GetId());
      return true;
    }
    std::set<std::string> Robots;
  } collect;
  const std::string index = GENERATE("", "index=\"hash\"");
  CRobotWorld world(WithRadios(Row(10.0), index));
  world.Step();
  auto& medium = world.GetSimulator().GetMedium<CSimpleRadioMedium>("radios");
  CHECK(&RadioOf(world, "a").GetMedium() == &medium);
  medium.GetIndex().ForEntitiesInSphereRange(CVector3(), 20.0, collect);
  CHECK(collect.Robots == std::set<std::string>{"a", "b", "c"});
}

TEST_CASE("simple radio: robots can be added and removed, and a reset empties all radios",
          "[contract][media]") {
  CRobotWorld world(WithRadios(Row(10.0)));
  Send(world, "a", "one");
  world.GetSimulator().GetLoopFunctions().RemoveEntity("b");
  world.Step();
  CHECK(Received(world, "c") == TTexts{"one"});
  Send(world, "a", "two");
  world.GetSimulator().Reset();
  CHECK(Received(world, "c").empty());
  world.Step();
  CHECK(Received(world, "c").empty());
  RadioOf(world, "c").Disable();
  Send(world, "a", "three");
  world.Step();
  CHECK(Received(world, "c").empty());
}

TEST_CASE("simple radio: lines from the senders are recorded only on request",
          "[contract][media]") {
  const bool show = GENERATE(false, true);
  SRobotExperiment experiment = WithRadios(Row(1.5));
  experiment.Sensors = std::string("<simple_radios implementation=\"default\"") +
                       (show ? " show_rays=\"true\"/>" : "/>");
  CRobotWorld world(experiment);
  Send(world, "a", "one");
  world.Step();
  const auto& rays = world.GetRobot("b").GetCheckedRays();
  REQUIRE(rays.size() == (show ? 1 : 0));
  if (show) {
    CHECK(rays[0].second.GetStart() == CVector3(0.0, 0.0, 0.0));
    CHECK(rays[0].second.GetEnd() == CVector3(1.0, 0.0, 0.0));
  }
  CHECK(world.GetRobot("c").GetCheckedRays().empty());
}

TEST_CASE("simple radio: sending and receiving allocate nothing in steady state",
          "[contract][media][allocation]") {
  WarnUnlessAllocationsAreCounted();
  CRobotWorld world(WithRadios(Row(10.0)));
  size_t counted = 0;
  std::string first;
  for (int tick = 0; tick < 10; ++tick) {
    // allocations by the controller are not counted
    Send(world, "a", "a message that is longer than a string is without memory of its own");
    Send(world, "c", "another one");
    const CAllocationCount count;
    world.Step();
    counted += tick < 3 ? 0 : count.GetCount();
    first = count.DescribeFirst();
  }
  INFO(first);
  CHECK(counted == 0);
  CHECK(Received(world, "b").size() == 2);
}

TEST_CASE("simple radio: invalid experiments are refused with the reason",
          "[contract][media][errors]") {
  struct SCase {
    std::string Radios;
    const char* Reason;
  };
  const SCase c = GENERATE_COPY(
      SCase{Radio("r", -1.0), "range"},
      SCase{"<simple_radio id=\"r\" medium=\"radios\"/>", "range"},
      SCase{"<simple_radio id=\"r\" range=\"1\"/>", "medium"},
      SCase{"<simple_radio id=\"r\" range=\"1\" medium=\"radio\"/>", "radios"},
      SCase{"<simple_radio id=\"r\" range=\"1\" medium=\"leds\"/>", "not of the required type"},
      SCase{Radio("r", 1.0, "anchor=\"mast\""), "mast"},
      SCase{Radio("r", 1.0) + Radio("r", 2.0), "already a radio with id \"r\""});
  CAPTURE(c.Radios);
  SRobotExperiment experiment = WithRadios(RobotAt("foot-bot", "a", CVector3(), c.Radios));
  experiment.Media += "<led id=\"leds\"/>";
  CHECK_THAT(LoadError(experiment), Contains(c.Reason) && Contains("test.argos:"));
}

TEST_CASE("simple radio: a robot without radios is refused", "[contract][media][errors]") {
  SRobotExperiment experiment = WithRadios(Robot("foot-bot", "a", "position=\"0,0,0\""));
  CHECK_THAT(LoadError(experiment), Contains("no component \"simple_radios\""));
}

TEST_CASE("simple radio: messages to a radio that users have added come once",
          "[contract][media]") {
  CRobotWorld world(WithRadios(RobotAt("e-puck", "a", CVector3(), Radio("r", 5.0)) +
                               RobotAt("e-puck", "b", CVector3(1, 0, 0), Radio("r", 5.0))));
  auto& medium = world.GetSimulator().GetMedium<CSimpleRadioMedium>("radios");
  for (const int times : {1, 2}) {
    for (int time = 0; time < times; ++time) {
      medium.AddEntity(RadioOf(world, "b"));
    }
    Send(world, "a", "hello");
    world.Step();
    CHECK(Received(world, "b") == TTexts{"hello"});
    medium.RemoveEntity(RadioOf(world, "b"));
    Send(world, "a", "hello");
    world.Step();
    CHECK(Received(world, "b") == TTexts{});
  }
}

}  // namespace simple_radio_test
