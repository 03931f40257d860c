#include "lua_tester.h"

#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <stdexcept>

namespace lua_state_test {

using namespace argos;
using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("lua state: has all standard libraries", "[lua][state]") {
  CLuaTester lua;
  const std::string name =
      GENERATE("string.format", "table.concat", "math.sin", "io.open", "os.time", "debug.traceback",
               "coroutine.create", "utf8.char", "require", "package.searchers", "print", "load");
  CAPTURE(name);
  CHECK(lua.Get("type(" + name + ')') != "nil");
}

TEST_CASE("lua state: an error carries file, line and traceback", "[lua][state]") {
  CLuaTester lua;
  std::string message;
  try {
    lua.Do("function inner() error('no good') end\nfunction outer()\n  inner()\nend\nouter()");
  } catch (const CLuaError& error) {
    message = error.GetMessage();
  }
  CHECK_THAT(message, StartsWith("test:1: no good\nstack traceback:\n") &&
                          Contains("in function 'inner'") && Contains("in function 'outer'"));
}

TEST_CASE("lua state: errors that are not strings are described", "[lua][state]") {
  CLuaTester lua;
  CHECK(lua.GetError("error({})") == "(the error is a table value)");
  CHECK(lua.GetError("error()") == "(the error is a nil value)");
  CHECK(lua.GetError("error(setmetatable({}, {__tostring = function() return 'mine' end}))") ==
        "mine");
  CHECK(lua.GetError("error(setmetatable({}, {__tostring = function() return 1 end}))") ==
        "(the error is a table value)");
}

TEST_CASE("lua state: exceptions pass through Run, and the state can be used again",
          "[lua][state]") {
  CLuaTester lua;
  lua.Do("x = 3");
  CHECK_THROWS_AS(lua.Run([](lua_State* state) {
    lua_pushinteger(state, 1);
    throw std::out_of_range("mine");
  }),
                  std::out_of_range);
  CHECK(lua.GetNumber("x") == 3.0);
}

TEST_CASE("lua state: the error on a missing function names it", "[lua][state]") {
  CLuaTester lua;
  const auto call = [&](const char* name) {
    lua.Run([name](lua_State* state) { CLuaState::CallGlobal(state, name); });
  };
  CHECK_THROWS_WITH(call("step"),
                    Contains("the script must define a global function \"step\", found nil"));
  lua.Do("step = 5");
  CHECK_THROWS_WITH(call("step"), Contains("found number"));
  lua.Do("function step() done = true end");
  call("step");
  CHECK(lua.Get("done") == "true");
}

TEST_CASE("lua state: endless loops are interrupted, even if they catch errors", "[lua][state]") {
  CLuaTester lua(50000);
  const std::string loop = GENERATE(
      "while true do end", "repeat until false", "for i = 1, math.huge do end",
      "local function f() return f() end f()", "::again:: goto again",
      "while true do pcall(function() while true do end end) end", "while true do pcall(error) end",
      "xpcall(function() while true do end end, function() while true do end end)",
      "xpcall(error, function() while true do end end)",
      "coroutine.wrap(function() while true do end end)()",
      "while true do coroutine.resume(coroutine.create(function() for i = 1, 10 do end end)) end",
      "local c = coroutine.wrap(function() while true do coroutine.yield() end end)\n"
      "while true do c() end",
      "setmetatable(_G, {__index = function(t, k) return t[k .. 1] end}) local _ = undefined");
  CAPTURE(loop);
  // the chunk must go on for the error to leave an xpcall()
  const std::string error = lua.GetError(loop + "\nlocal done = true");
  CHECK_THAT(error, Contains("interrupted after 50000 instructions") ||
                        // an endless recursion may reach the stack limit first
                        Contains("C stack overflow"));
  // afterwards the state works as before
  CHECK(lua.GetNumber("1 + 1") == 2.0);
  CHECK(lua.GetError("for i = 1, 5000 do end") == "");
}

TEST_CASE("lua state: the instruction limit applies to each call separately", "[lua][state]") {
  CLuaTester lua(100000);
  // each call takes about 30,000 instructions, all together ten times the limit
  for (int i = 0; i < 35; ++i) {
    CHECK(lua.GetError("local sum = 0 for i = 1, 15000 do sum = sum + i end") == "");
  }
  // the same in a coroutine that is resumed by each call
  lua.Do(
      "worker = coroutine.wrap(function()\n"
      "  while true do for i = 1, 15000 do end coroutine.yield() end\n"
      "end)");
  for (int i = 0; i < 35; ++i) {
    CHECK(lua.GetError("worker()") == "");
  }
}

TEST_CASE("lua state: the point of interruption does not depend on time", "[lua][state]") {
  const auto count = [] {
    CLuaTester lua(20000);
    CHECK_THAT(lua.GetError("n = 0 while true do n = n + 1 end"), Contains("interrupted"));
    return lua.GetNumber("n");
  };
  const Real first = count();
  CHECK(first > 1000.0);
  CHECK(count() == first);
}

TEST_CASE("lua state: without a limit instructions are not counted", "[lua][state]") {
  CLuaTester lua(0);
  CHECK(lua.Get("debug.gethook()") == "nil");
  CHECK(lua.GetError("for i = 1, 1000000 do end") == "");
}

TEST_CASE("lua state: pairs visits numbers, then strings, then booleans, in order",
          "[lua][state]") {
  CLuaTester lua;
  lua.Do(
      "t = { zebra = 1, apple = 2, [3] = 3, mango = 4, [-1] = 5, [2.5] = 6, [true] = 7,\n"
      "      [false] = 8, ['10'] = 9, ['9'] = 10 }\n"
      "order = ''\n"
      "for k, v in pairs(t) do order = order .. tostring(k) .. '=' .. v .. ' ' end");
  CHECK(lua.Get("order") == "-1=5 2.5=6 3=3 10=9 9=10 apple=2 mango=4 zebra=1 false=8 true=7 ");
}

TEST_CASE("lua state: pairs visits every entry once, as in Lua", "[lua][state]") {
  CLuaTester lua;
  lua.Do(
      "t, n, sum = {}, 0, 0\n"
      "for i = 1, 500 do t[i] = i; t['key' .. i] = i; t[{}] = i end\n"
      "for k, v in pairs(t) do n = n + 1; sum = sum + v end");
  CHECK_THAT(TakeLogErr(), Contains("test:3: pairs() visits several keys"));
  CHECK(lua.GetNumber("n") == 1500.0);
  CHECK(lua.GetNumber("sum") == 3 * 500 * 501 / 2);
  // a loop may remove entries that it has not visited yet, and change entries
  lua.Do(
      "t, seen = { a = 1, b = 2, c = 3, d = 4 }, ''\n"
      "for k, v in pairs(t) do seen = seen .. k .. v; t.c = nil; t.d = 9 end");
  CHECK(lua.Get("seen") == "a1b2d9");
  lua.Do("t = { a = 1, b = 2, c = 3 } for k in pairs(t) do t[k] = nil end");
  CHECK(lua.Get("next(t)") == "nil");
  lua.Do("n = 0 for k, v in pairs({}) do n = n + 1 end");
  CHECK(lua.GetNumber("n") == 0.0);
}

TEST_CASE("lua state: pairs obeys __pairs and refuses other values than tables", "[lua][state]") {
  CLuaTester lua;
  lua.Do(
      "local function step(_, k) if k < 3 then return k + 1, 'v' end end\n"
      "t = setmetatable({}, { __pairs = function(t) return step, t, 0 end })\n"
      "seen = ''\n"
      "for k, v in pairs(t) do seen = seen .. k .. v end");
  CHECK(lua.Get("seen") == "1v2v3v");
  CHECK_THAT(lua.GetError("for k in pairs(nil) do end"), Contains("table expected, got nil"));
  CHECK_THAT(lua.GetError("pairs()"), Contains("bad argument #1"));
}

TEST_CASE("lua state: xpcall works as in Lua", "[lua][state]") {
  CLuaTester lua;
  lua.Do(
      "function handler(message) return 'handled ' .. message end\n"
      "a, b = xpcall(error, handler, 'this')\n"
      "c, d, e = xpcall(function(...) return ... end, handler, 1, 2)\n"
      "thread = coroutine.wrap(function()\n"
      "  local ok, message = xpcall(function() coroutine.yield('first') error('late', 0) end, "
      "handler)\n"
      "  return message\n"
      "end)\n"
      "f, g = thread(), thread()");
  CHECK(lua.Get("a") == "false");
  CHECK(lua.Get("b") == "handled this");
  CHECK(lua.Get("c") == "true");
  CHECK(lua.Get("d + e") == "3");
  CHECK(lua.Get("f") == "first");
  CHECK(lua.Get("g") == "handled late");
  CHECK_THAT(lua.GetError("xpcall(print)"), Contains("bad argument #2"));
}

TEST_CASE("lua state: math.random gives equal numbers for equal seeds", "[lua][state]") {
  const std::string draw = "math.random() .. ' ' .. math.random(1000000)";
  CLuaTester lua;
  lua.SeedMath(1);
  const std::string first = lua.Get(draw);
  CHECK(lua.Get(draw) != first);
  lua.SeedMath(2);
  CHECK(lua.Get(draw) != first);
  lua.SeedMath(1);
  CHECK(lua.Get(draw) == first);
  CLuaTester other;
  other.SeedMath(1);
  CHECK(other.Get(draw) == first);
}

TEST_CASE("lua state: warn writes to the error log once it is on", "[lua][state]") {
  CLuaTester lua;
  lua.Do("warn('nobody hears this')");
  CHECK(TakeLogErr() == "");
  lua.Do("warn('@on') warn('something ', 'odd') warn('@off') warn('no more')");
  CHECK(TakeLogErr() == "Lua warning: something odd\n");
}

TEST_CASE("lua state: log writes arguments without separators, then a newline", "[lua][state]") {
  CLuaTester lua;
  lua.Do("log('a', 1, ' ', 1.0, ' ', 1/3, ' ', 1e10, ' ', true, false)");
  CHECK(TakeLog() == "a1 1 0.333333 1e+10 10\n");
  lua.Do("log(nil, ' ', {}, ' ', print, ' ', vector2(1, 2), ' ', coroutine.create(print))");
  CHECK(TakeLog() == "nil table function userdata thread\n");
  lua.Do("log(tostring(vector2(1, 2)))");
  CHECK(TakeLog() == "1,2\n");
  lua.Do("log()");
  CHECK(TakeLog() == "\n");
  lua.Do("logerr('to the error log')");
  CHECK(TakeLogErr() == "to the error log\n");
  CHECK(TakeLog() == "");
}

}  // namespace lua_state_test
