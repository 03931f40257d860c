// What scripts cannot do, to the process, to others, or to their own limits.

#include "lua_tester.h"

#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/wrappers/lua/lua_script.h>
#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/comma_locale.h>

#include <catch2/catch.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace lua_sandbox_test {

using namespace argos;
using Catch::Contains;
using Catch::StartsWith;

namespace {

constexpr UInt64 kFewInstructions = 200000;

SLuaLimits Unsafe() {
  SLuaLimits limits;
  limits.IsUnsafe = true;
  return limits;
}

SLuaLimits WithMemory(UInt64 mebi) {
  SLuaLimits limits;
  limits.MaxMemory = mebi * SLuaLimits::kMebi;
  return limits;
}

/** A file that is removed by the destructor. */
class CTemporaryFile {
 public:
  CTemporaryFile(const std::string& name, const std::string& content)
      : m_path((std::filesystem::temp_directory_path() / name).string()) {
    std::ofstream(m_path, std::ios::binary) << content;
  }
  ~CTemporaryFile() { std::remove(m_path.c_str()); }
  CTemporaryFile(const CTemporaryFile&) = delete;
  CTemporaryFile& operator=(const CTemporaryFile&) = delete;

  const std::string& GetPath() const { return m_path; }

 private:
  std::string m_path;
};

std::string GetBytecode() {
  CLuaTester lua(Unsafe());
  std::string code;
  lua.Do("code = string.dump(function() return 42 end)");
  lua.Run([&code](lua_State* state) {
    lua_getglobal(state, "code");
    std::size_t length = 0;
    const char* const text = lua_tolstring(state, -1, &length);
    code.assign(text, length);
  });
  return code;
}

}  // namespace

TEST_CASE("lua sandbox: what acts on the whole process is an error", "[lua][sandbox]") {
  CLuaTester lua(GENERATE(SLuaLimits(), Unsafe()));
  CHECK_THAT(lua.GetError("os.exit()"), StartsWith("test:1: os.exit() ends the whole process"));
  CHECK_THAT(lua.GetError("os.exit(true, true)"), Contains("os.exit()"));
  CHECK_THAT(lua.GetError("os.setlocale('C')"), StartsWith("test:1: os.setlocale()"));
  CHECK_THAT(lua.GetError("os.setlocale('', 'numeric')"), Contains("os.setlocale()"));
  CHECK(lua.Get("os.setlocale()") == "C");
}

TEST_CASE("lua sandbox: our functions check what they are called with", "[lua][sandbox]") {
  CLuaTester lua;
  const auto [code, message] = GENERATE(table<std::string, std::string>(
      {{"pairs()", "bad argument #1 to 'pairs'"},
       {"for _ in pairs(nil) do end", "bad argument #1"},
       {"pairs({a = 1})()", "table expected, got no value"},
       {"pairs({a = 1})(5)", "table expected, got number"},
       {"pairs({a = 1})(vector2())", "table expected, got vector2"},
       {"local _ = -vector2 + 1", "attempt to perform arithmetic on a function value"},
       {"vector2.x = 1", "attempt to index a function value"},
       {"vector2():dot()", "vector2:dot: argument 1 must be a vector2, got nothing"},
       {"vector2().dot()", "must be called on a vector2 with a colon, got nothing"},
       {"vector3():cross(vector2())", "argument 1 must be a vector3, got vector2"},
       {"quaternion():toeulerangles(1)", "takes 0 arguments, got 1"},
       {"local v = vector2() v[nil] = 1", "components"},
       {"local v = vector2() v.x = {}", "must be a number, got table"},
       {"coroutine.wrap()", "bad argument #1"},
       {"coroutine.wrap(5)", "bad argument #1"},
       {"coroutine.create()", "bad argument #1"},
       {"coroutine.close()", "bad argument #1"},
       {"string.rep()", "bad argument #1"},
       {"string.rep('x')", "bad argument #2"},
       {"string.rep('x', {})", "bad argument #2"},
       {"string.rep('x', 2, {})", "bad argument #3"},
       {"table.move()", "bad argument #2"},
       {"table.move({}, {}, {})", "bad argument #2"},
       {"table.insert()", "bad argument #1"},
       {"table.insert(nil, 1, 2)", "bad argument #1"},
       {"table.insert({}, 5, 2)", "position out of bounds"},
       {"table.insert({}, 1, 2, 3)", "wrong number of arguments"},
       {"table.remove({}, 5)", "position out of bounds"},
       {"table.concat()", "bad argument #1"},
       {"table.concat({}, 1, 2, {})", "bad argument #4"},
       {"table.concat({{}})", "invalid value (table) at index 1"},
       {"setmetatable()", "bad argument #1"},
       {"setmetatable({}, 5)", "bad argument #2"},
       {"load()", "bad argument #1"},
       {"load('x', 'n', {})", "bad argument #3"},
       {"loadfile({})", "bad argument #1"},
       {"dofile({})", "bad argument #1"},
       {"dofile('/nowhere.lua')", "cannot open /nowhere.lua"},
       {"require()", "bad argument #1"},
       {"require('nowhere')", "module 'nowhere' not found"},
       {"os.setlocale({})", "os.setlocale()"}}));
  CAPTURE(code);
  CHECK_THAT(lua.GetError(code), Contains(message) && Contains("test:1:"));
}

TEST_CASE("lua sandbox: require() checks the path that a script sets", "[lua][sandbox]") {
  CLuaTester lua;
  CHECK(lua.GetError("package.path = {} require('nowhere')") == "package.path must be a string");
  CHECK_THAT(lua.GetError("package.path = '?' require('nowhere')"),
             Contains("module 'nowhere' not found"));
}

TEST_CASE("lua sandbox: metamethods of vectors check their operands", "[lua][sandbox]") {
  CLuaTester lua(Unsafe());
  lua.Do(
      "m = {getmetatable(vector2()), getmetatable(vector3()), getmetatable(quaternion())}\n"
      "values = {nil, 5, 'x', {}, print, vector2(), vector3(), quaternion(), io.stdout}");
  // every call ends, with a value or an error
  lua.Do(
      "for i = 1, 3 do for name, f in pairs(m[i]) do if type(f) == 'function' then\n"
      "  pcall(f) for a = 1, 9 do pcall(f, values[a]) for b = 1, 9 do\n"
      "    pcall(f, values[a], values[b]) pcall(f, values[a], values[b], values[b])\n"
      "end end end end end");
  CHECK_THAT(lua.GetError("m[1].__unm(5)"), Contains("vector2:__unm takes a vector2, got number"));
}

TEST_CASE("lua sandbox: replaced functions work as before", "[lua][sandbox]") {
  CLuaTester lua;
  lua.Do("t = {1, 2, 3} table.insert(t, 4) table.insert(t, 1, 0) removed = table.remove(t, 2)");
  CHECK(lua.Get("table.concat(t, ',')") == "0,2,3,4");
  CHECK(lua.Get("removed") == "1");
  CHECK(lua.Get("table.remove(t)") == "4");
  CHECK(lua.Get("table.concat(t, '-', 2, 3)") == "2-3");
  CHECK(lua.Get("table.concat(table.move({1, 2, 3}, 2, 3, 1), ',')") == "2,3,3");
  CHECK(lua.Get("('ab'):rep(3, '.')") == "ab.ab.ab");
  CHECK(lua.Get("('ab'):rep(0)") == "");
  CHECK(lua.Get("('ab'):rep(-1)") == "");
  CHECK(lua.Get("(''):rep(1 << 62)") == "");
  CHECK(lua.Get("load('return 1 + 1')()") == "2");
  CHECK(lua.Get("load('return x', 'name', 't', {x = 7})()") == "7");
  CHECK(lua.Get("select(2, load('= 1', '=name'))") == "name:1: unexpected symbol near '='");
  CHECK(lua.Get("getmetatable(setmetatable({}, {__index = 5})).__index") == "5");
  const CTemporaryFile file("argos_sandbox_test.lua", "return ..., 5\n");
  CHECK(lua.Get("select(2, dofile('" + file.GetPath() + "'))") == "5");
  CHECK(lua.Get("select(2, loadfile('" + file.GetPath() + "')(1))") == "5");
  CHECK(lua.Get("loadfile('/nowhere.lua')") == "nil");
}

TEST_CASE("lua sandbox: coroutines work as before", "[lua][sandbox]") {
  CLuaTester lua;
  lua.Do("c = coroutine.wrap(function(a) while true do a = coroutine.yield(a + 1) end end)");
  CHECK(lua.Get("c(1)") == "2");
  CHECK(lua.Get("c(5)") == "6");
  CHECK(lua.Get("select('#', coroutine.wrap(function() return 1, nil, nil end)())") == "3");
  CHECK_THAT(lua.GetError("coroutine.wrap(function() error('no good') end)()"),
             Contains("no good") && StartsWith("test:1:"));
  // texts of errors begin with the place of the call, as in Lua
  CHECK(lua.GetError("\ncoroutine.wrap(function() error('no good', 0) end)()") ==
        "test:2: no good");
  CHECK(lua.GetError("coroutine.wrap(function() error({}) end)()") ==
        "(the error is a table value)");
  CHECK_THAT(lua.GetError("local c = coroutine.wrap(function() end) c() c()"),
             Contains("cannot resume dead coroutine"));
  // a coroutine that fails closes its variables
  lua.Do(
      "closed = 0 mark = setmetatable({}, {__close = function() closed = closed + 1 end})\n"
      "pcall(coroutine.wrap(function() local x <close> = mark error('no good') end))");
  CHECK(lua.Get("closed") == "1");
  lua.Do(
      "co = coroutine.create(function() local x <close> = mark coroutine.yield() end)\n"
      "coroutine.resume(co) ok = coroutine.close(co)");
  CHECK(lua.Get("closed") == "2");
  CHECK(lua.Get("ok") == "true");
}

TEST_CASE("lua sandbox: more values than a stack holds cannot be passed to or from a coroutine",
          "[lua][sandbox]") {
  // a stack holds a million
  CLuaTester lua(WithMemory(200));
  lua.Do(
      "few = table.pack(string.byte(string.rep('x', 400000), 1, -1))\n"
      "many = table.pack(string.byte(string.rep('x', 700000), 1, -1))\n"
      "n = select('#', coroutine.wrap(function(...) return ... end)(table.unpack(few)))");
  CHECK(lua.Get("n") == "400000");
  CHECK_THAT(lua.GetError("local c = coroutine.wrap(function(...) coroutine.yield() end)\n"
                          "c(table.unpack(few)) c(table.unpack(many))"),
             Contains("too many arguments to resume"));
  CHECK_THAT(lua.GetError("local function f(...)\n"
                          "  coroutine.wrap(function() return table.unpack(many) end)()\n"
                          "end f(table.unpack(few))"),
             Contains("too many results to resume"));
  CHECK(lua.Get("coroutine.wrap(function() return 7 end)()") == "7");
}

TEST_CASE("lua sandbox: a limit of memory that no computer has is an error of the file",
          "[lua][sandbox][memory]") {
  const auto read = [](const std::string& mebi) {
    CConfigurationDocument document;
    document.Parse("<params max_memory='" + mebi + "'/>", "e.argos");
    return SLuaLimits::Read(document.GetRoot(), SLuaLimits()).MaxMemory;
  };
  CHECK(read("1048576") == UInt64{1} << 40);
  CHECK(read("0") == 0);
  CHECK_THROWS_WITH(read("1048577"),
                    Contains("e.argos:1: <params>: \"max_memory\" must be from 0 (no limit) to "
                             "1048576 MiB, got 1048577"));
}

TEST_CASE("lua sandbox: no way round the limit of instructions", "[lua][sandbox]") {
  CLuaTester lua(kFewInstructions);
  const std::string loop = GENERATE(
      // the end of an interrupted coroutine, whose hook is off
      "pcall(coroutine.wrap(function()\n"
      "  local x <close> = setmetatable({}, {__close = function() while true do end end})\n"
      "  while true do end end))",
      "local co = coroutine.create(function()\n"
      "  local x <close> = setmetatable({}, {__close = function() while true do end end})\n"
      "  while true do end end)\n"
      "pcall(coroutine.resume, co) coroutine.close(co)",
      "local co = coroutine.create(function()\n"
      "  local x <close> = setmetatable({}, {__close = function() while true do end end})\n"
      "  table.sort({3, 2, 1}, function() while true do end end) end)\n"
      "pcall(coroutine.resume, co) pcall(coroutine.close, co)",
      // many coroutines, each with a counter of its own
      "local function run() for i = 1, 100 do\n"
      "  coroutine.wrap(run)() end end\n"
      "while true do pcall(run) end",
      "while true do coroutine.wrap(function() for i = 1, 400 do end end)() end",
      // handlers and metamethods
      "while true do xpcall(error, function() while true do end end) end",
      "error(setmetatable({}, {__tostring = function() while true do end end}))",
      "table.sort({1, 2, 3}, function() while true do pcall(error) end end)",
      "(('x'):rep(100)):gsub('.', function() while true do end end)",
      "local x <close> = setmetatable({}, {__close = function() while true do end end})\n"
      "while true do end",
      "load(function() while true do end end)", "load(function() return ' ' end)",
      // loops in C
      "table.move({}, 1, 1 << 40, 2)", "table.move({}, 1, '1e15', 2)",
      "table.insert(setmetatable({}, {__len = function() return 1 << 60 end}), 1, 1)",
      "table.remove(setmetatable({}, {__len = function() return 1 << 60 end}), 1)",
      "table.concat(setmetatable({}, {__index = table.concat}), '', 1, 1 << 60)",
      "table.concat(setmetatable({}, {__index = table.concat, __len = function() return 1 << 60 "
      "end}))",
      // large copies
      "local s = ('x'):rep(1 << 20) while true do local t = s .. s end");
  CAPTURE(loop);
  CHECK_THAT(lua.GetError(loop + "\nlocal done = true"),
             Contains("interrupted after 200000 instructions") || Contains("C stack overflow") ||
                 Contains("not enough memory"));
  CHECK(lua.GetNumber("1 + 1") == 2.0);
}

TEST_CASE("lua sandbox: a hook cannot replace the limit of instructions", "[lua][sandbox]") {
  CLuaTester safe;
  CHECK_THAT(safe.GetError("debug.sethook()"),
             StartsWith("test:1: debug.sethook() is off; it needs unsafe=\"true\""));
  CLuaTester unsafe(Unsafe());
  CHECK_THAT(unsafe.GetError("debug.sethook()"), Contains("max_instructions=\"0\""));
  CHECK_THAT(unsafe.GetError("debug.sethook(coroutine.create(print), print, '', 1)"),
             Contains("max_instructions=\"0\""));
  SLuaLimits none = Unsafe();
  none.MaxInstructions = 0;
  CLuaTester unlimited(none);
  CHECK(unlimited.GetError("debug.sethook()") == "");
}

TEST_CASE("lua sandbox: the dangerous part of \"debug\" needs unsafe", "[lua][sandbox]") {
  const std::string name =
      GENERATE("debug", "getlocal", "getmetatable", "getregistry", "getupvalue", "getuservalue",
               "setcstacklimit", "setlocal", "setmetatable", "setupvalue", "setuservalue",
               "upvalueid", "upvaluejoin");
  CAPTURE(name);
  CLuaTester safe;
  CHECK_THAT(safe.GetError("debug." + name + "()"), Contains("debug." + name + "() is off"));
  CHECK(safe.Get("type(debug.getinfo(1).short_src) .. type(debug.traceback())") == "stringstring");
  CLuaTester unsafe(Unsafe());
  CHECK(unsafe.Get("type(debug." + name + ")") == "function");
  CHECK(unsafe.GetError("debug.getregistry()") == "");
}

TEST_CASE("lua sandbox: bytecode and libraries need unsafe", "[lua][sandbox]") {
  const CTemporaryFile file("argos_sandbox_bytecode.lua", GetBytecode());
  CLuaTester safe;
  CLuaTester unsafe(Unsafe());
  safe.Do("code = string.dump(function() return 42 end)");
  unsafe.Do("code = string.dump(function() return 42 end)");

  CHECK_THAT(safe.Get("select(2, load(code))"), Contains("attempt to load a binary chunk"));
  CHECK_THAT(safe.Get("select(2, load(code, 'c', 'bt'))"),
             Contains("attempt to load a binary chunk"));
  CHECK_THAT(safe.GetError("load(code, 'c', 'b')"), Contains("bytecode is off; it needs unsafe"));
  CHECK(unsafe.Get("load(code, 'c', 'b')()") == "42");

  const std::string path = "'" + file.GetPath() + "'";
  CHECK_THAT(safe.Get("select(2, loadfile(" + path + "))"), Contains("binary chunk"));
  CHECK_THAT(safe.GetError("loadfile(" + path + ", 'b')"), Contains("bytecode is off"));
  CHECK_THAT(safe.GetError("dofile(" + path + ")"), Contains("binary chunk"));
  CHECK(unsafe.Get("dofile(" + path + ")") == "42");

  const std::string folder = std::filesystem::path(file.GetPath()).parent_path().string();
  const std::string require =
      "package.path = '" + folder + "/?.lua' x = require('argos_sandbox_bytecode')";
  CHECK_THAT(safe.GetError(require),
             Contains("error loading module 'argos_sandbox_bytecode'") && Contains("binary chunk"));
  CHECK(unsafe.GetError(require) == "");

  CHECK_THAT(safe.GetError("package.loadlib('libc.so.6', '*')"),
             Contains("package.loadlib() is off; it needs unsafe=\"true\""));
  CHECK(unsafe.Get("package.loadlib('libc.so.6', '*')") == "true");
  CHECK(safe.Get("#package.searchers") == "2");
  CHECK(safe.Get("package.cpath") == "");
  CHECK(unsafe.Get("#package.searchers") == "4");

  CHECK_THROWS_WITH(SLuaScript::Load(file.GetPath(), ""),
                    Contains("is precompiled") && Contains("unsafe=\"true\""));
  unsafe.Execute(*SLuaScript::Load(file.GetPath(), "", true));
  // the permission of one script is not that of another
  CHECK_THROWS_WITH(SLuaScript::Load(file.GetPath(), ""), Contains("is precompiled"));
}

TEST_CASE("lua sandbox: finalizers, which no limit interrupts, need unsafe", "[lua][sandbox]") {
  CLuaTester safe(kFewInstructions);
  CHECK_THAT(safe.GetError("setmetatable({}, {__gc = function() while true do end end})"),
             StartsWith("test:1: setmetatable: finalizers (__gc) are off"));
  // a finalizer that is added later is not called, as in every Lua
  CHECK(safe.GetError("local m = {} for i = 1, 100 do setmetatable({}, m) end\n"
                      "m.__gc = function() while true do end end collectgarbage()") == "");
  CHECK(safe.Get("getmetatable(io.stdout)") == "false");
  CHECK(safe.Get("getmetatable(vector2())") == "false");
  CHECK(safe.Get("getmetatable(vector3())") == "false");
  CHECK(safe.Get("getmetatable(quaternion())") == "false");
  CHECK(safe.Get("type(getmetatable('').__index)") == "table");
  CLuaTester unsafe(Unsafe());
  unsafe.Do("n = 0 setmetatable({}, {__gc = function() n = n + 1 end}) collectgarbage()");
  CHECK(unsafe.Get("n") == "1");
}

TEST_CASE("lua sandbox: memory is limited, and the error names limit and line",
          "[lua][sandbox][memory]") {
  CLuaTester lua(WithMemory(2));
  const std::string code =
      GENERATE("\nlocal t = {} while true do t[#t + 1] = {} end",
               "\nlocal s = 'x' while true do s = s .. s end", "\nlocal s = ('x'):rep(1 << 30)",
               "\nlocal t = {} for i = 1, 1e9 do t[i] = i end",

               "\nlocal s = string.rep('local x = {} ', 1e5) load(s .. s)",
               "\nlocal s = io.open('/dev/zero', 'rb'):read('a')",
               "\nlocal t = {} while true do t[#t + 1] = coroutine.create("
               "print) end",
               "\ncoroutine.wrap(function() string.rep('x', 1e9) end)()");
  CAPTURE(code);
  const std::string error = lua.GetError(code);
  CHECK_THAT(error, StartsWith("test:2: not enough memory: the limit is 2 MiB, of which ") &&
                        Contains("raise \"max_memory\" in <params>"));
  // the memory is free again
  CHECK(lua.GetError("s = ('x'):rep(600000)") == "");
}

TEST_CASE("lua sandbox: a script may catch the error of the memory limit",
          "[lua][sandbox][memory]") {
  CLuaTester lua(WithMemory(2));
  lua.Do("ok, message = pcall(string.rep, 'x', 1 << 30)");
  CHECK(lua.Get("ok") == "false");
  CHECK(lua.Get("message") == "not enough memory");
  const std::string error =
      lua.GetError("error('again: ' .. select(2, pcall(string.rep, 'x', 1e9)))");
  CHECK_THAT(error, Contains("the limit is 2 MiB") && Contains("again: not enough memory"));
  // but it cannot go on for ever
  CLuaTester impatient({.MaxInstructions = kFewInstructions, .MaxMemory = SLuaLimits::kMebi});
  CHECK_THAT(impatient.GetError("while true do pcall(string.rep, 'x', 1e9) end"),
             Contains("interrupted after"));
}

TEST_CASE("lua sandbox: the limit of memory can be lifted, and counts what is in use",
          "[lua][sandbox][memory]") {
  CLuaTester lua(WithMemory(0));
  CHECK(lua.GetError("s = ('x'):rep(100 << 20)") == "");
  // garbage does not count: a hundred times the limit
  CLuaTester small(WithMemory(2));
  CHECK(small.GetError("for i = 1, 400 do local s = ('x'):rep(500000 + i) end") == "");
  CHECK(small.GetError("for i = 1, 100000 do local t = {i, {}} end") == "");
  // an array that grows by doubling may use the whole limit
  CLuaTester array(WithMemory(8));
  CHECK(array.GetError("t = {} for i = 1, 200000 do t[i] = i end") == "");
}

TEST_CASE("lua sandbox: a limit below the size of a state is an error", "[lua][sandbox][memory]") {
  CHECK_THROWS_WITH(CLuaTester(SLuaLimits{.MaxMemory = 2000}), Contains("not enough memory"));
  CHECK_THROWS_WITH(CLuaTester(SLuaLimits{.MaxMemory = 20000}), Contains("not enough memory"));
}

TEST_CASE("lua sandbox: the text that one call logs is limited, too", "[lua][sandbox][memory]") {
  CLuaTester lua(WithMemory(1));
  CHECK_THAT(lua.GetError("local s = ('x'):rep(100000) while true do log(s) end"),
             Contains("test:1: one call has logged more text than the 1 MiB"));
  CHECK(lua.GetError("log(('x'):rep(100000))") == "");
  CHECK(TakeLog().size() > 1000000);
}

TEST_CASE("lua sandbox: deep recursion is an error", "[lua][sandbox]") {
  CLuaTester lua;
  const std::string code = GENERATE(
      "local function f() return 1 + f() end f()",
      "local t = setmetatable({}, {}) getmetatable(t).__index = function(s, k) return "
      "s[k] end local x = t.x",
      "local function f() coroutine.wrap(f)() end f()",
      "local function f() pcall(f) error('x') end f()",
      "local function f(s) return (s:gsub('.', f)) end f('x')",
      "local function f() table.sort({1, 2, 3}, f) end f()",

      "load(('('):rep(1e6))()", "local s = ('a'):rep(300000) s:find(('a?'):rep(300000) .. s)",
      "string.format(('%d'):rep(1000))");
  CAPTURE(code);
  CHECK(lua.GetError(code) != "");
  CHECK(lua.GetNumber("1 + 1") == 2.0);
}

TEST_CASE("lua sandbox: messages do not depend on the global locale", "[lua][sandbox][locale]") {
  const CCommaLocale comma;
  CLuaTester lua;
  CHECK(lua.Get("1234.5") == "1234.5");
  CHECK_THAT(lua.GetError("string.rep('x', 'y')"), Contains("number expected"));
}

}  // namespace lua_sandbox_test
