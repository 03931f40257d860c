#include <argos3/core/wrappers/lua/lua_source.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <filesystem>

namespace lua_source_test {

using namespace argos;

namespace {

SLuaSource Read(const std::string& text) {
  return SLuaSource::Read(text, ".");
}

}  // namespace

TEST_CASE("lua source: parameters are fields of params, and of variables that refer to it",
          "[lua][source]") {
  for (const char* const text :
       {"v = robot.params.speed", "v = tonumber(robot.params['speed'])",
        "local v = (simulation.params [ [[speed]] ])", "local p = robot.params print(p.speed)",
        "params = robot.params\nfunction step() go(params.speed) end",
        "local next = robot.params v = next.speed", "pairs = robot.params v = pairs.speed",
        "local p = robot.params or {} --[[ x ]] v = p.speed --"}) {
    CAPTURE(text);
    const SLuaSource source = Read(text);
    CHECK(source.MayUseParameter("speed"));
    CHECK_FALSE(source.MayUseParameter("sped"));
    CHECK_FALSE(source.PassesParameters);
  }
}

TEST_CASE("lua source: neither comments nor other tables count", "[lua][source]") {
  for (const char* const text : {"-- robot.params.speed", "--[[ robot.params.speed\n]] x = 1",
                                 "--[==[ ]] robot.params.speed ]==]", "speed = robot.params.limit",
                                 "state.speed = 'speed'", "x = 'robot.params.speed'"}) {
    CAPTURE(text);
    CHECK_FALSE(Read(text).MayUseParameter("speed"));
  }
}

TEST_CASE("lua source: where the name of a parameter is not known, every word may be one",
          "[lua][source]") {
  for (const char* const text :
       {"function get(name) return robot.params[name] end v = get('speed')",
        "function get(t) return t.speed end v = get(robot.params)",
        "self.p = robot.params\nv = self.p.speed", "return { robot.params, 'speed' }",
        // of two variables, the first may have it
        "a, b = robot.params, 1 v = a.speed", "t[1] = robot.params v = t[1].speed"}) {
    CAPTURE(text);
    CHECK(Read(text).MayUseParameter("speed"));
    CHECK_FALSE(Read(text).MayUseParameter("sped"));
  }
}

TEST_CASE("lua source: a script that visits its parameters, or runs unknown code, uses all",
          "[lua][source]") {
  for (const char* const text :
       {"for k, v in pairs(robot.params) do end", "for k, v in next, robot.params do end",
        "k = next(robot.params)", "load(text)()", "require(name)", "require 'no.such.module'",
        "loadfile(name)()", "dofile(name)", "\x1bLua"}) {
    CAPTURE(text);
    CHECK(Read(text).MayUseParameter("speed"));
  }
}

TEST_CASE("lua source: files that a script loads belong to it", "[lua][source]") {
  const CTemporaryFolder folder;
  folder.Write("m.lua", "require('m') local p = robot.params return p.speed");
  const std::string file = folder.Write("f.lua", "return robot.params.limit");
  const SLuaSource source = SLuaSource::Read(
      "local m = require 'm' dofile('" + file + "') p = 1 x = p.other", folder.Path(""));
  CHECK(source.MayUseParameter("speed"));
  CHECK(source.MayUseParameter("limit"));
  // an alias of another file
  CHECK_FALSE(source.MayUseParameter("other"));
  CHECK_FALSE(source.UsesAllParameters);
}

TEST_CASE("lua source: a module is a file, or init.lua of a folder", "[lua][source]") {
  const CTemporaryFolder folder;
  std::filesystem::create_directories(folder.Path("package/part"));
  folder.Write("package/init.lua", "return robot.params.speed");
  folder.Write("package/part/init.lua", "return robot.params.limit");
  const SLuaSource source =
      SLuaSource::Read("require 'package' require('package.part')", folder.Path(""));
  CHECK(source.MayUseParameter("speed"));
  CHECK(source.MayUseParameter("limit"));
  CHECK_FALSE(source.MayUseParameter("other"));
  CHECK_FALSE(source.UsesAllParameters);
}

TEST_CASE("lua source: names are counted", "[lua][source]") {
  const SLuaSource source = Read("function step() helper(x.helper) end -- helper\nf = 'helper'");
  CHECK(source.CountUses("step") == 1);
  CHECK(source.CountUses("helper") == 2);
  CHECK(source.CountUses("none") == 0);
}

TEST_CASE("lua source: text that is cut off is read to its end", "[lua][source]") {
  for (const char* const text :
       {"robot.params", "robot.params.", "robot.params[", "params", "'x\\", "[==[ robot", "--[[",
        "require", "x = params", "robot.params['a"}) {
    CAPTURE(text);
    CHECK_FALSE(Read(text).MayUseParameter("speed"));
  }
}

}  // namespace lua_source_test
