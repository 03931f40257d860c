// Warnings about what makes a run differ from another one of the same experiment.

#include "lua_tester.h"

#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

namespace lua_variations_test {

using namespace argos;
using Catch::Contains;

TEST_CASE("lua variations: what differs from run to run is reported once, with its line",
          "[lua][variations]") {
  const auto [code, message] = GENERATE(table<std::string, std::string>(
      {{"for k in pairs({[{}] = 1, [{}] = 2}) do end",
        "pairs() visits several keys that are tables or functions"},
       {"for k in pairs({[print] = 1, a = 2, [{}] = 2}) do end",
        "pairs() visits several keys that are tables or functions"},
       {"for k in next, {a = 1, b = 2} do end", "next() visits strings"},
       {"local k = next({[{}] = 1, [{}] = 2}); t = {a = 1, b = 2}; k = next(t, (next(t)))",
        "next() visits strings"},
       {"s = tostring({})", "the text of a table or function is its address"},
       {"s = tostring(print) .. 'x'", "the text of a table or function is its address"},
       {"print('values:', {}, 5)", "the text of a table or function is its address"},
       {"s = ('%s'):format({})", "the text of a table or function is its address"},
       {"s = string.format('%p', coroutine.create(print))",
        "the text of a table or function is its address"},
       {"math.randomseed()", "math.randomseed() without a number draws a seed"},
       {"t = os.time()", "os.time() depends on the clock of the machine"},
       {"t = os.clock()", "os.clock() depends on the clock of the machine"},
       {"t = os.date('%Y')", "os.date() depends on the clock of the machine"}}));
  CAPTURE(code);
  CLuaTester lua;
  lua.Do("\n" + code);
  CHECK_THAT(TakeLogErr(), Contains("[WARNING] ") && Contains(":2: " + message));
  lua.Do(code);
  lua.Do("function f() " + code + " end f()");
  CHECK(TakeLogErr() == "");
}

TEST_CASE("lua variations: what is the same in each run is not reported", "[lua][variations]") {
  CLuaTester lua;
  lua.Do(
      "for k in pairs({a = 1, b = 2, [1] = 3, [true] = 4, [{}] = 5}) do end\n"
      "for k in pairs({1, 2, 3}) do end for k in next, {1, 2, 3} do end\n"
      "for k in next, {[true] = 1, [2.5] = 2} do end\n"
      "is_empty = next({a = 1, b = 2}) == nil and next({[{}] = 1}) == nil\n"
      "s = tostring(5) .. tostring('x') .. tostring(nil) .. tostring(vector3())\n"
      "s = tostring(setmetatable({}, { __tostring = function() return 'mine' end }))\n"
      "s = ('%d %s %s'):format(5, true, vector2())\n"
      "math.randomseed(5) t = os.time({ year = 2020, month = 1, day = 1 })\n"
      "t = os.date('%Y', 0)\n");
  CHECK(TakeLogErr() == "");
  CHECK(lua.Get("s") == "5 true 0,0");
  CHECK(lua.Get("is_empty") == "false");
}

TEST_CASE("lua variations: math.randomseed() works as in Lua", "[lua][variations]") {
  CLuaTester lua;
  lua.Do("math.randomseed(7) a = math.random(1000000) math.randomseed(7) b = math.random(1000000)");
  CHECK(lua.Get("a == b") == "true");
  // the two numbers of the seed
  lua.Do(
      "x, y = math.randomseed() math.randomseed(x, y) a = math.random(1000000)\n"
      "math.randomseed(x, y) b = math.random(1000000)");
  CHECK(lua.Get("a == b") == "true");
  CHECK(TakeLogErr() != "");
}

TEST_CASE("lua variations: next() is as in Lua", "[lua][variations]") {
  CLuaTester lua;
  lua.Do("n = 0 for k, v in next, {1, 2, x = 3} do n = n + v end");
  CHECK(lua.Get("n") == "6");
  CHECK(lua.Get("next({})") == "nil");
  CHECK(lua.Get("select('#', next({}))") == "1");
  CHECK(lua.Get("select(2, next({7}))") == "7");
  CHECK_THAT(lua.GetError("next(5)"), Contains("table expected, got number"));
  CHECK_THAT(lua.GetError("next({}, 'x')"), Contains("invalid key to 'next'"));
  CHECK(TakeLogErr() != "");
}

}  // namespace lua_variations_test
