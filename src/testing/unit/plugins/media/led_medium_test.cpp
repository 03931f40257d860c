#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/media/led_medium.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <set>

namespace led_medium_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

class CCollect : public CPositionalIndex<CLEDEntity>::COperation {
 public:
  bool operator()(CLEDEntity& led) override {
    Found.push_back(&led);
    return true;
  }
  std::vector<CLEDEntity*> Found;
};

SRobotExperiment WithMedium(const std::string& attributes) {
  SRobotExperiment experiment;
  experiment.Media = "<led id=\"leds\" " + attributes + "/>";
  return experiment;
}

}  // namespace

TEST_CASE(
    "led medium: finds every lit LED in range, inside and outside the arena, as brute force does",
    "[media]") {
  const std::string index = GENERATE("", "index=\"grid\"", "index=\"grid\" grid_size=\"3,20,1\"",
                                     "index=\"hash\"", "index=\"hash\" grid_size=\"100,100,10\"");
  CAPTURE(index);
  SRobotExperiment experiment = WithMedium(index);
  CRandomStream random(1, "test", "led medium", "places");
  const auto place = [&random] {
    // the arena is 10 x 10 x 2 m around the origin: half of them are outside
    return CVector3(random.Uniform(-8.0, 8.0), random.Uniform(-8.0, 8.0),
                    random.Uniform(-2.0, 2.0));
  };
  constexpr int kLights = 300;
  for (int i = 0; i < kLights; ++i) {
    experiment.Arena += "<light id=\"l" + std::to_string(i) + "\" position=\"" + ToText(place()) +
                        "\" color=\"" + (i % 5 == 0 ? "black" : "red") +
                        "\" intensity=\"1\" medium=\"leds\"/>";
  }
  CRobotWorld world(experiment);
  world.Step();
  auto& medium = world.GetSimulator().GetMedium<CLEDMedium>("leds");
  for (int trial = 0; trial < 50; ++trial) {
    const CVector3 center = place();
    const Real radius = random.Uniform(0.0, 3.0);
    CCollect collect;
    medium.GetIndex().ForEntitiesInSphereRange(center, radius, collect);
    const std::set<CLEDEntity*> found(collect.Found.begin(), collect.Found.end());
    for (int i = 0; i < kLights; ++i) {
      auto& light = world.Get<CLightEntity>("l" + std::to_string(i));
      if (light.IsLit() && Distance(light.GetPosition(), center) <= radius) {
        CHECK(found.count(&light) == 1);
      }
    }
  }
}

TEST_CASE("led medium: the order of visits is repeatable", "[media]") {
  const std::string index = GENERATE("index=\"grid\"", "index=\"hash\"");
  SRobotExperiment experiment = WithMedium(index);
  for (int i = 0; i < 50; ++i) {
    experiment.Arena += "<light id=\"l" + std::to_string(i) + "\" position=\"" +
                        ToText(CVector3(i % 7, i % 3, 0.0)) +
                        "\" color=\"red\" intensity=\"1\" medium=\"leds\"/>";
  }
  const auto order = [&experiment] {
    CRobotWorld world(experiment);
    world.Step();
    CCollect collect;
    world.GetSimulator().GetMedium<CLEDMedium>("leds").GetIndex().ForEntitiesInBoxRange(
        CVector3(2.0, 1.0, 0.0), CVector3(2.0, 1.0, 1.0), collect);
    std::vector<std::string> ids;
    for (const CLEDEntity* led : collect.Found) {
      ids.push_back(led->GetId());
    }
    return ids;
  };
  const std::vector<std::string> first = order();
  CHECK(first.size() >= 30);
  CHECK(order() == first);
}

TEST_CASE("led medium: contains LEDs exactly while they are enabled", "[media]") {
  CRobotWorld world(WithMedium(""));
  auto& medium = world.GetSimulator().GetMedium<CLEDMedium>("leds");
  const auto count = [&medium] {
    medium.Update();
    CCollect collect;
    medium.GetIndex().ForAllEntities(collect);
    return collect.Found.size();
  };
  CHECK(count() == 0);
  {
    CLEDEntity led(nullptr, "led", CVector3(), CColor::RED);
    led.SetMedium(medium);
    CHECK(count() == 0);
    led.Enable();
    led.Enable();
    CHECK(count() == 1);
    CHECK(&led.GetMedium() == &medium);
    led.Disable();
    CHECK(count() == 0);
    led.Enable();
    CHECK(count() == 1);
  }
  // the destructor of an LED removes it from the medium
  CHECK(count() == 0);
}

TEST_CASE("led medium: LEDs may outlive it", "[media]") {
  CRobotWorld world(WithMedium(""));
  CLEDEntity led(nullptr, "led", CVector3(), CColor::RED);
  {
    TConfigurationNode node("led");
    SetNodeAttribute(node, "id", std::string("other"));
    CLEDMedium medium;
    medium.Init(node);
    led.SetMedium(medium);
    led.Enable();
    CHECK(led.HasMedium());
  }
  CHECK_FALSE(led.HasMedium());
}

TEST_CASE("led medium: an LED can be moved to another medium", "[media]") {
  SRobotExperiment experiment;
  experiment.Media = "<led id=\"one\"/><led id=\"two\"/>";
  CRobotWorld world(experiment);
  auto& one = world.GetSimulator().GetMedium<CLEDMedium>("one");
  auto& two = world.GetSimulator().GetMedium<CLEDMedium>("two");
  CLEDEntity led(nullptr, "led", CVector3(), CColor::RED);
  led.Enable();
  led.SetMedium(one);
  led.SetMedium(two);
  CCollect inOne;
  one.GetIndex().ForAllEntities(inOne);
  CCollect inTwo;
  two.GetIndex().ForAllEntities(inTwo);
  CHECK(inOne.Found.empty());
  CHECK(inTwo.Found.size() == 1);
}

TEST_CASE("led medium: invalid attributes are refused with place and reason", "[media][errors]") {
  struct SCase {
    const char* Attributes;
    const char* Reason;
  };
  const SCase c = GENERATE(SCase{"index=\"gird\"", "grid"}, SCase{"grid_size=\"1,2\"", "grid_size"},
                           SCase{"grid_size=\"1,0,1\"", "at least 1"},
                           SCase{"grid_size=\"1,2,3,4\"", "grid_size"},
                           SCase{"grid_size=\"1,2,x\"", "grid_size"});
  CAPTURE(c.Attributes);
  CHECK_THAT(LoadError(WithMedium(c.Attributes)), Contains(c.Reason) && Contains("test.argos:"));
  SRobotExperiment twice;
  twice.Media = "<led id=\"leds\"/><led id=\"leds\"/>";
  CHECK_THAT(LoadError(twice), Contains("leds"));
}

TEST_CASE("led medium: AddEntity() of users enables an LED in it, once", "[media]") {
  SRobotExperiment experiment;
  experiment.Media = "<led id='leds'/><led id='others'/>";
  CRobotWorld world(experiment);
  auto& medium = world.GetSimulator().GetMedium<CLEDMedium>("leds");
  auto& others = world.GetSimulator().GetMedium<CLEDMedium>("others");
  const auto count = [](CLEDMedium& counted) {
    CCollect collect;
    counted.Update();
    counted.GetIndex().ForAllEntities(collect);
    return collect.Found.size();
  };
  // before and after it is added to the space, as loop functions do
  auto owned = std::make_unique<CLightEntity>("l", CVector3(1, 0, 0), CColor::RED, 1.0);
  medium.AddEntity(*owned);
  CLightEntity& light = world.Add(std::move(owned));
  medium.AddEntity(light);
  CHECK(light.IsEnabled());
  CHECK(count(medium) == 1);
  others.AddEntity(light);
  CHECK(&light.GetMedium() == &others);
  CHECK(count(medium) == 0);
  CHECK(count(others) == 1);
  // it is not in this one
  medium.RemoveEntity(light);
  CHECK(count(others) == 1);
  others.RemoveEntity(light);
  others.RemoveEntity(light);
  CHECK_FALSE(light.HasMedium());
  CHECK(count(others) == 0);
  others.AddEntity(light);
  CHECK(count(others) == 1);
  world.GetSimulator().GetLoopFunctions().RemoveEntity("l");
  CHECK(count(others) == 0);
  // the medium is destroyed before an entity that is in no space
  CLEDEntity loose(nullptr, "loose", CVector3(), CColor::RED);
  medium.AddEntity(loose);
  world.GetSimulator().Destroy();
  CHECK_FALSE(loose.HasMedium());
}

}  // namespace led_medium_test
