// The live view, with viewers that behave well and others that don't.

#include "live_viewer.h"

#include <argos3/core/simulator/replay/replay.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/support/live_runs.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace live_test {

using namespace argos;
using Catch::Contains;

namespace {

bool Has(const SRecordedFrame& frame, const std::string& id) {
  return std::any_of(frame.Entities.begin(), frame.Entities.end(),
                     [&](const SRecordedEntity& entity) { return entity.Id == id; });
}

// ten robots, each of which logs 16 KB in each tick
std::function<void(CSimulator&)> LongLines(const CTemporaryFolder& folder) {
  SExperiment experiment;
  experiment.Controllers = "<lua_controller id='c'><actuators /><sensors /><params script='" +
                           folder.Write("long.lua",
                                        "local line = string.rep('x', 4000)\n"
                                        "function step() for _ = 1, 4 do log(line) end end") +
                           "' /></lua_controller>";
  experiment.Engines = "<dynamics2d id='dyn2d' />";
  for (int i = 0; i < 10; ++i) {
    const std::string number = std::to_string(i);
    experiment.Arena += "<e-puck id='e" + number + "'><body position='" + number +
                        ",0,0' /><controller config='c' /></e-puck>";
  }
  experiment.ArenaSize = "30,10,2";
  return Loading(experiment.ToXml());
}

// a robot that logs once, in tick 3
std::function<void(CSimulator&)> OneLine(const CTemporaryFolder& folder) {
  SExperiment experiment;
  experiment.Controllers = "<lua_controller id='c'><actuators /><sensors /><params script='" +
                           folder.Write("line.lua",
                                        "local tick = 0\n"
                                        "function step() tick = tick + 1\n"
                                        "if tick == 3 then log('a line of tick 3') end end") +
                           "' /></lua_controller>";
  experiment.Engines = "<dynamics2d id='dyn2d' />";
  experiment.Arena = "<e-puck id='e'><body position='0,0,0' /><controller config='c' /></e-puck>";
  return Loading(experiment.ToXml());
}

std::string Get(const CLiveWorld& world, const std::string& lines) {
  return RequestByHTTP(world.GetURL(), lines + "\r\n\r\n");
}

}  // namespace

TEST_CASE("live view: a viewer gets the run, and plays, steps and ends it", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  CLiveClient viewer(world.GetURL());
  viewer.Hello();
  const TJson welcome = viewer.WaitFor("welcome");
  CHECK(welcome["protocol"] == 1);
  CHECK(welcome["tick_length"] == 0.1);
  CHECK(welcome["viewer"] == 1);
  viewer.ReceiveUntil([&] { return viewer.CountFrames() > 0; });
  CHECK(viewer.CountInfos() == 1);
  CHECK(viewer.GetFrame().Tick == 0);
  // 4 walls, 5 + 3 boxes, 5 cylinders, 10 robots
  CHECK(viewer.GetFrame().Entities.size() == 27);
  CHECK(IsOk(viewer.Do("step", {{"n", 7}})));
  viewer.ReceiveUntil([&] { return viewer.GetFrame().Tick == 7; });
  CHECK(IsOk(viewer.Do("pin", {{"entity", "fb0"}})));
  const TJson values = viewer.WaitFor("values");
  CHECK(values["entity"] == "fb0");
  CHECK(values["tree"]["type"] == "foot-bot");
  CHECK(values["tree"]["pose"]["x (m)"].get<Real>() ==
        Approx(GetPose(viewer.GetFrame(), "fb0").Position.GetX()).margin(1e-6));
  CHECK(values["tree"]["readings:footbot_proximity"].size() == 24);
  PlayToEnd(viewer);
  CHECK(viewer.GetFrame().Tick == 30);
  CHECK_THAT(GetError(viewer.Do("play")), Contains("reset it first"));
  CHECK(IsOk(viewer.Do("reset")));
  viewer.ReceiveUntil([&] { return viewer.GetFrame().Tick == 0; });
  PlayToEnd(viewer);
  CHECK(IsOk(viewer.Do("end")));
  CHECK_THAT(viewer.WaitFor("error").get<std::string>(), Contains("ended"));
  CHECK(world.Finish() == RunHeadless(Diffusion(3)));
}

TEST_CASE("live view: viewers do not change the run", "[live]") {
  const UInt64 expected = RunHeadless(Diffusion(20));
  const int numViewers = GENERATE(0, 1, 8);
  CAPTURE(numViewers);
  CLiveWorld world(numViewers == 0 ? kPlays : kWaits, Diffusion(20));
  std::vector<std::unique_ptr<CLiveClient>> viewers;
  for (int i = 0; i < numViewers; ++i) {
    viewers.push_back(Join(world));
    CHECK(IsOk(viewers.back()->Do("pin", {{"entity", "fb" + std::to_string(i)}})));
  }
  if (numViewers > 0) {
    PlayToEnd(*viewers.front());
    CHECK(IsOk(viewers.front()->Do("end")));
  }
  CHECK(world.Finish() == expected);
}

TEST_CASE("live view: a viewer that joins later gets the log from its start", "[live]") {
  const CTemporaryFolder folder;
  CLiveWorld world(kWaits, OneLine(folder));
  auto first = Join(world);
  CHECK(IsOk(first->Do("step", {{"n", 5}})));
  CHECK_THAT(first->WaitFor("log").dump(), Contains("a line of tick 3"));
  auto second = Join(world);
  CHECK_THAT(second->WaitFor("log").dump(), Contains("a line of tick 3"));
  CHECK(IsOk(first->Do("end")));
  world.Finish();
}

TEST_CASE("live view: values of an entity go to those who have pinned it", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  auto first = Join(world);
  auto second = Join(world);
  CHECK(IsOk(first->Do("pin", {{"entity", "fb0"}})));
  CHECK(IsOk(second->Do("pin", {{"entity", "fb1"}})));
  CHECK(IsOk(first->Do("step", {{"n", 3}})));
  for (int i = 0; i < 3; ++i) {
    CHECK(first->WaitFor("values")["entity"] == "fb0");
    CHECK(second->WaitFor("values")["entity"] == "fb1");
    CHECK(IsOk(first->Do("step")));
  }
  CHECK(IsOk(first->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a viewer never needs more than 100 states to decode one", "[live]") {
  CLiveWorld world(kWaits, Diffusion(60));
  auto viewer = Join(world);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  std::vector<UInt32> keys;  // numbers of states, from 1, that can be decoded without others
  while (viewer->CountFrames() < 110) {
    const UInt32 before = viewer->CountKeyFrames();
    StepTicks(*viewer, 1);
    if (viewer->CountKeyFrames() > before) {
      keys.push_back(viewer->CountFrames());
    }
  }
  // each viewer's first state is one; the others are differences, which need a fraction of the
  // bytes
  CHECK(keys == std::vector<UInt32>{101});
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a run that viewers come to and leave goes on without them", "[live]") {
  const CTemporaryFolder folder;
  setenv("XDG_RUNTIME_DIR", folder.Path(".").c_str(), 1);
  const UInt64 expected = RunHeadless(Diffusion(30));
  CLiveWorld world({{"url_file", "auto"}, {"play", "true"}, {"speed", "20"}, {"linger", "0"}},
                   Diffusion(30));
  const std::vector<SLiveRunEntry> runs = ListLiveRuns();
  REQUIRE(runs.size() == 1);
  CHECK(runs[0].URL == world.GetURL());
  CHECK_THAT(runs[0].Experiment, Contains("diffusion_10.argos"));
  CHECK(runs[0].Seed == 124);
  struct stat status {};
  REQUIRE(stat(runs[0].File.c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == 0600);
  // of a run that was killed
  const std::string left = std::filesystem::path(runs[0].File).parent_path() / "1-1.live";
  std::ofstream(left) << "url http://127.0.0.1:1/#0\n";
  CHECK(ListLiveRuns().size() == 1);
  CHECK_FALSE(std::filesystem::exists(left));
  {
    auto viewer = Join(world);
    CHECK(IsOk(viewer->Do("pause")));
    CHECK(IsOk(viewer->Do("speed", {{"factor", 0.01}})));
    viewer->ReceiveUntil([&] { return viewer->GetStatus().value("run", "") == "paused"; });
  }
  // time for the run to notice that no viewer is connected
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  // who still looks does not delay the end
  const auto watching = Join(world);
  CHECK(world.Finish() == expected);
  CHECK(ListLiveRuns().empty());
  unsetenv("XDG_RUNTIME_DIR");
}

TEST_CASE("live view: where no viewer may have control, all only look", "[live]") {
  CLiveWorld world({{"play", "true"}, {"speed", "20"}, {"control", "false"}, {"linger", "0"}},
                   Diffusion(20));
  auto viewer = Join(world);
  for (const char* command : {"pause", "end", "ask_control", "move", "give_control"}) {
    CHECK_THAT(GetError(viewer->Do(command)), Contains("only be watched"));
  }
  CHECK(viewer->GetStatus()["control"] == 0);
  CHECK(IsOk(viewer->Do("pin", {{"entity", "fb0"}})));
  CHECK(viewer->WaitFor("values")["entity"] == "fb0");
  viewer.reset();
  CHECK(world.Finish() == RunHeadless(Diffusion(20)));
}

TEST_CASE("live view: attributes have limits, which are allowed themselves", "[live]") {
  const auto [name, value, error] = GENERATE(table<const char*, const char*, const char*>(
      {{"fps", "0.1", ""},
       {"fps", "100", ""},
       {"fps", "0.09", "\"fps\" must be from 0.1 to 100"},
       {"fps", "100.1", "\"fps\" must be from 0.1 to 100"},
       {"speed", "0", ""},
       {"speed", "1000000", ""},
       {"speed", "-0.1", "\"speed\" must be from 0 to 1000000"},
       {"speed", "1000001", "\"speed\" must be from 0 to 1000000"},
       {"linger", "0", ""},
       {"linger", "1e9", ""},
       {"linger", "-1", "\"linger\" must be from 0 to 1e9"},
       {"linger", "1.1e9", "\"linger\" must be from 0 to 1e9"}}));
  CAPTURE(name, value);
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  simulator.SetVisualization("live", {{"open", "false"}, {name, value}});
  if (*error == '\0') {
    CHECK_NOTHROW(Diffusion(1)(simulator));
  } else {
    CHECK_THROWS_WITH(Diffusion(1)(simulator), Contains(error));
  }
}

TEST_CASE("live view: strangers are refused", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  const std::string& url = world.GetURL();
  const std::string host = url.substr(7, url.find("/#") - 7);
  using SOptions = CLiveClient::SOptions;
  CHECK_THROWS(CLiveClient(url, SOptions{.Host = "evil.example:80"}));
  CHECK_THROWS(CLiveClient(url, SOptions{.Host = "evil.example"}));
  CHECK_THROWS(CLiveClient(url, SOptions{.Origin = "http://evil.example"}));
  CHECK_THROWS(CLiveClient(url, SOptions{.Origin = "null"}));
  CHECK_THROWS(CLiveClient(url, SOptions{.Origin = "http://" + host + ".evil.example"}));
  CHECK_THROWS(CLiveClient(url, SOptions{.Protocol = "other"}));
  for (const char* token : {"0", "0123456789abcdef0123456789abcdef"}) {
    CLiveClient viewer(url);
    viewer.Hello(token);
    CHECK_THAT(viewer.WaitFor("error").get<std::string>(), Contains("token is wrong"));
    CHECK_FALSE(viewer.Receive());
  }
  CLiveClient hasty(url);
  hasty.Send({{"do", "end"}, {"id", 1}});
  CHECK_THAT(hasty.WaitFor("error").get<std::string>(), Contains("token"));

  CHECK_THAT(Get(world, "GET / HTTP/1.1\r\nHost: " + host), Contains("200 OK"));
  CHECK_THAT(Get(world, "GET / HTTP/1.1\r\nHost: localhost:1"), Contains("200 OK"));
  CHECK_THAT(Get(world, "GET /?detail=low HTTP/1.1\r\nHost: localhost:1"), Contains("200 OK"));
  CHECK_THAT(Get(world, "GET / HTTP/1.1\r\nHost: evil.example"), Contains("403"));
  CHECK_THAT(Get(world, "GET / HTTP/1.1\r\nHost: localhost.evil.example"), Contains("403"));
  CHECK_THAT(Get(world, "GET /../../etc/passwd HTTP/1.1\r\nHost: " + host), Contains("404"));
  CHECK_THAT(Get(world, "GET /live HTTP/1.1\r\nHost: " + host), Contains("403"));
  CHECK_THAT(Get(world, "POST / HTTP/1.1\r\nHost: " + host), Contains("405"));

  CHECK(IsOk(Join(world)->Do("end")));
  world.Finish();
}

TEST_CASE("live view: one viewer has control, and hands it over", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  auto first = Join(world);
  auto second = Join(world);
  auto third = Join(world);
  CHECK_THAT(GetError(second->Do("play")), Contains("another viewer has control"));
  CHECK_THAT(GetError(second->Do("give_control", {{"viewer", 2}})), Contains("control"));
  CHECK(IsOk(third->Do("ask_control")));
  CHECK_THAT(GetError(first->Do("give_control", {{"viewer", 99}})), Contains("no such viewer"));
  CHECK(IsOk(first->Do("give_control", {{"viewer", 2}})));
  CHECK(IsOk(second->Do("step")));
  CHECK_THAT(GetError(first->Do("step")), Contains("control"));
  // the third one has asked, the first one has not
  second.reset();
  third->ReceiveUntil([&] { return third->GetStatus().value("control", 0) == 3; });
  CHECK(IsOk(third->Do("step")));
  third.reset();
  first->ReceiveUntil([&] { return first->GetStatus().value("control", 0) == 1; });
  CHECK(IsOk(first->Do("end")));
  world.Finish();
}

TEST_CASE("live view: robots and things are moved, added and removed", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  auto viewer = Join(world);
  const auto see = [&](const auto& isThere) {
    return viewer->ReceiveUntil([&] { return isThere(viewer->GetFrame()); });
  };
  CHECK_THAT(GetError(viewer->Do("move", {{"entity", "fb0"}, {"position", {2.5, 0, 0}}})),
             Contains("would overlap \"wall_east\""));
  CHECK_THAT(GetError(viewer->Do("move", {{"entity", "fb0"}, {"position", {9, 0, 0}}})),
             Contains("outside of the arena"));
  CHECK_THAT(GetError(viewer->Do("move", {{"entity", "nobody"}, {"position", {0, 0, 0}}})),
             Contains("no entity \"nobody\""));
  for (const TJson& position : {TJson("here"), TJson({1, 2}), TJson({1, 2, "3"}),
                                TJson({1e300, 0, 0}), TJson({{"x", 1}})}) {
    CHECK_THAT(GetError(viewer->Do("move", {{"entity", "fb0"}, {"position", position}})),
               Contains("three numbers"));
  }
  REQUIRE(IsOk(viewer->Do("remove", {{"entity", "fb1"}})));
  CHECK(see([](const SRecordedFrame& frame) { return !Has(frame, "fb1"); }));
  // between the walls and what is distributed up to 2.2 m
  const TJson corner = {-2.44, 2.44, 0};
  REQUIRE(IsOk(viewer->Do("add", {{"type", "box"}, {"position", corner}, {"yaw", 0.0}})));
  CHECK(see([](const SRecordedFrame& frame) { return Has(frame, "box_added_1"); }));
  CHECK(GetPose(viewer->GetFrame(), "box_added_1").Position.GetX() == Approx(-2.44));
  CHECK_THAT(GetError(viewer->Do("add", {{"type", "foot-bot"}, {"position", corner}})),
             Contains("would overlap"));
  CHECK_THAT(GetError(viewer->Do("add", {{"type", "footbot"}, {"position", corner}})),
             Contains("foot-bot"));
  CHECK_THAT(GetError(viewer->Do("add", {{"type", "floor"}, {"position", corner}})),
             Contains("no \"floor\""));
  CHECK(IsOk(viewer->Do("remove", {{"entity", "box_added_1"}})));
  REQUIRE(
      IsOk(viewer->Do("move", {{"entity", "fb0"}, {"position", {2.41, -2.41, 0}}, {"yaw", 1}})));
  CHECK(see([](const SRecordedFrame& frame) {
    return std::abs(GetPose(frame, "fb0").Position.GetX() - 2.41) < 1e-5;
  }));
  PlayToEnd(*viewer);
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a run is repeated with the commands in its recording", "[live]") {
  const CTemporaryFolder folder;
  const std::string file = folder.Path("run.rec");
  CLiveWorld world(kWaits, [&](CSimulator& simulator) {
    simulator.AddOutput("recording", {{"file", file}});
    Diffusion(10)(simulator);
  });
  auto viewer = Join(world);
  std::mt19937 random(7);
  std::uniform_real_distribution<Real> place(-2.3, 2.3);
  int numDone = 0;
  for (int i = 0; i < 30; ++i) {
    const std::string robot = "fb" + std::to_string(i % 10);
    const TJson position = {place(random), place(random), 0};
    const TJson answer = i % 3 == 0
                             ? viewer->Do("add", {{"type", i % 2 == 0 ? "foot-bot" : "cylinder"},
                                                  {"position", position}})
                             : viewer->Do("move", {{"entity", robot}, {"position", position}});
    numDone += IsOk(answer) ? 1 : 0;
    CHECK(IsOk(viewer->Do("step", {{"n", i % 4 + 1}})));
    viewer->ReceiveUntil([&] { return viewer->GetStatus().value("run", "") == "paused"; });
  }
  CHECK(numDone > 5);
  // it stands, where its controller would drive
  CHECK(IsOk(viewer->Do("drive", {{"entity", "fb3"}, {"left", 0}, {"right", 0}})));
  CHECK(IsOk(viewer->Do("step", {{"n", 5}})));
  viewer->ReceiveUntil([&] { return viewer->GetStatus().value("run", "") == "paused"; });
  CHECK(IsOk(viewer->Do("move", {{"entity", "fb3"}, {"yaw", 0.5}})));
  CHECK(IsOk(viewer->Do("end")));
  const UInt64 digest = world.Finish();
  const auto load = [&](CSimulator& simulator) {
    simulator.SetVisualization("live", {{"commands", file}});
    Diffusion(10)(simulator);
  };
  CHECK(RunHeadless(load) == digest);
  CHECK(RunHeadless(Diffusion(10)) != digest);
}

TEST_CASE("live view: who comes to a waiting run that all have left sees its state", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  int number = 0;
  const auto look = [&](UInt32 tick) {
    auto viewer = Join(world);
    ++number;
    viewer->ReceiveUntil([&] {
      return viewer->CountFrames() > 0 && viewer->GetStatus().value("control", 0) == number;
    });
    CHECK(viewer->GetFrame().Tick == tick);
    return viewer;
  };
  look(0);
  StepTicks(*look(0), 2);
  auto last = look(2);
  CHECK(IsOk(last->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a viewer drives a robot, whatever its controller wants", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  auto viewer = Join(world);
  CHECK_THAT(GetError(viewer->Do("drive", {{"entity", "wall_east"}, {"left", 0}, {"right", 0}})),
             Contains("cannot be driven"));
  CHECK_THAT(GetError(viewer->Do("drive", {{"entity", "fb0"}, {"left", "x"}, {"right", 0}})),
             Contains("\"left\" is a number"));
  const auto step = [&](UInt32 to) {
    CHECK(IsOk(viewer->Do("step", {{"n", 5}})));
    viewer->ReceiveUntil([&] { return viewer->GetFrame().Tick == to; });
    return GetPose(viewer->GetFrame(), "fb0").Position;
  };
  CHECK(IsOk(viewer->Do("drive", {{"entity", "fb0"}, {"left", 0}, {"right", 0}})));
  const CVector3 start = step(5);
  // its controller would drive at 10 cm/s, 5 cm in half a second
  CHECK(Distance(step(10), start) < 1e-4);
  CHECK(IsOk(viewer->Do("drive", {{"entity", "fb0"}})));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a replay is played, and shown from any tick on", "[live]") {
  const CTemporaryFolder folder;
  const std::string file = folder.Path("run.rec");
  RunHeadless([&](CSimulator& simulator) {
    simulator.AddOutput("recording", {{"file", file}});
    Diffusion(5)(simulator);
  });
  CLiveWorld world(kWaits, [&](CSimulator& simulator) {
    SReplayRequest request;
    request.File = file;
    simulator.LoadReplay(request, true);
  });
  auto viewer = Join(world);
  for (const UInt32 tick : {40U, 10U, 0U, 50U, 10U}) {
    CHECK(IsOk(viewer->Do("seek", {{"tick", tick}})));
    CHECK(viewer->ReceiveUntil([&] { return viewer->GetFrame().Tick == tick; }));
  }
  CHECK_THAT(GetError(viewer->Do("move", {{"entity", "fb0"}, {"position", {0, 0, 0}}})),
             Contains("nothing can be changed"));
  CHECK(IsOk(viewer->Do("step", {{"n", 2}})));
  CHECK(viewer->ReceiveUntil([&] { return viewer->GetFrame().Tick == 12; }));
  PlayToEnd(*viewer);
  CHECK(viewer->GetFrame().Tick == 50);
  CHECK(IsOk(viewer->Do("reset")));
  CHECK(viewer->ReceiveUntil([&] { return viewer->GetFrame().Tick == 0; }));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: garbage ends a connection, and never the run", "[live]") {
  const UInt64 expected = RunHeadless(Diffusion(5));
  CLiveWorld world(kWaits, Diffusion(5));
  auto viewer = Join(world);
  std::string deep(60000, '[');
  const std::string large = "{\"do\":\"play\",\"id\":1,\"x\":\"" + std::string(70000, 'x') + "\"}";
  for (const std::string& text : {std::string("{"), std::string("\xff\xfe"), std::string("[]"),
                                  deep, large, std::string("7"), std::string()}) {
    auto other = Join(world);
    CAPTURE(text.substr(0, 20));
    other->SendText(text);
    // bytes that are no UTF-8 end the connection without a message
    CHECK((other->WaitFor("error").is_string() || text[0] == '\xff'));
    CHECK_FALSE(other->Receive());
  }
  auto binary = Join(world);
  binary->SendText("{}", true);
  CHECK_THAT(binary->WaitFor("error").get<std::string>(), Contains("texts"));
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    auto other = std::make_unique<CLiveClient>(world.GetURL());
    if (i % 2 == 0) {
      other->Hello();
    }
    std::string bytes(random() % 300, ' ');
    for (char& byte : bytes) {
      byte = static_cast<char>(random());
    }
    other->SendText(bytes, i % 3 == 0);
  }
  // unknown and wrong commands are answered
  CHECK_THAT(GetError(viewer->Do("fly")), Contains("no command \"fly\""));
  for (const char* command : {"step", "speed", "reset", "seek", "rate", "pin", "give_control"}) {
    for (const TJson& value : {TJson(-1), TJson("x"), TJson(1e30), TJson::array()}) {
      TJson arguments;
      for (const char* name : {"n", "factor", "seed", "tick", "fps", "entity", "viewer"}) {
        arguments[name] = value;
      }
      if (command != std::string("pin") || value != "x") {
        CHECK_FALSE(GetError(viewer->Do(command, arguments)).empty());
      }
    }
  }
  PlayToEnd(*viewer);
  CHECK(IsOk(viewer->Do("end")));
  CHECK(world.Finish() == expected);
}

TEST_CASE("live view: a viewer that floods it is disconnected", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  auto flooding = Join(world);
  for (int i = 0; i < 300; ++i) {
    flooding->SendText(R"({"do":"unpin","entity":"fb0","id":1})");
  }
  CHECK_THAT(flooding->WaitFor("error").get<std::string>(), Contains("100 messages a second"));
  CHECK(IsOk(Join(world)->Do("end")));
  world.Finish();
}

TEST_CASE("live view: a viewer that reads nothing is disconnected, and slows nothing", "[live]") {
  const CTemporaryFolder folder;
  CLiveWorld world(kWaits, LongLines(folder));
  auto viewer = Join(world);
  CLiveClient slow(world.GetURL(), CLiveClient::SOptions{.ReceiveBuffer = 4096});
  slow.Hello();
  viewer->ReceiveUntil([&] { return viewer->GetStatus().value("viewers", TJson()).size() == 2; });
  // 1 MiB may wait, and the buffers of the system take some more: 160 KB in each tick
  constexpr int kMaxTicks = 400;
  const auto isGone = [&] { return viewer->GetStatus().value("viewers", TJson()).size() == 1; };
  for (int tick = 0; tick < kMaxTicks && !isGone(); ++tick) {
    REQUIRE(IsOk(viewer->Do("step")));
    // 100 messages a second are allowed
    std::this_thread::sleep_for(std::chrono::milliseconds(15));
  }
  CHECK(isGone());
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

}  // namespace live_test
