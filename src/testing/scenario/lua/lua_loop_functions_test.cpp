// Loop functions written in Lua.

#include "lua_world.h"

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <thread>
#include <vector>

namespace lua_loop_functions_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

// tolerance of a few roundings of numbers of about 1
constexpr Real kRounding = 1e-12;

/** The log output of loop functions whose init() is the given code. */
std::string LogOf(const std::string& code, const std::string& arena = "") {
  TakeLog();
  CLuaWorld world(WithLoopFunctions("function init() " + code + " end", arena));
  return TakeScriptLog();
}

/** The error of loop functions whose init() is the given code. */
std::string ErrorOf(const std::string& code, const std::string& arena = "") {
  return LoadError(WithLoopFunctions("function init() " + code + " end", arena));
}

const std::string kBox =
    "<box id='box' size='0.2,0.2,0.2' movable='true' mass='1'><body position='2,0,0'/></box>";
const std::string kLight =
    "<light id='lamp' position='1,2,3' orientation='0,0,0' color='red' "
    "intensity='2.5' medium='leds'/>";

}  // namespace

TEST_CASE("lua loop functions: hooks are called in the documented order", "[lua][loop_functions]") {
  CLuaWorld world(WithLoopFunctions(
      "log('chunk')\n"
      "function init() log('init') end\n"
      "function pre_step() log('pre_step ', simulation.clock()) end\n"
      "function post_step() log('post_step ', simulation.clock()) end\n"
      "function reset() log('reset ', simulation.clock()) end\n"
      "function destroy() log('destroy') end\n"
      "function post_experiment() log('post_experiment') end\n"
      "function is_experiment_finished() log('finished?') return simulation.clock() == 2 end\n"));
  CHECK(TakeScriptLog() == "chunk init ");
  world.Step();
  CHECK(TakeScriptLog() == "pre_step 1 post_step 1 ");
  world.GetSimulator().Reset();
  CHECK(TakeScriptLog() == "reset 0 ");
  world.GetSimulator().Execute();
  CHECK(TakeScriptLog() ==
        "finished? pre_step 1 post_step 1 finished? pre_step 2 post_step 2 finished? "
        "post_experiment ");
  world.Destroy();
  CHECK(TakeScriptLog() == "destroy ");
}

TEST_CASE("lua loop functions: every hook is optional, but there must be one",
          "[lua][loop_functions]") {
  {
    CLuaWorld world(WithLoopFunctions("function pre_step() n = (n or 0) + 1 end"));
    world.Step(3);
    world.GetSimulator().Reset();
    CHECK_FALSE(world.GetSimulator().IsExperimentFinished());
    const CSimulator::CScope scope(world.GetSimulator());
    CHECK(world.GetSimulator().GetLoopFunctions().GetFloorColor(CVector2()) == CColor::WHITE);
  }
  CHECK_THAT(
      LoadError(WithLoopFunctions("function prestep() end")),
      Contains("define none of the functions that are called: init, reset, destroy, pre_step"));
}

TEST_CASE("lua loop functions: clock, experiment and arena can be read", "[lua][loop_functions]") {
  SLuaExperiment experiment = WithLoopFunctions(
      "function init()\n"
      "  log(simulation.tick_length, ' ', simulation.length, ' ', simulation.seed())\n"
      "  local a = simulation.arena\n"
      "  log(tostring(a.size), ' ', tostring(a.center), ' ', tostring(a.min), ' ', "
      "tostring(a.max))\n"
      "  log(simulation.params.items, ' ', type(simulation.params.items))\n"
      "end\n"
      "function post_step() log(simulation.clock(), ' ', simulation.time(), ' ',\n"
      "                         math.type(simulation.clock())) end");
  experiment.LoopParams = "items='20'";
  experiment.Seed = 17;
  CLuaWorld world(experiment);
  CHECK(TakeScriptLog() == "0.1 0 17 10,10,2 0,0,0 -5,-5,-1 5,5,1 20 string ");
  world.Step(3);
  CHECK(TakeScriptLog() == "1 0.1 integer 2 0.2 integer 3 0.3 integer ");
}

TEST_CASE("lua loop functions: entities can be found by type and by id", "[lua][loop_functions]") {
  CHECK(LogOf("log(table.concat(simulation.ids(), ' '))", kBox + kLight) == "fb box lamp ");
  CHECK(LogOf("log(table.concat(simulation.ids('box'), ' '))", kBox + kLight) == "box ");
  CHECK(LogOf("log(#simulation.ids('cylinder'), #simulation.entities('foot-bot'))") == "01 ");
  CHECK(
      LogOf("for _, e in ipairs(simulation.entities()) do\n"
            "  log(e.id, ' ', e.type, ' ', tostring(e.position), ' ', tostring(e.orientation)) end",
            kBox + kLight) ==
      "fb foot-bot 0,0,0 0,0,0 box box 2,0,0 0,0,0 lamp light 1,2,3 0,0,0 ");
  // a floor has no position
  CHECK(LogOf("local e = simulation.entity('f') log(e.id, ' ', e.type, ' ', e.position)",
              "<floor id='f' source='loop_functions' pixels_per_meter='10'/>") == "f floor nil ");
  CHECK(LogOf("log(simulation.entity('nobody'), ' ', simulation.entity('box').id)", kBox) ==
        "nil box ");
  CHECK(LogOf("log(simulation.entity('fb.wheels_0'))") == "nil ");
  CHECK(LogOf("log(simulation.position('box'))", kBox) == "200 ");
  CHECK_THAT(
      ErrorOf("simulation.ids('footbot')"),
      Contains("simulation.ids: there is no type of entity \"footbot\"") && Contains("foot-bot"));
  CHECK_THAT(ErrorOf("simulation.position('bax')", kBox), Contains("bax") && Contains("box"));
  CHECK_THAT(ErrorOf("simulation.position('fb.wheels_0')"), Contains("is a component"));
  CHECK_THAT(ErrorOf("simulation.ids(1)"),
             Contains("simulation.ids: argument 1 must be a string, got 1"));
}

TEST_CASE("lua loop functions: move puts entities into free places", "[lua][loop_functions]") {
  CLuaWorld world(WithLoopFunctions(
      "function init()\n"
      "  log(simulation.move('fb', 1, -1, 0, math.pi / 2))\n"
      "  log(simulation.move('fb', 2, 0.1, 0, 0))\n"
      "  log(simulation.is_free('fb', 2, 0.1, 0), simulation.is_free('fb', 3, 3, 0))\n"
      "  log(simulation.move('lamp', vector3(0, 0, 1)))\n"
      "end",
      kBox + kLight));
  // the second place is occupied by the box: the robot stays in the first
  CHECK(TakeScriptLog() == "1 0 01 1 ");
  CHECK(world.GetAnchor().Position == CVector3(1.0, -1.0, 0.0));
  CRadians z;
  CRadians y;
  CRadians x;
  world.GetAnchor().Orientation.ToEulerAngles(z, y, x);
  CHECK_THAT(z.GetValue(), WithinAbs(CRadians::PI_OVER_TWO.GetValue(), kRounding));
  CHECK(world.World().Get<CLightEntity>("lamp").GetPosition() == CVector3(0.0, 0.0, 1.0));
}

TEST_CASE("lua loop functions: move keeps values that are not given", "[lua][loop_functions]") {
  CLuaWorld world(WithLoopFunctions(
      "function init()\n"
      "  simulation.move('fb', 1, 0, 0, 0.5)\n"
      "  simulation.move('fb', 1, 1, 0)\n"
      "  log(simulation.yaw('fb'))\n"
      "  simulation.move('fb', vector3(1, 2, 0), quaternion(0.25, vector3(0, 0, 1)))\n"
      "  log(simulation.yaw('fb'))\n"
      "  simulation.move('fb', vector3(2, 2, 0))\n"
      "  log(simulation.yaw('fb'))\n"
      "end"));
  CHECK(TakeScriptLog() == "0.5 0.25 0.25 ");
  CHECK(world.GetAnchor().Position == CVector3(2.0, 2.0, 0.0));
  CHECK_THAT(ErrorOf("simulation.move('fb', 0/0, 0, 0)"), Contains("must be finite"));
  CHECK_THAT(ErrorOf("simulation.move('fb', 1, 2)"),
             Contains("simulation.move: argument 4 must be a number, got nothing"));
  CHECK_THAT(ErrorOf("simulation.move('fb', vector2(1, 2))"), Contains("must be a vector3"));
  CHECK_THAT(ErrorOf("simulation.move('f', 0, 0, 0)",
                     "<floor id='f' source='loop_functions' pixels_per_meter='10'/>"),
             Contains("has no position"));
}

TEST_CASE("lua loop functions: entities can be added and removed during the experiment",
          "[lua][loop_functions]") {
  CLuaWorld world(WithLoopFunctions(
      "function pre_step()\n"
      "  if simulation.clock() == 1 then\n"
      "    log(simulation.add([[<foot-bot id='new'><body position='1,1,0'/>"
      "<controller config='c'/></foot-bot>]]))\n"
      "    log(simulation.add([[<cylinder id='on' radius='0.1' height='0.1' movable='true' "
      "mass='1'>"
      "<body position='1,1,0'/></cylinder>]]))\n"
      "    log(simulation.add([[<light id='l' position='0,0,1' color='red' intensity='1' "
      "medium='leds'/>]]))\n"
      "  elseif simulation.clock() == 3 then\n"
      "    simulation.remove('new') simulation.remove('on') simulation.remove('l')\n"
      "  end\n"
      "  log(table.concat(simulation.ids(), ' '))\n"
      "end"));
  world.Step();
  // a cylinder that overlaps the robot is added, and the result of the call reports it
  CHECK(TakeScriptLog() == "new1 on0 l1 fb new on l ");
  CHECK(world.Get("robot.id", "new") == "new");
  world.Step(2);
  CHECK(TakeScriptLog() == "fb new on l fb ");
  world.Step();
  // the id can be used again
  TakeLog();
  CHECK(LogOf("local box = [[<box id='b' size='0.1,0.1,0.1' movable='false'><body "
              "position='1,1,0'/></box>]]\n"
              "for i = 1, 3 do simulation.add(box) simulation.remove('b') end "
              "log(#simulation.ids())") == "1 ");
}

TEST_CASE("lua loop functions: entities that init() adds are as those of the file",
          "[lua][loop_functions]") {
  CLuaWorld world(WithLoopFunctions(
      "function init()\n"
      "  for i = 1, 20 do\n"
      "    simulation.add(\"<foot-bot id='r\" .. i .. \"'><body position='\" .. i % 5 - 2 ..\n"
      "      ',' .. i // 5 - 3 .. \",0'/><controller config='c'/></foot-bot>\")\n"
      "  end\n"
      "  simulation.add([[<box id='b' size='1,1,1' movable='false'>"
      "<body position='3,3,0'/></box>]])\n"
      "  log(pcall(simulation.add, [[<box id='b' size='1,1,1' movable='false'>"
      "<body position='-3,3,0'/></box>]]))\n"
      "end"));
  CHECK_THAT(TakeScriptLog(),
             Contains("already an entity with id \"b\" (<box> at simulation.add:1"));
  world.Step(2);
  CSpace& space = world.World().GetSpace();
  CHECK(space.GetRootEntityVector().size() == 22);
  CHECK(space.GetEntity("r20").GetConfigurationNode()->GetAttribute("id") == "r20");
}

TEST_CASE("lua loop functions: a function with nearly the name of a hook is reported",
          "[lua][loop_functions]") {
  CLuaWorld world(WithLoopFunctions(
      "function init() helper() reset_all() end function helper() end\n"
      "function reset_all() end function post_setp() end function posst_experiment() end"));
  CHECK(TakeLogErr() ==
        "[WARNING] the Lua loop functions \"" + world.Folder().Path("loop.lua") +
            "\": nothing calls the global function \"posst_experiment\"; did you mean "
            "\"post_experiment\"?\n[WARNING] the Lua loop functions \"" +
            world.Folder().Path("loop.lua") +
            "\": nothing calls the global function \"post_setp\"; did you mean \"post_step\"?\n");
}

TEST_CASE("lua loop functions: invalid entities are errors", "[lua][loop_functions]") {
  CHECK_THAT(ErrorOf("simulation.add('<foot-bott id=\"x\"/>')"),
             Contains("simulation.add") && Contains("foot-bott") && Contains("foot-bot"));
  CHECK_THAT(ErrorOf("simulation.add('<foot-bot')"), Contains("simulation.add"));
  CHECK_THAT(ErrorOf("simulation.add([[<box id='fb' size='1,1,1' movable='false'>"
                     "<body position='3,3,0'/></box>]])"),
             Contains("already an entity with id"));
  CHECK_THAT(ErrorOf("simulation.remove('nobody')"), Contains("nobody"));
  CHECK_THAT(ErrorOf("simulation.add([[<box id='b' size='1,1,1' movable='false'>"
                     "<body position='3,3,0'/><body position='1,1,0'/></box>]])"),
             Contains("simulation.add:1: <body>: there is already one at simulation.add:1"));
  CHECK(LogOf("log(pcall(simulation.add, '<box/>'))").substr(0, 1) == "0");
  // an unused attribute is reported
  CHECK(LogOf("simulation.add([[<box id='b' size='1,1,1' movable='false' colour='red'>"
              "<body position='3,3,0'/></box>]])") == "");
  CHECK_THAT(TakeLogErr(), Contains("[WARNING] simulation.add:1: <box>: attribute \"colour\""));
}

TEST_CASE("lua loop functions: LEDs and lights can be read and set", "[lua][loop_functions]") {
  CLuaWorld world(
      WithLoopFunctions("function init()\n"
                        "  simulation.set_all_led_colors('fb', 'green')\n"
                        "  simulation.set_led_color('fb', 13, 1, 2, 3)\n"
                        "  log(simulation.light_intensity('lamp'))\n"
                        "  simulation.set_light_intensity('lamp', 7)\n"
                        "  simulation.set_light_color('lamp', 'blue')\n"
                        "end",
                        kLight + kBox));
  CHECK(TakeScriptLog() == "2.5 ");
  auto& leds = world.World().Get<CComposableEntity>("fb").GetComponent<CLEDEquippedEntity>("leds");
  CHECK(leds.GetLEDColor(0) == CColor::GREEN);
  CHECK(leds.GetLEDColor(12) == CColor(1, 2, 3));
  CHECK(world.World().Get<CLightEntity>("lamp").GetIntensity() == 7.0);
  CHECK(world.World().Get<CLightEntity>("lamp").GetColor() == CColor::BLUE);
  CHECK_THAT(ErrorOf("simulation.set_led_color('fb', 14, 'red')"),
             Contains("from 1 to 13, got 14"));
  CHECK_THAT(ErrorOf("simulation.set_led_color('box', 1, 'red')", kBox),
             Contains("\"box\" (<box>) has no LEDs"));
  CHECK_THAT(ErrorOf("simulation.set_light_intensity('fb', 1)"),
             Contains("is a <foot-bot>, no <light>"));
}

TEST_CASE(
    "lua loop functions: a disabled robot stands still and is silent until it is enabled or reset",
    "[lua][loop_functions]") {
  SLuaExperiment experiment = WithLoopFunctions(
      "function pre_step()\n"
      "  assert(simulation.is_enabled('fb') == (simulation.clock() <= 11 or simulation.clock() > "
      "21))\n"
      "  if simulation.clock() == 11 then simulation.disable('fb') end\n"
      "  if simulation.clock() == 21 then simulation.enable('fb') end\n"
      "end",
      "<foot-bot id='other'><body position='0,0.5,0'/><controller config='other'/></foot-bot>");
  experiment.Script =
      "function step() robot.wheels.set_velocity(10, 10) robot.range_and_bearing.set_data(1, 7) "
      "end";
  const std::string actuators =
      "<differential_steering implementation='default'/>"
      "<range_and_bearing implementation='default'/>";
  const std::string sensors = "<range_and_bearing implementation='medium' medium='rab'/>";
  experiment.Actuators = actuators;
  experiment.Sensors = sensors;
  experiment.Media += "<range_and_bearing id='rab'/>";
  CTemporaryFolder folder;
  experiment.Controllers =
      "<lua_controller id='other'><actuators>" + actuators + "</actuators><sensors>" + sensors +
      "</sensors><params script='" +
      folder.Write("other.lua", "heard = 0 function step() heard = #robot.range_and_bearing end") +
      "'/></lua_controller>";
  CLuaWorld world(experiment);
  const auto run = [&] {
    world.Step(10);
    CHECK(world.Get("heard", "other") == "1");
    world.Step(10);
    // ten commands of 1 cm each
    CHECK_THAT(world.GetAnchor().Position.GetX(), WithinAbs(0.1, 1e-9));
    CHECK(world.Get("heard", "other") == "0");
  };
  run();
  world.GetSimulator().Reset();
  run();
  world.Step(11);
  CHECK_THAT(world.GetAnchor().Position.GetX(), WithinAbs(0.199, 1e-9));
  CHECK(world.Get("heard", "other") == "1");
  CHECK_THAT(ErrorOf("simulation.disable('box')", kBox), Contains("\"box\" (<box>) is no robot"));
}

TEST_CASE("lua loop functions: the charge of a battery can be read and set",
          "[lua][loop_functions]") {
  SLuaExperiment experiment = WithLoopFunctions(
      "function init()\n"
      "  log(simulation.battery('fb'))\n"
      "  simulation.set_battery('fb', 0.25)\n"
      "  log(simulation.battery('fb'))\n"
      "end");
  CLuaWorld world(experiment);
  CHECK(TakeScriptLog() == "1 0.25 ");
  CHECK_THAT(ErrorOf("simulation.set_battery('fb', 1.5)"),
             Contains("must be from 0 to 1, got 1.5"));
  CHECK_THAT(ErrorOf("simulation.set_battery('fb', 0/0)"), Contains("must be from 0 to 1"));
  CHECK_THAT(ErrorOf("simulation.battery('box')", kBox), Contains("has no battery"));
}

TEST_CASE("lua loop functions: the floor has the colors of floor_color", "[lua][loop_functions]") {
  CLuaWorld world(WithLoopFunctions(
      "black = false\n"
      "function floor_color(x, y)\n"
      "  if black then return 'black' end\n"
      "  if x < 0 then return 'red' elseif y < 0 then return 10, 20, 30 else return '1,2,3,4' end\n"
      "end\n"
      "function post_step() black = true simulation.floor_changed() end",
      "<floor id='f' source='loop_functions' pixels_per_meter='10'/>"));
  const CSimulator::CScope scope(world.GetSimulator());
  CFloorEntity& floor = world.World().GetSpace().GetFloorEntity();
  CHECK(floor.GetColorAtPoint(-1.0, 0.0) == CColor::RED);
  CHECK(floor.GetColorAtPoint(1.0, -1.0) == CColor(10, 20, 30));
  CHECK(floor.GetColorAtPoint(1.0, 1.0) == CColor(1, 2, 3, 4));
  floor.ClearChanged();
  world.Step();
  CHECK(floor.HasChanged());
  CHECK(floor.GetColorAtPoint(-1.0, 0.0) == CColor::BLACK);
}

TEST_CASE("lua loop functions: pheromones can be read and deposited", "[lua][loop_functions]") {
  // one layer on cells of 0.01 m^2, with centres at odd multiples of 0.05 m
  const auto with = [](const std::string& code) {
    SLuaExperiment experiment = WithLoopFunctions(code);
    experiment.Media =
        "<led id='leds'/><pheromone id='p' cell_size='0.1'><layer id='trail' "
        "evaporation='2'/></pheromone>";
    return experiment;
  };
  TakeLog();
  {
    CLuaWorld world(
        with("function init() simulation.lay_pheromone('p', 'trail', 0.05, 0.15, 0.03)\n"
             "log(simulation.pheromone('p', 'trail', 0.05, 0.15), ' ',\n"
             "simulation.pheromone('p', 'trail', 0.1, 0.15), ' ',\n"
             "simulation.total_pheromone('p', 'trail')) end\n"
             "function post_step() total = simulation.total_pheromone('p', 'trail')\n"
             "log(tostring(math.abs(total - 0.03 * math.exp(-0.2)) < 1e-15)) end"));
    const std::string start = TakeScriptLog();
    std::istringstream numbers(start);
    Real here = 0.0;
    Real between = 0.0;
    Real total = 0.0;
    numbers >> here >> between >> total;
    CHECK_THAT(here, WithinAbs(3.0, 1e-5));
    CHECK_THAT(between, WithinAbs(1.5, 1e-5));
    CHECK_THAT(total, WithinAbs(0.03, 1e-7));
    world.Step();
    CHECK_THAT(TakeScriptLog(), Contains("true"));
  }
  const auto error = [&](const std::string& call) {
    try {
      CLuaWorld world(with("function init() simulation." + call + " end"));
    } catch (const std::exception& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK_THAT(error("pheromone('p', 'trial', 0, 0)"),
             Contains("no layer \"trial\"") && Contains("trail"));
  CHECK_THAT(error("pheromone('q', 'trail', 0, 0)"), Contains("q"));
  CHECK_THAT(error("pheromone('leds', 'trail', 0, 0)"), Contains("leds"));
  CHECK_THAT(error("pheromone('p', 'trail', 0)"), Contains("argument 4 must be a number"));
  CHECK_THAT(error("lay_pheromone('p', 'trail', 0, 0, -1)"), Contains(">= 0, got -1"));
  CHECK_THAT(error("lay_pheromone('p', 'trail', 0, 0)"), Contains("argument 5"));
}

TEST_CASE("lua loop functions: threads may query the floor's color concurrently",
          "[lua][loop_functions][threads]") {
  CLuaWorld world(
      WithLoopFunctions("function floor_color(x, y) return x, y, 0 end",
                        "<floor id='f' source='loop_functions' pixels_per_meter='10'/>"));
  CFloorEntity& floor = world.World().GetSpace().GetFloorEntity();
  std::vector<std::thread> threads;
  std::atomic<int> wrong{0};
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      const CSimulator::CScope scope(world.GetSimulator());
      for (int i = 0; i < 200; ++i) {
        wrong +=
            floor.GetColorAtPoint(t, i) == CColor(static_cast<UInt8>(t), static_cast<UInt8>(i), 0)
                ? 0
                : 1;
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  CHECK(wrong == 0);
}

TEST_CASE("lua loop functions: invalid colors and recursive color queries are errors",
          "[lua][loop_functions][error]") {
  const std::string floor = "<floor id='f' source='loop_functions' pixels_per_meter='10'/>";
  const auto ask = [](CLuaWorld& world) {
    const CSimulator::CScope scope(world.GetSimulator());
    return world.World().GetSpace().GetFloorEntity().GetColorAtPoint(0.0, 0.0);
  };
  CLuaWorld nothing(WithLoopFunctions("function floor_color(x, y) end", floor));
  CHECK_THROWS_WITH(ask(nothing), Contains("floor_color(x, y) must return a color"));
  CLuaWorld broken(WithLoopFunctions("function floor_color(x, y) error('no paint') end", floor));
  CHECK_THROWS_WITH(ask(broken),
                    Contains("failed in floor_color()") && Contains("loop.lua:1: no paint"));
}

TEST_CASE("lua loop functions: the script can end the experiment", "[lua][loop_functions]") {
  CLuaWorld world(WithLoopFunctions(
      "function post_step() if simulation.clock() == 5 then simulation.finish() end end"));
  world.GetSimulator().Execute();
  CHECK(world.World().GetSpace().GetSimulationClock() == 5);
  CLuaWorld wrong(WithLoopFunctions("function is_experiment_finished() return 1 end"));
  CHECK_THROWS_WITH(wrong.GetSimulator().Execute(),
                    Contains("is_experiment_finished() must return true or false, got number"));
}

TEST_CASE("lua loop functions: data can be written with the standard io library",
          "[lua][loop_functions]") {
  CTemporaryFolder folder;
  SLuaExperiment experiment = WithLoopFunctions(
      "function init() file = io.open(simulation.params.data, 'w') end\n"
      "function post_step()\n"
      "  local x = simulation.position('fb')\n"
      "  file:write(simulation.clock(), ',', string.format('%.3f', x), '\\n')\n"
      "end\n"
      "function destroy() file:close() end");
  experiment.Script =
      "function init() end function reset() end function destroy() end\n"
      "function step() robot.wheels.set_velocity(10, 10) end";
  experiment.LoopParams = "data='" + folder.Path("data.csv") + "'";
  CLuaWorld world(experiment);
  world.Step(3);
  world.Destroy();
  CHECK(folder.Read("data.csv") == "1,0.000\n2,0.009\n3,0.019\n");
}

TEST_CASE("lua loop functions: variables of robots can be read and written",
          "[lua][loop_functions]") {
  SLuaExperiment experiment = WithLoopFunctions(
      "function post_step()\n"
      "  local items = simulation.get_variable('fb', 'items')\n"
      "  log(items.count, ' ', tostring(items.where), ' ', simulation.get_variable('fb', "
      "'nothing'),\n"
      "      ' ', simulation.get_variable('fb', 'step'))\n"
      "  simulation.set_variable('fb', 'goal', { vector2(1, 2), name = 'nest' })\n"
      "  simulation.set_variable('fb', 'old', nil)\n"
      "end");
  experiment.Script = "items = { count = 3, where = vector3(1, 2, 3) } old = 1\n" + kIdleScript;
  CLuaWorld world(experiment);
  world.Step();
  CHECK(TakeScriptLog() == "3 1,2,3 nil nil ");
  CHECK(world.Get("tostring(goal[1]) .. goal.name") == "1,2nest");
  CHECK(world.Get("old") == "nil");
  // a copy: changes do not affect the robot's table
  world.Do("items.count = 4");
  world.Step();
  CHECK(TakeScriptLog() == "4 1,2,3 nil nil ");
  CHECK_THAT(ErrorOf("simulation.get_variable('box', 'x')", kBox),
             Contains("\"box\" (<box>) runs no Lua script"));
  CHECK_THAT(ErrorOf("simulation.set_variable('fb', 'x')"), Contains("got 2 arguments"));
}

TEST_CASE("lua loop functions: random numbers repeat with the seed and after a reset",
          "[lua][loop_functions][random]") {
  SLuaExperiment experiment = WithLoopFunctions(
      "function post_step() log(simulation.random.uniform(), ' ', math.random()) end");
  CLuaWorld world(experiment);
  TakeLog();
  world.Step(2);
  const std::string first = TakeScriptLog();
  world.GetSimulator().Reset();
  world.Step(2);
  CHECK(TakeScriptLog() == first);
  experiment.Seed = 2;
  CLuaWorld other(experiment);
  TakeLog();
  other.Step(2);
  CHECK(TakeScriptLog() != first);
  CHECK_THAT(ErrorOf("simulation.random.uniform('a')"),
             Contains("simulation.random.uniform: argument 1"));
}

}  // namespace lua_loop_functions_test
