// Every device in Lua: names, structure and arguments as published with ARGoS 3.

#include "lua_world.h"

#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/device_list.h>

#include <catch2/catch.hpp>

#include <array>

namespace lua_device_list_test {

using namespace argos;
using Catch::Contains;

namespace {

struct SWrongCall {
  std::string Arguments;
  std::string Message;
};

struct SFunction {
  std::string Name;
  std::vector<std::string> Arguments; /**< of valid calls */
  std::vector<SWrongCall> Wrong;
};

/** The interface of a device in Lua. */
struct SLuaDevice {
  std::string Section, Tag;
  std::string Table; /**< name in `robot` */
  /**
   * Content of the table in the notation of kShapeOf: functions "f()", lists "[length]" followed by
   * their elements, fields "{a b}" in alphabetical order, and the types of values other than
   * numbers. "[N]" is a list whose length depends on the robot.
   */
  std::string Shape;
  std::vector<SFunction> Functions = {};
  std::array<int, 3> N = {}; /**< foot-bot, e-puck, eye-bot */
  std::string Prepare = ""; /**< statements before the first step */
  std::string Beside = ""; /**< tag of an actuator that the sensor needs */
};

// numbers must be floats, like all numbers of devices
const char* const kShapeOf = R"(
function shape_of(value)
  local kind = math.type(value) or type(value)
  if kind == 'float' then return '' end
  if kind == 'function' then return '()' end
  if kind == 'userdata' then
    if pcall(function() return value.w end) then return ':quaternion' end
    return pcall(function() return value.z end) and ':vector3' or ':vector2'
  end
  if kind ~= 'table' then return ':' .. kind end
  local shape, names = '', {}
  for i = 1, #value do
    local each = shape_of(value[i])
    shape = shape == '' and '[' .. #value .. ']' .. each or shape
    if shape ~= '[' .. #value .. ']' .. each then return ':mixed' end
  end
  for key in pairs(value) do
    if math.type(key) ~= 'integer' then names[#names + 1] = key end
  end
  if shape == '' and #names == 0 then return '[0]' end
  if #names == 0 then return shape end
  table.sort(names)
  for i, name in ipairs(names) do names[i] = name .. shape_of(value[name]) end
  return shape .. '{' .. table.concat(names, ' ') .. '}'
end
)";

const SWrongCall kOneTooMany = {"1", "too many arguments"};

std::vector<SFunction> WithoutArguments(const std::vector<std::string>& names) {
  std::vector<SFunction> functions;
  for (const std::string& name : names) {
    functions.push_back({name, {""}, {kOneTooMany}});
  }
  return functions;
}

SFunction TakesNumber(const std::string& name) {
  return {name,
          {"1.5", "-2"},
          {{"'1'", "argument 1 must be a number, got string \"1\""},
           {"", "argument 1 must be a number, got nothing"},
           {"1, 2", "too many arguments"}}};
}

SFunction TakesBoolean(const std::string& name) {
  return {name,
          {"true", "false"},
          {{"1", "argument 1 must be true or false, got 1"}, {"true, 1", "too many arguments"}}};
}

SFunction TakesPlace(const std::string& name) {
  return {name,
          {"1, -2, 0.5"},
          {{"1, 2", "argument 3 must be a number, got nothing"},
           {"vector3(1, 2, 3)", "argument 1 must be a number, got"}}};
}

SFunction TakesColor(const std::string& name) {
  return {name,
          {"'red'", "1, 2, 3", "'1,2,3,4'"},
          {{"true", "argument 1 must be the name of a color"},
           {"'no such color'", "no such color"},
           {"1, 2, 256", "argument 3 must be a whole number"}}};
}

const SFunction kSingleColor = {"set_single_color",
                                {"1, 'red'", "2, 1, 2, 3", "1, '1,2,3,4'"},
                                {{"0, 'red'", "argument 1 must be a whole number from 1 to"},
                                 {"100, 'red'", "argument 1 must be a whole number from 1 to"},
                                 {"'one', 'red'", "argument 1 must be a"},
                                 {"1, {}", "argument 2 must be the name of a color"}}};

std::vector<SFunction> Plus(std::vector<SFunction> functions, const SFunction& more) {
  functions.push_back(more);
  return functions;
}

const std::string kBlobs = "{blue green red}";

std::vector<SLuaDevice> LuaActuators() {
  const std::vector<SFunction> wheels = {
      {"set_velocity",
       {"10, -2.5"},
       {{"'fast', 1", "argument 1 must be a number, got string \"fast\""},
        {"1, nil", "argument 2 must be a number, got nil"},
        {"1, 2, 3", "too many arguments"}}}};
  return {
      {"actuators", "differential_steering", "wheels", "{set_velocity()}", wheels},
      {"actuators",
       "leds",
       "leds",
       "{set_all_colors() set_single_color()}",
       {kSingleColor, TakesColor("set_all_colors")}},
      {"actuators",
       "directional_leds",
       "directional_leds",
       "{set_all_colors() set_single_color()}",
       {kSingleColor, TakesColor("set_all_colors")}},
      {"actuators", "range_and_bearing", "range_and_bearing", "{clear_data() set_data()}",
       Plus(WithoutArguments({"clear_data"}),
            {"set_data",
             {"1, 255", "3, 0", "{1, 2, 3}"},
             {{"4, 1", "argument 1 must be a whole number from 1 to 3, got 4"},
              {"1, 256", "argument 2 must be a whole number"},
              {"{1, 2, 3, 4}", "argument 1 must be a table of 3 whole numbers"},
              {"{1, 2, 256}", "argument 1 must be a table of 3 whole numbers"},
              {"'abc'", "argument 1 must be a"}}})},
      {"actuators", "footbot_gripper", "gripper", "{lock_negative() lock_positive() unlock()}",
       WithoutArguments({"lock_negative", "lock_positive", "unlock"})},
      {"actuators", "gripper", "gripper", "{lock() unlock()}",
       WithoutArguments({"lock", "unlock"})},
      {"actuators", "footbot_turret", "turret",
       "{set_passive_mode() set_position_control_mode() set_rotation() set_rotation_speed() "
       "set_speed_control_mode()}",
       Plus(Plus(WithoutArguments(
                     {"set_passive_mode", "set_position_control_mode", "set_speed_control_mode"}),
                 TakesNumber("set_rotation")),
            TakesNumber("set_rotation_speed"))},
      {"actuators", "footbot_distance_scanner", "distance_scanner",
       "{disable() enable() set_angle() set_rpm()}",
       Plus(Plus(WithoutArguments({"disable", "enable"}), TakesNumber("set_angle")),
            TakesNumber("set_rpm"))},
      {"actuators",
       "quadrotor_position",
       "quadrotor",
       "{set_absolute_position() set_absolute_yaw() set_relative_position() set_relative_yaw()}",
       {TakesPlace("set_absolute_position"), TakesPlace("set_relative_position"),
        TakesNumber("set_absolute_yaw"), TakesNumber("set_relative_yaw")}},
      {"actuators",
       "quadrotor_speed",
       "quadrotor",
       "{set_linear_velocity() set_rotational_speed()}",
       {TakesPlace("set_linear_velocity"), TakesNumber("set_rotational_speed")}},
      {"actuators", "ceiling_attachment", "ceiling", "{attach() detach() is_attached()}",
       WithoutArguments({"attach", "detach", "is_attached"})},
      {"actuators",
       "simple_radios",
       "simple_radios",
       "{wifi{send()}}",
       {{"wifi.send",
         {"{}", "{ 'text', nested = { true, vector2(1, 2) } }"},
         {{"'text'", "argument 1 must be a table, got string \"text\""},
          {"{}, {}", "too many arguments"}}}}},
      {"actuators",
       "tags",
       "tags",
       "{set_all_payloads() set_single_payload()}",
       {{"set_all_payloads", {"'text'"}, {{"12", "argument 1 must be a string, got 12"}}},
        {"set_single_payload",
         {"2, 'text'"},
         {{"3, 'text'", "argument 1 must be a whole number from 1 to 2, got 3"},
          {"1", "argument 2 must be a string, got nothing"}}}}},
      {"actuators",
       "magnets",
       "magnets",
       "{front{set_current()}}",
       {TakesNumber("front.set_current")}},
      {"actuators",
       "pan_tilt_camera",
       "pan_tilt_camera",
       "{set_pan() set_tilt()}",
       {TakesNumber("set_pan"), TakesNumber("set_tilt")}},
      {"actuators",
       "pheromone",
       "pheromone",
       "{trail{set_rate()}}",
       {{"trail.set_rate",
         {"1.5", "0"},
         {{"'1'", "argument 1 must be a number, got string \"1\""},
          {"-1", "must be a number >= 0 (amount per second), got -1"},
          {"1, 2", "too many arguments"}}}}},
      {"actuators", "rfid", "rfid", "{write() written()}",
       Plus(WithoutArguments({"written"}),
            {"write",
             {"{1, 2}", "{255}, 2", "{}"},
             {{"'text'", "argument 1 must be a table of"},
              {"{256}", "argument 1 must be a table of 1 whole numbers from 0 to 255"},
              {"{1}, 0", "argument 2 must be a whole number from 1 on, got 0"},
              {"{1}, 1, 1", "too many arguments"}}})},
      {"actuators",
       "pipuck_differential_drive",
       "differential_drive",
       "{set_linear_velocity()}",
       {{"set_linear_velocity",
         {"0.1, -0.05"},
         {{"'fast', 1", "argument 1 must be a number, got string \"fast\""},
          {"1", "argument 2 must be a number, got nothing"},
          {"1, 2, 3", "too many arguments"}}}}},
      {"actuators",
       "pipuck_leds",
       "leds",
       "{set_body_led() set_front_led() set_ring_led_index() set_ring_leds()}",
       {TakesBoolean("set_body_led"),
        TakesBoolean("set_front_led"),
        TakesBoolean("set_ring_leds"),
        {"set_ring_led_index",
         {"1, true", "8, false"},
         {{"0, true", "argument 1 must be a whole number from 1 to 8, got 0"},
          {"9, true", "argument 1 must be a whole number from 1 to 8, got 9"},
          {"1", "argument 2 must be true or false, got nothing"}}}}}};
}

std::vector<SLuaDevice> LuaSensors() {
  const std::string omnidirectional = "colored_blob_omnidirectional_camera";
  const std::string perspective = "colored_blob_perspective_camera";
  const std::vector<SFunction> onAndOff = WithoutArguments({"enable", "disable"});
  const std::string ring = "[N]{angle value}";
  const std::string transform = "transform{anchor:string orientation:quaternion position:vector3}";
  const std::array<int, 3> kOfRing = {24, 8, 24};
  return {
      {"sensors", "differential_steering", "wheels",
       "{axis_length distance_left distance_right velocity_left velocity_right}"},
      {"sensors", "proximity", "proximity", "[N]", {}, kOfRing},
      {"sensors", "footbot_proximity", "proximity", ring, {}, kOfRing},
      {"sensors", "eyebot_proximity", "proximity", ring, {}, kOfRing},
      {"sensors", "epuck_proximity", "proximity", ring, {}, kOfRing},
      {"sensors", "light", "light", "[N]", {}, kOfRing},
      {"sensors", "footbot_light", "light", ring, {}, kOfRing},
      {"sensors", "eyebot_light", "light", ring, {}, kOfRing},
      {"sensors", "ground", "ground", "[N]", {}, {12, 3, 0}},
      {"sensors", "footbot_motor_ground", "motor_ground", "[4]{offset:vector2 value}"},
      {"sensors", "footbot_base_ground", "base_ground", "[8]{offset:vector2 value}"},
      // two lights near the foot-bot are in the area of its camera
      {"sensors",
       omnidirectional,
       omnidirectional,
       "[2]{angle color" + kBlobs + " distance}{disable() enable()}",
       onAndOff,
       {},
       "robot." + omnidirectional + ".enable()"},
      // the foot-bot sees two lights ahead, the eye-bot one light below
      {"sensors",
       perspective,
       perspective,
       "[N]{color" + kBlobs + " x y}{disable() enable()}",
       onAndOff,
       {2, 0, 1},
       "robot." + perspective + ".enable()"},
      {"sensors", "range_and_bearing", "range_and_bearing",
       "[1]{data[3] horizontal_bearing range vertical_bearing}"},
      {"sensors",
       "footbot_distance_scanner",
       "distance_scanner",
       "{disable() enable() long_range[2]{angle distance} set_angle() set_rpm() "
       "short_range[2]{angle distance}}",
       {},
       {},
       "robot.distance_scanner.enable()",
       "footbot_distance_scanner"},
      {"sensors", "footbot_turret_encoder", "turret", "{rotation}"},
      {"sensors", "battery", "battery", "{available_charge time_left}"},
      {"sensors", "positioning", "positioning", "{orientation:quaternion position:vector3}"},
      {"sensors", "simple_radios", "simple_radios", "{wifi{recv[1]{number text:string}}}"},
      {"sensors", "cameras", "cameras",
       "{front{directional_led_detector[1]{center:vector2 color" + kBlobs +
           "} led_detector[1]{center:vector2 color" + kBlobs +
           "} tag_detector[1]{center:vector2 corners[4]:vector2 payload:string}}}"},
      {"sensors", "pheromone", "pheromone", "{trail[1]{offset:vector2 value}}"},
      {"sensors", "rfid", "rfid", "[1]{angle data[2] distance id:string}"},
      {"sensors", "altitude", "altitude", "{height}"},
      {"sensors", "clock", "clock", "{tick time}"},
      {"sensors", "footbot_encoder", "encoder", "{axis_length distance_left distance_right}"},
      {"sensors", "pipuck_differential_drive", "differential_drive", "{encoders{left right}}"},
      {"sensors", "pipuck_front_camera", "front_camera",
       "{detect_led() disable() enable() resolution:vector2 tags[0] timestamp " + transform + "}",
       Plus(onAndOff,
            {"detect_led", {"vector3(0, 0, 0.1)"}, {{"1", "argument 1 must be a vector3"}}})},
      {"sensors", "pipuck_ground", "ground_sensors", "[3]{background reflected " + transform + "}"},
      {"sensors", "pipuck_imu", "imu",
       "{accelerometer:vector3 gyroscope:vector3 magnetometer:vector3}"},
      {"sensors", "pipuck_rangefinders", "rangefinders",
       "[8]{illuminance proximity " + transform + "}"},
      {"sensors", "pipuck_system", "system", "{temperature time}"}};
}

const SLuaDevice& LuaDeviceOf(const SListedDevice& device) {
  static const std::vector<SLuaDevice> devices = [] {
    std::vector<SLuaDevice> all = LuaActuators();
    const std::vector<SLuaDevice> sensors = LuaSensors();
    all.insert(all.end(), sensors.begin(), sensors.end());
    return all;
  }();
  for (const SLuaDevice& lua : devices) {
    if (lua.Section == device.Section && lua.Tag == device.Tag) {
      return lua;
    }
  }
  throw std::runtime_error("the list of devices in Lua lacks " + device.Label());
}

/** A robot "fb" with one device, and objects and robots that it can sense or communicate with. */
class CDeviceWorld {
 public:
  CDeviceWorld(const SListedDevice& device, const std::string& robot) {
    const SLuaDevice& lua = LuaDeviceOf(device);
    SLuaExperiment experiment;
    experiment.Script = std::string(kShapeOf) + "function init() shape_at_init = shape_of(robot." +
                        lua.Table +
                        ") end function step() end function reset() end function destroy() end\n";
    experiment.Actuators =
        lua.Beside.empty() ? "" : "<" + lua.Beside + " implementation='default'/>";
    (device.Section == "sensors" ? experiment.Sensors : experiment.Actuators) += device.ToXml();
    experiment.Engines = "<pointmass3d id='engine'/>";
    experiment.Media = MediaForDevices();
    // eye-bots start 40 cm higher, so that their cameras see the upper tags and lights
    experiment.Robots =
        RobotForDevices(robot, "fb", robot == "eye-bot" ? "0,0,0.4" : "0,0,0", "c") +
        RobotForDevices("foot-bot", "other", "0.6,0.1,0", "other");
    experiment.Arena = Lamp("near", "0.4,0.1,0.1") + Lamp("ahead", "1,0.1,0.174249733") +
                       Lamp("below", "0.1,0.05,0.05") + Lamp("high", "0.5,0.05,0.7") +
                       "<rfid_tag id='tag' position='0.2,0,0.2' medium='rfid' memory='2'/>"
                       "<floor id='floor' source='loop_functions' pixels_per_meter='1'/>";
    experiment.Controllers =
        "<lua_controller id='other'><actuators><range_and_bearing implementation='default'/>"
        "<simple_radios implementation='default'/></actuators><params script='" +
        m_folder.Write("other.lua",
                       "function init() end function reset() end function destroy() end\n"
                       "function step() robot.range_and_bearing.set_data({ 1, 2, 3 })\n"
                       "robot.simple_radios.wifi.send({ number = 1.5, text = 'x' }) end\n") +
        "'/></lua_controller>";
    m_world.emplace(experiment);
    m_world->Do(lua.Prepare);
  }

  CLuaWorld* operator->() { return &*m_world; }
  std::string ErrorOf(const std::string& call) {
    return m_world->Get("select(2, pcall(function() " + call + " end))");
  }

 private:
  static std::string Lamp(const std::string& id, const std::string& position) {
    return "<light id='" + id + "' position='" + position +
           "' color='red' intensity='1' medium='leds'/>";
  }

  CTemporaryFolder m_folder;
  std::optional<CLuaWorld> m_world;
};

// the structure with the numbers of the robot
std::string ShapeFor(const SLuaDevice& lua, const std::string& robot) {
  std::string shape = lua.Shape;
  const size_t at = shape.find("[N]");
  if (at != std::string::npos) {
    const size_t number = robot == "foot-bot" ? 0 : robot == "e-puck" ? 1 : 2;
    shape.replace(at, 3, "[" + std::to_string(lua.N.at(number)) + "]");
  }
  return shape;
}

template <typename TEST>
void ForEveryDevice(TEST test) {
  for (const SListedDevice& device : ListedDevices()) {
    for (const std::string& robot : ListedRobots()) {
      if (device.IsOf(robot)) {
        CAPTURE(device.Section, device.Label(), robot);
        test(device, LuaDeviceOf(device), robot);
      }
    }
  }
}

}  // namespace

TEST_CASE("lua device list: tables, functions and fields have the published names and types",
          "[lua][devices]") {
  ForEveryDevice([](const SListedDevice& device, const SLuaDevice& lua, const std::string& robot) {
    CDeviceWorld world(device, robot);
    // the table is complete in init(), except for lists that depend on other entities
    const bool dependsOnOthers = !lua.Prepare.empty() || lua.Shape.find("[1]") != std::string::npos;
    if (!dependsOnOthers) {
      CHECK(world->Get("shape_at_init") == ShapeFor(lua, robot));
    }
    world->Step(3);
    CHECK(TakeLogErr() == "");
    CHECK(world->Get("shape_of(robot." + lua.Table + ")") == ShapeFor(lua, robot));
    // robot contains nothing else, except for the entries that it always has
    world->Do(
        "names = {} for name in pairs(robot) do names[#names + 1] = name end "
        "table.sort(names)");
    std::vector<std::string> names = {"id", "params", "random", lua.Table};
    std::sort(names.begin(), names.end());
    std::string joined;
    for (const std::string& name : names) {
      joined += (joined.empty() ? "" : " ") + name;
    }
    CHECK(world->Get("table.concat(names, ' ')") == joined);
  });
}

TEST_CASE("lua device list: functions accept valid arguments and report invalid ones",
          "[lua][devices][error]") {
  ForEveryDevice([](const SListedDevice& device, const SLuaDevice& lua, const std::string& robot) {
    CDeviceWorld world(device, robot);
    for (const SFunction& function : lua.Functions) {
      const std::string name = "robot." + lua.Table + "." + function.Name;
      for (const std::string& arguments : function.Arguments) {
        CHECK_NOTHROW(world->Do(name + "(" + arguments + ")"));
      }
      for (const SWrongCall& wrong : function.Wrong) {
        CHECK_THAT(world.ErrorOf(name + "(" + wrong.Arguments + ")"),
                   Contains(name + ": ") && Contains(wrong.Message));
      }
    }
    world->Step(2);
    CHECK(TakeLogErr() == "");
  });
}

TEST_CASE("lua device list: an error on an argument names robot, script, function and argument",
          "[lua][devices][error]") {
  ForEveryDevice([](const SListedDevice& device, const SLuaDevice& lua, const std::string& robot) {
    for (const SFunction& function : lua.Functions) {
      CDeviceWorld world(device, robot);
      const std::string name = "robot." + lua.Table + "." + function.Name;
      const SWrongCall& wrong = function.Wrong.front();
      world->Do("function step() " + name + "(" + wrong.Arguments + ") end");
      world->Step();
      CHECK_THAT(TakeLogErr(), Contains("robot \"fb\": the Lua script \"") &&
                                   Contains("failed in step()\n") &&
                                   Contains(name + ": " + wrong.Message));
    }
  });
}

TEST_CASE("lua device list: actuator and sensor of a communication device share a table",
          "[lua][devices]") {
  // actuators and sensors that share a table
  const std::string tag =
      GENERATE(as<std::string>(), "differential_steering", "range_and_bearing", "simple_radios");
  CAPTURE(tag);
  SLuaExperiment experiment;
  experiment.Script = std::string(kShapeOf) + kIdleScript;
  for (const SListedDevice& device : ListedDevices()) {
    if (device.Tag == tag && device.Implementation != "dead_reckoning") {
      (device.Section == "sensors" ? experiment.Sensors : experiment.Actuators) = device.ToXml();
    }
  }
  experiment.Media = MediaForDevices();
  experiment.Robots = RobotForDevices("foot-bot", "fb", "0,0,0", "c");
  CLuaWorld world(experiment);
  const std::string expected =
      tag == "differential_steering"
          ? "{axis_length distance_left distance_right set_velocity() velocity_left velocity_right}"
      : tag == "range_and_bearing" ? "{clear_data() set_data()}"
                                   : "{wifi{recv[0] send()}}";
  const std::string table = tag == "differential_steering" ? "wheels" : tag;
  CHECK(world.Get("shape_of(robot." + table + ")") == expected);
}

}  // namespace lua_device_list_test
