// A program that embeds the simulator may have set a locale with a decimal comma.

#include "lua_world.h"

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/comma_locale.h>

#include <catch2/catch.hpp>

namespace lua_locale_test {

using namespace argos;
using Catch::Contains;

namespace {

const char* const kScript =
    "function init() half = tonumber('0.5') end\n"
    "function step()\n"
    "  robot.wheels.set_velocity(1234.5 / 100 + robot.random.uniform(-1.5, 1.5), half * 7)\n"
    "  text = 0.25 .. ' ' .. string.format('%.2f', 1234.5) .. ' ' .. tostring(vector2(0.5, 1.5))\n"
    "  comma = tonumber('0,5')\n"
    "  log(0.125)\n"
    "end\n"
    "function reset() end function destroy() end\n";

struct SResult {
  UInt64 Digest;
  std::string Text;
  std::string Comma;
  std::string Log;
};

SResult RunText(const std::string& xml) {
  TakeLog();
  CTestWorld world(xml);
  world.Step(5);
  auto& controller =
      dynamic_cast<CLuaController&>(world.Get<CComposableEntity>("fb")
                                        .GetComponent<CControllableEntity>("controller")
                                        .GetController());
  SResult result{world.ComputeDigest(), "", "", TakeLog()};
  lua_State* const state = controller.GetLuaState();
  lua_getglobal(state, "text");
  lua_getglobal(state, "comma");
  result.Text = lua_tostring(state, -2);
  result.Comma = luaL_typename(state, -1);
  lua_settop(state, 0);
  return result;
}

}  // namespace

TEST_CASE("lua locale: a decimal comma of the process changes neither scripts nor digests",
          "[lua][locale]") {
  const CTemporaryFolder folder;
  SLuaExperiment experiment;
  experiment.Script = kScript;
  experiment.Actuators = "<differential_steering implementation='default'/>";
  experiment.Arena =
      "<box id='b' size='0.25,1.5,0.5' movable='false'><body position='-2.5,1.25,0' "
      "orientation='22.5,0,0'/></box>"
      "<distribute><position method='uniform' min='1.5,1.5,0' max='3.5,3.5,0'/>"
      "<orientation method='gaussian' mean='0,0,0' std_dev='22.5,0,0'/>"
      "<entity quantity='3' max_trials='100'><cylinder id='c' radius='0.125' height='0.5' "
      "movable='true' mass='1.5'/></entity></distribute>";
  const std::string xml = ToXml(experiment, folder);
  const SResult usual = RunText(xml);
  CHECK(usual.Text == "0.25 1234.50 0.5,1.5");
  const CCommaLocale comma;
  if (!comma.HasCLocale()) {
    WARN("this machine has no C locale with a decimal comma; only the C++ locale is tested");
  }
  const SResult result = RunText(xml);
  CHECK(result.Digest == usual.Digest);
  CHECK(result.Text == usual.Text);
  CHECK(result.Comma == "nil");
  CHECK(result.Log == usual.Log);
  CHECK_THAT(result.Log, Contains("0.125"));
}

}  // namespace lua_locale_test
