// Sensors for light, ground, pose, charge, time and distance in Lua.

#include "lua_world.h"

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/testing/support/robot_sizes.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace lua_sensors_test {

using namespace argos;
using Catch::WithinAbs;

namespace {

// tolerance of a few roundings of numbers of about 100
constexpr Real kRounding = 1e-12;

SLuaExperiment With(const std::string& sensors, const std::string& actuators = "") {
  SLuaExperiment experiment;
  experiment.Actuators = actuators;
  experiment.Sensors = sensors;
  return experiment;
}

std::string Device(const std::string& tag, const std::string& implementation = "default") {
  return "<" + tag + " implementation='" + implementation + "'/>";
}

Real GetNumber(CLuaWorld& world, const std::string& expression) {
  return std::stod(world.Get("string.format('%.17g', " + expression + ")"));
}

}  // namespace

TEST_CASE("lua devices: generic light is a list of numbers", "[lua][devices]") {
  SLuaExperiment experiment = With(Device("light"));
  // 1 m ahead of sensor 1
  const Real angle = 7.5 * M_PI / 180.0;
  const Real distance = 1.0 + kFootBotRadius;
  experiment.Arena = "<light id='l' position='" + std::to_string(distance * std::cos(angle)) + "," +
                     std::to_string(distance * std::sin(angle)) +
                     ",0.06' color='white' intensity='0.5' medium='leds'/>";
  CLuaWorld world(experiment);
  CHECK(world.Get("#robot.light") == "24");
  CHECK(GetNumber(world, "robot.light[1]") == 0.0);
  world.Step();
  // the position is written with six digits
  CHECK_THAT(GetNumber(world, "robot.light[1]"), WithinAbs(0.25, 1e-6));
  CHECK(GetNumber(world, "robot.light[13]") == 0.0);
}

TEST_CASE("lua devices: the light rings have angles and values", "[lua][devices]") {
  const bool flies = GENERATE(false, true);
  SLuaExperiment experiment = With(Device(flies ? "eyebot_light" : "footbot_light", "rot_z_only"));
  experiment.Arena = "<light id='l' position='1,0,0' color='white' intensity='1' medium='leds'/>";
  if (flies) {
    experiment.Engines = "<pointmass3d id='pm3d'/>";
    experiment.Robots =
        "<eye-bot id='fb'><body position='0,0,0'/><controller config='c'/></eye-bot>";
  }
  CLuaWorld world(experiment);
  CHECK(world.Get("#robot.light") == "24");
  world.Do("first = robot.light[1]");
  world.Step();
  for (int i = 1; i <= 24; ++i) {
    CAPTURE(i);
    const std::string entry = "robot.light[" + std::to_string(i) + "]";
    const Real angle = std::remainder((7.5 + 15.0 * (i - 1)) * M_PI / 180.0, 2.0 * M_PI);
    CHECK_THAT(GetNumber(world, entry + ".angle"), WithinAbs(angle, kRounding));
    const Real value = std::exp(-2.0) * std::max(0.0, 1.0 - 2.0 * std::abs(angle) / M_PI);
    CHECK_THAT(GetNumber(world, entry + ".value"), WithinAbs(value, 1e-9));
  }
  CHECK(world.Get("first == robot.light[1]") == "true");
}

TEST_CASE("lua devices: ground sensors are numbers, or offsets in cm and values",
          "[lua][devices]") {
  SLuaExperiment experiment =
      With(Device("ground", "rot_z_only") + Device("footbot_motor_ground", "rot_z_only") +
           Device("footbot_base_ground", "rot_z_only"));
  // the default loop functions give a white floor
  experiment.Arena = "<floor id='floor' source='loop_functions' pixels_per_meter='1'/>";
  CLuaWorld world(experiment);
  CHECK(world.Get("#robot.ground") == "12");
  CHECK(world.Get("#robot.motor_ground") == "4");
  CHECK(world.Get("#robot.base_ground") == "8");
  CHECK(GetNumber(world, "robot.ground[12]") == 0.0);
  world.Step();
  CHECK(GetNumber(world, "robot.ground[1]") == 1.0);
  CHECK(GetNumber(world, "robot.ground[12]") == 1.0);
  CHECK(GetNumber(world, "robot.motor_ground[2].value") == 1.0);
  CHECK_THAT(GetNumber(world, "robot.motor_ground[2].offset.x"), WithinAbs(-6.3, kRounding));
  CHECK_THAT(GetNumber(world, "robot.motor_ground[2].offset.y"), WithinAbs(1.16, kRounding));
  CHECK(GetNumber(world, "robot.base_ground[8].value") == 1.0);
  CHECK_THAT(GetNumber(world, "robot.base_ground[8].offset.x"), WithinAbs(4.2, kRounding));
  CHECK_THAT(GetNumber(world, "robot.base_ground[8].offset.y"), WithinAbs(-6.5, kRounding));
}

TEST_CASE("lua devices: pose and height are in metres, time is in seconds", "[lua][devices]") {
  SLuaExperiment experiment = With(Device("positioning") + Device("altitude") + Device("clock"));
  experiment.Robots =
      "<foot-bot id='fb'><body position='1.5,-2.25,0' orientation='90,0,0'/>"
      "<controller config='c'/></foot-bot>";
  CLuaWorld world(experiment);
  world.Step(3);
  CHECK(GetNumber(world, "robot.positioning.position.x") == 1.5);
  CHECK(GetNumber(world, "robot.positioning.position.y") == -2.25);
  CHECK(GetNumber(world, "robot.positioning.position.z") == 0.0);
  CHECK_THAT(GetNumber(world, "robot.positioning.orientation.w"),
             WithinAbs(std::sqrt(0.5), kRounding));
  CHECK_THAT(GetNumber(world, "robot.positioning.orientation.z"),
             WithinAbs(std::sqrt(0.5), kRounding));
  CHECK(GetNumber(world, "robot.altitude.height") == 0.0);
  CHECK(GetNumber(world, "robot.clock.tick") == 3.0);
  CHECK_THAT(GetNumber(world, "robot.clock.time"), WithinAbs(0.3, kRounding));
}

TEST_CASE("lua devices: the battery has charge and time left", "[lua][devices]") {
  SLuaExperiment experiment = With(Device("battery"));
  experiment.Robots =
      "<foot-bot id='fb'><body position='0,0,0'/><controller config='c'/>"
      "<battery delta='0.25'/></foot-bot>";
  CLuaWorld world(experiment);
  CHECK(world.Get("robot.battery.available_charge") == "1.0");
  CHECK(world.Get("robot.battery.time_left == math.huge") == "true");
  world.Step();
  CHECK(GetNumber(world, "robot.battery.available_charge") == 0.75);
  CHECK_THAT(GetNumber(world, "robot.battery.time_left"), WithinAbs(0.4, kRounding));
}

TEST_CASE("lua devices: the encoders of the foot-bot are in cm", "[lua][devices]") {
  CLuaWorld world(With(Device("footbot_encoder"), Device("differential_steering")));
  CHECK_THAT(GetNumber(world, "robot.encoder.axis_length"), WithinAbs(14.0, kRounding));
  world.Do("robot.wheels.set_velocity(3, -7)");
  world.Step(2);
  CHECK_THAT(GetNumber(world, "robot.encoder.distance_left"), WithinAbs(0.3, 1e-11));
  CHECK_THAT(GetNumber(world, "robot.encoder.distance_right"), WithinAbs(-0.7, 1e-11));
}

TEST_CASE(
    "lua devices: the distance scanner can be switched on and lists angles and distances in cm",
    "[lua][devices]") {
  SLuaExperiment experiment =
      With(Device("footbot_distance_scanner", "rot_z_only"), Device("footbot_distance_scanner"));
  // 20 cm ahead of the body
  experiment.Arena =
      "<box id='wall' size='0.1,4,0.5' movable='false'><body position='0.335036758,0,0'/></box>";
  CLuaWorld world(experiment);
  const std::string scanner = "robot.distance_scanner";
  const std::string lengths = "#" + scanner + ".short_range .. ' ' .. #" + scanner + ".long_range";
  world.Step();
  CHECK(world.Get(lengths) == "0 0");
  world.Do(scanner + ".enable()");
  world.Step();
  REQUIRE(world.Get(lengths) == "2 2");
  // sorted by angle: ahead, then behind
  CHECK_THAT(GetNumber(world, scanner + ".short_range[1].angle"), WithinAbs(0.0, kRounding));
  CHECK_THAT(GetNumber(world, scanner + ".short_range[1].distance"), WithinAbs(20.0, 1e-11));
  CHECK(GetNumber(world, scanner + ".short_range[2].distance") == -2.0);
  // each step creates new lists, so that a script may keep them
  world.Do("kept = " + scanner + ".short_range");
  world.Do(scanner + ".set_angle(0.5 * math.pi)");
  world.Step();
  CHECK(world.Get("kept == " + scanner + ".short_range") == "false");
  CHECK_THAT(GetNumber(world, "kept[1].distance"), WithinAbs(20.0, 1e-11));
  CHECK_THAT(GetNumber(world, scanner + ".short_range[1].angle"),
             WithinAbs(-0.5 * M_PI, kRounding));
  world.Do(scanner + ".set_rpm(30)");
  world.Step();
  CHECK(world.Get(lengths) == "12 12");
  world.Do(scanner + ".disable()");
  world.Step();
  CHECK(world.Get(lengths) == "0 0");
}

TEST_CASE("lua devices: after a reset the table of a sensor that is off has no old readings",
          "[lua][devices]") {
  SLuaExperiment experiment =
      With(Device("footbot_light", "rot_z_only") +
           "<colored_blob_omnidirectional_camera implementation='rot_z_only' medium='leds'/>");
  experiment.Script =
      "function init() robot.colored_blob_omnidirectional_camera.enable() end\n"
      "function step() end function destroy() end\n"
      "function reset() seen = #robot.colored_blob_omnidirectional_camera end\n";
  experiment.Arena = "<light id='l' position='0.5,0,0.1' color='red' intensity='1' medium='leds'/>";
  CLuaWorld world(experiment);
  const std::string before = world.Get("#robot.colored_blob_omnidirectional_camera");
  world.Step(2);
  REQUIRE(world.Get("#robot.colored_blob_omnidirectional_camera") == "1");
  REQUIRE(GetNumber(world, "robot.light[1].value") > 0.0);
  // sensors that are switched off are not read in step()
  for (const auto& [label, sensor] : world.GetController().GetAllSensors()) {
    sensor->Disable();
    sensor->MarkStart();
  }
  world.GetSimulator().Reset();
  CHECK(world.Get("seen") == "0");
  CHECK(world.Get("#robot.colored_blob_omnidirectional_camera") == before);
  CHECK(GetNumber(world, "robot.light[1].value") == 0.0);
}

}  // namespace lua_sensors_test
