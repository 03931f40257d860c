// Measures the cost of media per robot-tick, including the devices that use them, and
// prints it as CSV. The world is the arena of rooms of benchmark.cpp; every line is
// measured in a process of its own.
//
//   argos3_media_benchmark [--robots 10000] [--threads 0,2] [--ticks 100]
//                          [--media none,pheromone,range_and_bearing] [--range 0.8]

#include <argos3/testing/benchmark/in_child.h>
#include <argos3/testing/support/rooms.h>

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/tick_times.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <functional>
#include <map>

using namespace argos;
using argos::testing::RunInChild;
using argos::testing::SecondsSince;
using argos::testing::SRoomsWorld;
using argos::testing::TBenchmarkClock;

namespace {

constexpr Real kTick = 0.1;  // s, the tick length of SRoomsWorld

// a medium with its devices
struct SSubject {
  std::string Actuators, Sensors, Media;  // XML elements
  // called before the first tick, for each robot
  std::function<void(CControllableEntity&)> Prepare;
  // amount of work in the last tick, per robot: number of received packets, ...
  std::function<Real(CControllableEntity&)> CountWork;
};

const std::map<std::string, SSubject>& Subjects() {
  static const std::map<std::string, SSubject> subjects = {
      {"none", {"", "", "", [](CControllableEntity&) {}, [](CControllableEntity&) { return 0.0; }}},
      // every robot deposits, so the work is equal for all
      {"pheromone",
       {"<pheromone implementation=\"medium\" medium=\"scents\"/>",
        "<pheromone implementation=\"medium\" medium=\"scents\"><point offset=\"0.05,0.03\"/>"
        "<point offset=\"0.05,-0.03\"/></pheromone>",
        "<pheromone id=\"scents\"><layer id=\"trail\" evaporation=\"0.01\" "
        "diffusion=\"1e-4\"/></pheromone>",
        [](CControllableEntity& robot) {
          robot.GetController().GetActuator<CCI_PheromoneActuator>("pheromone")->SetRate(1.0);
        },
        [](CControllableEntity&) { return 1.0; }}},
      {"range_and_bearing",
       {"<range_and_bearing implementation=\"default\"/>",
        "<range_and_bearing implementation=\"medium\" medium=\"rab\"/>",
        "<range_and_bearing id=\"rab\"/>", [](CControllableEntity&) {},
        [](CControllableEntity& robot) {
          const auto& sensor =
              *robot.GetController().GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
          return static_cast<Real>(sensor.GetReadings().size());
        }}}};
  return subjects;
}

struct SOptions {
  std::vector<UInt32> Robots = {10000};
  std::vector<UInt32> Threads = {0, 2};
  UInt32 Ticks = 100;
  UInt32 WarmUp = 20;
  Real Range = 0.8;  // of messages, m
  std::vector<std::string> Media;
};

void Report(const SOptions& options, const std::string& name, UInt32 robots, UInt32 threads) {
  const SSubject& subject = Subjects().at(name);
  SRoomsWorld world;
  world.Robots = robots;
  world.Threads = threads;
  world.Side = SRoomsWorld::SideAtSameDensity(robots);
  world.Actuators = subject.Actuators;
  world.Sensors = subject.Sensors;
  world.Media = subject.Media;
  CSimulator& simulator = CSimulator::GetInstance();
  CConfigurationDocument document;
  document.Parse(world.ToXML(), "benchmark");
  simulator.Load(document);
  for (CControllableEntity* robot : simulator.GetSpace().GetControllableEntities()) {
    subject.Prepare(*robot);
    robot->GetParent().GetComponent<CRABEquippedEntity>("rab").SetRange(options.Range);
  }
  for (UInt32 tick = 0; tick < options.WarmUp; ++tick) {
    simulator.UpdateSpace();
  }
  STickTimes times;
  simulator.SetTickTimes(&times);
  const TBenchmarkClock::time_point start = TBenchmarkClock::now();
  for (UInt32 tick = 0; tick < options.Ticks; ++tick) {
    simulator.UpdateSpace();
  }
  const Real total = SecondsSince(start);
  Real work = 0.0;
  for (CControllableEntity* robot : simulator.GetSpace().GetControllableEntities()) {
    work += subject.CountWork(*robot) / robots;
  }
  const Real perRobotTick = 1e6 / (static_cast<Real>(robots) * options.Ticks);
  std::printf("%s,%u,%u,%u,%.4f,%.4f,%.4f,%.4f,%.2f,%.2f\n", name.c_str(), robots, threads,
              options.Ticks, total * perRobotTick, times.Act * perRobotTick,
              times.Media * perRobotTick, times.Sense * perRobotTick, work,
              kTick * options.Ticks / total);
  std::fflush(stdout);
  simulator.Destroy();
}

}  // namespace

int main(int argc, char** argv) {
  SOptions options;
  std::vector<std::string> known;
  for (const auto& subject : Subjects()) {
    known.push_back(subject.first);
  }
  options.Media = known;
  CLI::App app("Measures what media cost a robot-tick; prints CSV.");
  app.add_option("--robots", options.Robots, "numbers of robots")->delimiter(',');
  app.add_option("--threads", options.Threads, "numbers of threads")->delimiter(',');
  app.add_option("--ticks", options.Ticks, "ticks of 0.1 s that are measured");
  app.add_option("--range", options.Range, "of range-and-bearing messages, m");
  app.add_option("--media", options.Media, "which media")
      ->delimiter(',')
      ->check(CLI::IsMember(known));
  CLI11_PARSE(app, argc, argv);

  std::printf(
      "medium,robots,threads,ticks,total_us,act_us,media_us,sense_us,work_per_robot,real_time_"
      "factor\n");
  bool good = true;
  for (const std::string& name : options.Media) {
    for (const UInt32 robots : options.Robots) {
      for (const UInt32 threads : options.Threads) {
        good = RunInChild([&] { Report(options, name, robots, threads); }) && good;
      }
    }
  }
  return good ? 0 : 1;
}
