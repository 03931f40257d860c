// Compares the devices that each robot supports with the list that was published with
// ARGoS 3 and with our own devices.

#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/device_list.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/fitting_devices.h>

#include <catch2/catch.hpp>

#include <algorithm>

namespace device_fit_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

// position of <controllers> in experiments of tests
const char* const kControllersAt = "test.argos:4:";

SExperiment With(const SListedDevice& device, const std::string& robot) {
  SExperiment experiment;
  experiment.Controllers = "<robot_world_controller id='c'><" + device.Section + ">" +
                           device.ToXml() + "</" + device.Section +
                           "><params/></robot_world_controller>";
  experiment.Engines = "<pointmass3d id='engine'/>";
  experiment.Media = MediaForDevices();
  experiment.Arena = RobotForDevices(robot, "r", "0,0,0", "c") +
                     "<floor id='floor' source='loop_functions' pixels_per_meter='1'/>";
  return experiment;
}

std::string KindOf(const SListedDevice& device) {
  return device.Section == "sensors" ? "sensor" : "actuator";
}

}  // namespace

TEST_CASE("devices: every label is registered", "[contract][robots]") {
  for (const SListedDevice& device : ListedDevices()) {
    CAPTURE(device.Section, device.Label());
    CHECK((device.Section == "sensors" ? CFactory<CSimulatedSensor>::Exists(device.Label())
                                       : CFactory<CSimulatedActuator>::Exists(device.Label())));
  }
}

TEST_CASE("devices: the list contains every device that accepts a robot", "[contract][robots]") {
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  for (const std::string& robot : ListedRobots()) {
    for (const SFittingDevice& device : FittingDevices(robot)) {
      CAPTURE(robot, device.Kind, device.Label);
      const bool isListed = std::any_of(
          ListedDevices().begin(), ListedDevices().end(), [&](const SListedDevice& listed) {
            return listed.Label() == device.Label && listed.IsOf(robot) &&
                   KindOf(listed) == device.Kind;
          });
      CHECK(isListed);
    }
  }
}

TEST_CASE("devices: each runs on every robot that supports it", "[contract][robots]") {
  for (const SListedDevice& device : ListedDevices()) {
    for (const std::string& robot : ListedRobots()) {
      if (!device.IsOf(robot)) {
        continue;
      }
      CAPTURE(device.Section, device.Label(), robot);
      CTestWorld world(With(device, robot));
      world.Step(2);
      world.GetSimulator().Reset();
      world.Step(2);
      CHECK(TakeLogErr() == "");
    }
  }
}

TEST_CASE("devices: the error on a robot without the component gives the line of the device",
          "[contract][robots][errors]") {
  for (const SListedDevice& device : ListedDevices()) {
    for (const std::string& robot : ListedRobots()) {
      if (device.IsOf(robot)) {
        continue;
      }
      CAPTURE(device.Section, device.Label(), robot);
      const std::string error = LoadError(With(device, robot));
      CHECK_THAT(error, Contains("cannot be put into the arena"));
      CHECK_THAT(error, Contains(std::string(kControllersAt) + " the " + KindOf(device) + " <" +
                                 device.Tag + "> does not fit " + robot + " \"r\""));
      // the error lists the robot's components, or a similar one, or the number of its sensors
      CHECK_THAT(error, Contains("known: body, ") || Contains("did you mean") ||
                            Contains("robot \"r\" has "));
    }
  }
}

TEST_CASE("devices: the error on an unknown implementation lists the known ones",
          "[contract][robots][errors]") {
  for (SListedDevice device : ListedDevices()) {
    const std::string good = device.Label();
    device.Implementation = "defaults";
    CAPTURE(device.Section, good);
    const std::string robot = device.Robots.substr(0, device.Robots.find(' '));
    CHECK_THAT(LoadError(With(device, robot)),
               Contains(std::string(kControllersAt) + " there is no " + KindOf(device) + " \"" +
                        device.Label() + "\"") &&
                   Contains(device.Tag + " ("));
  }
}

TEST_CASE("devices: the error on a missing mounted component names it",
          "[contract][robots][errors]") {
  for (const SListedDevice& device : ListedDevices()) {
    const bool isMounted = device.Tag == "simple_radios" || device.Tag == "tags" ||
                           device.Tag == "magnets" || device.Tag == "directional_leds";
    if (!isMounted) {
      continue;
    }
    CAPTURE(device.Section, device.Label());
    SExperiment experiment = With(device, "e-puck");
    experiment.Arena = "<e-puck id='r'><body position='0,0,0'/><controller config='c'/></e-puck>";
    CHECK_THAT(LoadError(experiment),
               Contains("does not fit e-puck \"r\"") &&
                   Contains("\"r\" (e-puck) has no component \"" + device.Tag + "\"; "));
  }
}

}  // namespace device_fit_test
