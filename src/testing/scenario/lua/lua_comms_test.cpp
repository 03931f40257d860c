// Communication devices in Lua.

#include "lua_world.h"

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace lua_comms_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

constexpr Real kRounding = 1e-12;

// two foot-bots 1 m apart that run the same script: "fb" faces "other", which faces left
SLuaExperiment PairOf(const std::string& script, const std::string& actuators,
                      const std::string& sensors, const std::string& media,
                      const std::string& parts = "") {
  SLuaExperiment experiment;
  experiment.Script = "function init() end function reset() end function destroy() end\n" + script;
  experiment.Actuators = actuators;
  experiment.Sensors = sensors;
  experiment.Media = media;
  experiment.Robots =
      "<foot-bot id='fb' rab_data_size='3'><body position='0,0,0'/><controller config='c'/>" +
      parts +
      "</foot-bot><foot-bot id='other' rab_data_size='3'><body position='1,0,0' "
      "orientation='90,0,0'/><controller config='c'/>" +
      parts + "</foot-bot>";
  return experiment;
}

Real GetNumber(CLuaWorld& world, const std::string& expression, const std::string& robot = "fb") {
  return std::stod(world.Get("string.format('%.17g', " + expression + ")", robot));
}

std::string ErrorOf(CLuaWorld& world, const std::string& call) {
  return world.Get("select(2, pcall(function() " + call + " end))");
}

}  // namespace

TEST_CASE("lua devices: range and bearing exchanges messages of bytes", "[lua][devices]") {
  CLuaWorld world(
      PairOf("function step() robot.range_and_bearing.set_data(2, 7)\n"
             "if robot.id == 'other' then robot.range_and_bearing.set_data({1, 2, 255})"
             " end end",
             "<range_and_bearing implementation='default'/>",
             "<range_and_bearing implementation='medium' medium='rab'/>",
             "<range_and_bearing id='rab'/>"));
  CHECK(world.Get("#robot.range_and_bearing") == "0");
  world.Step(2);
  CHECK(TakeLogErr() == "");
  REQUIRE(world.Get("#robot.range_and_bearing") == "1");
  CHECK_THAT(GetNumber(world, "robot.range_and_bearing[1].range"), WithinAbs(100.0, kRounding));
  CHECK(GetNumber(world, "robot.range_and_bearing[1].horizontal_bearing") == 0.0);
  CHECK(GetNumber(world, "robot.range_and_bearing[1].vertical_bearing") == 0.0);
  CHECK(world.Get("table.concat(robot.range_and_bearing[1].data, ' ')") == "1.0 2.0 255.0");
  // "other" faces along y: "fb" is to its left, at 90 degrees
  CHECK_THAT(GetNumber(world, "robot.range_and_bearing[1].horizontal_bearing", "other"),
             WithinAbs(M_PI / 2.0, kRounding));
  CHECK(world.Get("table.concat(robot.range_and_bearing[1].data, ' ')", "other") == "0.0 7.0 0.0");
  world.Do("robot.range_and_bearing.clear_data() function step() end");
  world.Step();
  CHECK(world.Get("table.concat(robot.range_and_bearing[1].data, ' ')", "other") == "0.0 0.0 0.0");

  const auto error = [&world](const std::string& call) {
    return ErrorOf(world, "robot.range_and_bearing." + call);
  };
  CHECK_THAT(error("set_data(0, 1)"), Contains("from 1 to 3, got 0"));
  CHECK_THAT(error("set_data(4, 1)"), Contains("from 1 to 3, got 4"));
  CHECK_THAT(error("set_data(1, 256)"), Contains("argument 2"));
  CHECK_THAT(error("set_data({1, 2})"), Contains("3"));
  CHECK_THAT(error("set_data({1, 2, 300})"), Contains("255"));
  CHECK_THAT(error("set_data(1)"), Contains("argument 2"));
}

TEST_CASE("lua devices: simple radios send tables", "[lua][devices]") {
  CLuaWorld world(
      PairOf("function step() if robot.id == 'fb' then\n"
             "robot.simple_radios.wifi.send({ 'hello', from = robot.id, nested = { 1.5, true } })\n"
             "robot.simple_radios.wifi.send({ second = vector2(1, 2) }) end end",
             "<simple_radios implementation='default'/>",
             "<simple_radios implementation='default'/>", "<simple_radio id='radios'/>",
             "<simple_radios><simple_radio id='wifi' medium='radios' range='3'/></simple_radios>"));
  CHECK(world.Get("#robot.simple_radios.wifi.recv") == "0");
  world.Step(2);
  CHECK(TakeLogErr() == "");
  CHECK(world.Get("#robot.simple_radios.wifi.recv") == "0");
  REQUIRE(world.Get("#robot.simple_radios.wifi.recv", "other") == "2");
  const std::string first = "robot.simple_radios.wifi.recv[1]";
  CHECK(world.Get(first + "[1]", "other") == "hello");
  CHECK(world.Get(first + ".from", "other") == "fb");
  CHECK(world.Get(first + ".nested[1]", "other") == "1.5");
  CHECK(world.Get(first + ".nested[2]", "other") == "true");
  CHECK(world.Get("robot.simple_radios.wifi.recv[2].second.y", "other") == "2.0");
  world.Do("function step() end");
  world.Step(2);
  CHECK(world.Get("#robot.simple_radios.wifi.recv", "other") == "0");
  CHECK_THAT(ErrorOf(world, "robot.simple_radios.wifi.send('text')"),
             Contains("must be a table, got"));
  CHECK_THAT(ErrorOf(world, "robot.simple_radios.wifi.send({}, {})"),
             Contains("too many arguments"));
}

TEST_CASE("lua devices: RFID tags can be read and written", "[lua][devices]") {
  SLuaExperiment experiment =
      PairOf("function step() if robot.id == 'other' then robot.rfid.write({ 3, 4 }, 2) end end",
             "<rfid implementation='medium' medium='rfid'/>",
             "<rfid implementation='medium' medium='rfid' range='0.2'/>", "<rfid id='rfid'/>");
  experiment.Arena =
      "<rfid_tag id='t' position='1,0.05,0' medium='rfid' memory='3' data='9'/>"
      "<rfid_tag id='far' position='1,0.15,0' medium='rfid' memory='1'/>";
  CLuaWorld world(experiment);
  CHECK(world.Get("#robot.rfid") == "0");
  world.Step(2);
  CHECK(TakeLogErr() == "");
  CHECK(world.Get("#robot.rfid") == "0");
  CHECK(world.Get("robot.rfid.written()") == "");
  REQUIRE(world.Get("#robot.rfid", "other") == "2");
  CHECK(world.Get("robot.rfid[1].id", "other") == "t");
  CHECK(world.Get("table.concat(robot.rfid[1].data, ' ')", "other") == "9.0 3.0 4.0");
  CHECK(world.Get("robot.rfid.written()", "other") == "t");
  // "other" faces along y
  CHECK_THAT(GetNumber(world, "robot.rfid[1].distance", "other"), WithinAbs(5.0, kRounding));
  CHECK_THAT(GetNumber(world, "robot.rfid[1].angle", "other"), WithinAbs(0.0, kRounding));
  CHECK_THAT(ErrorOf(world, "robot.rfid.write({ 1 }, 0)"), Contains("from 1 on, got 0"));
  CHECK_THAT(ErrorOf(world, "robot.rfid.write({ 256 })"), Contains("from 0 to 255"));
  CHECK_THAT(ErrorOf(world, "robot.rfid.write('text')"), Contains("a table"));
}

TEST_CASE("lua devices: pheromones can be deposited and read", "[lua][devices]") {
  CLuaWorld world(
      PairOf("function step() robot.pheromone.food.set_rate(robot.id == 'fb' and 2 or 0) end",
             "<pheromone implementation='medium' medium='p'/>",
             "<pheromone implementation='medium' medium='p' layers='food'><point offset='0,0'/>"
             "<point offset='0.05,0.02'/></pheromone>",
             "<pheromone id='p' cell_size='0.1' size='3,3' center='0.05,0.05'><layer id='food'/>"
             "<layer id='home'/></pheromone>"));
  // offsets are available from the start
  CHECK(world.Get("#robot.pheromone.food") == "2");
  CHECK_THAT(GetNumber(world, "robot.pheromone.food[2].offset.x"), WithinAbs(5.0, kRounding));
  CHECK_THAT(GetNumber(world, "robot.pheromone.food[2].offset.y"), WithinAbs(2.0, kRounding));
  world.Step(3);
  CHECK(TakeLogErr() == "");
  // "fb" is in the centre of a cell of 0.01 m^2 and has deposited 2/s for two ticks of 0.1 s
  CHECK_THAT(GetNumber(world, "robot.pheromone.food[1].value"), WithinAbs(40.0, 1e-10));
  // half a cell ahead and a fifth of a cell to the left
  CHECK_THAT(GetNumber(world, "robot.pheromone.food[2].value"), WithinAbs(40.0 * 0.5 * 0.8, 1e-10));
  CHECK(GetNumber(world, "robot.pheromone.food[1].value", "other") == 0.0);
  // a layer of the actuator alone has no readings
  CHECK(world.Get("#robot.pheromone.home") == "0");
  world.Do("robot.pheromone.home.set_rate(1) function step() end");
  world.Step(2);
  CHECK_THAT(GetNumber(world, "robot.pheromone.food[1].value"), WithinAbs(80.0, 1e-10));
  CHECK_THAT(ErrorOf(world, "robot.pheromone.food.set_rate(-1)"),
             Contains("\"food\" must be a number >= 0") && Contains("got -1"));
  CHECK_THAT(ErrorOf(world, "robot.pheromone.food.set_rate('a lot')"), Contains("number"));
  CHECK_THAT(ErrorOf(world, "robot.pheromone.food.set_rate(0 / 0)"), Contains(">= 0"));
}

}  // namespace lua_comms_test
