// What scripts see of devices, and what devices do for them.

#include "lua_world.h"

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

// a few roundings of numbers of about 10
constexpr Real kRounding = 1e-12;

SLuaExperiment WithDevices(const std::string& step, const std::string& actuators,
                           const std::string& sensors) {
  SLuaExperiment experiment;
  experiment.Script =
      "function init() end function reset() end function destroy() end\n"
      "function step() " +
      step + " end\n";
  experiment.Actuators = actuators;
  experiment.Sensors = sensors;
  return experiment;
}

std::string Device(const std::string& name, const std::string& attributes = "") {
  return "<" + name + " implementation='default' " + attributes + "/>";
}

std::string EPuck(const std::string& pose) {
  return "<e-puck id='fb'><body " + pose + "/><controller config='c'/></e-puck>";
}

Real GetNumber(CLuaWorld& world, const std::string& expression) {
  return std::stod(world.Get("string.format('%.17g', " + expression + ")"));
}

}  // namespace

TEST_CASE("lua devices: wheels are ordered and read in cm", "[lua][devices]") {
  CLuaWorld world(WithDevices("robot.wheels.set_velocity(12, -3)", Device("differential_steering"),
                              Device("differential_steering")));
  // start values, not yet measured
  CHECK(GetNumber(world, "robot.wheels.velocity_left") == 0.0);
  CHECK_THAT(GetNumber(world, "robot.wheels.axis_length"), WithinAbs(14.0, kRounding));
  world.Step();
  CHECK(GetNumber(world, "robot.wheels.velocity_left") == 0.0);
  world.Step();
  CHECK_THAT(GetNumber(world, "robot.wheels.velocity_left"), WithinAbs(12.0, kRounding));
  CHECK_THAT(GetNumber(world, "robot.wheels.velocity_right"), WithinAbs(-3.0, kRounding));
  CHECK_THAT(GetNumber(world, "robot.wheels.distance_left"), WithinAbs(1.2, kRounding));
  CHECK_THAT(GetNumber(world, "robot.wheels.distance_right"), WithinAbs(-0.3, kRounding));
  // a reset is seen by reset() already
  world.Do("function reset() seen = robot.wheels.velocity_left end");
  world.GetSimulator().Reset();
  CHECK(GetNumber(world, "seen") == 0.0);
}

TEST_CASE("lua devices: the wheels' table has both halves of the pair, whoever comes alone",
          "[lua][devices]") {
  CLuaWorld sensor(WithDevices("", "", Device("differential_steering")));
  CHECK(sensor.Get("robot.wheels.set_velocity") == "nil");
  CHECK(sensor.Get("robot.wheels.distance_left") == "0.0");
  CLuaWorld actuator(WithDevices("", Device("differential_steering"), ""));
  CHECK(actuator.Get("type(robot.wheels.set_velocity)") == "function");
  CHECK(actuator.Get("robot.wheels.distance_left") == "nil");
}

TEST_CASE("lua devices: the ring of a foot-bot, angle and value", "[lua][devices]") {
  // a wall whose face is 5 cm from the ring, ahead
  SLuaExperiment experiment = WithDevices("", "", Device("footbot_proximity"));
  experiment.Arena =
      "<box id='wall' size='0.1,4,0.5' movable='false'><body position='0.185036758,0,0'/></box>";
  CLuaWorld world(experiment);
  CHECK(world.Get("#robot.proximity") == "24");
  CHECK(world.Get("robot.proximity[1].value") == "0.0");
  world.Do("first = robot.proximity[1]");
  world.Step();
  for (int i = 1; i <= 24; ++i) {
    CAPTURE(i);
    const std::string entry = "robot.proximity[" + std::to_string(i) + "]";
    const Real angle = CRadians((7.5 + 15.0 * (i - 1)) * CRadians::PI.GetValue() / 180.0)
                           .SignedNormalize()
                           .GetValue();
    CHECK_THAT(GetNumber(world, entry + ".angle"), WithinAbs(angle, kRounding));
    // rays that see the wall point ahead; the ring's radius is 0.085036758 m, the range 0.1 m
    const Real distance = 0.135036758 / std::cos(angle) - 0.085036758;
    const bool hits = std::cos(angle) > 0.0 && distance < 0.1;
    const Real value = hits ? 0.0100527 / (distance + 0.000163144) : 0.0;
    CHECK_THAT(GetNumber(world, entry + ".value"), WithinAbs(value, 1e-9));
  }
  // refreshed in place
  CHECK(world.Get("first.value > 0.1") == "true");
  CHECK(world.Get("first == robot.proximity[1]") == "true");
}

TEST_CASE("lua devices: the sensors of an e-puck, angle and value", "[lua][devices]") {
  // a wall whose face is 2 cm from the e-puck's rim, ahead
  SLuaExperiment experiment = WithDevices("", "", Device("epuck_proximity"));
  experiment.Robots = EPuck("position='0,0,0'");
  experiment.Arena =
      "<box id='wall' size='0.1,4,0.5' movable='false'><body position='0.105,0,0'/></box>";
  CLuaWorld world(experiment);
  CHECK(world.Get("#robot.proximity") == "8");
  world.Step();
  for (UInt32 i = 0; i < 8; ++i) {
    CAPTURE(i);
    const std::string entry = "robot.proximity[" + std::to_string(i + 1) + "]";
    const Real angle = CCI_EPuckProximitySensor::GetAngle(i).GetValue();
    CHECK_THAT(GetNumber(world, entry + ".angle"), WithinAbs(angle, kRounding));
    const bool ahead = i == 0 || i == 7;
    CHECK((GetNumber(world, entry + ".value") > 0.1) == ahead);
  }
}

TEST_CASE("lua devices: generic proximity is a list of numbers", "[lua][devices]") {
  SLuaExperiment experiment = WithDevices("", "", Device("proximity"));
  experiment.Arena =
      "<box id='wall' size='0.1,4,0.5' movable='false'><body position='0.185036758,0,0'/></box>";
  CLuaWorld world(experiment);
  CHECK(world.Get("#robot.proximity") == "24");
  CHECK(world.Get("robot.proximity[1]") == "0.0");
  world.Step();
  // the first ray points 7.5 degrees to the left: exp(-distance)
  const Real distance = 0.135036758 / std::cos(7.5 * CRadians::PI.GetValue() / 180.0) - 0.085036758;
  CHECK_THAT(GetNumber(world, "robot.proximity[1]"), WithinAbs(std::exp(-distance), 1e-9));
  CHECK_THAT(GetNumber(world, "robot.proximity[24]"), WithinAbs(std::exp(-distance), 1e-9));
  CHECK(GetNumber(world, "robot.proximity[13]") == 0.0);
}

TEST_CASE("lua devices: LEDs count from 1 and take names, texts and numbers", "[lua][devices]") {
  const std::string leds = Device("leds", "medium='leds'");
  SLuaExperiment experiment = WithDevices(
      "robot.leds.set_all_colors('blue') robot.leds.set_single_color(1, 'red')\n"
      "robot.leds.set_single_color(2, 1, 2, 3) robot.leds.set_single_color(13, '4,5,6,7')",
      leds, "");
  CLuaWorld world(experiment);
  world.Step(2);
  CHECK(TakeLogErr() == "");
  auto& entity =
      world.World().Get<CComposableEntity>("fb").GetComponent<CLEDEquippedEntity>("leds");
  CHECK(entity.GetLEDColor(0) == CColor::RED);
  CHECK(entity.GetLEDColor(1) == CColor(1, 2, 3));
  CHECK(entity.GetLEDColor(2) == CColor::BLUE);
  CHECK(entity.GetLEDColor(12) == CColor(4, 5, 6, 7));
  world.Do("function step() robot.leds.set_all_colors(9, 8, 7) end");
  world.Step(2);
  CHECK(entity.GetLEDColor(0) == CColor(9, 8, 7));
  CHECK(entity.GetLEDColor(12) == CColor(9, 8, 7));

  const auto error = [&world](const std::string& call) {
    return world.Get("select(2, pcall(function() robot.leds." + call + " end))");
  };
  CHECK_THAT(
      error("set_single_color(0, 'red')"),
      Contains(
          "robot.leds.set_single_color: argument 1 must be a whole number from 1 to 13, got 0"));
  CHECK_THAT(error("set_single_color(14, 'red')"), Contains("from 1 to 13, got 14"));
  CHECK_THAT(error("set_single_color(1)"), Contains("argument 2 must be the name of a color"));
  CHECK_THAT(error("set_single_color(1, 'rde')"), Contains("rde"));
  CHECK_THAT(error("set_single_color(1, 1, 2, 256)"),
             Contains("argument 4 must be a whole number"));
  CHECK_THAT(error("set_all_colors('red', 'blue')"), Contains("too many arguments"));
}

TEST_CASE("lua devices: an e-puck has eight LEDs", "[lua][devices]") {
  SLuaExperiment experiment = WithDevices("", Device("leds", "medium='leds'"), "");
  experiment.Robots = EPuck("position='0,0,0'");
  CLuaWorld world(experiment);
  world.Do("robot.leds.set_single_color(8, 'red')");
  CHECK_THAT(world.Get("select(2, pcall(robot.leds.set_single_color, 9, 'red'))"),
             Contains("from 1 to 8, got 9"));
}

TEST_CASE("lua devices: two sensors that would write into one table are fatal", "[lua][devices]") {
  CHECK_THAT(LoadError(WithDevices("", "", Device("proximity") + Device("footbot_proximity"))),
             Contains("the sensors <footbot_proximity> and <proximity> would both write into the "
                      "Lua table robot.proximity; use one of them"));
}

TEST_CASE("lua devices: a script that destroys its tables gets an error at most",
          "[lua][devices]") {
  CLuaWorld world(WithDevices("robot.proximity = nil robot.wheels.set_velocity(1, 1) robot = nil",
                              Device("differential_steering"), Device("footbot_proximity")));
  world.Step(2);
  CHECK_THAT(TakeLogErr(), Contains("attempt to index a nil value (global 'robot')"));
  world.Step(3);
  CHECK_THAT(world.GetAnchor().Position.GetX(), WithinAbs(0.004, 1e-9));
}
