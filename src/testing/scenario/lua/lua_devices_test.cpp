// Devices in Lua: readings and orders.

#include "lua_world.h"

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace lua_devices_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

// tolerance of a few roundings of numbers of about 10
constexpr Real kRounding = 1e-12;

/** A sensor like those of plug-ins for ARGoS 3: it counts its updates, and is disabled at first. */
class CUserCounter : public CSimulatedSensor, public CCI_Sensor {
 public:
  void SetRobot(CComposableEntity&) override {}
  void Update() override { ++m_count; }

  void CreateLuaState(lua_State* state) override {
    CLuaUtility::OpenRobotStateTable(state, "counter");
    CLuaUtility::AddToTable(state, "_instance", this);
    CLuaUtility::AddToTable(state, "enable", &EnableFromLua);
    CLuaUtility::AddToTable(state, "count", Real(m_count));
    CLuaUtility::CloseRobotStateTable(state);
  }
  void ReadingsToLuaState(lua_State* state) override {
    lua_getfield(state, -1, "counter");
    lua_pushnumber(state, m_count);
    lua_setfield(state, -2, "count");
    lua_pop(state, 1);
  }
  static int EnableFromLua(lua_State* state) {
    CLuaUtility::GetDeviceInstance<CUserCounter>(state, "counter")->Enable();
    return 0;
  }

 private:
  int m_count = 0;
};

REGISTER_SENSOR(CUserCounter, "user_counter", "default", "a user", "1.0", "Counts its updates.",
                "Has no attributes.", "Usable")

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

TEST_CASE("lua devices: wheel speeds are ordered and read in cm", "[lua][devices]") {
  CLuaWorld world(WithDevices("robot.wheels.set_velocity(12, -3)", Device("differential_steering"),
                              Device("differential_steering")));
  // initial values, before the first reading
  CHECK(GetNumber(world, "robot.wheels.velocity_left") == 0.0);
  CHECK_THAT(GetNumber(world, "robot.wheels.axis_length"), WithinAbs(14.0, kRounding));
  world.Step();
  CHECK(GetNumber(world, "robot.wheels.velocity_left") == 0.0);
  world.Step();
  CHECK_THAT(GetNumber(world, "robot.wheels.velocity_left"), WithinAbs(12.0, kRounding));
  CHECK_THAT(GetNumber(world, "robot.wheels.velocity_right"), WithinAbs(-3.0, kRounding));
  CHECK_THAT(GetNumber(world, "robot.wheels.distance_left"), WithinAbs(1.2, kRounding));
  CHECK_THAT(GetNumber(world, "robot.wheels.distance_right"), WithinAbs(-0.3, kRounding));
  // reset() reads the values after the reset
  world.Do("function reset() seen = robot.wheels.velocity_left end");
  world.GetSimulator().Reset();
  CHECK(GetNumber(world, "seen") == 0.0);
}

TEST_CASE("lua devices: the wheels' table is complete with actuator or sensor alone",
          "[lua][devices]") {
  CLuaWorld sensor(WithDevices("", "", Device("differential_steering")));
  CHECK(sensor.Get("robot.wheels.set_velocity") == "nil");
  CHECK(sensor.Get("robot.wheels.distance_left") == "0.0");
  CLuaWorld actuator(WithDevices("", Device("differential_steering"), ""));
  CHECK(actuator.Get("type(robot.wheels.set_velocity)") == "function");
  CHECK(actuator.Get("robot.wheels.distance_left") == "nil");
}

namespace {

// A foot-bot with a sensor, and a wall with its face 5 cm ahead of the ring.
SLuaExperiment BesideWall(const std::string& sensor) {
  SLuaExperiment experiment = WithDevices("", "", Device(sensor));
  experiment.Arena = "<box id='wall' size='0.1,4,0.5' movable='false'><body position='" +
                     ToText(kFootBotRadius + 0.1) + ",0,0'/></box>";
  return experiment;
}

}  // namespace

TEST_CASE("lua devices: the proximity ring of a foot-bot has angles and values", "[lua][devices]") {
  CLuaWorld world(BesideWall("footbot_proximity"));
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
    // rays that hit the wall point ahead; the ring's radius is that of the body, the range 0.1 m
    const Real distance = (kFootBotRadius + 0.05) / std::cos(angle) - kFootBotRadius;
    const bool hits = std::cos(angle) > 0.0 && distance < 0.1;
    const Real value = hits ? 0.0100527 / (distance + 0.000163144) : 0.0;
    CHECK_THAT(GetNumber(world, entry + ".value"), WithinAbs(value, 1e-9));
  }
  // records are updated in place
  CHECK(world.Get("first.value > 0.1") == "true");
  CHECK(world.Get("first == robot.proximity[1]") == "true");
}

TEST_CASE("lua devices: the proximity sensors of an e-puck have angles and values",
          "[lua][devices]") {
  // a wall with its face 2 cm ahead of the e-puck's rim
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
  CLuaWorld world(BesideWall("proximity"));
  CHECK(world.Get("#robot.proximity") == "24");
  CHECK(world.Get("robot.proximity[1]") == "0.0");
  world.Step();
  // the first ray points 7.5 degrees to the left: the reading is exp(-distance)
  const Real distance =
      (kFootBotRadius + 0.05) / std::cos(7.5 * CRadians::PI.GetValue() / 180.0) - kFootBotRadius;
  CHECK_THAT(GetNumber(world, "robot.proximity[1]"), WithinAbs(std::exp(-distance), 1e-9));
  CHECK_THAT(GetNumber(world, "robot.proximity[24]"), WithinAbs(std::exp(-distance), 1e-9));
  CHECK(GetNumber(world, "robot.proximity[13]") == 0.0);
}

TEST_CASE("lua devices: LEDs are numbered from 1 and take names, texts and numbers as colours",
          "[lua][devices]") {
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

TEST_CASE("lua devices: an eye-bot has 33 LEDs", "[lua][devices]") {
  SLuaExperiment experiment = WithDevices("", Device("leds", "medium='leds'"), "");
  experiment.Robots = "<eye-bot id='fb'><body position='0,0,0'/><controller config='c'/></eye-bot>";
  experiment.Engines = "<pointmass3d id='air'/>";
  CLuaWorld world(experiment);
  world.Do("robot.leds.set_single_color(33, 'red')");
  CHECK_THAT(world.Get("select(2, pcall(robot.leds.set_single_color, 34, 'red'))"),
             Contains("from 1 to 33, got 34"));
}

TEST_CASE("lua devices: a user's sensor with its own Lua functions works",
          "[lua][devices][compat]") {
  CLuaWorld world(WithDevices("robot.counter.enable() seen = robot.counter.count", "",
                              Device("user_counter") + Device("footbot_proximity")));
  CHECK(world.Get("robot.counter.count") == "0.0");
  // it is updated from the first tick on, whether or not it was enabled
  world.Step();
  CHECK(world.Get("seen") == "1.0");
  world.Step(3);
  CHECK(TakeLogErr() == "");
  CHECK(world.Get("seen") == "4.0");
}

TEST_CASE("lua devices: two sensors that write to one table are fatal", "[lua][devices]") {
  CHECK_THAT(LoadError(WithDevices("", "", Device("proximity") + Device("footbot_proximity"))),
             Contains("the sensors <footbot_proximity> and <proximity> would both write into the "
                      "Lua table robot.proximity; use one of them"));
}

TEST_CASE("lua devices: a script that overwrites its tables causes at most an error",
          "[lua][devices]") {
  CLuaWorld world(WithDevices("robot.proximity = nil robot.wheels.set_velocity(1, 1) robot = nil",
                              Device("differential_steering"), Device("footbot_proximity")));
  world.Step(2);
  CHECK_THAT(TakeLogErr(), Contains("attempt to index a nil value (global 'robot')"));
  world.Step(3);
  // 1 cm/s for 4 ticks, less the tenth of a tick in which the order does not act yet
  CHECK_THAT(world.GetAnchor().Position.GetX(), WithinAbs(0.0039, 1e-9));
}

TEST_CASE("lua devices: propellers take positions in metres and yaws in degrees",
          "[lua][devices]") {
  const auto eyeBot = [](const std::string& actuator, const std::string& sensors) {
    SLuaExperiment experiment = WithDevices("", Device(actuator), sensors);
    experiment.Robots =
        "<eye-bot id='fb'><body position='0,0,0' orientation='90,0,0'/><controller config='c'/>"
        "</eye-bot>";
    experiment.Engines = "<pointmass3d id='air'/>";
    return experiment;
  };
  CLuaWorld places(eyeBot("quadrotor_position", ""));
  places.Do("robot.quadrotor.set_absolute_position(0.5, -0.25, 0.1)");
  places.Do("robot.quadrotor.set_absolute_yaw(45)");
  // the control loops leave e^-16 of the path and e^-30 of the rotation
  places.Step(60);
  CHECK_THAT(Distance(places.GetAnchor().Position, CVector3(0.5, -0.25, 0.1)),
             WithinAbs(0.0, 1e-5));
  const CQuaternion turned(CRadians::PI_OVER_FOUR, CVector3::Z);
  CHECK_THAT(places.GetAnchor().Orientation.GetZ(), WithinAbs(turned.GetZ(), 1e-9));
  // ahead in the present orientation
  places.Do("robot.quadrotor.set_relative_position(0.2, 0, 0)");
  places.Do("robot.quadrotor.set_relative_yaw(-45)");
  places.Step(60);
  const Real diagonal = 0.2 * std::sqrt(0.5);
  CHECK_THAT(Distance(places.GetAnchor().Position, CVector3(0.5 + diagonal, -0.25 + diagonal, 0.1)),
             WithinAbs(0.0, 2e-5));
  CHECK_THAT(places.GetAnchor().Orientation.GetZ(), WithinAbs(0.0, 1e-9));
  CHECK(places.Get("robot.quadrotor.set_linear_velocity") == "nil");
  CHECK_THROWS_WITH(places.Do("robot.quadrotor.set_absolute_position(1, 2)"),
                    Contains("robot.quadrotor.set_absolute_position: argument 3 must be a number"));

  CLuaWorld speeds(eyeBot("quadrotor_speed", ""));
  speeds.Do("robot.quadrotor.set_linear_velocity(0.2, -0.1, 0.05)");
  speeds.Do("robot.quadrotor.set_rotational_speed(0.3)");
  speeds.Step(60);
  const CVector3 before = speeds.GetAnchor().Position;
  const Real half = std::asin(speeds.GetAnchor().Orientation.GetZ());
  speeds.Step(1);
  // along the axes of the world, although the robot faces along y
  CHECK_THAT(Distance(speeds.GetAnchor().Position, before + CVector3(0.02, -0.01, 0.005)),
             WithinAbs(0.0, kRounding));
  CHECK_THAT(2.0 * (std::asin(speeds.GetAnchor().Orientation.GetZ()) - half),
             WithinAbs(0.03, 1e-9));
}

TEST_CASE("lua devices: the rings of an eye-bot have angles and values", "[lua][devices]") {
  SLuaExperiment experiment = WithDevices(
      "", "", Device("eyebot_proximity") + "<eyebot_light implementation='rot_z_only'/>");
  experiment.Robots = "<eye-bot id='fb'><body position='0,0,0'/><controller config='c'/></eye-bot>";
  experiment.Engines = "<pointmass3d id='air'/>";
  experiment.Arena =
      "<box id='wall' size='0.2,8,1' movable='false'><body position='2,0,0'/></box>"
      "<light id='l' position='0,1,0' intensity='1' color='yellow' medium='leds'/>";
  CLuaWorld world(experiment);
  world.Step();
  CHECK(world.Get("#robot.proximity") == "24");
  CHECK(world.Get("#robot.light") == "24");
  const Real angle = 7.5 / 180.0 * ARGOS_PI;
  CHECK_THAT(GetNumber(world, "robot.proximity[1].angle"), WithinAbs(angle, kRounding));
  CHECK_THAT(GetNumber(world, "robot.light[24].angle"), WithinAbs(-angle, kRounding));
  const Real distance = 1.9 / std::cos(angle) - 0.255;
  CHECK_THAT(GetNumber(world, "robot.proximity[1].value"),
             WithinAbs(0.0100527 / (distance + 0.000163144), kRounding));
  // sensor 6 is at 82.5 degrees, 7.5 off the light, which is 1 m away: e^-2 (1 - 2 * 7.5 / 180)
  CHECK_THAT(GetNumber(world, "robot.light[6].value"),
             WithinAbs(std::exp(-2.0) * (1.0 - 15.0 / 180.0), kRounding));
}

TEST_CASE("lua devices: the gripper holds a load, and the turret turns by whole turns per minute",
          "[lua][devices]") {
  SLuaExperiment experiment = WithDevices(
      "", Device("footbot_gripper") + Device("footbot_turret") + Device("differential_steering"),
      Device("footbot_turret_encoder"));
  experiment.Arena =
      "<cylinder id='load' radius='0.1' height='0.1' movable='true' mass='1'>"
      "<body position='0.19,0,0'/></cylinder>";
  CLuaWorld world(experiment);
  CHECK(world.Get("robot.turret.rotation") == "0.0");
  // without a load the turret follows its motor: 2 turns per minute, 12 degrees per second
  world.Do("robot.turret.set_speed_control_mode() robot.turret.set_rotation_speed(2.9)");
  world.Step(10);
  CHECK_THAT(GetNumber(world, "robot.turret.rotation"), WithinAbs(ARGOS_PI / 15.0, 1e-12));
  world.Do("robot.turret.set_rotation_speed(-2.9)");
  world.Step(10);
  CHECK_THAT(GetNumber(world, "robot.turret.rotation"), WithinAbs(0.0, 1e-12));
  world.Do("robot.turret.set_passive_mode() robot.turret.set_rotation(1)");
  world.Step(10);
  CHECK_THAT(GetNumber(world, "robot.turret.rotation"), WithinAbs(0.0, 1e-12));
  // locked in either direction, it pulls the load along
  const std::string lock = GENERATE(as<std::string>(), "lock_positive", "lock_negative");
  world.Do("robot.gripper." + lock + "() robot.wheels.set_velocity(-10, -10)");
  world.Step(11);
  const auto load = [&world] {
    return world.World()
        .Get<CComposableEntity>("load")
        .GetComponent<CEmbodiedEntity>("body")
        .GetOriginAnchor()
        .Position.GetX();
  };
  // the friction of the load, 1.49 N, stretches the grip by 0.15 mm
  CHECK_THAT(world.GetAnchor().Position.GetX(), WithinAbs(-0.109, 1e-3));
  CHECK_THAT(load(), WithinAbs(0.19 - 0.109, 2e-3));
  world.Do("robot.gripper.unlock()");
  world.Step(3);
  const Real there = load();
  world.Step(5);
  CHECK_THAT(load(), WithinAbs(there, 1e-6));
  world.Do("robot.turret.set_position_control_mode()");
  world.Step(400);
  CHECK_THAT(GetNumber(world, "robot.turret.rotation"), WithinAbs(1.0, 1e-4));
  CHECK(TakeLogErr() == "");
}

}  // namespace lua_devices_test
