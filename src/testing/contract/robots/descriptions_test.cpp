// The examples in the output of `argos3 -q` for robots, objects, devices and media load and run.

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/plugins/label_index.h>
#include <argos3/core/utility/plugins/registered_labels.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/media/led_medium.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/device_list.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <sstream>
#include <vector>

namespace descriptions_test {

using namespace argos;

namespace {

// media that the examples refer to
const std::string kMedia = MediaForDevices();

// the XML examples of a description: runs of lines that begin with two blanks and a tag
std::vector<std::string> ExamplesIn(const std::string& description) {
  std::vector<std::string> examples;
  std::istringstream lines(description);
  std::string line;
  bool inExample = false;
  while (std::getline(lines, line)) {
    const bool begins = !inExample && line.compare(0, 3, "  <") == 0;
    if (begins) {
      examples.emplace_back();
    }
    inExample = !line.empty() && (inExample || begins);
    if (inExample) {
      examples.back() += line + "\n";
    }
  }
  return examples;
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

// content of an element: text between its start tag and its end tag
std::string Inside(const std::string& element) {
  const size_t begin = element.find('>') + 1;
  return element.substr(begin, element.rfind("</") - begin);
}

void RunInArena(const std::string& arena) {
  SExperiment experiment;
  experiment.Engines = "<toy_engine id=\"engine\"/>";
  experiment.Media = kMedia;
  experiment.Controllers =
      "<robot_world_controller id=\"c1\"><actuators/><sensors/><params/></robot_world_controller>";
  experiment.Arena = arena;
  CTestWorld world(experiment);
  world.Step(2);
  // discards the warning about an unused controller
  TakeLogErr();
}

void RunWithControllers(const std::string& controllers, const std::string& robot) {
  SExperiment experiment;
  experiment.Engines = "<toy_engine id=\"engine\"/>";
  experiment.Media = kMedia;
  experiment.Controllers = Replaced(controllers, "my_controller", "robot_world_controller");
  experiment.Arena = RobotForDevices(robot, "r", "0,0,0", "c1") +
                     "<floor id=\"floor\" source=\"loop_functions\" pixels_per_meter=\"1\"/>";
  CTestWorld world(experiment);
  world.Step(2);
  CHECK(TakeLogErr() == "");
}

void RunWithDevice(const std::string& section, const std::string& device,
                   const std::string& robot) {
  const auto in = [&](const std::string& tag) {
    return "<" + tag + ">" + (tag == section ? device : "") + "</" + tag + ">";
  };
  RunWithControllers(
      "<my_controller id=\"c1\">" + in("actuators") + in("sensors") + "<params/></my_controller>",
      robot);
}

void RunWithMedia(const std::string& media) {
  SExperiment experiment;
  experiment.Media = media;
  CTestWorld world(experiment);
  world.Step(2);
}

void RunWithEngines(const std::string& engines) {
  SExperiment experiment;
  experiment.Engines = engines;
  // a place inside the regions of the examples
  experiment.Arena =
      "<box id=\"b\" size=\"1,1,1\" movable=\"false\"><body position=\"2,2,0\"/></box>";
  CTestWorld world(experiment);
  world.Step(2);
  CHECK(TakeLogErr() == "");
}

// runs every example of a description; returns their number
template <typename BASE>
size_t RunExamples(const std::string& label, const std::string& section = "",
                   const std::string& robot = "") {
  const auto found = CFactory<BASE>::GetTypeMap().find(label);
  REQUIRE(found != CFactory<BASE>::GetTypeMap().end());
  const std::vector<std::string> examples = ExamplesIn(found->second->LongDescription);
  for (const std::string& example : examples) {
    CAPTURE(label, example);
    if (example.find("<arena") != std::string::npos) {
      // the image of the example does not exist here
      CHECK_NOTHROW(RunInArena(Replaced(Inside(example), "source=\"image\" path=\"floor.png\"",
                                        "source=\"loop_functions\" pixels_per_meter=\"1\"")));
    } else if (example.find("  <foot-bot") == 0) {
      CHECK_NOTHROW(RunInArena(example));
    } else if (example.find("<controllers>") != std::string::npos) {
      CHECK_NOTHROW(RunWithControllers(Inside(example), robot));
    } else if (example.find("<physics_engines>") != std::string::npos) {
      CHECK_NOTHROW(RunWithEngines(Inside(example)));
    } else if (example.find("<media>") != std::string::npos) {
      CHECK_NOTHROW(RunWithMedia(Inside(example)));
    } else {
      CHECK_NOTHROW(RunWithDevice(section, example, robot));
    }
  }
  return examples.size();
}

}  // namespace

TEST_CASE("descriptions: examples of entities and media load and run", "[contract][robots]") {
  CHECK(RunExamples<CEntity>("box") == 3);
  CHECK(RunExamples<CEntity>("cylinder") == 3);
  CHECK(RunExamples<CEntity>("light") == 2);
  CHECK(RunExamples<CEntity>("foot-bot") == 2);
  CHECK(RunExamples<CEntity>("e-puck") == 2);
  CHECK(RunExamples<CEntity>("eye-bot") == 2);
  CHECK(RunExamples<CEntity>("pipuck") == 2);
  CHECK(RunExamples<CMedium>("led") == 2);
  CHECK(RunExamples<CMedium>("range_and_bearing") == 2);
  CHECK(RunExamples<CMedium>("simple_radio") == 3);
  CHECK(RunExamples<CEntity>("rfid_tag") == 4);
  CHECK(RunExamples<CMedium>("rfid") == 2);
  CHECK(RunExamples<CMedium>("pheromone") == 2);
}

TEST_CASE("descriptions: examples of physics engines load and run", "[contract][robots]") {
  CHECK(RunExamples<CPhysicsEngine>("dynamics2d") == 3);
  CHECK(RunExamples<CPhysicsEngine>("pointmass3d") == 2);
}

TEST_CASE("descriptions: examples of every device load and run on a robot that supports it",
          "[contract][robots]") {
  for (const SListedDevice& device : ListedDevices()) {
    const std::string robot = device.Robots.substr(0, device.Robots.find(' '));
    // at least the example of the required XML
    if (device.Section == "sensors") {
      CHECK(RunExamples<CSimulatedSensor>(device.Label(), device.Section, robot) >= 1);
    } else {
      CHECK(RunExamples<CSimulatedActuator>(device.Label(), device.Section, robot) >= 1);
    }
  }
}

TEST_CASE("descriptions: all examples of devices are found", "[contract][robots]") {
  CHECK(RunExamples<CSimulatedActuator>("differential_steering (default)", "actuators",
                                        "foot-bot") == 3);
  CHECK(RunExamples<CSimulatedActuator>("leds (default)", "actuators", "e-puck") == 2);
  CHECK(RunExamples<CSimulatedActuator>("range_and_bearing (default)", "actuators", "foot-bot") ==
        3);
  CHECK(RunExamples<CSimulatedActuator>("quadrotor_position (default)", "actuators", "eye-bot") ==
        2);
  CHECK(RunExamples<CSimulatedActuator>("quadrotor_speed (default)", "actuators", "eye-bot") == 2);
  CHECK(RunExamples<CSimulatedSensor>("differential_steering (default)", "sensors", "e-puck") == 2);
  CHECK(RunExamples<CSimulatedSensor>("proximity (default)", "sensors", "foot-bot") == 2);
  CHECK(RunExamples<CSimulatedSensor>("footbot_proximity (default)", "sensors", "foot-bot") == 2);
  CHECK(RunExamples<CSimulatedSensor>("epuck_proximity (default)", "sensors", "e-puck") == 2);
  CHECK(RunExamples<CSimulatedSensor>("range_and_bearing (medium)", "sensors", "e-puck") == 3);
  CHECK(RunExamples<CSimulatedActuator>("simple_radios (default)", "actuators", "e-puck") == 2);
  CHECK(RunExamples<CSimulatedSensor>("simple_radios (default)", "sensors", "foot-bot") == 3);
  CHECK(RunExamples<CSimulatedActuator>("pheromone (medium)", "actuators", "e-puck") == 3);
  CHECK(RunExamples<CSimulatedSensor>("pheromone (medium)", "sensors", "foot-bot") == 3);
  CHECK(RunExamples<CSimulatedActuator>("rfid (medium)", "actuators", "foot-bot") == 3);
  CHECK(RunExamples<CSimulatedSensor>("rfid (medium)", "sensors", "e-puck") == 3);
  CHECK(RunExamples<CSimulatedSensor>("eyebot_proximity (default)", "sensors", "eye-bot") == 2);
  CHECK(RunExamples<CSimulatedSensor>("eyebot_light (rot_z_only)", "sensors", "eye-bot") == 2);
}

TEST_CASE("descriptions: no robot and no device names a physics engine", "[contract][robots]") {
  const auto engines = CFactory<CPhysicsEngine>::GetLabels();
  REQUIRE(engines.size() >= 4);
  const auto check = [&engines](const std::string& label, const auto& info) {
    for (const std::string& engine : engines) {
      CAPTURE(label, engine);
      CHECK(info.BriefDescription.find(engine) == std::string::npos);
      CHECK(info.LongDescription.find(engine) == std::string::npos);
    }
  };
  for (const std::string& robot : ListedRobots()) {
    check(robot, CFactory<CEntity>::GetTypes().at(robot));
  }
  for (const auto& [label, info] : CFactory<CSimulatedSensor>::GetTypes()) {
    check(label, info);
  }
  for (const auto& [label, info] : CFactory<CSimulatedActuator>::GetTypes()) {
    check(label, info);
  }
}

TEST_CASE("descriptions: the index of a library has the labels that it registers",
          "[contract][plugins]") {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(InBuildTree("lib/argos3"))) {
    const std::vector<SPluginLabel> labels = ListLabelsOf(entry.path().filename().string());
    // not linked to this program, or the core
    if (entry.path().extension() != ".so" || labels.empty() ||
        entry.path().filename().string().rfind("libargos3plugin", 0) != 0) {
      continue;
    }
    CAPTURE(entry.path());
    CHECK(ReadLabelIndex(entry.path().string()) == labels);
    ++count;
  }
  CHECK(count > 10);
}

}  // namespace descriptions_test
