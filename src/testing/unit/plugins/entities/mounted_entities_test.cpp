// Directional LEDs, tags and magnets as components of bodies.

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/magnet_equipped_entity.h>
#include <argos3/plugins/simulator/entities/tag_equipped_entity.h>
#include <argos3/plugins/simulator/media/directional_led_medium.h>
#include <argos3/plugins/simulator/media/tag_medium.h>
#include <argos3/testing/support/robot_world.h>
#include <argos3/testing/unit/plugins/entities/component_checks.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace mounted_entities_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

const char* const kLEDs =
    "<directional_leds medium=\"directional_leds\">"
    "<directional_led position=\"0.1,0,0.05\" orientation=\"0,90,0\" anchor=\"origin\" "
    "observable_angle=\"60\" color=\"red\"/>"
    "<directional_led position=\"0,0.1,0.2\" anchor=\"turret\" observable_angle=\"180\"/>"
    "</directional_leds>";
const char* const kTags =
    "<tags medium=\"tags\">"
    "<tag position=\"-0.1,0,0.05\" orientation=\"0,-90,0\" anchor=\"origin\" "
    "observable_angle=\"75\" side_length=\"0.04\" payload=\"one\"/>"
    "<tag anchor=\"origin\" observable_angle=\"10\" side_length=\"0.02\"/></tags>";
const char* const kMagnets =
    "<magnets><magnet id=\"front\" offset=\"0.08,0,0.05\" anchor=\"origin\" "
    "passive_field=\"1,2,3\" active_field=\"-1,0,4\"/>"
    "<magnet offset=\"0,0,0\" anchor=\"turret\" passive_field=\"0,0,5\"/></magnets>";

SRobotExperiment With(const std::string& mounted, const std::string& tag = "foot-bot") {
  SRobotExperiment experiment;
  experiment.Media = "<directional_led id=\"directional_leds\"/><tag id=\"tags\"/>";
  experiment.Arena = "<" + tag + " id=\"r\"><body position=\"1,2,0\" orientation=\"90,0,0\"/>" +
                     "<controller config=\"c\"/>" + mounted + "</" + tag + ">";
  return experiment;
}

template <typename ENTITY>
class CCount : public CPositionalIndex<ENTITY>::COperation {
 public:
  bool operator()(ENTITY&) override {
    ++Number;
    return true;
  }
  size_t Number = 0;
};

template <typename ENTITY>
size_t Count(CPositionalIndex<ENTITY>& index) {
  CCount<ENTITY> count;
  index.Update();
  index.ForEntitiesInBoxRange(CVector3(), CVector3(100.0, 100.0, 100.0), count);
  return count.Number;
}

CDirectionalLEDEquippedEntity& LEDs(CRobotWorld& world) {
  return world.Get<CComposableEntity>("r").GetComponent<CDirectionalLEDEquippedEntity>(
      "directional_leds");
}

CTagEquippedEntity& Tags(CRobotWorld& world) {
  return world.Get<CComposableEntity>("r").GetComponent<CTagEquippedEntity>("tags");
}

CMagnetEquippedEntity& Magnets(CRobotWorld& world) {
  return world.Get<CComposableEntity>("r").GetComponent<CMagnetEquippedEntity>("magnets");
}

}  // namespace

TEST_CASE("directional leds: positions follow the file and the body", "[entities]") {
  CRobotWorld world(With(kLEDs));
  CDirectionalLEDEquippedEntity& leds = LEDs(world);
  CHECK(leds.IsEnabled());
  REQUIRE(leds.GetNumLEDs() == 2);
  CHECK(leds.GetLED(0).GetColor() == CColor::RED);
  CHECK(leds.GetLED(1).GetColor() == CColor::BLACK);
  CHECK(&world.GetSpace().GetEntity("r.directional_leds_0.directional_led_1") == &leds.GetLED(1));
  CHECK_THAT(ToDegrees(leds.GetLED(0).GetObservableAngle()).GetValue(), WithinAbs(60.0, 1e-12));
  CHECK(&leds.GetLED(0).GetMedium() ==
        &world.GetSimulator().GetMedium<CDirectionalLEDMedium>("directional_leds"));
  auto& body = world.Get<CFootBotEntity>("r").GetEmbodiedEntity();
  CHECK(body.GetAnchor("turret").InUseCount == 1);
  // tolerance of a few roundings of numbers near 1
  const auto check = [&](const CVector3& first, const CVector3& second, const CVector3& axis) {
    CHECK_THAT(Distance(leds.GetLED(0).GetPosition(), first), WithinAbs(0.0, 1e-15));
    CHECK_THAT(Distance(leds.GetLED(1).GetPosition(), second), WithinAbs(0.0, 1e-15));
    CVector3 z = CVector3::Z;
    z.Rotate(leds.GetLED(0).GetOrientation());
    CHECK_THAT(Distance(z, axis), WithinAbs(0.0, 1e-15));
  };
  // the robot faces along y, and so does the first LED
  check(CVector3(1.0, 2.1, 0.05), CVector3(0.9, 2.0, 0.2), CVector3::Y);
  REQUIRE(body.MoveTo(CVector3(0.0, 0.5, 0.0), CQuaternion(CRadians::PI, CVector3::Z)));
  check(CVector3(-0.1, 0.5, 0.05), CVector3(0.0, 0.4, 0.2), -CVector3::X);
  world.Step();
  check(CVector3(-0.1, 0.5, 0.05), CVector3(0.0, 0.4, 0.2), -CVector3::X);
  world.GetSimulator().Reset();
  check(CVector3(1.0, 2.1, 0.05), CVector3(0.9, 2.0, 0.2), CVector3::Y);
}

TEST_CASE("directional leds: the medium contains those that are enabled and lit",
          "[entities][media]") {
  CRobotWorld world(With(kLEDs));
  auto& index =
      world.GetSimulator().GetMedium<CDirectionalLEDMedium>("directional_leds").GetIndex();
  CHECK(Count(index) == 1);
  LEDs(world).SetLEDColors(CColor::BLUE);
  CHECK(Count(index) == 2);
  LEDs(world).SetLEDColor(0, CColor::BLACK);
  CHECK(Count(index) == 1);
  LEDs(world).SetLEDColors({CColor::RED, CColor::GREEN});
  CHECK(Count(index) == 2);
  auto& body = world.Get<CFootBotEntity>("r").GetEmbodiedEntity();
  LEDs(world).Disable();
  CHECK(Count(index) == 0);
  CHECK(body.GetAnchor("turret").InUseCount == 0);
  LEDs(world).Enable();
  CHECK(Count(index) == 2);
  // adds one LED during the run
  LEDs(world).AddLED(CVector3(0.0, 0.0, 0.3), CQuaternion(), body.GetOriginAnchor(), CRadians(1.0),
                     CColor::YELLOW);
  CHECK(Count(index) == 3);
  CHECK_THAT(Distance(LEDs(world).GetLED(2).GetPosition(), CVector3(1.0, 2.0, 0.3)),
             WithinAbs(0.0, 1e-15));
  CHECK(&world.GetSpace().GetEntity("r.directional_leds_0.directional_led_2") ==
        &LEDs(world).GetLED(2));
  world.GetSimulator().Reset();
  CHECK(LEDs(world).GetLED(0).GetColor() == CColor::RED);
  CHECK(LEDs(world).GetLED(2).GetColor() == CColor::YELLOW);
  world.GetSimulator().GetLoopFunctions().RemoveEntity("r");
  CHECK(Count(index) == 0);
}

TEST_CASE("directional led: is visible within an angle around its z axis", "[entities]") {
  const CQuaternion sideways(CRadians::PI_OVER_TWO, CVector3::Y);  // z becomes x
  const CDirectionalLEDEntity led(nullptr, "l", CVector3(1.0, 0.0, 0.0), sideways,
                                  ToRadians(CDegrees(30.0)), CColor::RED);
  const auto at = [](Real degrees, const CVector3& axis) {
    CVector3 away(2.0, 0.0, 0.0);
    away.Rotate(CQuaternion(ToRadians(CDegrees(degrees)), axis));
    return CVector3(1.0, 0.0, 0.0) + away;
  };
  for (const CVector3& axis : {CVector3::Y, CVector3::Z, -CVector3::Y}) {
    CHECK(led.ShinesOn(at(0.0, axis)));
    CHECK(led.ShinesOn(at(29.999999, axis)));
    CHECK_FALSE(led.ShinesOn(at(30.000001, axis)));
    CHECK_FALSE(led.ShinesOn(at(180.0, axis)));
  }
  CDirectionalLEDEntity all(nullptr);
  CHECK(all.ShinesOn(CVector3(0.0, 0.0, -1.0)));
  CHECK_FALSE(all.IsLit());
  all.SetObservableAngle(ToRadians(CDegrees(120.0)));
  CHECK(all.ShinesOn(CVector3(1.0, 0.0, -0.5)));
  CHECK_FALSE(all.ShinesOn(CVector3(1.0, 0.0, -0.6)));
}

TEST_CASE("tags: positions follow the file, corners surround them", "[entities]") {
  const std::string robot = GENERATE("foot-bot", "e-puck", "eye-bot");
  CRobotWorld world(With(kTags, robot));
  REQUIRE(Tags(world).GetNumTags() == 2);
  CTagEntity& tag = Tags(world).GetTag(0);
  CHECK(tag.GetPayload() == "one");
  CHECK(Tags(world).GetTag(1).GetPayload().empty());
  CHECK(tag.GetSideLength() == 0.04);
  // The robot faces along y. The tag can be read from behind the robot, and its y axis is the
  // robot's y axis, which points along -x.
  CHECK_THAT(Distance(tag.GetPosition(), CVector3(1.0, 1.9, 0.05)), WithinAbs(0.0, 1e-15));
  const auto corners = tag.ComputeCorners();
  const CVector3 expected[] = {
      {0.98, 1.9, 0.07}, {0.98, 1.9, 0.03}, {1.02, 1.9, 0.03}, {1.02, 1.9, 0.07}};
  for (size_t i = 0; i < 4; ++i) {
    CAPTURE(i);
    CHECK_THAT(Distance(corners[i], expected[i]), WithinAbs(0.0, 1e-15));
  }
  CHECK(tag.Faces(CVector3(1.0, 0.0, 0.05)));
  CHECK_FALSE(tag.Faces(CVector3(1.0, 3.0, 0.05)));
  auto& index = world.GetSimulator().GetMedium<CTagMedium>("tags").GetIndex();
  CHECK(Count(index) == 2);
  const UInt64 before = DigestOf(Tags(world));
  Tags(world).SetTagPayload(1, "two");
  CHECK(DigestOf(Tags(world)) != before);
  Tags(world).SetTagPayloads("all");
  CHECK(tag.GetPayload() == "all");
  Tags(world).SetTagPayloads(std::vector<std::string>{"a", "b"});
  CHECK(Tags(world).GetTag(1).GetPayload() == "b");
  world.GetSimulator().Reset();
  CHECK(tag.GetPayload() == "one");
  CHECK(Tags(world).GetTag(1).GetPayload().empty());
}

namespace {

// number of times that a medium lists entities, wherever they are
template <typename ENTITY, typename MEDIUM>
size_t CountListed(MEDIUM& medium) {
  CCount<ENTITY> count;
  medium.Update();
  medium.GetIndex().ForAllEntities(count);
  return count.Number;
}

// AddEntity() of users for one that the file has registered, and for one that nothing has
template <typename ENTITY, typename MEDIUM>
void CheckAddedOnce(MEDIUM& medium, MEDIUM& others, ENTITY& registered, ENTITY& loose) {
  const size_t before = CountListed<ENTITY>(medium);
  medium.AddEntity(registered);
  medium.AddEntity(registered);
  CHECK(CountListed<ENTITY>(medium) == before);
  registered.Disable();
  CHECK(CountListed<ENTITY>(medium) == before - 1);
  medium.AddEntity(registered);
  CHECK(registered.IsEnabled());
  CHECK(CountListed<ENTITY>(medium) == before);

  medium.AddEntity(loose);
  medium.AddEntity(loose);
  CHECK(loose.IsEnabled());
  CHECK(&loose.GetMedium() == &medium);
  CHECK(CountListed<ENTITY>(medium) == before + 1);
  others.AddEntity(loose);
  CHECK(CountListed<ENTITY>(medium) == before);
  CHECK(CountListed<ENTITY>(others) == 1);
  // it is not in this one
  medium.RemoveEntity(loose);
  CHECK(CountListed<ENTITY>(others) == 1);
  others.RemoveEntity(loose);
  others.RemoveEntity(loose);
  CHECK(CountListed<ENTITY>(others) == 0);
  CHECK_FALSE(loose.HasMedium());
}

}  // namespace

TEST_CASE("directional leds and tags: AddEntity() of users puts an entity into a medium once",
          "[entities][media]") {
  SRobotExperiment experiment = With(std::string(kLEDs) + kTags);
  experiment.Media += "<directional_led id='more_leds'/><tag id='more_tags'/>";
  CRobotWorld world(experiment);
  CSimulator& simulator = world.GetSimulator();
  CDirectionalLEDEntity led(nullptr, "led", CVector3(1.0, 0.0, 0.0), CQuaternion(), CRadians::PI,
                            CColor::RED);
  CheckAddedOnce(simulator.GetMedium<CDirectionalLEDMedium>("directional_leds"),
                 simulator.GetMedium<CDirectionalLEDMedium>("more_leds"), LEDs(world).GetLED(0),
                 led);
  CTagEntity tag(nullptr, "tag", CVector3(1.0, 0.0, 0.0), CQuaternion(), CRadians::PI, 0.02, "");
  CheckAddedOnce(simulator.GetMedium<CTagMedium>("tags"),
                 simulator.GetMedium<CTagMedium>("more_tags"), Tags(world).GetTag(0), tag);
}

TEST_CASE("magnets: the field is the passive part plus the active part times the current",
          "[entities]") {
  CRobotWorld world(With(kMagnets));
  REQUIRE(Magnets(world).GetNumMagnets() == 2);
  CMagnetEntity& magnet = Magnets(world).GetMagnet(0);
  CHECK(magnet.GetId() == "front");
  CHECK(Magnets(world).GetMagnet(1).GetId() == "magnet_1");
  CHECK(Magnets(world).GetInstances()[0].Offset == CVector3(0.08, 0.0, 0.05));
  CHECK(Magnets(world).GetInstances()[1].Anchor.Id == "turret");
  CHECK(world.Get<CFootBotEntity>("r").GetEmbodiedEntity().GetAnchor("turret").InUseCount == 1);
  CHECK(magnet.GetField() == CVector3(1.0, 2.0, 3.0));
  const UInt64 before = DigestOf(magnet);
  magnet.SetCurrent(0.5);
  CHECK(magnet.GetField() == CVector3(0.5, 2.0, 5.0));
  CHECK(DigestOf(magnet) != before);
  world.GetSimulator().Reset();
  CHECK(magnet.GetField() == CVector3(1.0, 2.0, 3.0));
  CHECK(Magnets(world).GetMagnet(1).GetField() == CVector3(0.0, 0.0, 5.0));
  Magnets(world).AddMagnet("", CVector3(),
                           world.Get<CFootBotEntity>("r").GetEmbodiedEntity().GetOriginAnchor(),
                           CVector3::X);
  CHECK(Magnets(world).GetMagnet(2).GetId() == "magnet_2");
}

TEST_CASE("mounted entities: robots without them have no such components", "[entities]") {
  CRobotWorld world(With(""));
  auto& robot = world.Get<CFootBotEntity>("r");
  for (const char* type : {"directional_leds", "tags", "magnets"}) {
    CHECK_FALSE(robot.HasComponent(type));
  }
}

TEST_CASE("mounted entities: invalid values are refused with place and reason",
          "[entities][errors]") {
  struct SCase {
    const char* Mounted;
    const char* Reason;
  };
  const std::string led = "<directional_led anchor=\"origin\" ";
  const SCase c = GENERATE(
      SCase{"<directional_leds/>", "medium"},
      SCase{"<directional_leds medium=\"tags\"/>", "\"tags\""},
      SCase{"<directional_leds medium=\"directional_leds\"><directional_led anchor=\"orign\" "
            "observable_angle=\"60\"/></directional_leds>",
            "origin"},
      SCase{"<directional_leds medium=\"directional_leds\"><directional_led anchor=\"origin\"/>"
            "</directional_leds>",
            "observable_angle"},
      SCase{"<directional_leds medium=\"directional_leds\"><directional_led anchor=\"origin\" "
            "observable_angle=\"181\"/></directional_leds>",
            "at most 180 degrees, got 181"},
      SCase{"<directional_leds medium=\"directional_leds\"><directional_led "
            "observable_angle=\"60\"/></directional_leds>",
            "anchor"},
      SCase{"<tags medium=\"tags\"><tag anchor=\"origin\" observable_angle=\"0\" "
            "side_length=\"1\"/></tags>",
            "above 0"},
      SCase{"<tags medium=\"tags\"><tag anchor=\"origin\" observable_angle=\"9\" "
            "side_length=\"0\"/></tags>",
            "side_length"},
      SCase{"<magnets><magnet anchor=\"origin\" offset=\"0,0,0\"/></magnets>", "passive_field"},
      SCase{"<magnets><magnet anchor=\"origin\" passive_field=\"0,0,0\"/></magnets>", "offset"});
  CAPTURE(c.Mounted);
  CHECK_THAT(LoadError(With(c.Mounted)), Contains(c.Reason) && Contains("test.argos:"));
}

TEST_CASE("mounted entities: unknown numbers and values out of range are errors",
          "[entities][errors]") {
  CRobotWorld world(With(std::string(kLEDs) + kTags + kMagnets));
  CHECK_THROWS_WITH(LEDs(world).GetLED(2),
                    Contains("no LED 2") && Contains("r.directional_leds_0"));
  CHECK_THROWS_WITH(LEDs(world).SetLEDColors(std::vector<CColor>(3)), Contains("3 colors for 2"));
  CHECK_THROWS_WITH(Tags(world).GetTag(2), Contains("no tag 2"));
  CHECK_THROWS_WITH(Tags(world).SetTagPayloads(std::vector<std::string>(1)),
                    Contains("1 payloads for 2"));
  CHECK_THROWS_WITH(Magnets(world).GetMagnet(2), Contains("no magnet 2"));
  CHECK_THROWS_WITH(Magnets(world).GetMagnet(0).SetCurrent(std::numeric_limits<Real>::quiet_NaN()),
                    Contains("current must be finite"));
  CHECK_THROWS_WITH(Tags(world).GetTag(0).SetSideLength(-1.0), Contains("side length"));
  CHECK_THROWS_WITH(Tags(world).GetTag(0).SetObservableAngle(CRadians(4.0)),
                    Contains("observable_angle"));
  CTagEntity tag(nullptr);
  CHECK_THROWS_WITH(tag.GetMedium(), Contains("no medium"));
}

}  // namespace mounted_entities_test
