// Loop functions written in Lua that fail.

#include "lua_world.h"

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <filesystem>

namespace lua_loop_failures_test {

using namespace argos;
using Catch::Contains;

TEST_CASE("lua loop functions: an error names script and line and ends the run",
          "[lua][loop_functions][error]") {
  CHECK_THAT(LoadError(WithLoopFunctions("error('bad chunk')")),
             Contains("<loop_functions>") && Contains("loop.lua:1: bad chunk") &&
                 Contains("stack traceback:"));
  CHECK_THAT(LoadError(WithLoopFunctions("\nfunction init() error('bad init') end")),
             Contains("failed in init()") && Contains("loop.lua:2: bad init"));
  CHECK_THAT(LoadError(WithLoopFunctions("x = = 1")), Contains("loop.lua:1:"));
  CHECK_THAT(LoadError(WithLoopFunctions("init = 5")),
             Contains("the global \"init\" must be a function, got number"));
  {
    CLuaWorld world(WithLoopFunctions("function pre_step() simulation.move('fb') end"));
    CHECK_THROWS_WITH(world.Step(), Contains("failed in pre_step()") &&
                                        Contains("loop.lua:1: simulation.move: argument 2"));
    // the script is loaded again after a reset
    world.GetSimulator().Reset();
    CHECK_THROWS_WITH(world.Step(), Contains("failed in pre_step()"));
  }
  {
    CLuaWorld world(WithLoopFunctions("function destroy() error('bad end') end"));
    CHECK_THROWS_WITH(world.Destroy(), Contains("failed in destroy()") && Contains("bad end"));
  }
  {
    // without a call of Destroy() the destructor of the simulator can only log the error
    CLuaWorld world(WithLoopFunctions("function destroy() error('bad end') end"));
  }
  CHECK_THAT(TakeLogErr(), Contains("failed in destroy()") && Contains("loop.lua:1: bad end"));
  SLuaExperiment endless = WithLoopFunctions("function post_step() while true do end end");
  endless.LoopParams = "max_instructions='50000'";
  CLuaWorld world(endless);
  CHECK_THROWS_WITH(world.Step(), Contains("interrupted after 50000 instructions"));
}

TEST_CASE("lua loop functions: after an error no function of the script is called",
          "[lua][loop_functions][error]") {
  const bool isReset = GENERATE(false, true);
  CAPTURE(isReset);
  CLuaWorld world(
      WithLoopFunctions("function pre_step() error('bad step') end\n"
                        "function is_experiment_finished() log('finished?') return true end\n"
                        "function floor_color() log('floor_color') return 'red' end\n"
                        "function post_experiment() log('post_experiment') end\n"
                        "function destroy() log('destroy') end\n"));
  CHECK_THROWS_WITH(world.Step(), Contains("bad step"));
  TakeLog();
  if (isReset) {
    // it cannot be loaded again
    REQUIRE(std::filesystem::remove(world.Folder().Path("loop.lua")));
    CHECK_THROWS_WITH(world.GetSimulator().Reset(), Contains("there is no Lua script"));
  }
  {
    const CSimulator::CScope scope(world.GetSimulator());
    CLoopFunctions& functions = world.GetSimulator().GetLoopFunctions();
    CHECK_FALSE(functions.IsExperimentFinished());
    CHECK(functions.GetFloorColor(CVector2()) == CColor::WHITE);
    functions.PostExperiment();
  }
  world.Destroy();
  CHECK_THAT(TakeLog(), !Contains("finished?") && !Contains("floor_color") &&
                            !Contains("post_experiment") && !Contains("destroy"));
}

TEST_CASE("lua loop functions: without a script they are refused", "[lua][loop_functions][error]") {
  SExperiment experiment;
  experiment.LoopFunctions = "<loop_functions label='lua'><params/></loop_functions>";
  CHECK_THAT(LoadError(experiment), Contains("script"));
  experiment.LoopFunctions = "<loop_functions label='lua'/>";
  CHECK_THAT(LoadError(experiment), Contains("params"));
  experiment.LoopFunctions =
      "<loop_functions label='lua'><params script='no_such.lua'/></loop_functions>";
  CHECK_THAT(LoadError(experiment), Contains("there is no Lua script \"no_such.lua\""));
}

}  // namespace lua_loop_failures_test
