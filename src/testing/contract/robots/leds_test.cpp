// LEDs of robots: orders of controllers, and their visibility in a medium.

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/simulator/media/led_medium.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <set>

namespace leds_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

SRobotExperiment WithLEDs() {
  SRobotExperiment experiment;
  experiment.Actuators = "<leds implementation=\"default\" medium=\"leds\"/>";
  experiment.Arena = Robot("foot-bot", "r", "position=\"1,2,0\" orientation=\"90,0,0\"");
  return experiment;
}

CCI_LEDsActuator& Actuator(CRobotWorld& world) {
  return world.GetActuator<CCI_LEDsActuator>("r", "leds");
}

CLEDEquippedEntity& LEDs(CRobotWorld& world) {
  return world.Get<CFootBotEntity>("r").GetLEDEquippedEntity();
}

// ids of all LEDs in the medium's index
std::set<std::string> LitLEDs(CRobotWorld& world) {
  class CCollect : public CPositionalIndex<CLEDEntity>::COperation {
   public:
    bool operator()(CLEDEntity& led) override {
      Ids.insert(led.GetContext() + led.GetId());
      return true;
    }
    std::set<std::string> Ids;
  } collect;
  world.GetSimulator().GetMedium<CLEDMedium>("leds").GetIndex().ForEntitiesInBoxRange(
      CVector3(), CVector3(100.0, 100.0, 100.0), collect);
  return collect.Ids;
}

}  // namespace

TEST_CASE("leds actuator: colours reach the robot in the next tick", "[contract][robots]") {
  CRobotWorld world(WithLEDs());
  REQUIRE(Actuator(world).GetNumLEDs() == 13);
  world.Step();
  CHECK(LEDs(world).GetLEDColor(3) == CColor::BLACK);
  Actuator(world).SetAllColors(CColor::RED);
  Actuator(world).SetSingleColor(3, CColor::GREEN);
  Actuator(world).SetSingleIntensity(4, 100);
  CHECK(LEDs(world).GetLEDColor(3) == CColor::BLACK);
  world.Step();
  CHECK(LEDs(world).GetLEDColor(0) == CColor::RED);
  CHECK(LEDs(world).GetLEDColor(3) == CColor::GREEN);
  CHECK(LEDs(world).GetLEDColor(4) == CColor(255, 0, 0, 100));
  CHECK(LEDs(world).GetLED(3).GetColor() == CColor::GREEN);
  world.GetSimulator().Reset();
  CHECK(LEDs(world).GetLEDColor(3) == CColor::BLACK);
  world.Step();
  CHECK(LEDs(world).GetLEDColor(3) == CColor::BLACK);
}

TEST_CASE("leds actuator: the medium contains lit LEDs, but not black ones", "[contract][robots]") {
  CRobotWorld world(WithLEDs());
  world.Step();
  CHECK(LitLEDs(world).empty());
  Actuator(world).SetSingleColor(2, CColor::BLUE);
  Actuator(world).SetSingleColor(12, CColor::WHITE);
  world.Step();
  CHECK(LitLEDs(world) == std::set<std::string>{"r.leds_0.led_2", "r.leds_0.led_12"});
  Actuator(world).SetAllColors(CColor::BLACK);
  world.Step();
  CHECK(LitLEDs(world).empty());
}

TEST_CASE("leds: follow their body", "[contract][robots]") {
  CRobotWorld world(WithLEDs());
  Actuator(world).SetAllColors(CColor::RED);
  world.Step();
  auto& robot = world.Get<CFootBotEntity>("r");
  REQUIRE(robot.GetEmbodiedEntity().MoveTo(CVector3(-1.0, 0.5, 0.0),
                                           CQuaternion(ToRadians(CDegrees(30.0)), CVector3::Z)));
  const auto checkPlaces = [&] {
    for (UInt32 i = 0; i < 12; ++i) {
      const Real angle = (15.0 + 30.0 * i + 30.0) * M_PI / 180.0;
      const CVector3 expected(-1.0 + 0.090036758 * std::cos(angle),
                              0.5 + 0.090036758 * std::sin(angle), 0.085);
      // tolerance of a few roundings of numbers near 1
      CHECK_THAT(Distance(LEDs(world).GetLED(i).GetPosition(), expected), WithinAbs(0.0, 1e-15));
    }
  };
  checkPlaces();
  world.Step();
  checkPlaces();
}

TEST_CASE("leds: without the actuator there are no LED entities in the medium",
          "[contract][robots]") {
  SRobotExperiment experiment = WithLEDs();
  experiment.Actuators = "";
  CRobotWorld world(experiment);
  world.Step();
  LEDs(world).SetAllLEDsColors(CColor::RED);
  world.Step();
  CHECK(LitLEDs(world).empty());
  CHECK(LEDs(world).GetLEDColor(5) == CColor::RED);
}

TEST_CASE("leds: robots are removed with their LEDs", "[contract][robots]") {
  CRobotWorld world(WithLEDs());
  Actuator(world).SetAllColors(CColor::RED);
  world.Step();
  CHECK(LitLEDs(world).size() == 13);
  world.GetSimulator().GetLoopFunctions().RemoveEntity("r");
  // immediately, not only after the next update
  CHECK(LitLEDs(world).empty());
  world.Step();
}

TEST_CASE("leds actuator: invalid orders and experiments are refused with the reason",
          "[contract][robots][errors]") {
  SECTION("an unknown LED") {
    CRobotWorld world(WithLEDs());
    CHECK_THROWS_WITH(Actuator(world).SetSingleColor(13, CColor::RED),
                      Contains("no LED 13") && Contains("13 LEDs"));
    CHECK_THROWS_WITH(Actuator(world).SetSingleIntensity(99, 1), Contains("no LED 99"));
    CHECK_THROWS_WITH(Actuator(world).SetAllColors(CCI_LEDsActuator::TSettings(2)),
                      Contains("2 colors for 13 LEDs"));
  }
  SECTION("an unknown medium") {
    SRobotExperiment experiment = WithLEDs();
    experiment.Actuators = "<leds implementation=\"default\" medium=\"led\"/>";
    CHECK_THAT(LoadError(experiment),
               Contains("\"led\"") && Contains("leds") && Contains("test.argos:"));
  }
  SECTION("a medium of the wrong type") {
    SRobotExperiment experiment = WithLEDs();
    experiment.Media = "<toy_medium id=\"leds\"/>";
    CHECK_THAT(LoadError(experiment), Contains("LED medium") && Contains("leds"));
  }
  SECTION("a missing medium") {
    SRobotExperiment experiment = WithLEDs();
    experiment.Actuators = "<leds implementation=\"default\"/>";
    CHECK_THAT(LoadError(experiment), Contains("medium"));
  }
}

}  // namespace leds_test
