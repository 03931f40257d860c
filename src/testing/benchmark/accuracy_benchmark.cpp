// Measures the accuracy of each physics engine and its cost over the number of substeps per tick,
// and prints them as CSV. There are three worlds of e-pucks: the arena of rooms, a crowd that
// presses against a wall, and free robots on arcs. Each is measured in a process of its own.
//
//   argos3_accuracy_benchmark [--robots 1000,10000] [--engine dynamics2d,dynamics3d]
//                             [--stepper mixed] [--iterations 0,5] [--rooms-ticks N]
//                             [--crowd-ticks N] [--warm-up N] [--seconds 60]

#include <argos3/testing/benchmark/in_child.h>
#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/support/closed_form/differential_drive.h>
#include <argos3/testing/support/crowd.h>
#include <argos3/testing/support/overlap.h>
#include <argos3/testing/support/rooms.h>

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/tick/tick_times.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_measures.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_engine.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>

using namespace argos;
using argos::testing::IntegrateDifferentialDrive;
using argos::testing::MeasureOverlaps;
using argos::testing::PressingCrowdText;
using argos::testing::RunInChild;
using argos::testing::SecondsOfThisThread;
using argos::testing::SecondsSince;
using argos::testing::SOverlaps;
using argos::testing::SPose;
using argos::testing::SRoomsWorld;
using argos::testing::TBenchmarkClock;

namespace {

constexpr UInt32 kDefault = 0;  // number of substeps: the default of the engine
constexpr Real kTick = 0.1;  // s, the tick length of SRoomsWorld and CDriveWorld

// an engine with one of its contact solvers
struct SSubject {
  std::string Engine;
  std::string Stepper;
  std::string Children;  // XML elements
  std::vector<UInt32> Iterations;
  std::string Attributes = "";  // of XML, besides iterations
  bool HasContacts = true;
  // robots; limits the solvers that take too long
  UInt32 LargestCrowd = std::numeric_limits<UInt32>::max();
  // number of robot-ticks to measure, approximately, after some ticks of warm-up
  UInt32 RoomsRobotTicks = 1000000;
  UInt32 RoomsWarmUp = 20;
  UInt32 CrowdRobotTicks = 100000;
  UInt32 CrowdWarmUp = 20;

  std::string ToAttributes(UInt32 iterations) const {
    return Attributes +
           (iterations == kDefault ? "" : " iterations=\"" + std::to_string(iterations) + "\"");
  }
  std::string ToXml(UInt32 iterations) const {
    return "<" + Engine + " id=\"engine\" " + ToAttributes(iterations) + ">" + Children + "</" +
           Engine + ">";
  }
};

SSubject Rigid(const std::string& stepper) {
  SSubject subject{"dynamics3d", stepper, "", {1, 5, kDefault, 20}};  // the engine's default is 10
  subject.Children = "<floor/><gravity g=\"9.81\"/><solver stepper=\"" + stepper + "\"/>";
  // free robots are those of the other engines: their arcs are exact
  subject.Attributes = "free_robots=\"false\"";
  subject.RoomsRobotTicks = 30000;
  subject.RoomsWarmUp = 5;
  subject.CrowdRobotTicks = 20000;
  subject.CrowdWarmUp = 8;
  return subject;
}

std::vector<SSubject> Subjects() {
  // the defaults of the first two are 1, and 2 or more
  const SSubject kinematics{"kinematics2d", "-", "", {kDefault, 2, 5, 10, 20}};
  const SSubject dynamics{"dynamics2d", "-", "", {1, 2, 5, 10, 20, kDefault}};
  SSubject iterative = Rigid("iterative");
  iterative.LargestCrowd = 1000;  // in crowds "mixed" is the same
  SSubject direct = Rigid("direct");
  direct.LargestCrowd = 0;  // the time for a crowd grows with the cube of its size
  SSubject pointMasses{"pointmass3d", "-", "", {kDefault}};
  pointMasses.HasContacts = false;
  pointMasses.LargestCrowd = 0;
  return {kinematics, dynamics, Rigid("mixed"), iterative, direct, pointMasses};
}

struct SOptions {
  std::vector<UInt32> Robots = {1000, 10000};
  std::vector<std::string> Engines, Steppers;  // empty: all
  std::vector<UInt32> Iterations;  // empty: those of the subject
  UInt32 RoomsTicks = 0;  // 0: those of the subject
  UInt32 CrowdTicks = 0;
  UInt32 WarmUp = 0;
  UInt32 Seconds = 60;  // duration of the arcs
};

UInt32 ChooseTicks(UInt32 asked, UInt32 robotTicks, UInt32 robots) {
  constexpr UInt32 kMin = 3;
  constexpr UInt32 kMax = 600;
  return asked > 0 ? asked : std::clamp(robotTicks / robots, kMin, kMax);
}

// prints the measured ticks, their cost, and the overlaps
void PrintTicks(CTestWorld& world, const SSubject& subject, UInt32 warmUp, UInt32 ticks) {
  CSpace& space = world.GetSpace();
  world.Step(warmUp);
  STickTimes times;
  world.GetSimulator().SetTickTimes(&times);
  SOverlaps overlaps;
  Real onProcessor = 0.0;
  Real byClock = 0.0;
  for (UInt32 tick = 0; tick < ticks; ++tick) {
    const TBenchmarkClock::time_point start = TBenchmarkClock::now();
    const Real startOnProcessor = SecondsOfThisThread();
    world.Step();
    onProcessor += SecondsOfThisThread() - startOnProcessor;
    byClock += SecondsSince(start);
    MeasureOverlaps(space, overlaps);
  }
  const auto robots = static_cast<Real>(space.GetControllableEntities().size());
  const Real total = 1e6 * onProcessor / (robots * ticks);
  // the phases are timed by the clock
  std::printf(",%u,%.4f,%.4f", ticks, total, total * times.Physics / byClock);
  if (!subject.HasContacts) {
    std::printf(",-,-,-,-,-");
    return;
  }
  std::printf(",%.3f", 100.0 * static_cast<Real>(overlaps.Touching.size()) / (robots * ticks));
  for (const Real quantile : {0.5, 0.99, 1.0}) {
    if (overlaps.Touching.empty()) {
      std::printf(",-");
    } else {
      std::printf(",%.4g", 100.0 * SOverlaps::Quantile(overlaps.Touching, quantile));
    }
  }
  std::printf(",%.4g", 100.0 * SOverlaps::Quantile(overlaps.WithWalls, 1.0));
}

void PrintRooms(const SOptions& options, const SSubject& subject, UInt32 iterations,
                UInt32 robots) {
  SRoomsWorld rooms;
  rooms.Robots = robots;
  rooms.Side = SRoomsWorld::SideAtSameDensity(robots);
  rooms.RoomsPerSide = SRoomsWorld::RoomsAlong(rooms.Side);
  rooms.Engine = subject.Engine;
  rooms.EngineAttributes = subject.ToAttributes(iterations);
  rooms.EngineChildren = subject.Children;
  CTestWorld world(rooms.ToXML());
  PrintTicks(world, subject, options.WarmUp > 0 ? options.WarmUp : subject.RoomsWarmUp,
             ChooseTicks(options.RoomsTicks, subject.RoomsRobotTicks, robots));
}

void PrintCrowd(const SOptions& options, const SSubject& subject, UInt32 iterations,
                UInt32 robots) {
  CDriveWorld world(subject.ToXml(iterations), PressingCrowdText(robots));
  PrintTicks(world, subject, options.WarmUp > 0 ? options.WarmUp : subject.CrowdWarmUp,
             ChooseTicks(options.CrowdTicks, subject.CrowdRobotTicks, robots));
}

// number of substeps of the last tick, if the engine reports it
UInt32 CountSubsteps(CTestWorld& world) {
  const CPhysicsEngine& engine = *world.GetSimulator().GetPhysicsEngines().front();
  const auto* rigid = dynamic_cast<const CDynamics3DEngine*>(&engine);
  return rigid != nullptr ? rigid->GetNumSubsteps() : engine.GetIterations();
}

// prints the substeps of a tick and the greatest deviation of some free robots from their
// arcs, in mm and in % of the path
void PrintArcs(const SOptions& options, const SSubject& subject, UInt32 iterations) {
  constexpr Real kApart = 12.0;  // m; twice the longest path
  const std::vector<std::pair<Real, Real>> speeds = {{10, 10},  {10, 9},  {3, 12},
                                                     {-5, 7.5}, {-8, -8}, {20, 18}};  // cm/s
  std::vector<SPose> starts;
  std::string arena;
  for (size_t i = 0; i < speeds.size(); ++i) {
    starts.push_back({kApart * (static_cast<Real>(i) - 2.5), -2.1, 2.0 + static_cast<Real>(i)});
    const Real degrees = starts[i].Yaw * 180.0 / ARGOS_PI;
    arena += DriverXml("e-puck", "r" + std::to_string(i), starts[i].X, starts[i].Y, degrees,
                       speeds[i].first, speeds[i].second);
  }
  CDriveWorld world(subject.ToXml(iterations), arena);
  // in the first tick no orders act yet, and in the next one they may act late
  world.Step();
  const Real lag = world.GetSimulator().GetPhysicsEngines().front()->GetVelocityLag();
  Real worst = 0.0;
  Real worstShare = 0.0;
  const auto ticks = static_cast<UInt32>(std::lround(options.Seconds / kTick));
  for (UInt32 tick = 1; tick <= ticks; ++tick) {
    world.Step();
    for (size_t i = 0; i < speeds.size(); ++i) {
      const Real left = 0.01 * speeds[i].first;
      const Real right = 0.01 * speeds[i].second;
      const SPose exact = IntegrateDifferentialDrive(
          starts[i], left, right, epuck::kInterwheelDistance, kTick * (tick - lag));
      const CVector3 position = world.Position("r" + std::to_string(i));
      const Real error = std::hypot(position.GetX() - exact.X, position.GetY() - exact.Y);
      worst = std::max(worst, error);
      worstShare = std::max(worstShare, error / (0.5 * std::abs(left + right) * options.Seconds));
    }
  }
  std::printf(",%u,%.3g,%.3g", CountSubsteps(world), 1e3 * worst, 100.0 * worstShare);
}

// prints a dash in each column of a world that failed or is left out
bool PrintInChild(bool isMeasured, int columns, const std::function<void()>& print) {
  const bool isPrinted = isMeasured && RunInChild(print);
  for (int i = 0; i < columns && !isPrinted; ++i) {
    std::printf(",-");
  }
  return isPrinted || !isMeasured;
}

bool Report(const SOptions& options, const SSubject& subject, UInt32 iterations, UInt32 robots) {
  std::printf("%s,%s,%u,%s", subject.Engine.c_str(), subject.Stepper.c_str(), robots,
              iterations == kDefault ? "default" : std::to_string(iterations).c_str());
  bool good = PrintInChild(true, 3, [&] { PrintArcs(options, subject, iterations); });
  good = PrintInChild(true, 8, [&] { PrintRooms(options, subject, iterations, robots); }) && good;
  good = PrintInChild(robots <= subject.LargestCrowd, 8,
                      [&] { PrintCrowd(options, subject, iterations, robots); }) &&
         good;
  std::printf("\n");
  std::fflush(stdout);
  return good;
}

template <typename T>
bool IsAsked(const std::vector<T>& asked, const T& value) {
  return asked.empty() || std::count(asked.begin(), asked.end(), value) > 0;
}

}  // namespace

int main(int argc, char** argv) {
  SOptions options;
  std::vector<std::string> engines;
  std::vector<std::string> steppers;
  for (const SSubject& subject : Subjects()) {
    engines.push_back(subject.Engine);
    steppers.push_back(subject.Stepper);
  }
  CLI::App app("Measures the accuracy and the cost of physics engines; prints CSV.");
  app.add_option("--robots", options.Robots, "numbers of robots")->delimiter(',');
  app.add_option("--engine", options.Engines, "which engines")
      ->delimiter(',')
      ->check(CLI::IsMember(engines));
  app.add_option("--stepper", options.Steppers, "which steppers; -: engines that have but one way")
      ->delimiter(',')
      ->check(CLI::IsMember(steppers));
  app.add_option("--iterations", options.Iterations,
                 "least substeps of a tick; 0: the engine's own")
      ->delimiter(',');
  app.add_option("--rooms-ticks", options.RoomsTicks, "ticks measured in rooms; 0: by the engine");
  app.add_option("--crowd-ticks", options.CrowdTicks,
                 "ticks measured in a crowd; 0: by the engine");
  app.add_option("--warm-up", options.WarmUp, "ticks before those; 0: by the engine");
  app.add_option("--seconds", options.Seconds, "of driving along arcs");
  CLI11_PARSE(app, argc, argv);

  std::printf("engine,stepper,robots,iterations,substeps,arc_error_mm,arc_error_pct");
  for (const char* world : {"rooms", "crowd"}) {
    std::printf(",%s_ticks", world);
    for (const char* column : {"total_us", "physics_us", "touching_pct", "overlap_median_pct",
                               "overlap_p99_pct", "overlap_max_pct", "wall_max_pct"}) {
      std::printf(",%s_%s", world, column);
    }
  }
  std::printf("\n");
  bool good = true;
  for (const SSubject& subject : Subjects()) {
    if (!IsAsked(options.Engines, subject.Engine) || !IsAsked(options.Steppers, subject.Stepper)) {
      continue;
    }
    for (const UInt32 robots : options.Robots) {
      for (const UInt32 iterations :
           options.Iterations.empty() ? subject.Iterations : options.Iterations) {
        good = Report(options, subject, iterations, robots) && good;
      }
    }
  }
  return good ? 0 : 1;
}
