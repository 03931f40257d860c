// Errors in scripts that misspelt names cause.

#include "../command_line/program_run.h"

#include <catch2/catch.hpp>

#include <regex>

namespace lua_messages_test {

using namespace argos;
using Catch::Contains;

namespace {

std::string Experiment() {
  return "<argos-configuration>\n"
         "<framework><experiment ticks_per_second='10' length='1' random_seed='1'/></framework>\n"
         "<controllers><lua_controller id='c'><actuators>"
         "<differential_steering implementation='default'/>"
         "<range_and_bearing implementation='default'/></actuators><sensors>"
         "<range_and_bearing implementation='medium' medium='rab'/></sensors>\n"
         "<params script='s.lua'/></lua_controller></controllers>\n"
         "<physics_engines><dynamics2d id='d'/></physics_engines>\n"
         "<media><range_and_bearing id='rab'/></media>\n"
         "<arena size='4,4,1'><foot-bot id='fb'><body position='0,0,0'/><controller config='c'/>"
         "</foot-bot></arena>\n</argos-configuration>\n";
}

// the error of a step(), whose first line is line 3 of the script
std::string ErrorOf(const std::string& step) {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  folder.Write("s.lua", "function init() end\nfunction step()\n" + step +
                            "\nend\nfunction reset() end\nfunction destroy() end\n");
  const SProgramRun run = folder.Run({"e.argos", "--quiet"});
  CHECK(run.Status == 3);
  // every line has its level
  CHECK(std::regex_match(run.Err, std::regex("(\\[FATAL\\] [^\n]*\n)+")));
  return run.Err;
}

}  // namespace

TEST_CASE("lua messages: a name without a value is explained by the nearest", "[lua][program]") {
  const auto [step, message] = GENERATE(table<std::string, std::string>(
      {{"local n = #robot.range_and_bering",
        "s.lua:3: attempt to get length of a nil value (field 'range_and_bering'); robot has no "
        "\"range_and_bering\"; did you mean \"range_and_bearing\"?\n"},
       {"for _, m in ipairs(robot.range_and_bering) do log(m) end",
        "; robot has no \"range_and_bering\"; did you mean \"range_and_bearing\"?\n"},
       {"for _, m in pairs(robot.range_and_bering) do log(m) end",
        "; robot has no \"range_and_bering\"; did you mean \"range_and_bearing\"?\n"},
       {"local rab = robot.range_and_bering -- comment\nlog('x')\nlog(rab[1])",
        "s.lua:5: attempt to index a nil value (local 'rab'); line 3: robot has no "
        "\"range_and_bering\"; did you mean \"range_and_bearing\"?\n"},
       // not the first name that is missing, but that of the variable
       {"local speed = robot.params.sped\nlocal stay = robot.params.wait\nlog(1 + stay)",
        "(local 'stay'); line 4: robot.params has no \"wait\"; it has: "},
       {"robot.distances = {1, 2}\nfor _, m in ipairs(robot.distances) do\nlog(m.value) end",
        "s.lua:5: attempt to index a number value (local 'm'); line 4: robot.distances is a list "
        "of "
        "numbers, without fields\n"},
       {"robot.wheels.set_velocty(1, 1)",
        "s.lua:3: attempt to call a nil value (field 'set_velocty'); robot.wheels has no "
        "\"set_velocty\"; did you mean \"set_velocity\"?\n"},
       {"robot.whels.set_velocity(1, 1)",
        "attempt to index a nil value (field 'whels'); robot has no \"whels\"; did you mean "
        "\"wheels\"?\n"},
       {"log(robot.wheels:set_velocty(1, 1))",
        "attempt to call a nil value (method 'set_velocty'); robot.wheels has no "
        "\"set_velocty\"; did you mean \"set_velocity\"?\n"},
       {"logg('x')", "(global 'logg'); there is no global \"logg\"; did you mean \"log\""},
       {"log(robot.proximity[1].value)",
        "(field 'proximity'); robot has no \"proximity\"; it has: id, params, random, "
        "range_and_bearing, wheels; is its device in <sensors> or <actuators>?\n"}}));
  CAPTURE(step);
  const std::string error = ErrorOf(step);
  CHECK_THAT(error, Contains(message));
  // also where Lua itself gives no place
  CHECK_THAT(error, Contains("[FATAL] s.lua:3: ") || Contains("[FATAL] s.lua:5: "));
}

TEST_CASE("lua messages: errors that no name explains stay as they are", "[lua][program]") {
  const std::string step =
      GENERATE(as<std::string>{}, "error('robot.whels')", "local x = nil; log(x.y)",
               "robot.state = nothing.of_this", "log(#robot.params.speed)", "log(1 + {})");
  CAPTURE(step);
  const std::string error = ErrorOf(step);
  CHECK_THAT(error, Contains("[FATAL] s.lua:3: "));
  CHECK_THAT(error, !Contains("did you mean"));
}

TEST_CASE("lua messages: lines before are blamed only for names that are nearly right",
          "[lua][program]") {
  const auto [name, isBlamed] =
      GENERATE(table<std::string, bool>({{"robot.whels", true}, {"robot.qqq", false}}));
  const std::string error = ErrorOf("local kept = " + name + "\nlocal x = nil\nlog(x.y)");
  CHECK_THAT(error, Contains("s.lua:5: attempt to index a nil value (local 'x')"));
  CHECK((error.find("line 3: robot has no \"whels\"; did you mean \"wheels\"?") !=
         std::string::npos) == isBlamed);
  CHECK_THAT(error, !Contains("qqq"));
}

TEST_CASE("lua messages: a colon in place of a dot is named", "[lua][program]") {
  CHECK_THAT(ErrorOf("robot.wheels:set_velocity(1, 1)"),
             Contains("s.lua:3: robot.wheels.set_velocity: argument 1 must be a number, got table; "
                      "call it with a dot, not with a colon\n"));
  CHECK_THAT(ErrorOf("robot.range_and_bearing:clear_data()"),
             Contains("too many arguments: expected 0, got 1; call it with a dot"));
  CHECK_THAT(ErrorOf("robot.wheels.set_velocity({}, 1)"), !Contains("dot"));
}

}  // namespace lua_messages_test
