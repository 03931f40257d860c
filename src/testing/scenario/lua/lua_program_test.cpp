// Lua scripts from the user's view of the program: exit status, messages, and
// the experiments of this project.

#include "../command_line/program_run.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <regex>

namespace lua_program_test {

using namespace argos;
using Catch::Contains;

namespace {

const std::string kGood =
    "function init() end\nfunction step() robot.wheels.set_velocity(10, 10) end\n"
    "function reset() end\nfunction destroy() end\n";

std::string Experiment(const std::string& params, const std::string& loopFunctions = "") {
  return "<argos-configuration>\n"
         "<framework><experiment ticks_per_second='10' length='1' random_seed='1'/></framework>\n"
         "<controllers><lua_controller id='c'><actuators>"
         "<differential_steering implementation='default'/></actuators><sensors/>\n"
         "<params " +
         params +
         "/></lua_controller></controllers>\n"
         "<physics_engines><dynamics2d id='d'/></physics_engines>\n<media/>\n"
         "<arena size='4,4,1'><foot-bot id='fb'><body position='0,0,0'/><controller config='c'/>"
         "</foot-bot></arena>\n" +
         loopFunctions + "\n</argos-configuration>\n";
}

std::string DigestIn(const std::string& text) {
  std::smatch match;
  return std::regex_search(text, match, std::regex("digest: ([0-9a-f]{16})\n")) ? match[1].str()
                                                                                : "";
}

}  // namespace

TEST_CASE("lua program: a valid script runs from any working directory", "[lua][program]") {
  const CTestFolder folder;
  folder.Write("good.lua", kGood);
  folder.Write("e.argos", Experiment("script='good.lua'"));
  const SProgramRun run = folder.Run({"-c", "e.argos", "--digest"});
  CHECK(run.Status == 0);
  CHECK(run.Err == "");
  // in another folder the script is found beside the experiment
  const CTestFolder elsewhere;
  const SProgramRun other = elsewhere.Run({"-c", folder.Path("e.argos"), "--digest"});
  CHECK(other.Status == 0);
  CHECK(other.Err == "");
  CHECK(DigestIn(other.Out) == DigestIn(run.Out));
  CHECK(DigestIn(run.Out) != "");
}

TEST_CASE("lua program: errors before the first tick end the program with status 1",
          "[lua][program]") {
  const CTestFolder folder;
  const auto [text, message] = GENERATE(table<std::string, std::string>(
      {{"x = = 1\n", "bad.lua:1: unexpected symbol near '='"},
       {"error('no good')\n", "bad.lua:1: no good"},
       {"\nfunction init() undefined() end\n",
        "bad.lua:2: attempt to call a nil value (global 'undefined')"},
       {"function init() robot.wheels.set_velocity('fast') end\n",
        "robot.wheels.set_velocity: argument 1 must be a number, got string \"fast\""},
       {"init = 5\n", "must define a global function \"init\", found number"},
       {"while true do end\n", "bad.lua:1: interrupted after 1000000 instructions"}}));
  CAPTURE(text);
  folder.Write("bad.lua", text);
  folder.Write("e.argos", Experiment("script='bad.lua' max_instructions='1000000'"));
  const SProgramRun run = folder.Run({"-c", "e.argos"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("[FATAL]") && Contains("robot \"fb\"") && Contains(message) &&
                          Contains("e.argos:3"));
}

TEST_CASE("lua program: a missing script ends the program with status 1", "[lua][program]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment("script='none.lua'"));
  const SProgramRun run = folder.Run({"-c", "e.argos"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("there is no Lua script \"none.lua\"; looked for \"" +
                               folder.Path("none.lua") + "\""));
}

TEST_CASE("lua program: --check finds functions that the run would miss", "[lua][program]") {
  const CTestFolder folder;
  const auto [text, message] = GENERATE(table<std::string, std::string>(
      {{"function init() end\nfunction stpe() end\nfunction destroy() end\n",
        "global function \"step\", found nil; did you mean \"stpe\"?"},
       {"function init() end\nfunction destroy() end\nstep = 5", "\"step\", found number\n"},
       {"function init() end\nfunction step() end\nfunction destory() end\n",
        "global function \"destroy\", found nil; did you mean \"destory\"?"},
       {"function init() end\nfunction step() end\nfunction rset() end\nfunction destroy() end\n",
        "global function \"reset\", found nil; did you mean \"rset\"?"},
       {"function inti() end\n", "global function \"init\", found nil; did you mean \"inti\"?"}}));
  CAPTURE(text);
  folder.Write("bad.lua", text);
  folder.Write("e.argos", Experiment("script='bad.lua'"));
  const SProgramRun run = folder.Run({"e.argos", "--check"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("the Lua script \"bad.lua\"") && Contains(message));
}

TEST_CASE("lua program: --check accepts functions that init() defines, and no reset()",
          "[lua][program]") {
  const CTestFolder folder;
  folder.Write("good.lua", "function init() step = function() end end\nfunction destroy() end\n");
  folder.Write("e.argos", Experiment("script='good.lua'"));
  const SProgramRun run = folder.Run({"e.argos", "--check", "--quiet"});
  CHECK(run.Status == 0);
  CHECK(run.Err == "");
}

TEST_CASE("lua program: robots that init() adds are recorded, drawn and replayed",
          "[lua][program]") {
  const CTestFolder folder;
  folder.Write("good.lua", kGood);
  folder.Write("loop.lua",
               "function init()\n"
               "  for i = 1, 20 do\n"
               "    simulation.add(string.format([[<foot-bot id='r%d'><body position='%g,%g,0'/>"
               "<controller config='c'/></foot-bot>]], i, i % 5 * 0.3 - 1.5, i // 5 * 0.3 - 1.5))\n"
               "  end\n"
               "end\n");
  folder.Write("e.argos",
               Experiment("script='good.lua'",
                          "<loop_functions label='lua'><params script='loop.lua'/></loop_functions>"
                          "<visualization><offscreen width='32' height='32' every='5' "
                          "directory='frames'/><povray width='32' height='32' every='5' "
                          "directory='scenes' render='false'/></visualization>"));
  const SProgramRun run =
      folder.Run({"e.argos", "--record", "run.rec", "--csv", "data", "--digest", "--quiet"});
  CHECK(run.Status == 0);
  CHECK(run.Err == "");
  CHECK_THAT(folder.Read("data/robots.csv"), Contains("r20"));
  const SProgramRun replay = folder.Run({"--replay", "run.rec", "--csv", "again"});
  CHECK(replay.Status == 0);
  CHECK_THAT(folder.Read("again/robots.csv"), Contains("r20"));
}

TEST_CASE("lua program: an error in step() ends the run only on request", "[lua][program]") {
  const CTestFolder folder;
  folder.Write("bad.lua",
               "function init() end\nfunction step() robot.wheels.set_velocity(1, nil) end\n"
               "function reset() end\nfunction destroy() end\n");
  folder.Write("e.argos", Experiment("script='bad.lua'"));
  const SProgramRun goesOn = folder.Run({"-c", "e.argos"});
  CHECK(goesOn.Status == 3);
  const std::string once =
      "[FATAL] robot \"fb\": the Lua script \"bad.lua\" failed in step()\n"
      "[FATAL] bad.lua:2: robot.wheels.set_velocity: argument 2 must be a number, got nil\n"
      "[FATAL] stack traceback:\n"
      "[FATAL] \t[C]: in field 'set_velocity'\n"
      "[FATAL] \tbad.lua:2: in function 'step'\n"
      "[FATAL] \t[C]: in ?\n";
  CHECK(
      goesOn.Err ==
      once +
          "[FATAL] 1 of 1 robots are stopped because of errors; all errors of robots in this "
          "run:\n"
          "[FATAL] once, first in tick 1, of \"fb\": robot \"fb\": the Lua script \"bad.lua\" "
          "failed in step()\n"
          "[FATAL]   bad.lua:2: robot.wheels.set_velocity: argument 2 must be a number, got nil\n");
  CHECK_THAT(goesOn.Notices, Contains("simulated 1 s"));
  folder.Write("e.argos", Experiment("script='bad.lua' on_error='end_run'"));
  const SProgramRun ends = folder.Run({"-c", "e.argos"});
  CHECK(ends.Status == 1);
  CHECK_THAT(ends.Err,
             Contains("robot \"fb\": ControlStep() threw in tick 1") && Contains("bad.lua:2:"));
  CHECK_THAT(ends.Notices, !Contains("simulated"));
}

TEST_CASE("lua program: errors of loop functions end the run with status 1, in every hook",
          "[lua][program]") {
  const CTestFolder folder;
  folder.Write("good.lua", kGood);
  const std::string hook = GENERATE("init", "pre_step", "post_step", "is_experiment_finished",
                                    "post_experiment", "destroy");
  CAPTURE(hook);
  folder.Write("loop.lua", "\nfunction " + hook + "() error('no good') end\n");
  folder.Write(
      "e.argos",
      Experiment("script='good.lua'",
                 "<loop_functions label='lua'><params script='loop.lua'/></loop_functions>"));
  const SProgramRun run = folder.Run({"-c", "e.argos"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("failed in " + hook + "()") && Contains("loop.lua:2: no good") &&
                          Contains("stack traceback:"));
}

TEST_CASE("lua program: queries describe controllers and loop functions in Lua", "[lua][program]") {
  const CTestFolder folder;
  CHECK_THAT(folder.Run({"-q", "loop_functions"}).Out,
             Contains("[ lua ]\n      Loop functions written in Lua."));
  CHECK_THAT(folder.Run({"-q", "lua"}).Out, Contains("[ lua ]") && Contains("floor_color") &&
                                                Contains("See also: lua_controller\n"));
  CHECK_THAT(folder.Run({"-q", "lua_controller"}).Out,
             Contains("[ lua_controller ]") && Contains("on_error"));
}

TEST_CASE("lua program: the crowd example of the documentation runs", "[lua][program]") {
  const CTestFolder folder;
  const SProgramRun run = folder.Run({"-zc", InSourceTree("experiments/crowd_lua.argos"),
                                      "--length", "2", "--set", "//entity/@quantity=100"});
  CHECK(run.Status == 0);
  CHECK(run.Err == "");
  CHECK_THAT(run.Notices, Contains("100 robots"));
}

TEST_CASE("lua program: diffusion in Lua and in C++ is equal bit by bit", "[lua][program]") {
  const std::string name = GENERATE("diffusion_1", "diffusion_10");
  CAPTURE(name);
  const std::string path = InSourceTree("experiments/" + name);
  const std::string library = InBuildTree("experiments/libfootbot_diffusion");
  const CTestFolder folder;
  const SProgramRun cpp =
      folder.Run({"-zc", path + ".argos", "--digest", "--set",
                  "controllers/footbot_diffusion_controller/@library=" + library});
  const SProgramRun lua = folder.Run({"-zc", path + "_lua.argos", "--digest"});
  REQUIRE(cpp.Status == 0);
  REQUIRE(lua.Status == 0);
  CHECK(lua.Err == "");
  CHECK(DigestIn(cpp.Out) != "");
  CHECK(DigestIn(lua.Out) == DigestIn(cpp.Out));
}

}  // namespace lua_program_test
