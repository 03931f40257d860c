// Orders of controllers to directional LEDs, tags and magnets of robots.

#include <argos3/plugins/robots/generic/control_interface/ci_directional_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_magnets_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_tags_actuator.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/magnet_equipped_entity.h>
#include <argos3/plugins/simulator/entities/tag_equipped_entity.h>
#include <argos3/testing/support/robot_world.h>
#include <argos3/testing/support/statistics.h>

#include <catch2/catch.hpp>

#include <limits>

namespace argos::mounted_devices_test {

using Catch::Matchers::Contains;

namespace {

SRobotExperiment With(const std::string& actuators, const std::string& tag = "foot-bot") {
  SRobotExperiment experiment;
  experiment.Actuators = actuators;
  experiment.Media = "<directional_led id=\"directional_leds\"/><tag id=\"tags\"/>";
  experiment.Arena =
      "<" + tag + " id=\"r\"><body/><controller config=\"c\"/>" +
      "<directional_leds medium=\"directional_leds\">"
      "<directional_led anchor=\"origin\" observable_angle=\"60\" color=\"red\"/>"
      "<directional_led anchor=\"origin\" observable_angle=\"60\"/></directional_leds>"
      "<tags medium=\"tags\">"
      "<tag anchor=\"origin\" observable_angle=\"60\" side_length=\"0.1\" payload=\"one\"/>"
      "<tag anchor=\"origin\" observable_angle=\"60\" side_length=\"0.1\"/></tags>"
      "<magnets><magnet id=\"front\" anchor=\"origin\" offset=\"0,0,0\" passive_field=\"1,0,0\" "
      "active_field=\"0,2,0\"/></magnets></" +
      tag + ">";
  return experiment;
}

template <typename COMPONENT>
COMPONENT& Component(CRobotWorld& world, const std::string& type) {
  return world.Get<CComposableEntity>("r").GetComponent<COMPONENT>(type);
}

}  // namespace

TEST_CASE("directional leds actuator: colours change in the next tick, and a reset restores them",
          "[contract][robots]") {
  const std::string tag = GENERATE("foot-bot", "e-puck", "eye-bot");
  CRobotWorld world(With("<directional_leds implementation=\"default\"/>", tag));
  auto& actuator = world.GetActuator<CCI_DirectionalLEDsActuator>("r", "directional_leds");
  auto& leds = Component<CDirectionalLEDEquippedEntity>(world, "directional_leds");
  REQUIRE(actuator.GetNumLEDs() == 2);
  world.Step();
  // without orders the LEDs keep the colours of the file
  CHECK(leds.GetLED(0).GetColor() == CColor::RED);
  CHECK(leds.GetLED(1).GetColor() == CColor::BLACK);
  actuator.SetSingleColor(1, CColor::GREEN);
  actuator.SetSingleIntensity(0, 100);
  CHECK(leds.GetLED(1).GetColor() == CColor::BLACK);
  world.Step();
  CHECK(leds.GetLED(0).GetColor() == CColor(255, 0, 0, 100));
  CHECK(leds.GetLED(1).GetColor() == CColor::GREEN);
  actuator.SetAllColors(CColor::BLUE);
  actuator.SetAllIntensities(7);
  world.Step();
  CHECK(leds.GetLED(0).GetColor() == CColor(0, 0, 255, 7));
  actuator.SetAllColors({CColor::WHITE, CColor::CYAN});
  world.Step();
  CHECK(leds.GetLED(1).GetColor() == CColor::CYAN);
  world.GetSimulator().Reset();
  CHECK(leds.GetLED(0).GetColor() == CColor::RED);
  world.Step();
  CHECK(leds.GetLED(0).GetColor() == CColor::RED);
  CHECK(leds.GetLED(1).GetColor() == CColor::BLACK);
  CHECK_THROWS_WITH(actuator.SetSingleColor(2, CColor::RED),
                    Contains("no LED 2") && Contains("directional_leds") && Contains("has 2 LEDs"));
  CHECK_THROWS_WITH(actuator.SetAllColors(std::vector<CColor>(3)), Contains("3 colors for 2"));
}

TEST_CASE("tags actuator: payloads change in the next tick, and a reset restores them",
          "[contract][robots]") {
  const std::string tag = GENERATE("foot-bot", "e-puck", "eye-bot");
  CRobotWorld world(With("<tags implementation=\"default\"/>", tag));
  auto& actuator = world.GetActuator<CCI_TagsActuator>("r", "tags");
  auto& tags = Component<CTagEquippedEntity>(world, "tags");
  REQUIRE(actuator.GetNumTags() == 2);
  world.Step();
  CHECK(tags.GetTag(0).GetPayload() == "one");
  CHECK(tags.GetTag(1).GetPayload().empty());
  actuator.SetSinglePayload(1, "two");
  CHECK(tags.GetTag(1).GetPayload().empty());
  world.Step();
  CHECK(tags.GetTag(0).GetPayload() == "one");
  CHECK(tags.GetTag(1).GetPayload() == "two");
  actuator.SetAllPayloads("same");
  world.Step();
  CHECK(tags.GetTag(0).GetPayload() == "same");
  world.GetSimulator().Reset();
  world.Step();
  CHECK(tags.GetTag(0).GetPayload() == "one");
  CHECK(tags.GetTag(1).GetPayload().empty());
  CHECK_THROWS_WITH(actuator.SetSinglePayload(2, "x"), Contains("no tag 2") && Contains("2 tags"));
}

TEST_CASE("magnets actuator: currents change in the next tick", "[contract][robots]") {
  const std::string tag = GENERATE("foot-bot", "e-puck", "eye-bot");
  CRobotWorld world(With("<magnets implementation=\"default\"/>", tag));
  auto& interfaces = world.GetActuator<CCI_MagnetsActuator>("r", "magnets").GetInterfaces();
  CMagnetEntity& magnet = Component<CMagnetEquippedEntity>(world, "magnets").GetMagnet(0);
  REQUIRE(interfaces.size() == 1);
  CHECK(interfaces[0].Id == "front");
  interfaces[0].Current = -1.5;
  CHECK(magnet.GetCurrent() == 0.0);
  world.Step();
  CHECK(magnet.GetField() == CVector3(1.0, -3.0, 0.0));
  world.GetSimulator().Reset();
  CHECK(interfaces[0].Current == 0.0);
  world.Step();
  CHECK(magnet.GetCurrent() == 0.0);
  interfaces[0].Current = std::numeric_limits<Real>::infinity();
  CHECK_THROWS_WITH(world.Step(), Contains("\"r\": an actuator threw"));
}

TEST_CASE("magnets actuator: noise is on the current and drawn in each tick",
          "[contract][robots][noise]") {
  CRobotWorld world(
      With("<magnets implementation=\"default\"><noise on=\"current\" model=\"gaussian\" "
           "std_dev=\"0.1\" relative=\"true\"/></magnets>"));
  world.GetActuator<CCI_MagnetsActuator>("r", "magnets").GetInterfaces()[0].Current = 2.0;
  const CMagnetEntity& magnet = Component<CMagnetEquippedEntity>(world, "magnets").GetMagnet(0);
  std::vector<Real> currents;
  for (int i = 0; i < 20000; ++i) {
    world.Step();
    currents.push_back(magnet.GetCurrent());
  }
  CHECK(KolmogorovSmirnovExcess(
            currents, [](Real current) { return NormalDistribution(current - 2.0, 0.2); }) < 1.0);
}

TEST_CASE("mounted devices: a robot without the component is refused by name",
          "[contract][robots][errors]") {
  const std::string device = GENERATE("directional_leds", "tags", "magnets");
  SRobotExperiment experiment = With("<" + device + " implementation=\"default\"/>");
  experiment.Arena = Robot("e-puck", "ep0", "position=\"0,0,0\"");
  CHECK_THAT(LoadError(experiment), Contains("ep0") && Contains("no component \"" + device + "\""));
}

}  // namespace argos::mounted_devices_test
