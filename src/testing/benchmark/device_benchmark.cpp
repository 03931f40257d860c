// Measures the cost of each device of each robot per robot-tick, and prints it as CSV. Two swarms
// of the same robots with equal motions are stepped in turns in one process: one with the device,
// one without it. Both have the environment of the device (lit LEDs, senders, ...).
//
//   argos3_device_benchmark [--robots 1000] [--rounds 41] [--ticks 4] [--device leds,proximity]
//                           [--robot foot-bot,e-puck,eye-bot]

#include <argos3/testing/benchmark/in_child.h>
#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/device_user.h>
#include <argos3/testing/support/device_world.h>
#include <argos3/testing/support/robot_world.h>
#include <argos3/testing/support/rooms.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/tick/tick_times.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

using namespace argos;
using argos::testing::RunInChild;
using argos::testing::SecondsOfThisThread;
using argos::testing::SRoomsWorld;

namespace {

constexpr Real kFlightHeight = 1.0;  // m

struct SOptions {
  UInt32 Robots = 1000;
  UInt32 Rounds = 41;
  UInt32 Ticks = 4;  // ticks of a swarm per round
  UInt32 WarmUp = 20;
  std::vector<std::string> RobotTypes = {"foot-bot", "e-puck", "eye-bot"};
  std::vector<std::string> Tags;  // empty: all
};

typedef std::vector<SListedDevice> TDevices;

const SListedDevice kWheels = {"actuators", "differential_steering", "default", ""};
const SListedDevice kPropellers = {"actuators", "quadrotor_position", "default", ""};

// tags of the devices that the environment of a device needs; sensors are marked by "?"
std::vector<std::string> NeedsOf(const SListedDevice& device) {
  static const std::map<std::string, std::vector<std::string>> needs = {
      {"?cameras", {"directional_leds", "leds", "tags"}},
      {"?colored_blob_omnidirectional_camera", {"leds"}},
      {"?colored_blob_perspective_camera", {"leds"}},
      {"?footbot_distance_scanner", {"footbot_distance_scanner"}},
      {"?footbot_turret_encoder", {"footbot_turret"}},
      {"?range_and_bearing", {"range_and_bearing"}},
      {"?pheromone", {"pheromone"}},
      {"?simple_radios", {"simple_radios"}},
      {"footbot_gripper", {"footbot_turret"}},
      {"gripper", {"footbot_turret"}},
      {"pan_tilt_camera", {"leds", "?colored_blob_perspective_camera"}}};
  const auto found = needs.find((device.Section == "sensors" ? "?" : "") + device.Tag);
  return found != needs.end() ? found->second : std::vector<std::string>();
}

// the devices of the swarm without the measured device
TDevices WithoutDevice(const std::string& robot, const SListedDevice& device) {
  const SListedDevice& drive = robot == "eye-bot" ? kPropellers : kWheels;
  TDevices devices;
  const std::string tag = device.Tag;
  const bool isDrive =
      device.Section == "actuators" && (tag == drive.Tag || tag == "quadrotor_speed");
  if (!isDrive || device.Implementation == "dead_reckoning") {
    devices.push_back(drive);
  }
  for (const std::string& need : NeedsOf(device)) {
    const bool isSensor = need[0] == '?';
    for (const SListedDevice& known : DevicesOf(robot)) {
      if (known.Tag == (isSensor ? need.substr(1) : need) &&
          (known.Section == "sensors") == isSensor) {
        devices.push_back(known);
      }
    }
  }
  return devices;
}

// adds a device in place of one of the same kind and tag
TDevices WithDevice(TDevices devices, const SListedDevice& device) {
  const auto isReplaced = [&device](const SListedDevice& other) {
    return other.Section == device.Section && other.Tag == device.Tag;
  };
  devices.erase(std::remove_if(devices.begin(), devices.end(), isReplaced), devices.end());
  devices.push_back(device);
  return devices;
}

std::string Controller(const std::string& robot, const TDevices& devices) {
  std::string actuators;
  std::string sensors;
  for (const SListedDevice& device : devices) {
    (device.Section == "sensors" ? sensors : actuators) += DeviceText(robot, device, false);
  }
  return "<device_user id='user'><actuators>" + actuators + "</actuators><sensors>" + sensors +
         "</sensors><params reads='false'/></device_user>";
}

std::string Distribute(const std::string& entity, UInt32 quantity, Real reach, Real height) {
  const std::string corner = ToText(reach) + "," + ToText(reach) + "," + ToText(height);
  return "<distribute><position method='uniform' min='-" + ToText(reach) + ",-" + ToText(reach) +
         "," + ToText(height) + "' max='" + corner +
         "'/><orientation method='uniform' min='0,0,0' max='360,0,0'/><entity quantity='" +
         std::to_string(quantity) + "' max_trials='1000'>" + entity + "</entity></distribute>\n";
}

std::string Arena(const std::string& robot, const TDevices& devices, UInt32 robots, Real side) {
  const bool flies = robot == "eye-bot";
  const Real reach = 0.5 * side;
  // ten other robots in range, on average
  const Real rabRange = side * std::sqrt(10.0 / (M_PI * robots));
  std::set<std::string> carried;
  std::string text = "<" + robot + " id='r' rab_data_size='4' rab_range='" + ToText(rabRange) +
                     "'><controller config='user'/>";
  for (const SListedDevice& device : devices) {
    if (carried.insert(device.Tag).second) {
      text += CarriedText(device.Tag);
    }
  }
  std::string arena =
      "<floor id='floor' source='loop_functions' pixels_per_meter='1'/>" +
      Distribute(text + "</" + robot + ">", robots, reach - 0.3, flies ? kFlightHeight : 0.0);
  for (int i = 0; i < 4; ++i) {
    const Real sign = i % 2 == 0 ? -1.0 : 1.0;
    const bool alongX = i < 2;
    arena += BoxText("wall" + std::to_string(i),
                     alongX ? CVector3(side, 0.1, 0.5) : CVector3(0.1, side, 0.5),
                     alongX ? CVector3(0.0, sign * reach, 0.0) : CVector3(sign * reach, 0.0, 0.0));
    arena += LightText("lamp" + std::to_string(i),
                       CVector3(0.4 * side * sign, alongX ? 0.1 : 0.3 * side, 2.0), "yellow");
  }
  if (!flies) {
    return arena + Distribute(
                       "<cylinder id='load' radius='0.05' height='0.15' movable='true' "
                       "mass='0.5'/>",
                       robots / 20, reach - 0.3, 0.0);
  }
  // objects on the ground for the sensors of eye-bots
  return arena + Distribute(
                     "<box id='lit' size='0.2,0.2,0.1' movable='false'><leds medium='leds'>"
                     "<led offset='0,0,0.11' anchor='origin' color='red'/></leds></box>",
                     robots, reach - 0.3, 0.0);
}

SExperiment MakeExperiment(const SOptions& options, const std::string& robot,
                           const TDevices& devices) {
  // eye-bots are wide and need a square metre each
  const Real side = robot == "eye-bot" ? std::sqrt(static_cast<Real>(options.Robots))
                                       : SRoomsWorld::SideAtSameDensity(options.Robots);
  SExperiment experiment;
  experiment.ArenaSize = ToText(CVector3(side + 2.0, side + 2.0, 6.0));
  experiment.Controllers = Controller(robot, devices);
  experiment.LoopFunctions = "<loop_functions label='striped_floor'/>";
  experiment.Engines = robot == "eye-bot" ? "<pointmass3d id='air'/>" : "<dynamics2d id='ground'/>";
  experiment.Media = MediaForDevices();
  experiment.Arena = Arena(robot, devices, options.Robots, side);
  return experiment;
}

// time of some ticks, in us per robot-tick
struct STimes {
  enum { TOTAL, ACT, PHYSICS, MEDIA, SENSE, CONTROL, NUM_TIMES };
  std::array<Real, NUM_TIMES> Values{};
};

STimes Measure(CTestWorld& world, const SOptions& options) {
  STickTimes times;
  world.GetSimulator().SetTickTimes(&times);
  const Real start = SecondsOfThisThread();
  world.Step(options.Ticks);
  const Real total = SecondsOfThisThread() - start;
  world.GetSimulator().SetTickTimes(nullptr);
  STimes result{{total, times.Act, times.Physics, times.Media, times.Sense, times.Control}};
  for (Real& value : result.Values) {
    value *= 1e6 / (static_cast<Real>(options.Robots) * options.Ticks);
  }
  return result;
}

STimes Medians(const std::vector<STimes>& sample) {
  STimes medians;
  for (size_t i = 0; i < STimes::NUM_TIMES; ++i) {
    std::vector<Real> values;
    for (const STimes& times : sample) {
      values.push_back(times.Values[i]);
    }
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    medians.Values[i] = values[values.size() / 2];
  }
  return medians;
}

// mean number of readings of variable length or of held objects per robot
Real CountWork(CTestWorld& world, const SListedDevice& device) {
  const auto& robots = world.GetSpace().GetControllableEntities();
  Real work = 0.0;
  for (CControllableEntity* user : robots) {
    work += static_cast<Real>(dynamic_cast<CDeviceUser&>(user->GetController()).CountSeen());
    if (device.Tag == "gripper" || device.Tag == "footbot_gripper") {
      auto& footBot = dynamic_cast<CFootBotEntity&>(user->GetRootEntity());
      work += footBot.GetGripperEquippedEntity().IsGripping() ? 1.0 : 0.0;
    }
  }
  return work / static_cast<Real>(robots.size());
}

void Report(const SOptions& options, const std::string& robot, const SListedDevice& device) {
  const TDevices without = WithoutDevice(robot, device);
  const TDevices with = WithDevice(without, device);
  CTestWorld worlds[] = {CTestWorld(MakeExperiment(options, robot, without)),
                         CTestWorld(MakeExperiment(options, robot, with))};
  for (CTestWorld& world : worlds) {
    world.Step(options.WarmUp);
  }
  std::vector<STimes> bases;
  std::vector<STimes> differences;
  for (UInt32 round = 0; round < options.Rounds; ++round) {
    // the first swarm has colder caches, so they alternate
    const size_t first = round % 2;
    STimes times[2];
    times[first] = Measure(worlds[first], options);
    times[1 - first] = Measure(worlds[1 - first], options);
    bases.push_back(times[0]);
    for (size_t i = 0; i < STimes::NUM_TIMES; ++i) {
      times[1].Values[i] -= times[0].Values[i];
    }
    differences.push_back(times[1]);
  }
  const auto added = Medians(differences).Values;
  std::printf("%s,%s,%s,%u,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%.1f\n", device.Section.c_str(),
              device.Label().c_str(), robot.c_str(), options.Robots, added[STimes::TOTAL],
              added[STimes::ACT], added[STimes::PHYSICS], added[STimes::MEDIA],
              added[STimes::SENSE], added[STimes::CONTROL], Medians(bases).Values[STimes::TOTAL],
              CountWork(worlds[1], device));
}

void ReportAll(const SOptions& options, const std::string& robot) {
  for (const SListedDevice& device : DevicesOf(robot)) {
    const bool isAsked = options.Tags.empty() ||
                         std::count(options.Tags.begin(), options.Tags.end(), device.Tag) > 0;
    if (isAsked) {
      Report(options, robot, device);
      std::fflush(stdout);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  SOptions options;
  CLI::App app("Measures what each device adds to a robot-tick; prints CSV.");
  app.add_option("--robots", options.Robots, "number of robots");
  app.add_option("--rounds", options.Rounds, "of which the medians are printed");
  app.add_option("--ticks", options.Ticks, "ticks of 0.1 s of each swarm in a round");
  app.add_option("--robot", options.RobotTypes, "which robots")->delimiter(',');
  app.add_option("--device", options.Tags, "which devices, by tag")->delimiter(',');
  CLI11_PARSE(app, argc, argv);

  std::printf(
      "section,device,robot,robots,added_us,act_us,physics_us,media_us,sense_us,control_us,"
      "base_us,work_per_robot\n");
  bool good = true;
  for (const std::string& robot : options.RobotTypes) {
    good = RunInChild([&] { ReportAll(options, robot); }) && good;
  }
  return good ? 0 : 1;
}
