// Attributes of <params> that no script uses.

#include "lua_world.h"

#include "../command_line/program_run.h"

#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

namespace lua_parameters_test {

using namespace argos;
using Catch::Contains;

namespace {

SLuaExperiment With(const std::string& init, const std::string& params) {
  SLuaExperiment experiment;
  experiment.Script = "function init() " + init + " end function step() " +
                      "v = robot.params.late end function reset() end function destroy() end";
  experiment.Params = params;
  return experiment;
}

/** The warnings about a robot whose init() has the given code. */
std::string WarningsOf(const std::string& init, const std::string& params) {
  CLuaWorld world(With(init, params));
  world.Step();
  return TakeLogErr();
}

std::string Experiment(const std::string& params, const std::string& loopParams) {
  return "<argos-configuration>\n"
         "<framework><experiment ticks_per_second='10' length='1' random_seed='1'/></framework>\n"
         "<controllers><lua_controller id='c'><actuators/><sensors/>\n<params script='s.lua' " +
         params +
         "/></lua_controller></controllers>\n"
         "<loop_functions label='lua'><params script='l.lua' " +
         loopParams +
         "/></loop_functions>\n<physics_engines><dynamics2d id='d'/></physics_engines><media/>\n"
         "<arena size='4,4,1'><foot-bot id='fb'><body position='0,0,0'/><controller config='c'/>"
         "</foot-bot></arena>\n</argos-configuration>\n";
}

}  // namespace

TEST_CASE("lua parameters: an attribute that a script does not use is reported", "[lua][params]") {
  const std::string message =
      "<params>: attribute \"sped\" is not used by anything; did you mean \"speed\"";
  for (const char* const init :
       {"v = robot.params.speed", "v = rawget(robot.params, 'speed')",
        "function get(n) return robot.params[n] end v = get('speed')",
        "local p = setmetatable(robot.params, { __index = { speed = 3 } }) v = p.speed",
        "f = function() return robot.params['speed'] end", "robot.params.speed = 5"}) {
    CAPTURE(init);
    const std::string warnings = WarningsOf(init, "sped='1'");
    CHECK_THAT(warnings, Contains("attribute \"sped\" is not used by anything"));
  }
  CHECK_THAT(WarningsOf("v = robot.params.speed", "sped='1'"), Contains(message));
  CHECK_THAT(WarningsOf("f = function() return robot.params['speed'] end", "sped='1'"),
             Contains(message));
  // step() reads it
  CHECK_THAT(WarningsOf("", "lat='1'"), Contains("did you mean \"late\"?"));
}

TEST_CASE("lua parameters: what a script uses is not reported", "[lua][params]") {
  for (const char* const init :
       {"v = robot.params.speed", "v = rawget(robot.params, 'speed')",
        "for n, v in pairs(robot.params) do end", "is_empty = next(robot.params) == nil",
        "function get(n) return robot.params[n] end v = get('sp' .. 'eed')",
        "function get(t) return t.speed end later = function() get(robot.params) end",
        "f = function() return robot.params['speed'] end"}) {
    CAPTURE(init);
    CHECK(WarningsOf(init, "speed='1' late='2'") == "");
  }
}

TEST_CASE("lua parameters: the table is as a plain one", "[lua][params]") {
  CLuaWorld world(
      With("local p = robot.params p.speed = p.speed + 1 p.more = 'm' p.gone = nil v = 0 "
           "seen = p.speed .. p.more .. tostring(p.gone) .. tostring(p.none) .. type(p.script)\n"
           "order = '' for n in pairs(p) do order = order .. n .. ' ' end",
           "speed='1' gone='x' other='y'"));
  CHECK(TakeLogErr() == "");
  CHECK(world.Get("seen") == "2mnilnilstring");
  CHECK(world.Get("order") == "more other script speed ");
  CLuaWorld other(
      With("local p = robot.params p[1] = 'one' none = tostring(p[2]) seen = p[1]\n"
           "ok, message = pcall(function() p[nil] = 1 end) v = p.speed",
           "speed='1'"));
  CHECK(other.Get("seen .. none") == "onenil");
  CHECK_THAT(other.Get("message"), Contains("index is nil"));
  world.Step();
  CHECK(world.Get("getmetatable(robot.params)") == "nil");
  CHECK(world.Get("next({}, nil)") == "nil");
  CHECK(world.Get("rawget(robot.params, 'speed') .. rawget(robot.params, 'other')") == "2y");
  world.Do("setmetatable(robot.params, { __index = { default = 7 } })");
  CHECK(world.Get("robot.params.default") == "7");
}

TEST_CASE("lua parameters: of --set an unused attribute is an error, also of loop functions",
          "[lua][params][program]") {
  const CTestFolder folder;
  folder.Write("s.lua",
               "function init() end\nfunction step() v = robot.params.speed end\n"
               "function reset() end\nfunction destroy() end\n");
  folder.Write("l.lua", "function init() items = simulation.params.items end\n");
  folder.Write("e.argos", Experiment("", ""));
  const SProgramRun wrong =
      folder.Run({"e.argos", "--check", "--set", "//lua_controller/params/@sped=5", "--set",
                  "loop_functions/params/@item=5"});
  CHECK(wrong.Status == 1);
  CHECK_THAT(wrong.Err,
             Contains("--set //lua_controller/params/@sped=5: e.argos:4: <params>: attribute "
                      "\"sped\" is not used by anything; did you mean \"speed\"?") &&
                 Contains("--set loop_functions/params/@item=5: e.argos:5: <params>: attribute "
                          "\"item\" is not used by anything; did you mean \"items\"?"));
  const SProgramRun right =
      folder.Run({"e.argos", "--quiet", "--set", "//lua_controller/params/@speed=5", "--set",
                  "loop_functions/params/@items=5"});
  CHECK(right.Status == 0);
  CHECK(right.Err == "");
  // leftovers of a file are warnings
  folder.Write("e.argos", Experiment("sped='5'", "item='5'"));
  const SProgramRun file = folder.Run({"e.argos", "--quiet"});
  CHECK(file.Status == 0);
  CHECK(file.Err ==
        "[WARNING] e.argos:4: <params>: attribute \"sped\" is not used by anything; did you mean "
        "\"speed\"?\n"
        "[WARNING] e.argos:5: <params>: attribute \"item\" is not used by anything; did you mean "
        "\"items\"?\n");
}

}  // namespace lua_parameters_test
