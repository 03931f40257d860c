// Readings that a script keeps from one tick to the next, and the garbage that readings make.

#include "lua_world.h"

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <string>

namespace lua_kept_readings_test {

using namespace argos;
using Catch::Contains;

namespace {

const std::string kHooks = "function init() end function reset() end function destroy() end\n";

// the robots "fb", "r1", "r2", ... in a square; each one hears all others, and sends the tick
SLuaExperiment Crowd(int robots, const std::string& script, bool reuse) {
  SLuaExperiment experiment;
  experiment.Script =
      kHooks +
      "tick = 0\nfunction step() tick = tick + 1 robot.range_and_bearing.set_data(1, tick)" +
      script + " end";
  experiment.Params = reuse ? "reuse_readings='true'" : "";
  experiment.Actuators =
      "<range_and_bearing implementation='default'/><leds implementation='default' medium='leds'/>";
  experiment.Sensors =
      "<range_and_bearing implementation='medium' medium='rab'/>"
      "<colored_blob_omnidirectional_camera implementation='rot_z_only' medium='leds'/>"
      "<footbot_distance_scanner implementation='rot_z_only'/>"
      "<positioning implementation='default'/>"
      "<footbot_motor_ground implementation='rot_z_only'/>"
      "<cameras implementation='default'><camera id='front' anchor='origin' position='0,0,0.3' "
      "orientation='-90,90,0' range='0.05:2' focal_length='500,500' principal_point='320,240' "
      "resolution='640,480'><led_detector medium='leds'/><tag_detector medium='tags'/></camera>"
      "</cameras>";
  experiment.Actuators += "<footbot_distance_scanner implementation='default'/>";
  experiment.Media =
      "<led id='leds'/><tag id='tags'/><range_and_bearing id='rab' check_occlusions='false'/>";
  experiment.Arena = "<floor id='floor' source='loop_functions' pixels_per_meter='1'/>";
  experiment.LoopScript = "function floor_color() return 'white' end";
  experiment.Robots.clear();
  for (int i = 0; i < robots; ++i) {
    const std::string id = i == 0 ? "fb" : "r" + std::to_string(i);
    experiment.Robots +=
        "<foot-bot id='" + id + "' rab_range='20' rab_data_size='10'><body position='" +
        std::to_string(0.3 * (i % 7)) + "," + std::to_string(0.3 * (i / 7)) +
        ",0'/><controller config='c'/><tags medium='tags'><tag anchor='origin' position='0,0,0.3' "
        "orientation='0,-90,0' observable_angle='60' side_length='0.1' payload='t'/></tags>"
        "</foot-bot>";
  }
  return experiment;
}

}  // namespace

TEST_CASE("lua readings: a message that a script has kept stays as it was", "[lua][devices]") {
  CLuaWorld world(Crowd(2,
                        " local now = robot.range_and_bearing[1]"
                        " if tick == 4 then kept, bytes, range = now, now.data, now.range end",
                        false));
  world.Step(4);
  // sent in tick 3
  REQUIRE(world.Get("kept.data[1]") == "3.0");
  world.Step(2);
  CHECK(TakeLogErr() == "");
  CHECK(world.Get("robot.range_and_bearing[1].data[1]") == "5.0");
  CHECK(world.Get("kept.data[1]") == "3.0");
  CHECK(world.Get("kept.range == range and kept.data == bytes") == "true");
  CHECK(world.Get("rawequal(kept, robot.range_and_bearing[1])") == "false");
}

TEST_CASE("lua readings: a script that reuses readings gets the same tables with new values",
          "[lua][devices]") {
  CLuaWorld world(Crowd(3, " if tick == 4 then kept = robot.range_and_bearing[2] end", true));
  world.Step(4);
  REQUIRE(world.Get("#robot.range_and_bearing .. ' ' .. kept.data[1]") == "2 3.0");
  world.Step();
  CHECK(world.Get("rawequal(kept, robot.range_and_bearing[2])") == "true");
  CHECK(world.Get("kept.data[1]") == "4.0");
  CHECK(world.Get("#kept.data") == "10");

  // fewer messages, and what a script does to the list
  world.Do("table.remove(robot.range_and_bearing, 1) robot.range_and_bearing[1].data[11] = 7");
  world.GetSimulator().GetLoopFunctions().RemoveEntity("r1");
  world.Step();
  CHECK(world.Get("#robot.range_and_bearing") == "1");
  CHECK(world.Get("robot.range_and_bearing[2]") == "nil");
  CHECK(world.Get("rawequal(kept, robot.range_and_bearing[1])") == "false");
  CHECK(world.Get("#robot.range_and_bearing[1].data") == "10");
  CHECK(TakeLogErr() == "");
}

TEST_CASE("lua readings: both ways give a script equal values", "[lua][devices]") {
  const std::string script = R"(
    robot.colored_blob_omnidirectional_camera.enable() robot.leds.set_all_colors('red')
    robot.distance_scanner.enable() robot.distance_scanner.set_rpm(30)
    local function text(v)
      if type(v) == 'function' then return 'f' end
      if type(v) ~= 'table' then return tostring(v) end
      local parts = {}
      for key, value in pairs(v) do
        if key ~= 'params' then parts[#parts + 1] = tostring(key) .. '=' .. text(value) end
      end
      return '{' .. table.concat(parts, ' ') .. '}'
    end
    seen = text(robot))";
  CLuaWorld fresh(Crowd(9, script, false));
  CLuaWorld reused(Crowd(9, script, true));
  for (int tick = 0; tick < 6; ++tick) {
    fresh.Step();
    reused.Step();
    CHECK(reused.Get("seen") == fresh.Get("seen"));
  }
  CHECK_THAT(fresh.Get("seen"), Contains("payload=t") && Contains("red=255.0") &&
                                    Contains("horizontal_bearing") && Contains("short_range={1="));
}

TEST_CASE("lua readings: reused ones of 49 heard robots make no garbage", "[lua][devices]") {
  // a scanner at rest, because the number of its readings is then fixed
  const std::string script = R"(
    if tick == 1 then
      robot.colored_blob_omnidirectional_camera.enable() robot.leds.set_all_colors('red')
      robot.distance_scanner.enable() robot.distance_scanner.set_angle(0)
    end
    sum = 0.0
    for i = 1, #robot.range_and_bearing do
      sum = sum + robot.range_and_bearing[i].data[1]
    end
    if tick == 6 then
      collectgarbage() collectgarbage('stop') start = collectgarbage('count')
    end
    if tick > 6 then growth = collectgarbage('count') - start end)";
  CLuaWorld reused(Crowd(50, script, true));
  reused.Step(20);
  CHECK(TakeLogErr() == "");
  REQUIRE(reused.Get("#robot.range_and_bearing") == "49");
  REQUIRE(reused.Get("#robot.colored_blob_omnidirectional_camera > 20") == "true");
  REQUIRE(reused.Get("#robot.cameras.front.tag_detector > 0") == "true");
  REQUIRE(reused.Get("sum") == "931.0");
  CHECK(reused.Get("growth") == "0.0");

  // new tables do
  CLuaWorld fresh(Crowd(50, script, false));
  fresh.Step(20);
  CHECK(std::stod(fresh.Get("growth")) > 100.0);
}

TEST_CASE("lua readings: reuse_readings must be a truth value", "[lua][errors]") {
  SLuaExperiment experiment = Crowd(1, "", false);
  experiment.Params = "reuse_readings='sometimes'";
  CHECK_THAT(LoadError(experiment), Contains("reuse_readings") && Contains("sometimes"));
}

}  // namespace lua_kept_readings_test
