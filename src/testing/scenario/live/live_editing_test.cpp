// Scripts and parameters that viewers of the live view change.

#include "live_viewer.h"

#include <argos3/core/control_interface/changeable_parameters.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

namespace live_editing_test {

using namespace argos;
using Catch::Contains;

namespace {

const CLiveWorld::TAttributes kEditable = {{"speed", "0"}, {"edit", "true"}};

constexpr char kStands[] =
    "function init() robot.leds.set_all_colors('red') end\n"
    "function reset() robot.leds.set_all_colors('red') end\n"
    "function step() end\n";
constexpr char kDrives[] = "function step() robot.wheels.set_velocity(10, 10) end\n";

/* Loop functions with a number that viewers may change. */
class CTunedFunctions : public CLoopFunctions, public CChangeableParameters {
 public:
  TParameters ListParameters() override { return {{"pull", m_pull, -1.0, 1.0, "m"}}; }
  void PostStep() override {
    auto& box = dynamic_cast<CComposableEntity&>(GetSpace().GetEntity("box"));
    box.GetComponent<CEmbodiedEntity>("body").MoveTo(CVector3(m_pull, 3.0, 0.0), CQuaternion());
  }

 private:
  Real m_pull = 0.0;
};
REGISTER_LOOP_FUNCTIONS(CTunedFunctions, "live_editing_test_tuned")

SExperiment ThreeRobots(const CTemporaryFolder& folder, const std::string& params = "") {
  SExperiment experiment;
  experiment.Controllers =
      "<lua_controller id='c'><actuators><differential_steering implementation='default' />"
      "<leds implementation='default' medium='leds' /></actuators><sensors />"
      "<params script='" +
      folder.Path("robot.lua") + "' " + params + " /></lua_controller>";
  experiment.Engines = "<dynamics2d id='dyn2d' />";
  experiment.Media = "<led id='leds' />";
  for (const std::string number : {"0", "1", "2"}) {
    experiment.Arena += "<foot-bot id='fb" + number + "'><body position='0," + number +
                        ",0' /><controller config='c' /></foot-bot>";
  }
  return experiment;
}

std::string ReadFile(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// of the robot "fb0", whose pose is the first one
Real GetX(const CLiveClient& viewer) {
  return viewer.GetFrame().Poses.at(0).Position.GetX();
}

void Reset(CLiveClient& viewer) {
  CHECK(IsOk(viewer.Do("reset")));
  viewer.ReceiveUntil([&] { return viewer.GetFrame().Tick == 0; });
}

std::function<void(CSimulator&)> Recorded(std::function<void(CSimulator&)> load,
                                          const std::string& file) {
  return [load = std::move(load), file](CSimulator& simulator) {
    simulator.AddOutput("recording", {{"file", file}});
    load(simulator);
  };
}

// of the run that does the commands of a recording again
UInt64 RunAgain(const std::function<void(CSimulator&)>& load, const std::string& file) {
  return RunHeadless([&](CSimulator& simulator) {
    simulator.SetVisualization("live", {{"commands", file}});
    load(simulator);
  });
}

}  // namespace

TEST_CASE("live view: an edited script runs in all robots that have it", "[live]") {
  const CTemporaryFolder folder;
  folder.Write("robot.lua", kStands);
  CLiveWorld world(kEditable, Loading(ThreeRobots(folder).ToXml()));
  auto viewer = Join(world);
  const TJson opened = viewer->Do("open_script", {{"entity", "fb1"}});
  CHECK(opened["text"] == kStands);
  CHECK(opened["file"] == folder.Path("robot.lua"));
  CHECK(opened["robots"] == 3);
  CHECK(opened["changed"] == false);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  StepTicks(*viewer, 5);
  CHECK(GetX(*viewer) == Approx(0.0).margin(1e-6));
  CHECK(viewer->Do("script", {{"entity", "fb1"}, {"text", kDrives}})["robots"] == 3);
  StepTicks(*viewer, 11);
  // it acts in the tick after its first step, and 10 cm/s for a second are 0.1 m, less what the
  // wheels need to get there
  CHECK(GetX(*viewer) == Approx(0.1).margin(2e-3));
  CHECK(viewer->Do("open_script", {{"entity", "fb0"}})["changed"] == true);
  CHECK(ReadFile(folder.Path("robot.lua")) == kStands);
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a script with an error is refused with its line, and changes nothing",
          "[live]") {
  const CTemporaryFolder folder;
  folder.Write("robot.lua", kDrives);
  CLiveWorld world(kEditable, Loading(ThreeRobots(folder).ToXml()));
  auto viewer = Join(world);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  StepTicks(*viewer, 1);
  const auto apply = [&](const std::string& text) {
    return viewer->Do("script", {{"entity", "fb0"}, {"text", text}});
  };
  const TJson syntax = apply("function step()\n  local x = = 1\nend\n");
  CHECK(syntax["line"] == 2);
  CHECK_THAT(GetError(syntax), Contains("near '='"));
  const TJson start =
      apply("\n\nfunction init()\n  robot.wheels.set_velocity(nothing.x, 1)\nend\n");
  CHECK(start["line"] == 4);
  CHECK_THAT(GetError(start), Contains("init()"));
  const TJson forbidden = apply("\x1bLua");
  CHECK_THAT(GetError(forbidden), Contains("precompiled"));
  CHECK_THAT(GetError(apply(std::string(200000, ' '))), Contains("192 KiB"));
  StepTicks(*viewer, 10);
  CHECK(GetX(*viewer) == Approx(0.1).margin(2e-3));
  CHECK(viewer->Do("open_script", {{"entity", "fb0"}})["changed"] == false);
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a robot that an error has stopped goes on with a better script", "[live]") {
  const CTemporaryFolder folder;
  folder.Write("robot.lua", "function step() error('here') end\n");
  CLiveWorld world(kEditable, Loading(ThreeRobots(folder).ToXml()));
  auto viewer = Join(world);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  StepTicks(*viewer, 2);
  CHECK(IsOk(viewer->Do("script", {{"entity", "fb0"}, {"text", kDrives}})));
  StepTicks(*viewer, 11);
  CHECK(GetX(*viewer) == Approx(0.1).margin(2e-3));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: scripts are edited only where the author allows it", "[live]") {
  const CTemporaryFolder folder;
  folder.Write("robot.lua", kStands);
  {
    CLiveWorld world(kWaits, Loading(ThreeRobots(folder).ToXml()));
    auto viewer = Join(world);
    for (const char* command : {"open_script", "script"}) {
      CHECK_THAT(GetError(viewer->Do(command, {{"entity", "fb0"}, {"text", kDrives}})),
                 Contains("the author of this run does not allow"));
    }
    CHECK(IsOk(viewer->Do("end")));
    world.Finish();
  }
  {
    CLiveWorld world(kEditable, Loading(ThreeRobots(folder, "unsafe='true'").ToXml()));
    auto viewer = Join(world);
    auto other = Join(world);
    CHECK_THAT(GetError(other->Do("open_script", {{"entity", "fb0"}})), Contains("control"));
    CHECK_THAT(GetError(viewer->Do("script", {{"entity", "fb0"}, {"text", kDrives}})),
               Contains("unsafe"));
    CHECK(IsOk(viewer->Do("end")));
    world.Finish();
  }
  CLiveWorld world(kEditable, Diffusion(3));
  auto viewer = Join(world);
  CHECK_THAT(GetError(viewer->Do("open_script", {{"entity", "fb0"}})),
             Contains("no controller in Lua"));
  CHECK_THAT(GetError(viewer->Do("open_script", {{"entity", "../../etc/passwd"}})),
             Contains("no entity"));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a run with edited scripts is repeated, also after a reset", "[live]") {
  const CTemporaryFolder folder;
  folder.Write("robot.lua", kStands);
  const auto load = Loading(ThreeRobots(folder).ToXml());
  const std::string file = folder.Path("run.rec");
  CLiveWorld world(kEditable, Recorded(load, file));
  auto viewer = Join(world);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  StepTicks(*viewer, 3);
  CHECK(IsOk(viewer->Do("script", {{"entity", "fb2"}, {"text", kDrives}})));
  StepTicks(*viewer, 4);
  // the new robot gets the edited script, too
  CHECK(IsOk(viewer->Do("add", {{"type", "foot-bot"}, {"position", {-2, -2, 0}}})));
  CHECK(IsOk(viewer->Do("remove", {{"entity", "fb2"}})));
  StepTicks(*viewer, 4);
  const bool isReset = GENERATE(false, true);
  CAPTURE(isReset);
  std::string recorded = file;
  if (isReset) {
    Reset(*viewer);
    // what was removed stays away, what was added does not
    CHECK(viewer->GetFrame().Entities.size() == 2);
    StepTicks(*viewer, 11);
    CHECK(GetX(*viewer) == Approx(0.1).margin(2e-3));
    recorded = folder.Path("run.2.rec");
  }
  CHECK(IsOk(viewer->Do("end")));
  const UInt64 digest = world.Finish();
  CHECK(RunAgain(load, recorded) == digest);
}

TEST_CASE("live view: parameters of controllers are changed, and the run is repeated", "[live]") {
  const CTemporaryFolder folder;
  const std::string file = folder.Path("run.rec");
  CLiveWorld world(kWaits, Recorded(Diffusion(10), file));
  auto viewer = Join(world);
  const TJson list = viewer->Do("parameters", {{"entity", "fb0"}})["parameters"];
  REQUIRE(list.size() == 2);
  CHECK(
      list[0] ==
      TJson(
          {{"name", "velocity"}, {"value", 10.0}, {"min", 0.0}, {"max", 30.0}, {"unit", "cm/s"}}));
  CHECK(viewer->Do("parameters")["parameters"].empty());
  CHECK(viewer->Do("parameters", {{"entity", "wall_east"}})["parameters"].empty());
  const auto set = [&](const char* name, Real value, bool isForAll) {
    return viewer->Do("set_parameter",
                      {{"entity", "fb0"}, {"name", name}, {"value", value}, {"all", isForAll}});
  };
  CHECK_THAT(GetError(set("velocity", 31.0, false)), Contains("from 0 to 30"));
  CHECK_THAT(GetError(set("speed", 1.0, false)), Contains("no changeable parameter \"speed\""));
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  CHECK(set("velocity", 0.0, true)["robots"] == 10);
  CHECK(set("velocity", 20.0, false)["robots"] == 1);
  CHECK(viewer->Do("parameters", {{"entity", "fb1"}})["parameters"][0]["value"] == 0.0);
  StepTicks(*viewer, 5);
  const bool isReset = GENERATE(false, true);
  CAPTURE(isReset);
  std::string recorded = file;
  if (isReset) {
    CHECK(IsOk(viewer->Do("reset")));
    viewer->ReceiveUntil([&] { return viewer->GetFrame().Tick == 0; });
    CHECK(viewer->Do("parameters", {{"entity", "fb1"}})["parameters"][0]["value"] == 0.0);
    CHECK(viewer->Do("parameters", {{"entity", "fb0"}})["parameters"][0]["value"] == 20.0);
    recorded = folder.Path("run.2.rec");
  }
  StepTicks(*viewer, 5);
  CHECK(IsOk(viewer->Do("end")));
  const UInt64 digest = world.Finish();
  CHECK(RunAgain(Diffusion(10), recorded) == digest);
}

TEST_CASE("live view: parameters of loop functions are changed", "[live]") {
  SExperiment experiment;
  experiment.Engines = "<dynamics2d id='dyn2d' />";
  experiment.LoopFunctions = "<loop_functions label='live_editing_test_tuned' />";
  experiment.Arena =
      "<box id='box' size='0.5,0.5,0.5' movable='true' mass='1'><body position='0,3,0' /></box>";
  CLiveWorld world(kWaits, Loading(experiment.ToXml()));
  auto viewer = Join(world);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  CHECK(viewer->Do("parameters")["parameters"][0]["name"] == "pull");
  CHECK(IsOk(viewer->Do("set_parameter", {{"name", "pull"}, {"value", 0.75}})));
  StepTicks(*viewer, 1);
  CHECK(GetX(*viewer) == Approx(0.75).margin(1e-5));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a viewer sees where a robot perceives messages and lights", "[live]") {
  SExperiment experiment;
  experiment.Controllers =
      "<lua_controller id='c'><actuators><leds implementation='default' medium='leds' />"
      "<range_and_bearing implementation='default' /></actuators><sensors>"
      "<range_and_bearing implementation='medium' medium='rab' />"
      "<colored_blob_omnidirectional_camera implementation='rot_z_only' medium='leds' />"
      "</sensors><params script='robot.lua' /></lua_controller>";
  const CTemporaryFolder folder;
  const std::string script =
      folder.Write("robot.lua",
                   "function init() robot.leds.set_single_color(13, 'red')\n"
                   "robot.colored_blob_omnidirectional_camera.enable() end\n"
                   "function step() robot.range_and_bearing.set_data(1, 7) end\n");
  experiment.Controllers.replace(experiment.Controllers.find("robot.lua"), 9, script);
  experiment.Engines = "<dynamics2d id='dyn2d' />";
  experiment.Media = "<led id='leds' /><range_and_bearing id='rab' />";
  for (const std::string number : {"0", "1"}) {
    experiment.Arena += "<foot-bot id='fb" + number + "' omnidirectional_camera_aperture='80'>" +
                        "<body position='0," + number +
                        ",0' /><controller config='c' /></foot-bot>";
  }
  CLiveWorld world(kWaits, Loading(experiment.ToXml()));
  auto viewer = Join(world);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  StepTicks(*viewer, 3);
  CHECK(IsOk(viewer->Do("pin", {{"entity", "fb0"}})));
  const TJson marks = viewer->WaitFor("perceived")["marks"];
  REQUIRE(marks.size() == 2);
  for (const TJson& mark : marks) {
    // the other robot is 1 m to the left
    CHECK(mark["range"].get<Real>() == Approx(1.0).margin(0.01));
    CHECK(mark["bearing"].get<Real>() == Approx(std::acos(0.0)).margin(0.01));
  }
  CHECK(marks[0]["kind"] == "blob");
  CHECK(marks[0]["color"] == TJson({255, 0, 0}));
  CHECK(marks[1]["kind"] == "message");
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

}  // namespace live_editing_test
