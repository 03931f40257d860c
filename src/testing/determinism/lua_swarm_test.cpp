// Swarms of robots that run Lua scripts.

#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/paths.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <set>
#include <thread>
#include <vector>

namespace lua_swarm_test {

using namespace argos;

namespace {

// A random walk by robot.random and math.random that turns away from obstacles; it depends on the
// order in which pairs() visits strings.
constexpr const char* kScript = R"(
local words = {}
function init()
  for i = 1, 20 do words["word" .. robot.random.uniform_int(1000)] = i end
  reset()
end
function reset() turn, ticks = 0, 0 end
function step()
  local left, right = 0, 0
  for i, reading in ipairs(robot.proximity) do
    -- more than noise
    local seen = reading.value > 0.06 and reading.value or 0
    if reading.angle > 0 then left = left + seen else right = right + seen end
  end
  ticks = ticks - 1
  if left + right > 0 then
    turn, ticks = left > right and 1 or -1, 3
  elseif ticks <= 0 then
    local sum = 0
    for word, number in pairs(words) do sum = (31 * sum + number) % 1000 end
    turn = math.random() < 0.5 and 0 or robot.random.gaussian(0.3) + sum / 10000
    ticks = robot.random.poisson(10)
  end
  robot.wheels.set_velocity(10 + 10 * turn, 10 - 10 * turn)
  robot.leds.set_all_colors(turn == 0 and "green" or "red")
end
function destroy() end
)";

// moves robots, lights and LEDs, adds and removes boxes
constexpr const char* kLoopScript = R"(
function post_step()
  local ids = simulation.ids("foot-bot")
  for i = 1, 5 do
    local id = ids[simulation.random.uniform_int(1, #ids + 1)]
    local x, y = simulation.position(id)
    simulation.move(id, x + simulation.random.gaussian(0.1), y + math.random() - 0.5, 0)
    simulation.set_led_color(id, 13, simulation.clock() % 256, 0, 0)
  end
  if simulation.clock() % 5 == 0 then
    simulation.add(string.format(
      "<box id='b%d' size='0.1,0.1,0.1' movable='true' mass='0.1'><body position='%f,0,0'/></box>",
      simulation.clock(), 0.2 * simulation.clock() - 5))
  elseif simulation.clock() % 5 == 3 and simulation.clock() > 10 then
    simulation.remove("b" .. simulation.clock() - 8)
  end
end
)";

/** Script files for all tests of this file, which run in processes of their own. */
class CScripts {
 public:
  CScripts() {
    std::ofstream(Robot) << kScript;
    std::ofstream(Loop) << kLoopScript;
  }
  ~CScripts() {
    std::remove(Robot.c_str());
    std::remove(Loop.c_str());
  }
  CScripts(const CScripts&) = delete;
  CScripts& operator=(const CScripts&) = delete;

  const std::string Robot = InBuildTree("lua_swarm_" + std::to_string(getpid()) + ".lua");
  const std::string Loop = InBuildTree("lua_swarm_loop_" + std::to_string(getpid()) + ".lua");
};

SExperiment Swarm(const CScripts& scripts, UInt32 robots, UInt32 threads, UInt32 seed = 1) {
  SExperiment experiment;
  experiment.Threads = threads;
  experiment.Seed = seed;
  experiment.Controllers =
      "<lua_controller id='c'><actuators><differential_steering implementation='default'/>"
      "<leds implementation='default' medium='leds'/></actuators>"
      "<sensors><footbot_proximity implementation='default' noise_level='0.05'/></sensors>"
      "<params script='" +
      scripts.Robot + "' on_error='end_run'/></lua_controller>";
  experiment.LoopFunctions =
      "<loop_functions label='lua'><params script='" + scripts.Loop + "'/></loop_functions>";
  experiment.Engines = "<dynamics2d id='d'/>";
  experiment.Media = "<led id='leds'/>";
  experiment.ArenaSize = "40,40,2";
  experiment.Arena =
      "<distribute><position method='uniform' min='-10,-10,0' max='10,10,0'/>"
      "<orientation method='uniform' min='0,0,0' max='360,0,0'/><entity quantity='" +
      std::to_string(robots) +
      "' max_trials='100'><foot-bot id='fb'><controller config='c'/></foot-bot></entity>"
      "</distribute>";
  return experiment;
}

}  // namespace

TEST_CASE("determinism: Lua robots and loop functions give equal results for any number of threads",
          "[determinism][lua][threads]") {
  const CScripts scripts;
  constexpr UInt32 kRobots = 200;
  constexpr UInt32 kTicks = FewerIfSanitized(60);
  CTestWorld reference(Swarm(scripts, kRobots, 0));
  const std::vector<UInt64> expected = RecordDigests(reference, kTicks);
  // the digest changes in every tick
  CHECK(std::set<UInt64>(expected.begin(), expected.end()).size() == expected.size());
  for (const UInt32 threads : {0U, 1U, 4U}) {
    CAPTURE(threads);
    CTestWorld world(Swarm(scripts, kRobots, threads));
    CHECK(RecordDigests(world, kTicks) == expected);
  }
  CTestWorld other(Swarm(scripts, kRobots, 0, 2));
  CHECK(RecordDigests(other, 5).back() != expected[5]);
}

TEST_CASE("determinism: a run of Lua robots repeats after a reset", "[determinism][lua]") {
  const CScripts scripts;
  SExperiment experiment = Swarm(scripts, 50, 2);
  // entities added by loop functions stay after a reset, so this run is without loop functions
  experiment.LoopFunctions = "";
  CTestWorld world(experiment);
  const std::vector<UInt64> first = RecordDigests(world, 40);
  world.GetSimulator().Reset();
  CHECK(RecordDigests(world, 40) == first);
}

TEST_CASE("determinism: simulators with Lua robots do not affect each other",
          "[determinism][lua][threads]") {
  const CScripts scripts;
  CTestWorld reference(Swarm(scripts, 30, 0));
  const std::vector<UInt64> expected = RecordDigests(reference, 40);
  std::vector<std::vector<UInt64>> digests(4);
  std::vector<std::thread> threads;
  for (size_t i = 0; i < digests.size(); ++i) {
    threads.emplace_back([&, i] {
      CTestWorld world(Swarm(scripts, 30, static_cast<UInt32>(i)));
      digests[i] = RecordDigests(world, 40);
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const std::vector<UInt64>& run : digests) {
    CHECK(run == expected);
  }
}

TEST_CASE("lua: two thousand robots run their scripts", "[determinism][lua]") {
  const CScripts scripts;
  SExperiment experiment = Swarm(scripts, 2000, 2);
  experiment.LoopFunctions = "";
  CTestWorld world(experiment);
  const std::vector<CControllableEntity*>& robots = world.GetSpace().GetControllableEntities();
  REQUIRE(robots.size() == 2000);
  const auto positions = [&robots] {
    std::vector<CVector3> found;
    for (CControllableEntity* const robot : robots) {
      auto& root = dynamic_cast<CComposableEntity&>(robot->GetRootEntity());
      found.push_back(root.GetComponent<CEmbodiedEntity>("body").GetOriginAnchor().Position);
    }
    return found;
  };
  const std::vector<CVector3> before = positions();
  constexpr UInt32 kTicks = 20;
  world.Step(kTicks);
  const std::vector<CVector3> after = positions();
  size_t moved = 0;
  for (size_t i = 0; i < robots.size(); ++i) {
    const Real distance = Distance(before[i], after[i]);
    moved += distance > 0.01 ? 1 : 0;
  }
  // Each robot is 0.17 m across and has 0.2 m^2, so a few are blocked, but most are not.
  CHECK(moved > 1800);
}

}  // namespace lua_swarm_test
