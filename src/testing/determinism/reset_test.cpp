// A reset after a run in which components were enabled and disabled.

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/media/led_medium.h>
#include <argos3/testing/determinism/swarm.h>
#include <argos3/testing/support/forked.h>
#include <argos3/testing/support/robot_world.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

namespace reset_test {

using namespace argos;

namespace {

constexpr UInt32 kTicks = 120;

CFootBotEntity& FootBot(CTestWorld& world, int number) {
  return world.Get<CFootBotEntity>("fb" + std::to_string(number));
}

CCI_Sensor& Eyes(CTestWorld& world, int number) {
  CCI_Controller& controller =
      FootBot(world, number).GetComponent<CControllableEntity>("controller").GetController();
  return *controller.GetAllSensors().at("footbot_proximity");
}

// enables and disables components as loop functions and controllers may do, at different times
void SwitchComponents(CTestWorld& world, UInt32 tick) {
  if (tick == 20) {
    FootBot(world, 0).Disable();
    FootBot(world, 1).GetComponent<CControllableEntity>("controller").Disable();
    FootBot(world, 2).GetComponent("proximity_sensors").Disable();
    FootBot(world, 3).GetLEDEquippedEntity().Disable();
    Eyes(world, 4).Disable();
    FootBot(world, 4).GetLEDEquippedEntity().GetLED(2).Disable();
    FootBot(world, 4).GetEmbodiedEntity().EnableAnchor("turret");
  } else if (tick == 40) {
    FootBot(world, 3).GetLEDEquippedEntity().Enable();
    FootBot(world, 0).GetComponent("wheels").Enable();
  } else if (tick == 60) {
    FootBot(world, 0).Enable();
  }
}

std::vector<UInt64> Run(CTestWorld& world, bool switchesComponents) {
  std::vector<UInt64> digests = {world.ComputeDigest()};
  for (UInt32 tick = 0; tick < kTicks; ++tick) {
    if (switchesComponents) {
      SwitchComponents(world, tick);
    }
    world.Step();
    digests.push_back(world.ComputeDigest());
  }
  return digests;
}

// the LEDs of the medium, in the order in which cameras visit them, and their positions
std::vector<std::pair<std::string, CVector3>> ListLEDs(CTestWorld& world) {
  class CList : public CPositionalIndex<CLEDEntity>::COperation {
   public:
    bool operator()(CLEDEntity& led) override {
      LEDs.emplace_back(led.GetContext() + led.GetId(), led.GetPosition());
      return true;
    }
    std::vector<std::pair<std::string, CVector3>> LEDs;
  } list;
  world.GetSimulator().GetMedium<CLEDMedium>("leds").GetIndex().ForAllEntities(list);
  return list.LEDs;
}

// the enabled state of each entity of the space, in order
std::vector<bool> ListEnabled(CTestWorld& world) {
  std::vector<bool> enabled;
  for (const CEntity* entity : world.GetSpace().GetEntityVector()) {
    enabled.push_back(entity->IsEnabled());
  }
  return enabled;
}

}  // namespace

TEST_CASE("reset: a run in which components were switched repeats", "[determinism][reset]") {
  const UInt32 threads = GENERATE(0U, 4U);
  SExperiment experiment = Swarm(10);
  experiment.Threads = threads;
  CTestWorld untouched(experiment);
  const auto leds = ListLEDs(untouched);
  const auto enabled = ListEnabled(untouched);
  REQUIRE(leds.size() == 5 * 13 + 5 * 8);
  const std::vector<UInt64> plain = Run(untouched, false);

  CTestWorld world(experiment);
  const std::vector<UInt64> switched = Run(world, true);
  CHECK(std::equal(plain.begin(), plain.begin() + 21, switched.begin()));
  CHECK(switched[22] != plain[22]);
  CHECK(ListEnabled(world) != enabled);
  CHECK(ListLEDs(world) != leds);
  CHECK_FALSE(Eyes(world, 4).IsEnabled());
  for (int repetition = 0; repetition < 2; ++repetition) {
    world.GetSimulator().Reset();
    CHECK(ListEnabled(world) == enabled);
    CHECK(ListLEDs(world) == leds);
    CHECK(Eyes(world, 4).IsEnabled());
    // enabled LEDs use the anchor; the use added during the run is gone
    CHECK(FootBot(world, 4).GetEmbodiedEntity().GetAnchor("turret").InUseCount == 1);
    CHECK(Run(world, true) == switched);
  }
  world.GetSimulator().Reset();
  CHECK(Run(world, false) == plain);
}

TEST_CASE("reset: the use counts of anchors are those of the start", "[determinism][reset]") {
  CTestWorld world(Swarm(10, 1, false));
  CEmbodiedEntity& body = FootBot(world, 0).GetEmbodiedEntity();
  SAnchor& turret = body.GetAnchor("turret");
  SAnchor& origin = body.GetOriginAnchor();
  const UInt32 uses = origin.InUseCount;
  REQUIRE(turret.InUseCount == 0);
  body.EnableAnchor("turret");
  body.EnableAnchor("turret");
  body.EnableAnchor("origin");
  world.GetSimulator().Reset();
  CHECK(turret.InUseCount == 0);
  CHECK(origin.InUseCount == uses);
  CHECK(body.GetEnabledAnchors() == std::vector<SAnchor*>{&origin});
  // an anchor added during the run was not in use at the start
  body.AddAnchor("late").Enable();
  world.GetSimulator().Reset();
  CHECK_FALSE(body.IsAnchorEnabled("late"));
}

TEST_CASE("reset: components disabled at the start are disabled again", "[determinism][reset]") {
  SRobotExperiment experiment;
  experiment.Arena =
      "<box id='dark' size='1,1,1' movable='false'><body position='3,0,0'/></box>"
      "<box id='lit' size='1,1,1' movable='false'><body position='1,2,0'/><leds medium='leds'>"
      "<led offset='0.5,0,0.2' anchor='origin' color='red'/></leds></box>";
  CRobotWorld world(experiment);
  auto& dark = world.Get<CBoxEntity>("dark");
  auto& lit = world.Get<CBoxEntity>("lit");
  dark.AddLED(CVector3(0.0, 0.5, 1.0), CColor::BLUE);
  const auto leds = ListLEDs(world);
  REQUIRE(leds.size() == 1);
  // half a metre ahead of the box's centre and 0.2 m above its base
  CHECK(leds[0].second == CVector3(1.5, 2.0, 0.2));

  dark.EnableLEDs(world.GetSimulator().GetMedium<CLEDMedium>("leds"));
  lit.DisableLEDs();
  world.Step();
  CHECK(ListLEDs(world).size() == 1);
  CHECK(ListLEDs(world) != leds);
  world.GetSimulator().Reset();
  CHECK(ListLEDs(world) == leds);
  CHECK_FALSE(dark.GetLEDEquippedEntity().IsEnabled());
  CHECK_FALSE(dark.GetLEDEquippedEntity().GetLED(0).IsEnabled());
}

TEST_CASE("reset: LED entities created while the LEDs are off are enabled again",
          "[determinism][reset]") {
  SExperiment experiment = Swarm(10, 1, false);
  CTestWorld world(experiment);
  CLEDEquippedEntity& leds = FootBot(world, 0).GetLEDEquippedEntity();
  leds.Enable();
  world.GetSpace().MarkStart();
  leds.Disable();
  CHECK_FALSE(leds.GetLED(3).IsEnabled());
  world.GetSimulator().Reset();
  CHECK(leds.GetLED(3).IsEnabled());
}

TEST_CASE("reset: a robot added during the run starts in the state in which it was added",
          "[determinism][reset]") {
  SRobotExperiment experiment;
  experiment.Sensors = "<footbot_proximity implementation='default'/>";
  experiment.Arena = Robot("foot-bot", "a", "position='0,0,0'");
  CRobotWorld world(experiment);
  world.Step();
  auto& added = world.Add(std::make_unique<CFootBotEntity>("b", "c", CVector3(1.0, 0.0, 0.0)));
  auto& eyes = *added.GetComponent<CControllableEntity>("controller")
                    .GetController()
                    .GetAllSensors()
                    .at("footbot_proximity");
  added.Disable();
  eyes.Disable();
  world.GetSimulator().Reset();
  CHECK(added.IsEnabled());
  CHECK(added.GetComponent("wheels").IsEnabled());
  // no device uses the LEDs: they start disabled
  CHECK_FALSE(added.GetLEDEquippedEntity().IsEnabled());
  CHECK(eyes.IsEnabled());

  // a new controller is kept, with the components that it has enabled
  eyes.Disable();
  added.GetComponent<CControllableEntity>("controller").SetController("c");
  added.Disable();
  world.GetSimulator().Reset();
  CHECK(added.IsEnabled());
  CHECK(added.GetComponent<CControllableEntity>("controller")
            .GetController()
            .GetAllSensors()
            .at("footbot_proximity")
            ->IsEnabled());
}

TEST_CASE("reset: a child of fork() runs as its parent, with threads of its own",
          "[determinism][threads]") {
  // ThreadSanitizer ends a child of several threads that starts one
  if (kHasThreadSanitizer) {
    return;
  }
  SExperiment experiment = Swarm(150);
  CTestWorld serial(experiment);
  serial.Step(10);
  const UInt64 expected = serial.ComputeDigest();
  experiment.Threads = 3;
  CTestWorld world(experiment);
  world.Step(4);
  const auto reset = [&] {
    world.GetSimulator().Reset();
    world.Step(10);
    return world.ComputeDigest() == expected ? 0 : 1;
  };
  CHECK(CallInFork(reset) == 0);
  const auto goOn = [&] {
    world.Step(6);
    const bool isEqual = world.ComputeDigest() == expected;
    world.GetSimulator().Destroy();
    return isEqual ? 0 : 1;
  };
  CHECK(CallInFork(goOn) == 0);
  CHECK(goOn() == 0);
}

TEST_CASE("reset: after a redistribution the run is that of an experiment loaded with the seed",
          "[determinism][reset]") {
  const auto scattered = [](UInt32 seed) {
    SExperiment experiment = Swarm(2);
    experiment.Seed = seed;
    const std::string any =
        "<distribute><position method='uniform' min='-2,-2,0' max='2,2,0'/><orientation "
        "method='uniform' min='-180,0,0' max='180,0,0'/>";
    experiment.Arena =
        "<box id='wall' size='1,0.1,0.3' movable='false'><body position='0,0,0'/></box>" + any +
        "<entity quantity='15' max_trials='1000'><foot-bot id='fb'><controller "
        "config='foot-bot'/></foot-bot></entity></distribute>" +
        any +
        "<entity quantity='15' max_trials='1000'><e-puck id='ep'><controller "
        "config='e-puck'/></e-puck></entity></distribute>" +
        any +
        "<entity quantity='5' max_trials='1000'><box id='box' size='0.2,0.1,0.2' movable='true' "
        "mass='0.2'/></entity></distribute>";
    return experiment;
  };
  CTestWorld world(scattered(1));
  world.Step(30);
  for (const UInt32 seed : {7U, 8U, 1U}) {
    CAPTURE(seed);
    CTestWorld fresh(scattered(seed));
    world.GetSimulator().Redistribute(seed);
    CHECK(Run(world, false) == Run(fresh, false));
    world.GetSimulator().Redistribute();
    CHECK(world.GetSpace().GetSimulationClock() == 0);
  }
}

}  // namespace reset_test
