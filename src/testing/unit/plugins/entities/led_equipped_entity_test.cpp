#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/datatypes/any.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/media/led_medium.h>
#include <argos3/testing/support/robot_world.h>
#include <argos3/testing/unit/plugins/entities/component_checks.h>

#include <catch2/catch.hpp>

#include <limits>

namespace led_equipped_entity_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

SRobotExperiment With(const std::string& arena) {
  SRobotExperiment experiment;
  experiment.Arena = arena;
  return experiment;
}

const char* const kTwoEPucks =
    "<e-puck id=\"a\"><body position=\"0,0,0\"/><controller config=\"c\"/></e-puck>"
    "<e-puck id=\"b\"><body position=\"1,0,0\"/><controller config=\"c\"/></e-puck>";

const char* const kBoxWithLEDs =
    "<box id=\"b\" size=\"1,1,1\" movable=\"false\"><body position=\"1,2,0\" "
    "orientation=\"90,0,0\"/><leds medium=\"leds\"><led offset=\"0.5,0,0.2\" anchor=\"origin\" "
    "color=\"red\"/><led offset=\"0,0,1\" anchor=\"origin\" color=\"0,10,20,30\"/></leds></box>";

}  // namespace

TEST_CASE("leds: entities are created on demand with their reserved indices", "[entities]") {
  CRobotWorld world(With(kTwoEPucks));
  auto& a = world.Get<CEPuckEntity>("a");
  auto& b = world.Get<CEPuckEntity>("b");
  CLEDEquippedEntity& leds = a.GetLEDEquippedEntity();
  CHECK(leds.GetNumLazyLEDs() == 8);
  const ssize_t index = leds.GetIndex();
  const UInt64 digest = DigestOf(leds);
  CLEDEntity& led = leds.GetLED(3);
  CHECK(led.GetId() == "led_3");
  CHECK(led.GetContext() == "a.leds_0.");
  CHECK(led.GetIndex() == index + 4);
  CHECK(leds.GetLED(7).GetIndex() == index + 8);
  CHECK(b.GetIndex() > index + 8);
  CHECK(leds.GetLEDs().size() == 8);
  // creating the entities by look-up does not change the digest
  CHECK(DigestOf(leds) == digest);
}

TEST_CASE("leds: are found by component path, by id and by type", "[entities]") {
  CRobotWorld world(With(kTwoEPucks));
  auto& a = world.Get<CEPuckEntity>("a");
  CLEDEntity& byPath = a.GetComponent<CLEDEntity>("leds.led[led_3]");
  CHECK(&byPath == &a.GetLEDEquippedEntity().GetLED(3));
  CHECK(&world.GetSpace().GetEntity("a.leds_0.led_3") == &byPath);
  const auto& byType = world.GetSpace().GetEntitiesByType("led");
  CHECK(byType.size() == 16);
  CHECK(any_cast<CLEDEntity*>(byType.at("a.leds_0.led_3")) == &byPath);
}

TEST_CASE("leds: all ways of setting and reading a colour agree", "[entities]") {
  const bool asEntitiesFirst = GENERATE(true, false);
  CRobotWorld world(With(kTwoEPucks));
  CLEDEquippedEntity& leds = world.Get<CEPuckEntity>("a").GetLEDEquippedEntity();
  if (asEntitiesFirst) {
    leds.GetLEDs();
  }
  leds.SetAllLEDsColors(std::vector<CColor>(8, CColor::GREEN));
  CHECK(leds.GetLEDColor(6) == CColor::GREEN);
  leds.SetAllLEDsColors(CColor::BLUE);
  leds.SetLEDColor(2, CColor::YELLOW);
  CHECK(leds.GetLEDColor(1) == CColor::BLUE);
  CHECK(leds.GetLEDColor(2) == CColor::YELLOW);
  CHECK(leds.GetLED(2).GetColor() == CColor::YELLOW);
  leds.GetLED(4).SetColor(CColor::RED);
  CHECK(leds.GetLEDColor(4) == CColor::RED);
  std::vector<CColor> colors(8, CColor::CYAN);
  colors[7] = CColor::ORANGE;
  leds.SetAllLEDsColors(colors);
  CHECK(leds.GetLEDColor(0) == CColor::CYAN);
  CHECK(leds.GetLEDColor(7) == CColor::ORANGE);
  leds.Reset();
  CHECK(leds.GetLEDColor(7) == CColor::BLACK);
  CHECK(leds.GetLED(7).GetColor() == CColor::BLACK);
}

TEST_CASE("leds: a change of one robot does not affect others of its type", "[entities]") {
  CRobotWorld world(With(kTwoEPucks));
  auto& a = world.Get<CEPuckEntity>("a");
  auto& b = world.Get<CEPuckEntity>("b");
  const CVector3 before = b.GetLEDEquippedEntity().GetLEDOffset(0);
  a.GetLEDEquippedEntity().SetLEDOffset(0, CVector3(1.0, 2.0, 3.0));
  CHECK(a.GetLEDEquippedEntity().GetLEDOffset(0) == CVector3(1.0, 2.0, 3.0));
  CHECK(b.GetLEDEquippedEntity().GetLEDOffset(0) == before);
  a.GetLEDEquippedEntity().AddLED(CVector3(), a.GetEmbodiedEntity().GetOriginAnchor(), CColor::RED);
  CHECK(a.GetLEDEquippedEntity().GetNumLEDs() == 9);
  CHECK(a.GetLEDEquippedEntity().GetLEDColor(8) == CColor::RED);
  CHECK(b.GetLEDEquippedEntity().GetNumLEDs() == 8);
  // an LED added later is the last one, and the others keep their indices
  CHECK(a.GetLEDEquippedEntity().GetLED(8).GetIndex() > b.GetControllableEntity().GetIndex());
  CHECK(a.GetLEDEquippedEntity().GetLED(7).GetIndex() == a.GetLEDEquippedEntity().GetIndex() + 8);
}

TEST_CASE("leds: positions and colours of a box's LEDs follow the file", "[entities]") {
  CRobotWorld world(With(kBoxWithLEDs));
  auto& box = world.Get<CBoxEntity>("b");
  CLEDEquippedEntity& leds = box.GetLEDEquippedEntity();
  REQUIRE(leds.GetNumLEDs() == 2);
  CHECK(leds.GetLEDColor(0) == CColor::RED);
  CHECK(leds.GetLEDColor(1) == CColor(0, 10, 20, 30));
  // turned by 90 degrees, the box faces along y; tolerance of one rounding
  CHECK(Distance(leds.GetLED(0).GetPosition(), CVector3(1.0, 2.5, 0.2)) < 1e-15);
  CHECK(leds.GetLED(0).IsEnabled());
  CHECK(&leds.GetLED(0).GetMedium() == &world.GetSimulator().GetMedium<CLEDMedium>("leds"));
  REQUIRE(box.GetAppearance()->Parts.size() == 3);
  CHECK(box.GetAppearance()->Parts[2].Kind == SVisualPart::EKind::LED);
  CHECK(box.GetAppearance()->Parts[2].LED == 1);
  leds.SetLEDColor(0, CColor::GREEN);
  world.GetSimulator().Reset();
  CHECK(leds.GetLEDColor(0) == CColor::RED);
}

TEST_CASE("leds: a program can add and switch the LEDs of a box", "[entities]") {
  CRobotWorld world(With(""));
  auto made =
      std::make_unique<CBoxEntity>("b", CVector3(), CQuaternion(), false, CVector3(1.0, 1.0, 1.0));
  made->AddLED(CVector3(0.0, 0.0, 1.0), CColor::RED);
  CBoxEntity& box = world.Add(std::move(made));
  auto& medium = world.GetSimulator().GetMedium<CLEDMedium>("leds");
  const auto count = [&medium] {
    class CCount : public CPositionalIndex<CLEDEntity>::COperation {
     public:
      bool operator()(CLEDEntity&) override {
        ++Number;
        return true;
      }
      int Number = 0;
    } counter;
    medium.GetIndex().ForAllEntities(counter);
    return counter.Number;
  };
  world.Step();
  CHECK(count() == 0);
  box.EnableLEDs(medium);
  CHECK(count() == 1);
  box.AddLED(CVector3(0.5, 0.0, 1.0), CColor::BLUE);
  CHECK(count() == 2);
  box.DisableLEDs();
  CHECK(count() == 0);
  world.Step();
}

TEST_CASE("leds: unknown numbers and names are errors", "[entities][errors]") {
  CRobotWorld world(With(kTwoEPucks));
  CLEDEquippedEntity& leds = world.Get<CEPuckEntity>("a").GetLEDEquippedEntity();
  CHECK_THROWS_WITH(leds.GetLED(8), Contains("no LED 8") && Contains("a.leds_0"));
  CHECK_THROWS_AS(leds.SetLEDColor(8, CColor::RED), CARGoSException);
  CHECK_THROWS_AS(leds.GetLEDOffset(8), CARGoSException);
  CHECK_THROWS_AS(leds.GetLEDColor(8), CARGoSException);
  CHECK_THROWS_WITH(leds.SetAllLEDsColors(std::vector<CColor>(3)), Contains("3 colors for 8"));
  CHECK_THROWS_WITH(leds.GetLED(0).GetMedium(), Contains("no medium"));
  const std::string led = "<led offset=\"0,0,1\" anchor=\"origin\" color=\"red\"/>";
  const auto error = [](const std::string& ledsElement) {
    return LoadError(
        With("<box id=\"b\" size=\"1,1,1\" movable=\"false\"><body/>" + ledsElement + "</box>"));
  };
  CHECK(error("<leds medium=\"leds\">" + led + "</leds>").empty());
  CHECK_THAT(error("<leds medium=\"lamps\">" + led + "</leds>"), Contains("lamps"));
  CHECK_THAT(error("<leds>" + led + "</leds>"), Contains("medium"));
  CHECK_THAT(error("<leds medium=\"leds\"><led offset=\"0,0,1\" anchor=\"orign\" "
                   "color=\"red\"/></leds>"),
             Contains("orign") && Contains("origin"));
  CHECK_THAT(error("<leds medium=\"leds\"><led offset=\"0,0,1\" anchor=\"origin\" "
                   "color=\"rad\"/></leds>"),
             Contains("rad"));
}

TEST_CASE("light: has colour, intensity and a medium, and no body", "[entities]") {
  CRobotWorld world(
      With("<light id=\"l\" position=\"1,2,3\" color=\"yellow\" intensity=\"2.5\" "
           "medium=\"leds\"/>"));
  auto& light = world.Get<CLightEntity>("l");
  CHECK(light.GetPosition() == CVector3(1.0, 2.0, 3.0));
  CHECK(light.GetColor() == CColor::YELLOW);
  CHECK(light.GetIntensity() == 2.5);
  CHECK(light.IsEnabled());
  CHECK(light.HasMedium());
  light.SetColor(CColor::RED);
  CHECK(light.GetAppearance()->Parts.at(0).Color == CColor::RED);
  world.GetSimulator().Reset();
  CHECK(light.GetColor() == CColor::YELLOW);
  CHECK_THROWS_AS(light.SetIntensity(std::numeric_limits<Real>::quiet_NaN()), CARGoSException);
  CHECK_THAT(LoadError(With("<light id=\"l\" color=\"yellow\" intensity=\"1\"/>")),
             Contains("medium"));
  CHECK_THAT(LoadError(With("<light id=\"l\" color=\"yellow\" intensity=\"1\" medium=\"x\"/>")),
             Contains("\"x\""));
  CHECK_THAT(LoadError(With("<light id=\"l\" color=\"yellow\" medium=\"leds\"/>")),
             Contains("intensity"));
}

}  // namespace led_equipped_entity_test
