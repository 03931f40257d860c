// What users' functions are told of viewers of the live view, and what they leave to these.

#include "live_viewer.h"

#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace live_user_functions_test {

using namespace argos;
using Catch::Contains;

namespace {

/* Notes what it is told, as code for ARGoS 3 would get it; Space and "i" are not its keys. */
class CNotingFunctions : public CQTOpenGLUserFunctions {
 public:
  static std::vector<std::string> notes;  // on the thread of the run; read after its end

  void EntitySelected(CEntity& entity) override { notes.push_back("selected " + entity.GetId()); }
  void EntityDeselected(CEntity& entity) override {
    notes.push_back("deselected " + entity.GetId());
  }
  void EntityMoved(CEntity& entity, const CVector3& before, const CVector3& now) override {
    notes.push_back("moved " + entity.GetId() + " by " + ToString(now - before));
  }
  void KeyPressed(QKeyEvent* event) override {
    notes.push_back("pressed " + std::to_string(event->key()) + NameModifiers(*event));
    switch (event->key()) {
      case Qt::Key_Space:
        GetQTOpenGLWidget().KeyPressed(event);
        break;
      case Qt::Key_I:
        event->ignore();
        break;
      case Qt::Key_X:
        throw std::runtime_error("x is no good key");
      default:
        break;
    }
  }
  void KeyReleased(QKeyEvent* event) override {
    notes.push_back("released " + event->text() + NameModifiers(*event));
  }

 private:
  static std::string NameModifiers(const QKeyEvent& event) {
    std::string names = event.modifiers().testFlag(Qt::ShiftModifier) ? "+shift" : "";
    names += (event.modifiers() & Qt::ControlModifier) != 0 ? "+control" : "";
    names += (event.modifiers() & Qt::AltModifier) != 0 ? "+alt" : "";
    return names + ((event.modifiers() & Qt::MetaModifier) != 0 ? "+meta" : "");
  }
};
std::vector<std::string> CNotingFunctions::notes;
REGISTER_QTOPENGL_USER_FUNCTIONS(CNotingFunctions, "live_test_notes")

/* Has no hooks of keys: those of the base class leave all to the view. */
class CDrawingOnly : public CQTOpenGLUserFunctions {};
REGISTER_QTOPENGL_USER_FUNCTIONS(CDrawingOnly, "live_test_drawing")

/* Log outside of ticks. */
class CLoggingFunctions : public CQTOpenGLUserFunctions {
 public:
  void EntitySelected(CEntity& entity) override { LOG << "chosen " << entity.GetId() << std::endl; }
  void DrawInWorld() override {
    if (!std::exchange(m_hasDrawn, true)) {
      LOGERR << "drawn for the first time" << std::endl;
    }
  }

 private:
  bool m_hasDrawn = false;
};
REGISTER_QTOPENGL_USER_FUNCTIONS(CLoggingFunctions, "live_test_logging")

/* Says at each key what is selected. */
class CSelectionFunctions : public CQTOpenGLUserFunctions {
 public:
  void KeyPressed(QKeyEvent*) override {
    CEntity* const selected = GetSelectedEntity();
    CNotingFunctions::notes.push_back(selected != nullptr ? selected->GetId() : "nothing");
  }
};
REGISTER_QTOPENGL_USER_FUNCTIONS(CSelectionFunctions, "live_test_selection")

/* Removes the box in tick 3. */
class CRemovingLoopFunctions : public CLoopFunctions {
 public:
  void PostStep() override {
    if (GetSpace().GetSimulationClock() == 3) {
      RemoveEntity("box");
    }
  }
};
REGISTER_LOOP_FUNCTIONS(CRemovingLoopFunctions, "live_test_removing_loop_functions")

class CLoggingLoopFunctions : public CLoopFunctions {
 public:
  void PostExperiment() override { LOG << "the result is 42" << std::endl; }
};
REGISTER_LOOP_FUNCTIONS(CLoggingLoopFunctions, "live_test_logging_loop_functions")

// a box and a robot, in a file with another view than <live>
// @param functions  labels
std::function<void(CSimulator&)> WithFunctions(const std::vector<std::string>& functions,
                                               const std::string& recording = "",
                                               const std::string& loopFunctions = "") {
  SExperiment experiment;
  experiment.LoopFunctions = loopFunctions;
  experiment.Engines = "<dynamics2d id='dyn2d' />";
  experiment.Arena =
      "<box id='box' size='0.5,0.5,0.5' movable='true' mass='1'><body position='1,1,0' /></box>"
      "<box id='wall' size='1,0.1,1' movable='false'><body position='-2,0,0' /></box>";
  std::string view;
  for (const std::string& label : functions) {
    view += "<user_functions label='" + label + "' />";
  }
  std::string xml = experiment.ToXml();
  xml.insert(xml.find("</argos-configuration>"),
             "<visualization><qt-opengl>" + view + "</qt-opengl></visualization>");
  return [load = Loading(xml), recording](CSimulator& simulator) {
    if (!recording.empty()) {
      simulator.AddOutput("recording", {{"file", recording}});
    }
    load(simulator);
  };
}

}  // namespace

TEST_CASE("live view: users' functions are told what a viewer does", "[live]") {
  CNotingFunctions::notes.clear();
  CLiveWorld world(kWaits, WithFunctions({"live_test_notes"}));
  auto viewer = Join(world);
  CHECK(IsOk(viewer->Do("user_select", {{"entity", "box"}})));
  CHECK(IsOk(viewer->Do("move", {{"entity", "box"}, {"position", {2, 1, 0}}})));
  CHECK(IsOk(viewer->Do("user_key", {{"key", "ArrowUp"}})));
  CHECK(IsOk(viewer->Do("user_key", {{"key", "ArrowUp"}, {"down", false}})));
  CHECK(IsOk(viewer->Do("user_key", {{"key", "w"}, {"down", false}})));
  CHECK_THAT(GetError(viewer->Do("user_key", {{"key", 7}})), Contains("no text"));
  CHECK(IsOk(viewer->Do("remove", {{"entity", "box"}})));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
  CHECK(CNotingFunctions::notes ==
        std::vector<std::string>{"selected box", "moved box by 1,0,0",
                                 "pressed " + std::to_string(int{Qt::Key_Up}), "released ",
                                 "released w", "deselected box"});
}

TEST_CASE("live view: a selection lasts until its entity is removed", "[live]") {
  CNotingFunctions::notes.clear();
  CLiveWorld world(kWaits,
                   WithFunctions({"live_test_selection"}, "",
                                 "<loop_functions label='live_test_removing_loop_functions' />"));
  auto viewer = Join(world);
  const auto note = [&viewer] { CHECK(IsOk(viewer->Do("user_key", {{"key", "s"}}))); };
  note();
  CHECK(IsOk(viewer->Do("user_select", {{"entity", "box"}})));
  note();
  StepTicks(*viewer, 2);
  note();
  CHECK(IsOk(viewer->Do("reset")));
  viewer->ReceiveUntil([&] { return viewer->GetFrame().Tick == 0; });
  note();
  StepTicks(*viewer, 3);
  note();
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
  CHECK(CNotingFunctions::notes ==
        std::vector<std::string>{"nothing", "box", "box", "box", "nothing"});
}

TEST_CASE("live view: users' functions are told which modifiers are down with a key", "[live]") {
  CNotingFunctions::notes.clear();
  CLiveWorld world(kWaits, WithFunctions({"live_test_notes"}));
  auto viewer = Join(world);
  CHECK(IsOk(viewer->Do("user_key", {{"key", "Alt"}, {"alt", true}})));
  CHECK(IsOk(viewer->Do("user_key", {{"key", "A"}, {"shift", true}, {"alt", true}})));
  CHECK(IsOk(viewer->Do("user_key", {{"key", "A"}, {"down", false}, {"alt", true}})));
  CHECK(IsOk(viewer->Do("user_key", {{"key", "b"}, {"control", true}, {"meta", true}})));
  CHECK(IsOk(viewer->Do("user_key", {{"key", "c"}, {"shift", false}})));
  CHECK_THAT(GetError(viewer->Do("user_key", {{"key", "d"}, {"shift", 1}})),
             Contains("\"shift\" is true or false"));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
  CHECK(CNotingFunctions::notes ==
        std::vector<std::string>{"pressed " + std::to_string(int{Qt::Key_Alt}) + "+alt",
                                 "pressed 65+shift+alt", "released A+alt",
                                 "pressed 66+control+meta", "pressed 67"});
}

TEST_CASE("live view: the answer says whether users' functions have used a key", "[live]") {
  const bool hasNotes = GENERATE(true, false);
  CAPTURE(hasNotes);
  CLiveWorld world(kWaits, WithFunctions(hasNotes ? std::vector<std::string>{"live_test_drawing",
                                                                             "live_test_notes"}
                                                  : std::vector<std::string>{"live_test_drawing"}));
  CLiveClient viewer(world.GetURL());
  viewer.Hello();
  CHECK(viewer.WaitFor("welcome")["can"]["user_functions"] == true);
  const auto isUsed = [&](const char* key) {
    const TJson answer = viewer.Do("user_key", {{"key", key}});
    CHECK(IsOk(answer));
    return answer.value("handled", !hasNotes);
  };
  CHECK(isUsed("w") == hasNotes);
  CHECK(isUsed("ArrowLeft") == hasNotes);
  // passed on to the widget, and ignored
  CHECK_FALSE(isUsed(" "));
  CHECK_FALSE(isUsed("i"));
  if (hasNotes) {
    CHECK_THAT(GetError(viewer.Do("user_key", {{"key", "x"}})), Contains("no good key"));
  }
  CHECK(IsOk(viewer.Do("end")));
  world.Finish();
}

TEST_CASE("live view: viewers are told that there are no users' functions", "[live]") {
  CLiveWorld world(kWaits, WithFunctions({}));
  CLiveClient viewer(world.GetURL());
  viewer.Hello();
  CHECK(viewer.WaitFor("welcome")["can"]["user_functions"] == false);
  CHECK(IsOk(viewer.Do("end")));
  world.Finish();
}

TEST_CASE("live view: lines that are logged while a run waits come at once", "[live]") {
  SExperiment experiment;
  experiment.Length = 1.0;
  experiment.LoopFunctions = "<loop_functions label='live_test_logging_loop_functions' />";
  experiment.Engines = "<dynamics2d id='dyn2d' />";
  experiment.Arena = "<box id='box' size='1,1,1' movable='false'><body position='0,0,0' /></box>";
  std::string xml = experiment.ToXml();
  xml.insert(xml.find("</argos-configuration>"),
             "<visualization><qt-opengl><user_functions label='live_test_logging' />"
             "</qt-opengl></visualization>");
  CLiveWorld world(kWaits, Loading(xml));
  CLiveClient viewer(world.GetURL());
  viewer.Hello();
  // fails after 20 s
  const auto waitForLine = [&viewer](const std::string& text) {
    CAPTURE(text);
    CHECK(viewer.ReceiveUntil([&] {
      return viewer.GetText().contains("log") &&
             viewer.GetText().dump().find(text) != std::string::npos;
    }));
  };
  waitForLine("drawn for the first time");
  CHECK(IsOk(viewer.Do("user_select", {{"entity", "box"}})));
  waitForLine("chosen box");
  CHECK(IsOk(viewer.Do("play")));
  waitForLine("the result is 42");
  CHECK(IsOk(viewer.Do("end")));
  world.Finish();
}

TEST_CASE("live view: keys that a viewer holds are released with its control", "[live]") {
  CNotingFunctions::notes.clear();
  const CTemporaryFolder folder;
  const std::string file = folder.Path("run.rec");
  CLiveWorld world(kWaits, WithFunctions({"live_test_notes"}, file));
  auto first = Join(world);
  auto second = Join(world);
  CHECK(IsOk(first->Do("user_key", {{"key", "a"}})));
  CHECK(IsOk(first->Do("user_key", {{"key", "b"}})));
  CHECK(IsOk(first->Do("user_key", {{"key", "b"}, {"down", false}})));
  CHECK(IsOk(first->Do("give_control", {{"viewer", 2}})));
  CHECK(IsOk(second->Do("user_key", {{"key", "c"}})));
  second.reset();
  first->ReceiveUntil([&] { return first->GetStatus().value("control", 0) == 1; });
  CHECK(IsOk(first->Do("step")));
  CHECK(IsOk(first->Do("end")));
  world.Finish();
  const auto pressed = [](char key) { return "pressed " + std::to_string(int{key}); };
  const std::vector<std::string> expected = {pressed('A'), pressed('B'), "released b",
                                             "released a", pressed('C'), "released c"};
  CHECK(CNotingFunctions::notes == expected);
  // a run that is repeated has the releases, too
  CNotingFunctions::notes.clear();
  RunHeadless([&](CSimulator& simulator) {
    simulator.SetVisualization("live", {{"commands", file}});
    WithFunctions({"live_test_notes"})(simulator);
  });
  CHECK(CNotingFunctions::notes == expected);
}

TEST_CASE("live view: what a viewer has selected is deselected with its control", "[live]") {
  CNotingFunctions::notes.clear();
  CLiveWorld world(kWaits, WithFunctions({"live_test_notes"}));
  auto first = Join(world);
  auto second = Join(world);
  CHECK(IsOk(first->Do("user_select", {{"entity", "box"}})));
  CHECK(IsOk(first->Do("give_control", {{"viewer", 2}})));
  CHECK(IsOk(second->Do("user_select", {{"entity", "wall"}})));
  CHECK(IsOk(second->Do("end")));
  world.Finish();
  CHECK(CNotingFunctions::notes ==
        std::vector<std::string>{"selected box", "deselected box", "selected wall"});
}

namespace {

// a foot-bot whose controller runs a script
std::function<void(CSimulator&)> OneFootBot(const std::string& script) {
  SExperiment experiment;
  experiment.Controllers =
      "<lua_controller id='c'><actuators><differential_steering implementation='default' />"
      "</actuators><sensors /><params script='" +
      script + "' /></lua_controller>";
  experiment.Engines = "<dynamics2d id='dyn2d' />";
  experiment.Arena =
      "<foot-bot id='fb0'><body position='0,0,0' /><controller config='c' /></foot-bot>";
  return Loading(experiment.ToXml());
}

}  // namespace

TEST_CASE("live view: a robot that a viewer drives is let go with its control", "[live]") {
  const CTemporaryFolder folder;
  const std::string script =
      folder.Write("robot.lua", "function step() robot.wheels.set_velocity(10, 10) end\n");
  CLiveWorld world(kWaits, OneFootBot(script));
  auto first = Join(world);
  auto second = Join(world);
  CHECK(IsOk(first->Do("drive", {{"entity", "fb0"}, {"left", 0}, {"right", 0}})));
  StepTicks(*first, 2);
  const SBodyPose start = GetPose(first->GetFrame(), "fb0");
  CHECK(IsOk(first->Do("give_control", {{"viewer", 2}})));
  CHECK(IsOk(second->Do("step", {{"n", 10}})));
  first->ReceiveUntil([&] { return first->GetFrame().Tick == 12; });
  // its controller drives it again, at 10 cm/s
  CHECK(Distance(GetPose(first->GetFrame(), "fb0").Position, start.Position) ==
        Approx(0.1).margin(2e-3));
  CHECK(IsOk(second->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a robot that is let go has the speeds that its controller set last",
          "[live]") {
  struct SCase {
    const char* Orders;  // of the controller, by tick
    Real Speed;  // m/s, after it was let go
  };
  // the last one sets what the viewer sets, too
  const SCase robot = GENERATE(SCase{"{[1] = 10}", 0.1}, SCase{"{[1] = 10, [4] = -5}", -0.05},
                               SCase{"{[1] = 10, [4] = 0}", 0.0});
  CAPTURE(robot.Orders);
  const CTemporaryFolder folder;
  CLiveWorld world(kWaits, OneFootBot(folder.Write(
                               "robot.lua", "local orders, tick = " + std::string(robot.Orders) +
                                                ", 0\n"
                                                "function step()\n"
                                                "  tick = tick + 1\n"
                                                "  local speed = orders[tick]\n"
                                                "  if speed then "
                                                "robot.wheels.set_velocity(speed, speed) "
                                                "end\n"
                                                "end\n")));
  auto viewer = Join(world);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  const auto x = [&] { return GetPose(viewer->GetFrame(), "fb0").Position.GetX(); };
  // its wheels follow orders with a delay that moves it by at most 2 mm
  constexpr Real kTolerance = 2e-3;  // m
  StepTicks(*viewer, 2);
  CHECK(x() == Approx(0.01).margin(kTolerance));
  CHECK(IsOk(viewer->Do("drive", {{"entity", "fb0"}, {"left", 0}, {"right", 0}})));
  StepTicks(*viewer, 4);
  const Real start = x();
  CHECK(start == Approx(0.01).margin(kTolerance));
  CHECK(IsOk(viewer->Do("drive", {{"entity", "fb0"}})));
  StepTicks(*viewer, 10);
  CHECK(x() - start == Approx(robot.Speed).margin(kTolerance));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

}  // namespace live_user_functions_test
