// What the live view accepts, and what is just beyond: arguments of commands, sizes, numbers.

#include "live_viewer.h"

#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/replay/replay.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_reader.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <memory>
#include <string>
#include <vector>

namespace live_limits_test {

using namespace argos;
using Catch::Contains;

namespace {

/* A floor that comes in tick 2, gets other sizes in ticks 4 and 6, and another colour in tick 8. */
class CGrowingFloor : public CLoopFunctions {
 public:
  void PostStep() override {
    const UInt32 tick = GetSpace().GetSimulationClock();
    if (tick == 2) {
      TConfigurationNode element("floor");
      element.SetAttribute("id", "floor");
      element.SetAttribute("source", "loop_functions");
      element.SetAttribute("pixels_per_meter", 1);
      GetSpace().CreateEntity(element);
      Resize(8, 4);
    } else if (tick == 4) {
      Resize(8, 5);
    } else if (tick == 6) {
      Resize(6, 5);
    } else if (tick == 8) {
      m_color = CColor::BLUE;
      GetSpace().GetFloorEntity().SetChanged();
    }
  }
  CColor GetFloorColor(const CVector2&) override { return m_color; }

 private:
  void Resize(UInt32 width, UInt32 height) {
    GetSpace().GetFloorEntity().SetImageSize(width, height);
    GetSpace().GetFloorEntity().SetChanged();
  }

  CColor m_color = CColor::RED;
};
REGISTER_LOOP_FUNCTIONS(CGrowingFloor, "live_limits_test_floor")

/* An arena without walls, with a box, a lamp and a floor. */
SExperiment MakePlain() {
  SExperiment experiment;
  experiment.Engines = "<dynamics2d id='dyn2d' />";
  experiment.Media = "<led id='leds' />";
  experiment.ArenaSize = "10,6,2";
  experiment.LoopFunctions = "<loop_functions label='live_limits_test_floor' />";
  experiment.Arena =
      "<box id='box' size='0.5,0.5,0.5' movable='true' mass='1'><body position='0,0,0' /></box>"
      "<light id='lamp' position='1,1,1' orientation='0,0,0' color='yellow' intensity='1'"
      " medium='leds' />";
  return experiment;
}

/* E-pucks that all hear each other. */
SExperiment MakeTalkers(const CTemporaryFolder& folder, UInt32 number) {
  SExperiment experiment;
  experiment.Controllers =
      "<lua_controller id='c'><actuators><range_and_bearing implementation='default' />"
      "</actuators><sensors><range_and_bearing implementation='medium' medium='rab' /></sensors>"
      "<params script='" +
      folder.Write("talk.lua", "function step() robot.range_and_bearing.set_data(1, 7) end\n") +
      "' /></lua_controller>";
  experiment.Engines = "<kinematics2d id='kin' />";
  experiment.Media = "<range_and_bearing id='rab' check_occlusions='false' />";
  experiment.ArenaSize = "30,30,2";
  constexpr UInt32 kRow = 20;
  for (UInt32 i = 0; i < number; ++i) {
    experiment.Arena += "<e-puck id='e" + std::to_string(i) + "' rab_range='100'><body position='" +
                        std::to_string(i % kRow) + ',' + std::to_string(i / kRow) +
                        ",0' /><controller config='c' /></e-puck>";
  }
  experiment.ArenaSize = "60,60,2";
  return experiment;
}

std::string TokenOf(const CLiveWorld& world) {
  return world.GetURL().substr(world.GetURL().find('#') + 1);
}

// of the frames that a viewer has got last
Real PoseX(const CLiveClient& viewer, const std::string& id) {
  return GetPose(viewer.GetFrame(), id).Position.GetX();
}

/* A command, and what its answer says; empty: it is done. */
struct SCase {
  std::string Command;
  TJson Arguments;
  std::string Error;
};

void CheckCases(CLiveClient& viewer, const std::vector<SCase>& cases) {
  for (const SCase& each : cases) {
    const TJson answer = viewer.Do(each.Command, each.Arguments);
    CAPTURE(each.Command, each.Arguments.dump().substr(0, 200), answer.dump().substr(0, 200));
    CHECK(IsOk(answer) == each.Error.empty());
    CHECK_THAT(GetError(answer), Contains(each.Error));
  }
}

// @return how many commands of a recording are these
size_t CountRecorded(const std::string& file, const std::string& part) {
  CRecordingReader reader(file);
  size_t count = 0;
  for (const SRecordedFrame* frame = reader.ReadNext(); frame != nullptr;
       frame = reader.ReadNext()) {
    for (const SRecordedCommand& command : frame->Commands) {
      count += command.Text.find(part) != std::string::npos ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("live view: a floor that comes, and gets another size, is seen by who watches",
          "[live]") {
  CLiveWorld world({{"speed", "0"}, {"fps", "100"}}, Loading(MakePlain().ToXml()));
  auto viewer = Join(world);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  const auto size = [&] {
    const SRecordedFrame& frame = viewer->GetFrame();
    return frame.Floor == nullptr ? std::vector<UInt32>()
                                  : std::vector<UInt32>{frame.Floor->Width, frame.Floor->Height};
  };
  const std::vector<UInt32> none;
  const std::vector<std::vector<UInt32>> expected = {none,   none,   {8, 4}, {8, 4}, {8, 5},
                                                     {8, 5}, {6, 5}, {6, 5}, {6, 5}};
  for (size_t tick = 0; tick < expected.size(); ++tick) {
    CAPTURE(tick);
    REQUIRE(viewer->GetFrame().Tick == tick);
    CHECK(size() == expected[tick]);
    if (viewer->GetFrame().Floor != nullptr) {
      CHECK(viewer->GetFrame().Floor->Pixels.substr(0, 3) ==
            (tick < 8 ? std::string("\xff\0\0", 3) : std::string("\0\0\xff", 3)));
    }
    StepTicks(*viewer, 1);
  }
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: numbers of commands have limits, which are allowed themselves", "[live]") {
  CLiveWorld world(kWaits, Loading(MakePlain().ToXml()));
  auto viewer = Join(world);
  const std::string factor = "\"factor\" is a number from 0";
  const std::string count = "\"n\" is a whole number from 1 to 1000000";
  const std::string fps = "\"fps\" is a number from 0.1 to 100";
  CheckCases(*viewer, {{"speed", {{"factor", 0}}, ""},
                       {"speed", {{"factor", 0.001}}, ""},
                       {"speed", {{"factor", 1e6}}, ""},
                       {"speed", {{"factor", 0.0009}}, factor},
                       {"speed", {{"factor", 1000001}}, factor},
                       {"speed", {{"factor", -0.001}}, factor},
                       {"speed", {{"factor", "1"}}, factor},
                       {"speed", {{"factor", nullptr}}, factor},
                       {"speed", TJson::object(), factor},
                       {"rate", {{"fps", 0.1}}, ""},
                       {"rate", {{"fps", 100}}, ""},
                       {"rate", {{"fps", 0.09}}, fps},
                       {"rate", {{"fps", 100.1}}, fps},
                       {"rate", {{"fps", "10"}}, fps},
                       {"rate", TJson::object(), fps},
                       {"step", {{"n", 0}}, count},
                       {"step", {{"n", 1000001}}, count},
                       {"step", {{"n", -1}}, count},
                       {"step", {{"n", 1.5}}, count},
                       {"step", {{"n", 1000000}}, ""},
                       {"pause", TJson::object(), ""},
                       {"seek", {{"tick", 1}}, "only a replay has other ticks"},
                       {"seek", TJson::object(), "\"tick\" is missing"},
                       {"reset", {{"seed", 0}}, "from 1 to 4294967295"},
                       {"reset", {{"seed", 4294967296}}, "from 1 to 4294967295"},
                       {"reset", {{"seed", 4294967295}}, ""},
                       {"redistribute", {{"seed", 0}}, "from 1 to 4294967295"},
                       {"redistribute", {{"seed", 5}}, ""}});
  CHECK(viewer->Do("reset", {{"seed", 7}})["seed"] == 7);
  CHECK(viewer->Do("redistribute", {{"seed", 9}})["seed"] == 9);
  CHECK(viewer->Do("reset", {{"seed", nullptr}})["seed"] == 9);
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: things can be moved and added up to the arena's sides", "[live]") {
  CLiveWorld world(kWaits, Loading(MakePlain().ToXml()));
  auto viewer = Join(world);
  const auto move = [](const char* entity, Real x, Real y) {
    return TJson({{"entity", entity}, {"position", {x, y, 0}}});
  };
  const std::string outside = "is outside of the arena";
  const std::string vector = "\"position\" is a list of three numbers from -1e+06 to 1e+06";
  for (const char* entity : {"box", "lamp"}) {
    CheckCases(*viewer, {{"move", move(entity, 5.0, 0.0), ""},
                         {"move", move(entity, -5.0, 0.0), ""},
                         {"move", move(entity, 0.0, 3.0), ""},
                         {"move", move(entity, 0.0, -3.0), ""},
                         {"move", move(entity, 5.01, 0.0), outside},
                         {"move", move(entity, -5.01, 0.0), outside},
                         {"move", move(entity, 0.0, 3.01), outside},
                         {"move", move(entity, 0.0, -3.01), outside},
                         {"move", move(entity, 1e6, 0.0), outside},
                         {"move", move(entity, -1e6, 0.0), outside},
                         {"move", move(entity, 1.1e6, 0.0), vector},
                         {"move", move(entity, -1.1e6, 0.0), vector}});
  }
  CheckCases(*viewer,
             {{"move", {{"entity", "box"}, {"yaw", 1000}}, ""},
              {"move", {{"entity", "box"}, {"yaw", -1000}}, ""},
              {"move", {{"entity", "box"}, {"yaw", 1000.1}}, "\"yaw\" is a number from -1000"},
              {"move", {{"entity", ""}, {"yaw", 0}}, "\"entity\" is missing, or no text"},
              {"move", {{"entity", 7}, {"yaw", 0}}, "\"entity\" is missing, or no text"}});
  // without a place it turns where it is, and without an angle it keeps its own
  CHECK(IsOk(viewer->Do("move", {{"entity", "lamp"}, {"position", {2, 1, 1}}, {"yaw", 1.0}})));
  CHECK(IsOk(viewer->Do("move", {{"entity", "lamp"}, {"position", {3, 1, 1}}})));
  CHECK(IsOk(viewer->Do("move", {{"entity", "box"}, {"position", {-2, 1, 0}}, {"yaw", 0.5}})));
  CHECK(IsOk(viewer->Do("move", {{"entity", "box"}, {"yaw", 1.0}})));
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  StepTicks(*viewer, 3);
  CHECK(PoseX(*viewer, "lamp") == Approx(3.0));
  CHECK(PoseX(*viewer, "box") == Approx(-2.0));
  for (const char* entity : {"lamp", "box"}) {
    CRadians yaw;
    CRadians pitch;
    CRadians roll;
    GetPose(viewer->GetFrame(), entity).Orientation.ToEulerAngles(yaw, pitch, roll);
    CAPTURE(entity);
    CHECK(yaw.GetValue() == Approx(1.0).margin(1e-4));
  }
  CheckCases(*viewer, {{"move", {{"entity", "floor"}, {"position", {0, 0, 0}}}, "has no place"},
                       {"remove", {{"entity", "floor"}}, "the floor cannot be removed"},
                       {"remove", {{"entity", "lamp"}}, ""},
                       {"remove", {{"entity", "lamp"}}, "no entity \"lamp\""}});
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: sizes and masses of what is added have limits", "[live]") {
  CLiveWorld world(kWaits, Loading(MakePlain().ToXml()));
  auto viewer = Join(world);
  Real x = -4.5;
  const auto add = [&x](const char* type, const char* name, const TJson& value) {
    x += 0.25;
    TJson arguments = {{"type", type}, {"position", {x, -2, 0}}};
    arguments[name] = value;
    return arguments;
  };
  CheckCases(
      *viewer,
      {{"add", add("box", "size", {0.001, 0.1, 0.1}), ""},
       {"add", add("box", "size", {0.1, 0.001, 0.1}), ""},
       {"add", add("box", "size", {0.1, 0.1, 0.001}), ""},
       {"add", add("box", "size", {0.0009, 0.1, 0.1}), "\"size\" is at least 0.001 m"},
       {"add", add("box", "size", {0.1, 0.0009, 0.1}), "\"size\" is at least 0.001 m"},
       {"add", add("box", "size", {0.1, 0.1, 0.0009}), "\"size\" is at least 0.001 m"},
       {"add", add("box", "size", {0.1, 0.1, 100.0}), ""},
       {"add", add("box", "size", {0.1, 0.1, 100.1}), "three numbers from -100 to 100"},
       {"add", add("box", "mass", 0.001), ""},
       {"add", add("box", "mass", 0.0009), "\"mass\" is a number from 0.001 to 1e+06"},
       {"add", add("box", "mass", 1e6), ""},
       {"add", add("cylinder", "mass", 1.1e6), "\"mass\" is a number from 0.001 to 1e+06"},
       {"add", add("cylinder", "radius", 0.001), ""},
       {"add", add("cylinder", "radius", 0.0009), "\"radius\" is a number from 0.001 to 100"},
       {"add", add("cylinder", "radius", 100.1), "\"radius\" is a number from 0.001 to 100"},
       {"add", add("cylinder", "height", 0.001), ""},
       {"add", add("cylinder", "height", 100.0), ""},
       {"add", add("cylinder", "height", 0.0009), "\"height\" is a number from 0.001 to 100"},
       {"add", add("cylinder", "height", 100.1), "\"height\" is a number from 0.001 to 100"},
       {"add", add("cylinder", "movable", 1), "\"movable\" is true or false"},
       {"add", add("cylinder", "movable", false), ""},
       {"add", add("box", "yaw", 1000.1), "\"yaw\" is a number"},
       {"add", add("light", "yaw", 0.5), ""},
       {"add", {{"type", "box"}}, "\"position\" is missing"},
       {"add", {{"type", "box"}, {"position", {5.1, 0, 0}}}, "is outside of the arena"},
       {"add", {{"type", "box"}, {"position", {0, 0, 0}}}, "it would overlap \"box\" there"},
       {"add", {{"position", {0, 0, 0}}}, "\"type\" is missing, or no text"}});
  // what was refused is not there: numbers go on without a gap
  CHECK(viewer->Do("add", add("cylinder", "radius", 0.05))["entity"] == "cylinder_added_5");
  CHECK(viewer->Do("add", add("light", "yaw", 0.0))["entity"] == "light_added_2");
  CHECK(IsOk(viewer->Do("remove", {{"entity", "cylinder_added_2"}})));
  CHECK(viewer->Do("add", add("cylinder", "radius", 0.05))["entity"] == "cylinder_added_2");
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a viewer pins 16 entities, by ids of 256 bytes", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  auto viewer = Join(world);
  const auto pin = [](const std::string& id) { return TJson({{"entity", id}}); };
  const std::string most = "at most 16 entities can be pinned";
  CheckCases(*viewer, {{"pin", pin(std::string(256, 'x')), ""},
                       {"unpin", pin(std::string(256, 'x')), ""},
                       {"pin", pin(std::string(257, 'x')), "there is no such entity"},
                       {"pin", {{"entity", 7}}, "\"entity\" is the id of an entity"},
                       {"pin", TJson::object(), "\"entity\" is the id of an entity"}});
  for (int i = 0; i < 16; ++i) {
    CHECK(IsOk(viewer->Do("pin", pin("fb" + std::to_string(i)))));
  }
  CheckCases(*viewer, {{"pin", pin("fb3"), ""},
                       {"pin", pin("fb16"), most},
                       {"unpin", pin("fb4"), ""},
                       {"pin", pin("fb16"), ""},
                       {"pin", pin("fb4"), most}});
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: names of keys have 32 bytes, and 64 keys are held at most", "[live]") {
  const CTemporaryFolder folder;
  const std::string file = folder.Path("run.rec");
  CLiveWorld world(kWaits, [&, load = Loading(MakePlain().ToXml())](CSimulator& simulator) {
    simulator.AddOutput("recording", {{"file", file}});
    load(simulator);
  });
  auto viewer = Join(world);
  auto other = Join(world);
  CheckCases(*viewer,
             {{"user_key", {{"key", std::string(32, 'k')}}, ""},
              {"user_key", {{"key", std::string(32, 'k')}, {"down", false}}, ""},
              {"user_key", {{"key", std::string(33, 'k')}}, "\"key\" is the name of a key"},
              {"user_key", {{"key", ""}}, "\"key\" is missing, or no text"},
              {"user_key", {{"key", "a"}, {"down", 1}}, "\"down\" is true or false"}});
  for (int i = 0; i < 66; ++i) {
    CHECK(IsOk(viewer->Do("user_key", {{"key", "k" + std::to_string(i)}, {"down", true}})));
  }
  CHECK(IsOk(viewer->Do("give_control", {{"viewer", 2}})));
  CHECK(IsOk(other->Do("step")));
  other->ReceiveUntil([&] { return other->GetStatus().value("tick", 0) == 1; });
  CHECK(IsOk(other->Do("end")));
  world.Finish();
  // one was released by the viewer
  CHECK(CountRecorded(file, "\"down\":false") == 1 + 64);
}

TEST_CASE("live view: lists are shown up to 50 rows, and marks up to 200", "[live]") {
  const CTemporaryFolder folder;
  const auto [number, rows, marks] = GENERATE(table<UInt32, size_t, size_t>(
      {{50, 49, 49}, {51, 50, 50}, {52, 50, 51}, {201, 50, 200}, {202, 50, 200}}));
  CAPTURE(number);
  CLiveWorld world(kWaits, Loading(MakeTalkers(folder, number).ToXml()));
  auto viewer = Join(world);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  StepTicks(*viewer, 3);
  CHECK(IsOk(viewer->Do("pin", {{"entity", "e0"}})));
  CHECK(viewer->WaitFor("perceived")["marks"].size() == marks);
  CHECK(IsOk(viewer->Do("step")));
  CHECK(viewer->WaitFor("values")["tree"]["messages"].size() == rows);
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: texts of viewers have a greatest size and depth", "[live]") {
  const CTemporaryFolder folder;
  CLiveWorld world({{"speed", "0"}, {"edit", "true"}}, Loading(MakeTalkers(folder, 1).ToXml()));
  auto viewer = Join(world);
  // accepted where the run goes on to answer
  const auto isAccepted = [&](const std::string& text) {
    auto other = Join(world);
    other->SendText(text);
    other->ReceiveUntil([&] {
      return other->GetText().is_object() &&
             (other->GetText().contains("re") || other->GetText().contains("error"));
    });
    return other->GetText().contains("re");
  };
  const auto withLength = [](size_t length, const std::string& command) {
    const std::string start = R"({"do":")" + command + R"(","id":1,"entity":"e0","x":")";
    return start + std::string(length - start.size() - 2, 'x') + "\"}";
  };
  CHECK(isAccepted(withLength(65536, "unpin")));
  CHECK_FALSE(isAccepted(withLength(65537, "unpin")));
  // those who have no control are answered, too
  CHECK(isAccepted(withLength(65537, "script")));
  const auto withDepth = [](int depth) {
    return R"({"do":"unpin","id":1,"entity":"e0","x":)" + std::string(depth, '[') +
           std::string(depth, ']') + '}';
  };
  CHECK(isAccepted(withDepth(7)));
  CHECK_FALSE(isAccepted(withDepth(9)));
  const std::string start = "function step() end\n--";
  const auto apply = [&](size_t length) {
    return viewer->Do(
        "script", {{"entity", "e0"}, {"text", start + std::string(length - start.size(), 'x')}});
  };
  CHECK(IsOk(apply(size_t(192) << 10)));
  CHECK_THAT(GetError(apply((size_t(192) << 10) + 1)), Contains("192 KiB"));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a viewer's name has 64 bytes at most, and need not be there", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  auto viewer = Join(world);
  const TJson names[] = {std::string(64, 'n'), std::string(65, 'n'), 7, nullptr};
  const std::string expected[] = {std::string(64, 'n'), std::string(64, 'n'), "", ""};
  for (size_t i = 0; i < std::size(names); ++i) {
    CLiveClient other(world.GetURL());
    other.Send({{"hello", {{"token", TokenOf(world)}, {"name", names[i]}}}});
    CHECK(other.WaitFor("welcome")["viewer"] == i + 2);
    const TJson viewers = other.WaitFor("status")["viewers"];
    CAPTURE(i);
    CHECK(viewers.back()["name"] == expected[i]);
  }
  for (const TJson& hello :
       {TJson({{"hello", 1}}), TJson({{"hello", {{"token", 1}}}}),
        TJson({{"hello", {{"name", "n"}}}}), TJson({{"bye", {{"token", TokenOf(world)}}}})}) {
    CLiveClient other(world.GetURL());
    other.Send(hello);
    CAPTURE(hello.dump());
    CHECK_THAT(other.WaitFor("error").get<std::string>(), Contains("token is wrong"));
  }
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: 64 viewers can watch", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  std::vector<std::unique_ptr<CLiveClient>> viewers;
  for (int i = 0; i < 64; ++i) {
    viewers.push_back(Join(world));
  }
  CLiveClient other(world.GetURL());
  other.Hello();
  CHECK_THAT(other.WaitFor("error").get<std::string>(), Contains("too many viewers"));
  viewers.pop_back();
  viewers[0]->ReceiveUntil(
      [&] { return viewers[0]->GetStatus().value("viewers", TJson()).size() == 63; });
  viewers.push_back(Join(world));
  CHECK(IsOk(viewers[0]->Do("end")));
  world.Finish();
}

TEST_CASE("live view: acknowledgements of nothing are counted as messages", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  auto viewer = Join(world);
  auto other = Join(world);
  for (int i = 0; i < 300; ++i) {
    other->Send({{"ack", 1}});
  }
  CHECK_THAT(other->WaitFor("error").get<std::string>(), Contains("100 messages a second"));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: who asks for control, and who has it, is asked once", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  auto first = Join(world);
  auto second = Join(world);
  // waits for a status with the viewers that ask
  const auto asking = [&](CLiveClient& viewer, UInt32 control) {
    viewer.ReceiveUntil([&] { return viewer.GetStatus().value("control", 0U) == control; });
    std::vector<bool> asks;
    for (const TJson& each : viewer.GetStatus()["viewers"]) {
      asks.push_back(each["asks"].get<bool>());
    }
    return asks;
  };
  CHECK(IsOk(first->Do("ask_control")));
  CHECK(asking(*first, 1) == std::vector<bool>{false, false});
  CHECK(IsOk(second->Do("ask_control")));
  CHECK(IsOk(second->Do("ask_control")));
  second->WaitFor("status");
  CHECK(asking(*second, 1) == std::vector<bool>{false, true});
  first.reset();
  CHECK(asking(*second, 2) == std::vector<bool>{false});
  auto third = Join(world);
  CHECK(IsOk(third->Do("ask_control")));
  CHECK(IsOk(second->Do("give_control", {{"viewer", 3}})));
  CHECK(asking(*third, 3) == std::vector<bool>{false, false});
  CHECK(IsOk(third->Do("end")));
  world.Finish();
}

TEST_CASE("live view: the page is the same by three paths, and HEAD gives its headers", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  const std::string& url = world.GetURL();
  const std::string host = url.substr(7, url.find("/#") - 7);
  const auto ask = [&](const std::string& request, const std::string& more = "") {
    return RequestByHTTP(url, request + " HTTP/1.1\r\nHost: " + host + "\r\n" + more + "\r\n");
  };
  const auto bodyOf = [](const std::string& answer) {
    return answer.substr(answer.find("\r\n\r\n") + 4);
  };
  const std::string page = bodyOf(ask("GET /"));
  CHECK(bodyOf(ask("GET /index.html")) == page);
  CHECK(bodyOf(ask("GET /?detail=full")) == page);
  CHECK(bodyOf(ask("GET /?detail=low")) == page);
  CHECK_THAT(ask("GET /?detail=some"), Contains("404"));
  CHECK(bodyOf(ask("HEAD /")).empty());
  CHECK_THAT(ask("HEAD /"), Contains("200 OK"));
  CHECK_THAT(ask("GET /live"), Contains("This is the address of a WebSocket."));
  // the page that says that the page was not built is not packed
  if (page.find("was not built") == std::string::npos) {
    const std::string packed = ask("GET /", "Accept-Encoding: deflate, GZIP\r\n");
    CHECK_THAT(packed, Contains("Content-Encoding: gzip"));
    CHECK(bodyOf(packed).size() < page.size() / 2);
  }
  CHECK_THAT(ask("GET /", "Accept-Encoding: deflate\r\n"), !Contains("Content-Encoding"));
  CHECK(IsOk(Join(world)->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a replay keeps its seed, and shows ticks that it has", "[live]") {
  const CTemporaryFolder folder;
  const std::string file = folder.Path("run.rec");
  RunHeadless([&](CSimulator& simulator) {
    simulator.AddOutput("recording", {{"file", file}});
    Diffusion(2)(simulator);
  });
  CLiveWorld world(kWaits, [&](CSimulator& simulator) {
    SReplayRequest request;
    request.File = file;
    simulator.LoadReplay(request, true);
  });
  CLiveClient viewer(world.GetURL());
  viewer.Hello();
  const TJson welcome = viewer.WaitFor("welcome");
  CHECK(welcome["types_to_add"].empty());
  for (const char* name : {"change", "drive", "edit", "redistribute", "user_functions"}) {
    CHECK(welcome["can"][name] == false);
  }
  for (const char* name : {"replay", "seek", "control"}) {
    CHECK(welcome["can"][name] == true);
  }
  const std::string changed = "nothing can be changed in it";
  CheckCases(viewer, {{"redistribute", TJson::object(), changed},
                      {"add", {{"type", "box"}, {"position", {0, 0, 0}}}, changed},
                      {"remove", {{"entity", "fb0"}}, changed},
                      {"reset", {{"seed", 77}}, ""}});
  CHECK(viewer.Do("reset", {{"seed", 77}})["seed"] == welcome["seed"]);
  CHECK(IsOk(viewer.Do("end")));
  world.Finish();
}

}  // namespace live_limits_test
