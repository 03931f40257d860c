// Measures the cost of a robot-tick in one of several scenes, see kScenes, and prints it as CSV.
// Every line is measured in a process of its own, so that the memory is that of one swarm.
//
//   argos3_benchmark [--scene rooms] [--robots 100,1000,10000,100000] [--threads 0] [--ticks 600]
//                    [--side M] [--engine dynamics2d] [--engine-attributes 'iterations="4"']
//                    [--bare-up-to 100000] [--gripping 1] [--records 10]

#include <argos3/testing/benchmark/bare_box2d.h>
#include <argos3/testing/benchmark/flocks.h>
#include <argos3/testing/benchmark/in_child.h>
#include <argos3/testing/benchmark/piles.h>
#include <argos3/testing/benchmark/shove.h>
#include <argos3/testing/support/crowd.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/overlap.h>
#include <argos3/testing/support/rooms.h>

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/context/robot_failures.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/tick/tick_times.h>

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>

using namespace argos;
using argos::testing::CBareBox2D;
using argos::testing::ComputeCrowdWidth;
using argos::testing::MeasureOverlaps;
using argos::testing::PressingCrowdText;
using argos::testing::RunInChild;
using argos::testing::SecondsSince;
using argos::testing::SOverlaps;
using argos::testing::SRoomsWorld;
using argos::testing::TBenchmarkClock;

namespace {

struct SOptions {
  std::string Scene = "rooms";
  std::vector<UInt32> Robots = {100, 1000, 10000, 100000};
  std::vector<UInt32> Threads = {0};
  UInt32 Ticks = 600;
  UInt32 WarmUp = 20;
  Real Side = 0.0;  // of the rooms, m; 0: by scene
  std::string Engine = "dynamics2d";
  std::string EngineAttributes;
  // robots; the bare world of Box2D of a larger swarm takes minutes
  UInt32 BareUpTo = 100000;
  UInt32 Gripping = 0;  // robots of the scene "shove" with a locked gripper
  UInt32 Records = 10;  // calls of a robot in a tick, in the scene "records"
};

size_t ResidentBytes() {
  size_t total = 0;
  size_t resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

// of the crowd, m: a quarter of the ground is covered from 100,000 robots on
Real SideOfCrowd(UInt32 robots) {
  constexpr Real kSide = 40.0;
  constexpr Real kRobots = 100000.0;
  return kSide * std::sqrt(std::max(1.0, robots / kRobots));
}

std::string MakeRooms(const SOptions& options, UInt32 robots, UInt32 threads) {
  SRoomsWorld world;
  world.Robots = robots;
  world.Threads = threads;
  world.Side = SRoomsWorld::SideAtSameDensity(robots);
  if (options.Scene == "crowd") {
    world.Side = SideOfCrowd(robots);
    world.DoorWidth = 2.0;
    world.Controller = "epuck_vector_diffusion_controller";
  }
  if (options.Side > 0.0) {
    world.Side = options.Side;
  }
  world.RoomsPerSide = SRoomsWorld::RoomsAlong(world.Side);
  world.Engine = options.Engine;
  world.EngineAttributes = options.EngineAttributes;
  return world.ToXML();
}

// robots that have the sensors of those in the rooms
std::string MakeWall(const SOptions& options, UInt32 robots, UInt32 threads) {
  SExperiment experiment;
  experiment.Threads = threads;
  experiment.Controllers =
      "<contract_driver id='driver'><actuators><differential_steering implementation='default'/>"
      "</actuators><sensors><epuck_proximity implementation='default'/></sensors>"
      "</contract_driver>";
  experiment.Engines = "<" + options.Engine + " id='engine' " + options.EngineAttributes + "/>";
  experiment.ArenaSize = "10," + std::to_string(ComputeCrowdWidth(robots) + 2.0) + ",2";
  experiment.Arena = PressingCrowdText(robots);
  return experiment.ToXml();
}

// robots in a square grid, without sensors and actuators
std::string MakeRecorders(const SOptions& options, UInt32 robots, UInt32 threads) {
  constexpr Real kDistance = 0.2;  // m
  const auto rows = static_cast<UInt32>(std::ceil(std::sqrt(static_cast<Real>(robots))));
  const std::string side = std::to_string(kDistance * rows + 1.0);
  SExperiment experiment;
  experiment.Threads = threads;
  experiment.Controllers =
      "<metric_recorder id='recorder'><actuators/><sensors/><params records='" +
      std::to_string(options.Records) + "'/></metric_recorder>";
  experiment.Engines = "<" + options.Engine + " id='engine' " + options.EngineAttributes + "/>";
  experiment.ArenaSize = side + "," + side + ",2";
  experiment.Arena =
      "<distribute><position method='grid' center='0,0,0' distances='0.2,0.2,0' layout='" +
      std::to_string(rows) + "," + std::to_string(rows) +
      ",1'/><orientation method='constant' values='0,0,0'/><entity quantity='" +
      std::to_string(robots) +
      "' max_trials='1'><e-puck id='r'><controller config='recorder'/></e-puck></entity>"
      "</distribute>";
  return experiment.ToXml();
}

std::string MakeShoveScene(const SOptions& options, UInt32 robots, UInt32 threads) {
  return argos::testing::MakeShove(robots, std::min(options.Gripping, robots), threads,
                                   options.Engine, options.EngineAttributes);
}

typedef std::string (*TMakeScene)(UInt32 robots, UInt32 threads, const std::string& engine,
                                  const std::string& attributes);

template <TMakeScene MAKE>
std::string Make(const SOptions& options, UInt32 robots, UInt32 threads) {
  return MAKE(robots, threads, options.Engine, options.EngineAttributes);
}

struct SScene {
  const char* Name;
  const char* What;
  std::string (*Make)(const SOptions& options, UInt32 robots, UInt32 threads);
};

constexpr SScene kScenes[] = {
    {"rooms", "e-pucks that keep apart", &MakeRooms},
    {"crowd", "e-pucks that press, in rooms", &MakeRooms},
    {"wall", "e-pucks that all press against a wall", &MakeWall},
    {"records", "e-pucks that record a metric", &MakeRecorders},
    {"shove", "foot-bots that push boxes and cylinders about", &MakeShoveScene},
    {"towers", "boxes on each other, ten each", &Make<&argos::testing::MakeTowers>},
    {"stack", "boxes in pyramids", &Make<&argos::testing::MakeStack>},
    {"pile", "balls that fall into a pen", &Make<&argos::testing::MakePile>},
    {"messages", "foot-bots that send each other messages by range and bearing",
     &Make<&argos::testing::MakeMessages>},
    {"colors", "the same by LEDs and cameras", &Make<&argos::testing::MakeColors>},
    {"scripts", "foot-bots that run experiments/controllers/lua/diffusion.lua",
     &Make<&argos::testing::MakeScripts>},
    {"flocking", "experiments/flocking.argos", &Make<&argos::testing::MakeFlocking>},
    {"flocking_lua", "experiments/flocking_lua.argos", &Make<&argos::testing::MakeFlockingLua>}};

std::vector<std::string> ListScenes() {
  std::vector<std::string> names;
  for (const SScene& scene : kScenes) {
    names.emplace_back(scene.Name);
  }
  return names;
}

std::string DescribeScenes() {
  std::string text;
  for (const SScene& scene : kScenes) {
    text += std::string(text.empty() ? "" : "; ") + scene.Name + ": " + scene.What;
  }
  return text;
}

std::string MakeWorld(const SOptions& options, UInt32 robots, UInt32 threads) {
  const auto* const scene =
      std::find_if(std::begin(kScenes), std::end(kScenes),
                   [&options](const SScene& known) { return known.Name == options.Scene; });
  return scene->Make(options, robots, threads);
}

void Report(const SOptions& options, UInt32 robots, UInt32 threads) {
  const size_t memoryBefore = ResidentBytes();
  CSimulator& simulator = CSimulator::GetInstance();
  CConfigurationDocument document;
  document.Parse(MakeWorld(options, robots, threads), "benchmark");
  const TBenchmarkClock::time_point loadStart = TBenchmarkClock::now();
  simulator.Load(document);
  const Real startUp = SecondsSince(loadStart);

  CSpace& space = simulator.GetSpace();
  const UInt32 substeps = simulator.GetPhysicsEngines().front()->GetIterations();
  for (UInt32 tick = 0; tick < options.WarmUp; ++tick) {
    simulator.UpdateSpace();
  }
  const size_t memory = ResidentBytes() - memoryBefore;

  // the worlds alternate tick by tick, so that noise of the machine affects both equally
  std::optional<CBareBox2D> bare;
  if (robots <= options.BareUpTo) {
    bare.emplace(space, substeps, simulator.GetTickLength());
  }
  STickTimes times;
  simulator.SetTickTimes(&times);
  SOverlaps overlaps;
  Real total = 0.0;
  Real bareTotal = 0.0;
  for (UInt32 tick = 0; tick < options.Ticks; ++tick) {
    TBenchmarkClock::time_point start = TBenchmarkClock::now();
    simulator.UpdateSpace();
    total += SecondsSince(start);
    if (bare.has_value()) {
      bare->TakeVelocities();
      start = TBenchmarkClock::now();
      bare->Tick();
      bareTotal += SecondsSince(start);
    }
    if (tick % 20 == 0) {
      MeasureOverlaps(space, overlaps);
    }
  }
  if (!simulator.GetRobotFailures().IsEmpty()) {
    THROW_ARGOSEXCEPTION("a robot failed, so the time is not that of the scene");
  }

  const Real perRobotTick = 1e6 / (static_cast<Real>(robots) * options.Ticks);
  std::printf("%s,%u,%u,%u,%u,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f", options.Engine.c_str(), robots,
              threads, substeps, options.Ticks, total * perRobotTick, times.Act * perRobotTick,
              times.Physics * perRobotTick, times.Index * perRobotTick, times.Media * perRobotTick,
              times.Sense * perRobotTick, times.Control * perRobotTick);
  if (bare.has_value()) {
    std::printf(",%.4f,%.3f", bareTotal * perRobotTick, total / bareTotal);
  } else {
    std::printf(",-,-");
  }
  std::printf(",%.0f,%.3f,%.3f,%.3f,%.3f,%.3f,%s\n", static_cast<Real>(memory) / robots, startUp,
              100.0 * SOverlaps::Quantile(overlaps.WithRobots, 0.5),
              100.0 * SOverlaps::Quantile(overlaps.WithRobots, 0.99),
              100.0 * SOverlaps::Quantile(overlaps.WithRobots, 1.0),
              100.0 * SOverlaps::Quantile(overlaps.WithWalls, 1.0), options.Scene.c_str());
  std::fflush(stdout);
  simulator.Destroy();
}

}  // namespace

int main(int argc, char** argv) {
  SOptions options;
  CLI::App app("Measures what a robot-tick costs; prints CSV.");
  app.add_option("--scene", options.Scene, DescribeScenes())->check(CLI::IsMember(ListScenes()));
  app.add_option("--robots", options.Robots, "numbers of robots")->delimiter(',');
  app.add_option("--threads", options.Threads, "numbers of threads")->delimiter(',');
  app.add_option("--ticks", options.Ticks, "ticks of 0.1 s that are measured");
  app.add_option("--warm-up", options.WarmUp, "ticks before those");
  app.add_option("--side", options.Side,
                 "side of the rooms in m; 0: always the same density (rooms), 40 (crowd)");
  app.add_option("--engine", options.Engine, "physics engine");
  app.add_option("--engine-attributes", options.EngineAttributes, "its XML attributes");
  app.add_option("--bare-up-to", options.BareUpTo,
                 "most robots that are compared with a bare world of Box2D; 0: none");
  app.add_option("--gripping", options.Gripping,
                 "robots that drag about what they touch first, in the scene shove");
  app.add_option("--records", options.Records,
                 "calls of CMetrics::Record() of a robot in a tick, in the scene records");
  CLI11_PARSE(app, argc, argv);

  std::printf(
      "engine,robots,threads,substeps,ticks,total_us,act_us,physics_us,index_us,media_us,sense_us,"
      "control_us,bare_box2d_us,ratio_to_bare,bytes_per_robot,startup_s,overlap_median_pct,"
      "overlap_p99_pct,overlap_max_pct,wall_max_pct,scene\n");
  bool good = true;
  for (const UInt32 robots : options.Robots) {
    for (const UInt32 threads : options.Threads) {
      good = RunInChild([&] { Report(options, robots, threads); }) && good;
    }
  }
  return good ? 0 : 1;
}
