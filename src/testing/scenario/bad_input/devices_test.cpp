// Unknown devices and media, and wrong use of devices by controllers.

#include "../command_line/program_run.h"
#include "experiment_text.h"

#include <catch2/catch.hpp>

namespace devices_test {

using namespace argos;
using Catch::Contains;

namespace {

std::string WithSensors(const std::string& sensors, const std::string& label = "test_idle",
                        const std::string& params = "<params/>") {
  return "<controllers>" +
         SExperimentText::Controller(label, params, "<sensors>" + sensors + "</sensors>") +
         "</controllers>";
}

/** An experiment with one robot that runs a script. */
struct SScriptedRun {
  std::string Script;
  std::string Actuators = "<differential_steering implementation='default'/>";
  std::string Media = "";
  std::string Params = "";

  /** Runs the program on the experiment "e.argos" and the script "s.lua". */
  SProgramRun Run() const {
    const CTestFolder folder;
    folder.Write("s.lua", Script);
    folder.Write("e.argos",
                 "<argos-configuration>\n"
                 "<framework><experiment ticks_per_second='10' length='1' random_seed='1'/>"
                 "</framework>\n"
                 "<controllers><lua_controller id='c'><actuators>\n" +
                     Actuators + "\n</actuators><sensors/><params script='s.lua' " + Params +
                     "/></lua_controller></controllers>\n"
                     "<physics_engines><dynamics2d id='d'/></physics_engines>\n<media>" +
                     Media +
                     "</media>\n"
                     "<arena size='4,4,1'><foot-bot id='fb' rab_data_size='3'><body "
                     "position='0,0,0'/><controller config='c'/></foot-bot></arena>\n"
                     "</argos-configuration>\n");
    return folder.Run({"-c", "e.argos"});
  }
};

const std::string kActuatorLine = "e.argos:4: ";

}  // namespace

TEST_CASE("bad input: a device that the robot does not support", "[bad_input]") {
  SExperimentText experiment;
  experiment.Controllers = WithSensors("<footbot_turret_encoder implementation=\"default\"/>");
  const std::string error = LoadError(experiment);
  CHECK_THAT(error, Contains(At(SExperimentText::kControllersLine) +
                             " the sensor <footbot_turret_encoder> does not fit e-puck \"ep\""));
  CHECK_THAT(error, Contains("has no component \"turret\"; known: body, "));
  CHECK_THAT(error, Contains(At(SExperimentText::kArenaLine)));
}

TEST_CASE("bad input: a medium that does not exist or is of the wrong type", "[bad_input]") {
  SExperimentText experiment;
  const auto [named, media, known] = GENERATE(table<std::string, std::string, std::string>(
      {{"rab", "", "there is no medium \"rab\"; known: none"},
       {"rba", "<range_and_bearing id=\"rab\"/>",
        "there is no medium \"rba\"; did you mean \"rab\"?"},
       {"leds", "<led id=\"leds\"/>", "medium \"leds\" is not of the required type"}}));
  CAPTURE(named, media);
  experiment.Media = "<media>" + media + "</media>";
  SECTION("the medium of a sensor") {
    experiment.Controllers =
        WithSensors("<range_and_bearing implementation=\"medium\" medium=\"" + named + "\"/>");
    CHECK_THAT(LoadError(experiment),
               Contains(At(SExperimentText::kControllersLine) +
                        " <range_and_bearing>: attribute \"medium\" must be the id of a range and "
                        "bearing medium, got \"" +
                        named + "\"") &&
                   Contains(known));
  }
  SECTION("the medium of a mounted component") {
    experiment.Robot =
        "<e-puck id=\"ep\"><body/><controller config=\"c\"/><simple_radios><simple_radio "
        "id=\"wifi\" medium=\"" +
        named + "\" range=\"1\"/></simple_radios></e-puck>";
    CHECK_THAT(LoadError(experiment),
               Contains(At(SExperimentText::kArenaLine) +
                        " <simple_radio>: attribute \"medium\" must be the id of a simple radio "
                        "medium, got \"" +
                        named + "\"") &&
                   Contains(known));
  }
}

TEST_CASE("bad input: lights and mounted lights whose medium does not exist", "[bad_input]") {
  SExperimentText experiment;
  const auto [element, message] = GENERATE(table<std::string, std::string>(
      {{"<light id=\"l\" position=\"0,1,0.5\" intensity=\"1\" color=\"red\" medium=\"ledz\"/>",
        "<light>: attribute \"medium\" must be the id of an LED medium, got \"ledz\""},
       {"<e-puck id=\"l\"><body position=\"0,1,0\"/><controller config=\"c\"/><tags "
        "medium=\"ledz\"/></e-puck>",
        "<tags>: attribute \"medium\" must be the id of a tag medium, got \"ledz\""},
       {"<e-puck id=\"l\"><body position=\"0,1,0\"/><controller config=\"c\"/><directional_leds "
        "medium=\"ledz\"/></e-puck>",
        "<directional_leds>: attribute \"medium\" must be the id of a medium of directional LEDs, "
        "got \"ledz\""}}));
  CAPTURE(element);
  experiment.Media = "<media><led id=\"leds\"/></media>";
  experiment.Box = element;
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kArenaLine) + " " + message) &&
                                        Contains("did you mean \"leds\"?"));
}

TEST_CASE("bad input: users of a medium that failed to load are not reported again",
          "[bad_input]") {
  SExperimentText experiment;
  experiment.Media = "<media><led id=\"leds\" index=\"nonsense\"/></media>";
  experiment.Box =
      "<light id=\"l\" position=\"0,1,0.5\" intensity=\"1\" color=\"red\" medium=\"leds\"/>";
  const std::string error = LoadError(experiment);
  CHECK_THAT(error, Contains(At(SExperimentText::kMediaLine)) && Contains("nonsense"));
  CHECK_THAT(error, !Contains("<light>"));
}

TEST_CASE("bad input: a controller that requests a sensor missing in its XML", "[bad_input]") {
  SExperimentText experiment;
  experiment.Controllers = WithSensors("<proximity implementation=\"default\"/>",
                                       "test_asks_for_device", "<params sensor=\"proximitty\"/>");
  const std::string error = LoadError(experiment);
  CHECK_THAT(error, Contains("Robot \"ep\": its controller requests the sensor \"proximitty\", "
                             "which is not in the <sensors> section"));
  CHECK_THAT(error, Contains("did you mean \"proximity\"?") &&
                        Contains("the section contains: proximity"));
  CHECK_THAT(error, Contains(At(SExperimentText::kControllersLine)) &&
                        Contains(At(SExperimentText::kArenaLine)));
  // an actuator, and a device of another type than requested
  experiment.Controllers = WithSensors("", "test_asks_for_device", "<params actuator=\"leds\"/>");
  CHECK_THAT(LoadError(experiment),
             Contains("the actuator \"leds\", which is not in the <actuators> section") &&
                 Contains("the section contains: differential_steering"));
  experiment.Controllers = WithSensors("<positioning implementation=\"default\"/>",
                                       "test_asks_for_device", "<params sensor=\"positioning\"/>");
  CHECK_THAT(LoadError(experiment), Contains("the sensor \"positioning\" as a ") &&
                                        Contains("CCI_ProximitySensor") &&
                                        Contains("CPositioningDefaultSensor"));
}

TEST_CASE("bad input: a message longer or shorter than the messages of the robot", "[bad_input]") {
  SExperimentText experiment;
  experiment.Media = "<media><range_and_bearing id=\"rab\"/></media>";
  const std::string bytes = GENERATE(as<std::string>(), "1", "3");
  experiment.Robot =
      "<e-puck id=\"ep\" rab_data_size=\"2\"><body/><controller config=\"c\"/></e-puck>";
  experiment.Controllers =
      "<controllers><test_sends_message id=\"c\" library=\"" + BadControllersLibrary() +
      "\"><actuators><range_and_bearing implementation=\"default\"/></actuators><sensors/>"
      "<params bytes=\"" +
      bytes + "\"/></test_sends_message></controllers>";
  CHECK_THAT(RunError(experiment), Contains("robot \"ep\": ControlStep() threw in tick 1") &&
                                       Contains("messages have 2 bytes, got " + bytes));
}

namespace {

const std::string kRest = "function reset() end function destroy() end\n";

std::string ErrorOf(const SScriptedRun& experiment) {
  const SProgramRun run = experiment.Run();
  CHECK(run.Status == 1);
  return run.Err;
}

// the error of a run that a step of the script ends; the step is line 2
std::string ErrorOfStep(SScriptedRun& experiment, const std::string& step) {
  experiment.Script = "function init() end\nfunction step() " + step + " end " + kRest;
  experiment.Params = "on_error='end_run'";
  return ErrorOf(experiment);
}

}  // namespace

TEST_CASE("bad input: errors of scripts end the program with status 1", "[bad_input]") {
  SScriptedRun experiment;
  SECTION("a syntax error") {
    experiment.Script = "function init() end\nfunction step( end\n" + kRest;
    CHECK_THAT(ErrorOf(experiment), Contains("e.argos:3") && Contains("robot \"fb\"") &&
                                        Contains("the Lua script \"s.lua\" cannot be compiled") &&
                                        Contains("s.lua:2: <name> or '...' expected near 'end'"));
  }
  SECTION("an endless loop in init()") {
    experiment.Script = "function init()\n  while true do end\nend\nfunction step() end " + kRest;
    experiment.Params = "max_instructions='100000'";
    CHECK_THAT(ErrorOf(experiment),
               Contains("robot \"fb\": the Lua script \"s.lua\" failed in init()") &&
                   Contains("s.lua:2: interrupted after 100000 instructions; is there an endless "
                            "loop? If not, raise \"max_instructions\" in <params>"));
  }
  SECTION("an argument of the wrong type") {
    CHECK_THAT(ErrorOfStep(experiment, "robot.wheels.set_velocity(1, '2')"),
               Contains("robot \"fb\": the Lua script \"s.lua\" failed in step()") &&
                   Contains("s.lua:2: robot.wheels.set_velocity: argument 2 must be a "
                            "number, got string \"2\""));
  }
  SECTION("a message that is too long") {
    experiment.Actuators = "<range_and_bearing implementation='default'/>";
    experiment.Media = "<range_and_bearing id='rab'/>";
    CHECK_THAT(ErrorOfStep(experiment, "robot.range_and_bearing.set_data({ 1, 2, 3, 4 })"),
               Contains("s.lua:2: robot.range_and_bearing.set_data: argument 1 must be a "
                        "table of 3 whole numbers from 0 to 255, got a table of 4"));
  }
  SECTION("a device missing in the XML") {
    CHECK_THAT(ErrorOfStep(experiment, "robot.gripper.lock_positive()"),
               Contains("robot \"fb\"") &&
                   Contains("s.lua:2: attempt to index a nil value (field 'gripper')"));
  }
  SECTION("an unknown actuator") {
    experiment.Script = "function init() end function step() end " + kRest;
    experiment.Actuators = "<footbot_griper implementation='default'/>";
    CHECK_THAT(
        ErrorOf(experiment),
        Contains(kActuatorLine + "there is no actuator \"footbot_griper (default)\"; did you mean "
                                 "\"footbot_gripper (default)\""));
  }
}

TEST_CASE("bad input: closing a gripper without an object in reach is no error", "[bad_input]") {
  SScriptedRun experiment;
  experiment.Actuators += "<footbot_gripper implementation='default'/>";
  experiment.Script =
      "function init() robot.gripper.lock_positive() end\n"
      "function step() robot.wheels.set_velocity(5, -5) end\n"
      "function reset() end function destroy() end\n";
  const SProgramRun run = experiment.Run();
  CHECK(run.Status == 0);
  CHECK(run.Err == "");
}

}  // namespace devices_test
