// Life cycle of Lua controllers, and handling of their errors.

#include "lua_world.h"

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/wrappers/lua/lua_script.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace lua_controller_test {

using namespace argos;
using Catch::Contains;
using Catch::StartsWith;
using Catch::WithinAbs;

namespace {

// a script that logs the calls of its functions; each function can be replaced
struct SFunctions {
  std::string Chunk = "";
  std::string Init = "log('init')";
  std::string Step = "log('step')";
  std::string Reset = "log('reset')";
  std::string Destroy = "log('destroy')";

  std::string ToScript() const {
    // one function per line: the chunk is line 1, destroy() line 5
    return Chunk + "\nfunction init() " + Init + " end\nfunction step() " + Step +
           " end\nfunction reset() " + Reset + " end\nfunction destroy() " + Destroy + " end\n";
  }
};

SLuaExperiment Running(const SFunctions& functions, const std::string& params = "") {
  SLuaExperiment experiment;
  experiment.Script = functions.ToScript();
  experiment.Params = params;
  return experiment;
}

// functions that log nothing
const SFunctions kQuiet{"", "", "", "", ""};

}  // namespace

TEST_CASE(
    "lua controller: chunk and init() run once, step() in each tick, then reset() and destroy()",
    "[lua][controller]") {
  SFunctions functions;
  functions.Chunk = "log('chunk ', robot.id)";
  CLuaWorld world(Running(functions));
  CHECK(TakeScriptLog() == "chunk fb init ");
  world.Step(3);
  CHECK(TakeScriptLog() == "step step step ");
  world.GetSimulator().Reset();
  CHECK(TakeScriptLog() == "reset ");
  world.Step();
  CHECK(TakeScriptLog() == "step ");
  world.Destroy();
  CHECK(TakeScriptLog() == "destroy ");
}

TEST_CASE("lua controller: globals survive a reset", "[lua][controller]") {
  SFunctions functions = kQuiet;
  functions.Init = "count = 0";
  functions.Step = "count = count + 1";
  CLuaWorld world(Running(functions));
  world.Step(5);
  world.GetSimulator().Reset();
  CHECK(world.Get("count") == "5");
  world.Step();
  CHECK(world.Get("count") == "6");
}

TEST_CASE("lua controller: robot has id, params as strings, and the devices of the XML only",
          "[lua][controller]") {
  SFunctions functions = kQuiet;
  functions.Init = "speed, mode = robot.params.speed, robot.params.mode";
  CLuaWorld world(Running(functions, "speed='12' mode='fast'"));
  CHECK(world.Get("robot.id") == "fb");
  CHECK(world.Get("robot.params.speed") == "12");
  CHECK(world.Get("type(robot.params.speed)") == "string");
  CHECK(world.Get("robot.params.mode") == "fast");
  CHECK(world.Get("robot.params.script") == world.Folder().Path("robot.lua"));
  world.Do("names = {} for name in pairs(robot) do names[#names + 1] = name end");
  CHECK(world.Get("table.concat(names, ' ')") == "id params random wheels");
}

TEST_CASE("lua controller: params of a robot replace those of the controller",
          "[lua][controller]") {
  SFunctions functions = kQuiet;
  functions.Init = "speed, color = robot.params.speed, robot.params.color";
  SLuaExperiment experiment = Running(functions, "speed='12'");
  CTemporaryFolder folder;
  const std::string script = folder.Write("own.lua", functions.ToScript());
  experiment.Robots +=
      "<foot-bot id='own'><body position='1,0,0'/><controller config='c'><params script='" +
      script + "' color='red'/></controller></foot-bot>";
  CLuaWorld world(experiment);
  CHECK(world.Get("robot.params.speed") == "12");
  CHECK(world.Get("robot.params.color", "own") == "red");
  CHECK(world.Get("robot.params.speed", "own") == "nil");
  CHECK(world.Get("robot.id", "own") == "own");
}

TEST_CASE("lua controller: the example of the reference moves as computed from the kinematics",
          "[lua][controller]") {
  SFunctions functions = kQuiet;
  functions.Init = "t = 0";
  functions.Step = "t = t + 1 robot.wheels.set_velocity(10, 10)";
  CLuaWorld world(Running(functions));
  // A command given in tick k acts from tick k + 1 on; 10 cm/s for 0.1 s are 0.01 m. A tenth of a
  // tick passes until it takes effect: ARGoS 3 loses 1.1 mm in this tick.
  const Real perTick = 0.01;
  constexpr Real kLag = 0.1;  // ticks
  // tolerance of a thousand roundings of a number near 1
  const Real tolerance = 1e-9;
  UInt32 tick = 0;
  for (const UInt32 t : {1U, 2U, 3U, 100U}) {
    world.Step(t - tick);
    tick = t;
    CAPTURE(t);
    CHECK(world.Get("t") == std::to_string(t));
    CHECK_THAT(world.GetAnchor().Position.GetX(),
               WithinAbs(t > 1 ? (t - 1 - kLag) * perTick : 0.0, tolerance));
    CHECK_THAT(world.GetAnchor().Position.GetY(), WithinAbs(0.0, tolerance));
  }
  // the result differs from the positions of the reference by less than the loss in ARGoS 3
  CHECK_THAT(world.GetAnchor().Position.GetX(), WithinAbs(0.98889, 0.0012));
}

TEST_CASE("lua controller: scripts of different robots are separate", "[lua][controller]") {
  SLuaExperiment experiment = Running(kQuiet);
  experiment.Robots +=
      "<foot-bot id='b'><body position='1,0,0'/><controller config='c'/></foot-bot>";
  CLuaWorld world(experiment);
  world.Do("x = 1 string.format = nil");
  CHECK(world.Get("x", "b") == "nil");
  CHECK(world.Get("string.format('%d', 3)", "b") == "3");
}

TEST_CASE("lua controller: random numbers differ between robots and repeat with the seed",
          "[lua][controller][random]") {
  SLuaExperiment experiment = Running(kQuiet);
  experiment.Robots +=
      "<foot-bot id='b'><body position='1,0,0'/><controller config='c'/></foot-bot>";
  const std::string draw = "robot.random.uniform() .. ' ' .. math.random()";
  CLuaWorld world(experiment);
  const std::string a = world.Get(draw);
  const std::string b = world.Get(draw, "b");
  CHECK(a != b);
  CHECK(world.Get(draw) != a);
  // after a reset they repeat, and with another seed they differ
  world.GetSimulator().Reset();
  CHECK(world.Get(draw) == a);
  CHECK(world.Get(draw, "b") == b);
  world.GetSimulator().Reset(2);
  CHECK(world.Get(draw) != a);
  // they do not depend on other robots
  CLuaWorld alone(Running(kQuiet));
  CHECK(alone.Get(draw) == a);
  experiment.Seed = 2;
  CLuaWorld other(experiment);
  CHECK(other.Get(draw) != a);
}

TEST_CASE("lua controller: without a script the robot does nothing, and a warning is logged",
          "[lua][controller]") {
  SLuaExperiment experiment = Running(kQuiet);
  const auto [params, isWarned] =
      GENERATE(table<std::string, bool>({{"<params/>", true}, {"<params script=''/>", true}}));
  CAPTURE(params, isWarned);
  experiment.Robots = "<foot-bot id='fb'><body position='0,0,0'/><controller config='c'>" + params +
                      "</controller></foot-bot>";
  CLuaWorld world(experiment);
  CHECK_THAT(TakeLogErr(), Contains("[WARNING]") && Contains("no \"script\": robot \"fb\""));
  world.Step(2);
  world.GetSimulator().Reset();
  CHECK(world.GetAnchor().Position.GetX() == 0.0);
  CHECK(world.GetController().GetLuaState() == nullptr);
  CHECK(world.GetController().IsOK());
}

TEST_CASE("lua controller: a missing or malformed script is fatal", "[lua][controller][error]") {
  SLuaExperiment experiment;
  experiment.Script = "x = 1\ny = = 2\n";
  CHECK_THAT(LoadError(experiment), Contains("robot \"fb\"") && Contains("robot.lua:2:") &&
                                        Contains("unexpected symbol near '='"));
  experiment.Robots =
      "<foot-bot id='fb'><body position='0,0,0'/><controller config='c'><params script='no.lua'/>"
      "</controller></foot-bot>";
  CHECK_THAT(LoadError(experiment),
             Contains("robot \"fb\"") && Contains("there is no Lua script \"no.lua\""));
}

TEST_CASE("lua controller: an error in the chunk or in init() is fatal, with a traceback",
          "[lua][controller][error]") {
  SFunctions functions;
  functions.Chunk = "error('bad chunk')";
  CHECK_THAT(LoadError(Running(functions)),
             Contains("robot \"fb\": the Lua script \"") && Contains("failed in its top level") &&
                 Contains("robot.lua:1: bad chunk") && Contains("stack traceback:"));
  functions.Chunk = "";
  functions.Init = "local function inner() error('bad init') end inner()";
  CHECK_THAT(LoadError(Running(functions)),
             Contains("failed in init()") && Contains("robot.lua:2: bad init") &&
                 (Contains("in upvalue 'inner'") || Contains("in local 'inner'")));
  SLuaExperiment experiment;
  experiment.Script = "init = 5 function step() end";
  CHECK_THAT(LoadError(experiment),
             Contains("failed in init()") &&
                 Contains("must define a global function \"init\", found number"));
  CHECK_THAT(TakeLog(), !Contains("step"));
}

TEST_CASE("lua controller: init(), reset() and destroy() may be left out, but not be misspelt",
          "[lua][controller][error]") {
  SLuaExperiment experiment;
  experiment.Script = "t = 0 function step() t = t + 1 end";
  {
    CLuaWorld world(experiment);
    world.Step(2);
    world.GetSimulator().Reset();
    world.Step();
    CHECK(world.Get("t") == "3");
    world.Destroy();
  }
  CHECK(TakeLogErr() == "");
  experiment.Script = "function inti() end function step() end";
  CHECK_THAT(LoadError(experiment),
             Contains("must define a global function \"init\", found nil; did you mean \"inti\"?"));
  experiment.Script = "function Reset() end function step() end";
  CLuaWorld world(experiment);
  world.GetSimulator().Reset();
  CHECK_THAT(TakeLogErr(), Contains("did you mean \"Reset\"?"));
}

TEST_CASE("lua controller: an error in step() stops the script, but neither the run nor the robot",
          "[lua][controller][error]") {
  SFunctions functions = kQuiet;
  functions.Init = "t = 0";
  functions.Step = "t = t + 1 robot.wheels.set_velocity(10, 10) if t == 3 then error('tired') end";
  functions.Destroy = "log('destroyed')";
  SLuaExperiment experiment = Running(functions);
  experiment.Robots +=
      "<foot-bot id='b'><body position='0,1,0'/><controller config='c'><params script='";
  CTemporaryFolder folder;
  experiment.Robots +=
      folder.Write("b.lua", SFunctions{"", "t = 0", "t = t + 1", "", ""}.ToScript()) +
      "'/></controller></foot-bot>";
  CLuaWorld world(experiment);
  world.Step(2);
  CHECK(TakeLogErr() == "");
  world.Step();
  const std::string error = TakeLogErr();
  CHECK_THAT(error, StartsWith("[FATAL] robot \"fb\": the Lua script \"") &&
                        Contains("failed in step()\n[FATAL] ") &&
                        Contains("robot.lua:3: tired\n[FATAL] stack traceback:\n"));
  CHECK(world.GetController().IsOK() == false);
  CHECK_THAT(world.GetController().GetErrorMessage(), Contains("tired"));
  world.Step(7);
  // it is reported once, step() is not called again, and the wheels still turn:
  // 9 ticks after the first command, less the tenth of a tick in which it does not act yet
  CHECK(TakeLogErr() == "");
  CHECK(world.Get("t") == "3");
  CHECK_THAT(world.GetAnchor().Position.GetX(), WithinAbs(0.089, 1e-9));
  // the other robot is not affected
  CHECK(world.Get("t", "b") == "10");
  TakeLog();
  world.Destroy();
  CHECK_THAT(TakeLog(), !Contains("destroyed"));
}

TEST_CASE("lua controller: a missing step() stops the script", "[lua][controller][error]") {
  SLuaExperiment experiment;
  experiment.Script = "function init() end";
  CLuaWorld world(experiment);
  world.Step(2);
  CHECK_THAT(TakeLogErr(), Contains("must define a global function \"step\", found nil"));
}

TEST_CASE("lua controller: on_error end_run ends the run", "[lua][controller][error]") {
  SFunctions functions = kQuiet;
  functions.Step = "error('enough')";
  CLuaWorld world(Running(functions, "on_error='end_run'"));
  CHECK_THROWS_WITH(world.Step(), Contains("robot \"fb\": ControlStep() threw in tick 1") &&
                                      Contains("robot.lua:3: enough"));
  CHECK_THAT(LoadError(Running(functions, "on_error='ignore'")),
             Contains("\"on_error\" must be \"end_run\", \"stop_robot\" or \"quarantine\", got "
                      "\"ignore\""));
}

TEST_CASE("lua controller: after an error a reset loads the script again",
          "[lua][controller][error]") {
  SFunctions functions = kQuiet;
  functions.Init = "t = 0 log('init ', robot.params.mode)";
  functions.Step = "t = t + 1 if t == 2 then error('tired') end";
  functions.Reset = "log('reset')";
  CLuaWorld world(Running(functions, "mode='fast'"));
  world.Step(2);
  CHECK_THAT(TakeLogErr(), Contains("tired"));
  TakeScriptLog();
  world.GetSimulator().Reset();
  CHECK(TakeScriptLog() == "init fast ");
  CHECK(world.GetController().IsOK());
  CHECK(world.Get("t") == "0");
  world.Step();
  CHECK(world.Get("t") == "1");
  world.Step();
  // an error that is equal to an earlier one is counted, and not logged again
  CHECK(TakeLogErr() == "");
  CHECK_FALSE(world.GetController().IsOK());
  // from the present content of the file
  functions.Step = "t = 100";
  world.Folder().Write("robot.lua", functions.ToScript());
  world.GetSimulator().Reset();
  world.Step();
  CHECK(world.Get("t") == "100");
}

TEST_CASE("lua controller: a script that cannot be reloaded stays stopped",
          "[lua][controller][error]") {
  SFunctions functions = kQuiet;
  functions.Step = "error('tired')";
  CLuaWorld world(Running(functions));
  world.Step();
  CHECK_THAT(TakeLogErr(), Contains("tired"));
  world.Folder().Write("robot.lua", "no Lua at all");
  world.GetSimulator().Reset();
  CHECK_THAT(TakeLogErr(), StartsWith("[FATAL] robot \"fb\"") && Contains("robot.lua:1:"));
  CHECK_FALSE(world.GetController().IsOK());
  world.Step(3);
  CHECK(TakeLogErr() == "");
  world.Folder().Write("robot.lua", kQuiet.ToScript());
  world.GetSimulator().Reset();
  CHECK(world.GetController().IsOK());
}

TEST_CASE("lua controller: errors in reset() and destroy() are reported",
          "[lua][controller][error]") {
  SFunctions functions = kQuiet;
  functions.Step = "log('step')";
  functions.Reset = "error('bad reset')";
  functions.Destroy = "error('bad destroy')";
  CLuaWorld world(Running(functions));
  SECTION("reset() stops the script") {
    world.GetSimulator().Reset();
    CHECK_THAT(TakeLogErr(), Contains("failed in reset()") && Contains("robot.lua:4: bad reset"));
    TakeLog();
    world.Step();
    CHECK(TakeLog() == "");
    world.Destroy();
    CHECK(TakeLogErr() == "");
  }
  SECTION("destroy()") {
    world.Destroy();
    CHECK_THAT(TakeLogErr(),
               Contains("failed in destroy()") && Contains("robot.lua:5: bad destroy"));
  }
}

TEST_CASE("lua controller: endless loops are interrupted in every function",
          "[lua][controller][error]") {
  const std::string params = "max_instructions='100000'";
  const std::string loop = "while true do end";
  const std::string message = "interrupted after 100000 instructions";
  SFunctions functions = kQuiet;
  SECTION("chunk") {
    functions.Chunk = loop;
    CHECK_THAT(LoadError(Running(functions, params)),
               Contains(message) && Contains("robot.lua:1:"));
  }
  SECTION("init") {
    functions.Init = loop;
    CHECK_THAT(LoadError(Running(functions, params)), Contains(message) && Contains("init()"));
  }
  SECTION("step") {
    functions.Step = loop;
    CLuaWorld world(Running(functions, params));
    world.Step(3);
    CHECK_THAT(TakeLogErr(), Contains(message) && Contains("robot.lua:3:"));
  }
  SECTION("reset") {
    functions.Reset = loop;
    CLuaWorld world(Running(functions, params));
    world.GetSimulator().Reset();
    CHECK_THAT(TakeLogErr(), Contains(message) && Contains("robot.lua:4:"));
  }
  SECTION("destroy") {
    functions.Destroy = loop;
    CLuaWorld world(Running(functions, params));
    world.Destroy();
    CHECK_THAT(TakeLogErr(), Contains(message) && Contains("robot.lua:5:"));
  }
  SECTION("an invalid limit") {
    CHECK_THAT(LoadError(Running(functions, "max_instructions='many'")),
               Contains("max_instructions") && Contains("many"));
  }
}

TEST_CASE("lua controller: errors caught by the script are not reported",
          "[lua][controller][error]") {
  SFunctions functions = kQuiet;
  functions.Step = "ok, message = pcall(robot.wheels.set_velocity, 1, nil) n = (n or 0) + 1";
  CLuaWorld world(Running(functions));
  world.Step(3);
  CHECK(TakeLogErr() == "");
  CHECK(world.Get("ok") == "false");
  CHECK_THAT(world.Get("message"),
             Contains("robot.wheels.set_velocity: argument 2 must be a number, got nil"));
  CHECK(world.Get("n") == "3");
}

TEST_CASE("lua controller: the script can be changed at run time", "[lua][controller]") {
  SFunctions functions = kQuiet;
  functions.Step = "which = 'first'";
  CLuaWorld world(Running(functions, "mode='fast'"));
  CHECK_THAT(TakeLogErr(), Contains("\"mode\" is not used by anything"));
  world.Step();
  functions.Init = "mode = robot.params.mode";
  functions.Step = "which = 'second'";
  const std::string second = world.Folder().Write("second.lua", functions.ToScript());
  world.GetController().SetLuaScript(second);
  world.Step();
  CHECK(world.Get("which") == "second");
  CHECK(world.Get("mode") == "fast");
  CHECK(world.Get("robot.params.script") == second);
}

TEST_CASE("lua controller: another text of the script runs, or leaves the former one as it was",
          "[lua][controller]") {
  SFunctions functions = kQuiet;
  functions.Init = "n = 0";
  functions.Step = "n = n + 1";
  CLuaWorld world(Running(functions));
  world.Step(3);
  CLuaController& controller = world.GetController();
  const std::shared_ptr<const SLuaScript> file = controller.GetScript();
  functions.Init = "error('no')";
  const auto broken = file->MakeVariant(functions.ToScript());
  CHECK_THROWS_WITH(controller.Restart(broken), Contains("init()") && Contains("no"));
  CHECK(controller.IsOK());
  CHECK(controller.GetScript() == file);
  world.Step(2);
  CHECK(world.Get("n") == "5");
  functions.Init = "n = 100";
  controller.Restart(file->MakeVariant(functions.ToScript()));
  world.Step();
  CHECK(world.Get("n") == "101");
  CHECK_THROWS_WITH(file->MakeVariant("\x1bLua"), Contains("precompiled"));
  CHECK_THROWS_WITH(file->MakeVariant("x = = 1"), Contains("robot.lua:1:"));
}

TEST_CASE("lua controller: removing a robot runs destroy()", "[lua][controller]") {
  SFunctions functions = kQuiet;
  functions.Destroy = "log('bye ', robot.id)";
  CLuaWorld world(Running(functions));
  world.Step();
  TakeLog();
  {
    const CSimulator::CScope scope(world.GetSimulator());
    world.GetSimulator().GetLoopFunctions().RemoveEntity("fb");
  }
  CHECK(TakeScriptLog() == "bye fb ");
}

TEST_CASE("lua controller: an invalid speed is reported as an error of the device",
          "[lua][controller][error]") {
  SFunctions functions = kQuiet;
  functions.Step = "robot.wheels.set_velocity(0/0, 1)";
  CLuaWorld world(Running(functions));
  world.Step();
  CHECK_THAT(TakeLogErr(), Contains("robot.lua:3: robot.wheels.set_velocity: "));
}

}  // namespace lua_controller_test
