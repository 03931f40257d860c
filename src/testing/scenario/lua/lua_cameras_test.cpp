// Cameras, tags, directional LEDs and magnets in Lua.

#include "lua_world.h"

#include <argos3/plugins/simulator/entities/directional_led_entity.h>
#include <argos3/plugins/simulator/entities/magnet_entity.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace lua_cameras_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

Real GetNumber(CLuaWorld& world, const std::string& expression) {
  return std::stod(world.Get("string.format('%.17g', " + expression + ")"));
}

SLuaExperiment With(const std::string& actuators, const std::string& sensors,
                    const std::string& mounted = "") {
  SLuaExperiment experiment;
  experiment.Actuators = actuators;
  experiment.Sensors = sensors;
  experiment.Robots = "<foot-bot id='fb'><body position='0,0,0'/><controller config='c'/>" +
                      mounted + "</foot-bot>";
  experiment.Arena =
      "<light id='l' position='0.3,0.4,0.1' color='255,140,0,255' intensity='1' medium='leds'/>"
      "<light id='m' position='" +
      ToText(1.0 + kFootBotRadius) +
      ",0.1,0.174249733' color='red' intensity='1' "
      "medium='leds'/>";
  experiment.Media = "<led id='leds'/><directional_led id='directional_leds'/><tag id='tags'/>";
  return experiment;
}

}  // namespace

TEST_CASE(
    "lua devices: the omnidirectional camera can be switched on and lists blobs in cm and rad",
    "[lua][devices]") {
  const std::string camera = "robot.colored_blob_omnidirectional_camera";
  CLuaWorld world(
      With("", "<colored_blob_omnidirectional_camera implementation='rot_z_only' medium='leds'/>"));
  world.Step();
  CHECK(world.Get("#" + camera) == "0");
  world.Do(camera + ".enable()");
  world.Step();
  REQUIRE(world.Get("#" + camera) == "1");
  CHECK_THAT(GetNumber(world, camera + "[1].distance"), WithinAbs(50.0, 1e-12));
  CHECK_THAT(GetNumber(world, camera + "[1].angle"), WithinAbs(std::atan2(4.0, 3.0), 1e-15));
  CHECK(world.Get(camera + "[1].color.red") == "255.0");
  CHECK(world.Get(camera + "[1].color.green") == "140.0");
  CHECK(world.Get(camera + "[1].color.blue") == "0.0");
  // each step creates new records, so that a script may keep them
  world.Do("kept = " + camera + "[1]");
  world.Step();
  CHECK(world.Get("kept == " + camera + "[1]") == "false");
  // after that the last readings are kept
  world.Do(camera + ".disable()");
  world.Step();
  CHECK(world.Get("#" + camera) == "1");
  // a reset brings back those of the start
  world.GetSimulator().Reset();
  CHECK(world.Get("#" + camera) == "0");
}

TEST_CASE("lua devices: the perspective camera lists pixels, and its head can be turned",
          "[lua][devices]") {
  const std::string camera = "robot.colored_blob_perspective_camera";
  CLuaWorld world(
      With("<pan_tilt_camera implementation='default'/>",
           "<colored_blob_perspective_camera implementation='default' medium='leds'/>"));
  world.Do(camera + ".enable()");
  world.Step();
  // 1 m ahead and 10 cm to the left, as in the tests of the camera
  REQUIRE(world.Get("#" + camera) == "1");
  CHECK(world.Get(camera + "[1].x") == "250.0");
  CHECK_THAT(GetNumber(world, camera + "[1].y"), WithinAbs(239.5, 0.5));
  CHECK(world.Get(camera + "[1].color.red") == "255.0");
  world.Do("robot.pan_tilt_camera.set_pan(math.atan(0.1, 1))");
  world.Step();
  CHECK_THAT(GetNumber(world, camera + "[1].x"), WithinAbs(319.5, 0.5));
  world.Do("robot.pan_tilt_camera.set_tilt(-math.pi / 2)");
  world.Step();
  CHECK(world.Get("#" + camera) == "0");
  CHECK_THROWS_WITH(world.Do("robot.pan_tilt_camera.set_pan('left')"),
                    Contains("set_pan") && Contains("number"));
}

TEST_CASE("lua devices: cameras are enabled from the start, in tables of their ids and algorithms",
          "[lua][devices]") {
  CLuaWorld world(With("",
                       "<cameras implementation='default'>"
                       "<camera id='front' anchor='origin' position='" +
                           ToText(kFootBotRadius) +
                           ",0,0.174249733' "
                           "orientation='-90,90,0' range='0.05:2' focal_length='500,500' "
                           "principal_point='320,240' resolution='640,480'>"
                           "<led_detector medium='leds'/></camera></cameras>"));
  CHECK(world.Get("#robot.cameras.front.led_detector") == "0");
  world.Step();
  REQUIRE(world.Get("#robot.cameras.front.led_detector") == "1");
  CHECK_THAT(GetNumber(world, "robot.cameras.front.led_detector[1].center.x"),
             WithinAbs(320.0 - 500.0 * 0.1, 1e-9));
  CHECK_THAT(GetNumber(world, "robot.cameras.front.led_detector[1].center.y"),
             WithinAbs(240.0, 1e-9));
  CHECK(world.Get("robot.cameras.front.led_detector[1].color.red") == "255.0");
}

TEST_CASE("lua devices: tags can be written and read", "[lua][devices]") {
  // a robot with a tag on a mast, 40 cm ahead of the camera and readable from behind that robot
  SLuaExperiment experiment =
      With("<tags implementation='default'/>",
           "<cameras implementation='default'>"
           "<camera id='front' anchor='origin' position='0,0,0.3' orientation='-90,90,0' "
           "range='0.05:2' focal_length='500,500' principal_point='320,240' resolution='640,480'>"
           "<tag_detector medium='tags'/></camera></cameras>",
           "<tags medium='tags'><tag position='0,0,0.3' orientation='0,-90,0' anchor='origin' "
           "observable_angle='60' side_length='0.1' payload='text'/></tags>");
  std::string other = experiment.Robots;
  other.replace(other.find("'fb'"), 4, "'other'");
  other.replace(other.find("0,0,0"), 5, "0.4,0,0");
  experiment.Robots += other;
  CLuaWorld world(experiment);
  world.Step();
  const std::string tags = "robot.cameras.front.tag_detector";
  REQUIRE(world.Get("#" + tags) == "1");
  CHECK(world.Get(tags + "[1].payload") == "text");
  CHECK_THAT(GetNumber(world, tags + "[1].center.x"), WithinAbs(320.0, 1e-9));
  REQUIRE(world.Get("#" + tags + "[1].corners") == "4");
  // 5 cm to either side at a distance of 40 cm: 62.5 pixels; the tag's x axis
  // points up, its y axis to the left
  CHECK_THAT(GetNumber(world, tags + "[1].corners[1].x"), WithinAbs(320.0 - 62.5, 1e-9));
  CHECK_THAT(GetNumber(world, tags + "[1].corners[1].y"), WithinAbs(240.0 - 62.5, 1e-9));
  CHECK_THAT(GetNumber(world, tags + "[1].corners[3].y"), WithinAbs(240.0 + 62.5, 1e-9));
  world.Do("robot.tags.set_all_payloads('all')", "other");
  world.Step();
  CHECK(world.Get(tags + "[1].payload") == "all");
  world.Do("robot.tags.set_single_payload(1, 'one')", "other");
  world.Step();
  CHECK(world.Get(tags + "[1].payload") == "one");
  CHECK_THROWS_WITH(world.Do("robot.tags.set_single_payload(2, 'x')"),
                    Contains("set_single_payload"));
}

TEST_CASE("lua devices: directional LEDs and magnets take orders", "[lua][devices]") {
  CLuaWorld world(
      With("<directional_leds implementation='default'/><magnets implementation='default'/>", "",
           "<directional_leds medium='directional_leds'>"
           "<directional_led anchor='origin' observable_angle='60'/>"
           "<directional_led anchor='origin' observable_angle='60'/></directional_leds>"
           "<magnets><magnet id='front' anchor='origin' offset='0,0,0' passive_field='1,0,0' "
           "active_field='0,2,0'/></magnets>"));
  world.Do("robot.directional_leds.set_all_colors('green')");
  world.Do("robot.directional_leds.set_single_color(2, 1, 2, 3)");
  world.Do("robot.magnets.front.set_current(0.5)");
  world.Step();
  const auto& led = [&world](const std::string& number) -> const auto& {
    return world.World().Get<CDirectionalLEDEntity>("fb.directional_leds_0.directional_led_" +
                                                    number);
  };
  CHECK(led("0").GetColor() == CColor::GREEN);
  CHECK(led("1").GetColor() == CColor(1, 2, 3));
  CHECK(world.World().Get<CMagnetEntity>("fb.magnets_0.front").GetField() ==
        CVector3(1.0, 1.0, 0.0));
  CHECK_THROWS_WITH(world.Do("robot.directional_leds.set_single_color(3, 'red')"),
                    Contains("set_single_color"));
  CHECK_THROWS_WITH(world.Do("robot.magnets.front.set_current('x')"), Contains("set_current"));
}

}  // namespace lua_cameras_test
