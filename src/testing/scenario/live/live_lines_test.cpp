// What the live view passes on of logs, of hosts that ask, and of scripts and parameters of several
// robots.

#include "live_viewer.h"

#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace live_lines_test {

using namespace argos;
using Catch::Contains;

namespace {

/* Logs lines of each kind in tick 1, a long one in tick 2, many in tick 3, and more in tick 4. */
class CLoggingFunctions : public CLoopFunctions {
 public:
  void PostStep() override {
    const UInt32 tick = GetSpace().GetSimulationClock();
    if (tick == 1) {
      LOG << "as it is" << std::endl;
      LOG << "[INFO] good to know" << std::endl;
      LOG << "[DEBUG] for authors" << std::endl;
      LOGERR << "[WARNING] take care" << std::endl;
      LOGERR << "[ERROR] too late" << std::endl;
    } else if (tick == 2) {
      LOG << std::string(4096, 'a') << std::endl;
      LOG << std::string(4097, 'b') << std::endl;
    } else if (tick == 3) {
      for (int i = 0; i < 50; ++i) {
        LOG << std::string(1000, 'c') << std::endl;
      }
    } else if (tick == 4) {
      for (int i = 0; i < 300; ++i) {
        LOG << std::string(4000, 'd') << std::endl;
      }
    }
  }
};
REGISTER_LOOP_FUNCTIONS(CLoggingFunctions, "live_lines_test_logging")

SExperiment MakeLogging() {
  SExperiment experiment;
  experiment.Engines = "<dynamics2d id='dyn2d' />";
  experiment.LoopFunctions = "<loop_functions label='live_lines_test_logging' />";
  return experiment;
}

// the messages of the log until the state of a tick
std::vector<TJson> StepAndReadLog(CLiveClient& viewer) {
  std::vector<TJson> messages;
  const UInt32 last = viewer.GetFrame().Tick + 1;
  viewer.Send({{"do", "step"}, {"id", 1000 + last}});
  viewer.ReceiveUntil([&] {
    if (viewer.GetText().is_object() && viewer.GetText().contains("log")) {
      messages.push_back(viewer.GetText()["log"]);
    }
    return viewer.GetFrame().Tick == last;
  });
  // what was logged in the tick may come after its state
  viewer.ReceiveUntil([&] {
    if (viewer.GetText().is_object() && viewer.GetText().contains("log")) {
      messages.push_back(viewer.GetText()["log"]);
    }
    return viewer.GetText().is_object() && viewer.GetText().contains("status");
  });
  return messages;
}

// the lines of all messages: level and text
std::vector<std::pair<std::string, std::string>> ListLines(const std::vector<TJson>& messages) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const TJson& message : messages) {
    for (const TJson& line : message) {
      lines.emplace_back(line["level"].get<std::string>(), line["text"].get<std::string>());
    }
  }
  return lines;
}

SExperiment TwoScripts(const CTemporaryFolder& folder) {
  SExperiment experiment;
  for (const std::string name : {"a", "b"}) {
    experiment.Controllers += "<lua_controller id='" + name +
                              "'><actuators><differential_steering implementation='default' />"
                              "</actuators><sensors /><params script='" +
                              folder.Write(name + ".lua", "function step() end\n") +
                              "' /></lua_controller>";
  }
  experiment.Engines = "<dynamics2d id='dyn2d' />";
  for (const std::string number : {"0", "1", "2", "3"}) {
    experiment.Arena += "<foot-bot id='fb" + number + "'><body position='0," + number +
                        ",0' /><controller config='" + (number == "2" ? "b" : "a") +
                        "' /></foot-bot>";
  }
  return experiment;
}

}  // namespace

TEST_CASE("live view: lines of the log have levels, and are cut at 4096 bytes", "[live]") {
  CLiveWorld world(kWaits, Loading(MakeLogging().ToXml()));
  auto viewer = Join(world);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  using TLines = std::vector<std::pair<std::string, std::string>>;
  const TLines levels = ListLines(StepAndReadLog(*viewer));
  const auto levelOf = [&](const std::string& part) {
    const auto found = std::find_if(levels.begin(), levels.end(), [&](const auto& line) {
      return line.second.find(part) != std::string::npos;
    });
    return found == levels.end() ? std::string() : found->first;
  };
  CHECK(levelOf("as it is") == "info");
  CHECK(levelOf("good to know") == "info");
  CHECK(levelOf("for authors") == "debug");
  CHECK(levelOf("take care") == "warning");
  CHECK(levelOf("too late") == "error");
  const TLines cut = ListLines(StepAndReadLog(*viewer));
  REQUIRE(cut.size() == 2);
  CHECK(cut[0].second == std::string(4096, 'a'));
  CHECK(cut[1].second == std::string(4096, 'b'));
  // messages of 16 KiB, and the line with which they exceed it
  const std::vector<TJson> messages = StepAndReadLog(*viewer);
  CHECK(ListLines(messages).size() == 50);
  REQUIRE(messages.size() == 3);
  CHECK(messages[0].size() == 17);
  CHECK(messages[1].size() == 17);
  // 1 MiB of 4000 bytes each
  const TLines many = ListLines(StepAndReadLog(*viewer));
  CHECK(many.size() == 262 + 1);
  CHECK(many.back() == std::pair<std::string, std::string>("warning", "38 lines were too many"));
  // who comes now gets the last 64 KiB
  CLiveClient late(world.GetURL());
  late.Hello();
  size_t size = 0;
  late.ReceiveUntil([&] {
    if (late.GetText().is_object() && late.GetText().contains("log")) {
      size += late.GetText().dump().size();
    }
    return late.GetText().is_object() && late.GetText().contains("status");
  });
  CHECK(size <= 65536);
  CHECK(size > 65536 - 24000);
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: pages are given to those who ask by a name or an address of the run",
          "[live]") {
  const auto [address, hosts, host, isGiven] =
      GENERATE(table<const char*, const char*, const char*, bool>(
          {{"0.0.0.0", "node7, Other.example", "node7", true},
           {"0.0.0.0", "node7, Other.example", "NODE7:80", true},
           {"0.0.0.0", "node7, Other.example", "other.example:1", true},
           {"0.0.0.0", "node7, Other.example", "192.168.1.1", true},
           {"0.0.0.0", "node7, Other.example", "192.168.1.1:5", true},
           {"0.0.0.0", "node7, Other.example", "[fe80::1]:8000", true},
           {"0.0.0.0", "node7, Other.example", "LOCALHOST", true},
           {"0.0.0.0", "node7, Other.example", "[::1]", true},
           {"0.0.0.0", "node7, Other.example", "node8", false},
           {"0.0.0.0", "node7, Other.example", "evil.example", false},
           {"0.0.0.0", "node7, Other.example", "1.2.3.4.evil.example", false},
           {"0.0.0.0", "node7, Other.example", "", false},
           {"0.0.0.0", "node7, Other.example", "node7:", false},
           {"0.0.0.0", "node7, Other.example", "192.168.1.1:8x", false},
           {"0.0.0.0", "", "", false},
           {"127.0.0.1", "", "127.0.0.1:8", true},
           {"127.0.0.1", "", "192.168.1.1", false},
           {"127.0.0.1", "", "", false},
           {"127.0.0.2", "", "127.0.0.2", true},
           {"127.0.0.2", "", "[127.0.0.2]", true},
           {"127.0.0.2", "", "127.0.0.1", true},
           {"127.0.0.2", "", "127.0.0.3", false}}));
  CAPTURE(address, hosts, host);
  CLiveWorld world({{"speed", "0"}, {"address", address}, {"hosts", hosts}},
                   Loading(MakeLogging().ToXml()));
  std::string url = world.GetURL();
  const bool isOfAll = address == std::string("0.0.0.0");
  CHECK_THAT(url, Contains(isOfAll ? "http://localhost:" : std::string("http://") + address));
  if (isOfAll) {
    url.replace(url.find("localhost"), 9, "127.0.0.1");
  }
  const std::string answer =
      RequestByHTTP(url, std::string("GET / HTTP/1.1\r\nHost: ") + host + "\r\n\r\n");
  CHECK((answer.find("200 OK") != std::string::npos) == isGiven);
  CHECK((answer.find("This live view has another address.") != std::string::npos) == !isGiven);
  // of another scheme, and of a program that names none
  const std::string own = url.substr(7, url.find("/#") - 7);
  CLiveClient secure(url, CLiveClient::SOptions{.Origin = "https://" + own});
  CLiveClient viewer(url, CLiveClient::SOptions{.Origin = ""});
  viewer.Hello();
  CHECK(IsOk(viewer.Do("end")));
  world.Finish();
}

TEST_CASE("live view: of several scripts the one that is edited is replaced", "[live]") {
  const CTemporaryFolder folder;
  CLiveWorld world({{"speed", "0"}, {"edit", "true"}}, Loading(TwoScripts(folder).ToXml()));
  auto viewer = Join(world);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  CHECK(viewer->Do("open_script", {{"entity", "fb0"}})["robots"] == 3);
  CHECK(viewer->Do("open_script", {{"entity", "fb2"}})["robots"] == 1);
  // the one that the viewer has chosen is not asked first, but that which comes first
  const TJson answer =
      viewer->Do("script", {{"entity", "fb1"},
                            {"text",
                             "function init() if robot.id == 'fb3' then error('not here') end end\n"
                             "function step() robot.wheels.set_velocity(10, 10) end\n"}});
  CHECK(IsOk(answer));
  CHECK(answer["robots"] == 3);
  CHECK(answer["failed"] == 1);
  CHECK(answer["first"] == "fb0");
  StepTicks(*viewer, 5);
  const auto hasMoved = [&](const char* id) {
    return GetPose(viewer->GetFrame(), id).Position.GetX() > 0.01;
  };
  CHECK(hasMoved("fb0"));
  CHECK(hasMoved("fb1"));
  CHECK_FALSE(hasMoved("fb2"));
  CHECK_FALSE(hasMoved("fb3"));
  CHECK(viewer->Do("open_script", {{"entity", "fb2"}})["changed"] == false);
  // after a reset all have the file's script, and the edited one is applied again
  CHECK(IsOk(viewer->Do("reset")));
  CHECK(viewer->Do("open_script", {{"entity", "fb0"}})["changed"] == true);
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

TEST_CASE("live view: parameters can have their least and greatest value", "[live]") {
  CLiveWorld world(kWaits, Diffusion(3));
  auto viewer = Join(world);
  const auto set = [&](const TJson& value, const TJson& all = nullptr) {
    return viewer->Do("set_parameter",
                      {{"entity", "fb0"}, {"name", "velocity"}, {"value", value}, {"all", all}});
  };
  CHECK(set(0)["robots"] == 1);
  CHECK(set(30)["robots"] == 1);
  CHECK(set(30, false)["robots"] == 1);
  CHECK(set(10, true)["robots"] == 10);
  CHECK_THAT(GetError(set(-0.01)), Contains("from 0 to 30"));
  CHECK_THAT(GetError(set(30.01)), Contains("from 0 to 30"));
  CHECK_THAT(GetError(set(nullptr)), Contains("\"value\" is missing"));
  CHECK_THAT(GetError(set("7")), Contains("\"value\" is a number"));
  CHECK_THAT(GetError(set(7, 1)), Contains("\"all\" is true or false"));
  CHECK_THAT(GetError(viewer->Do("set_parameter", {{"name", "velocity"}, {"value", 1}})),
             Contains("the loop functions declare no changeable parameter"));
  CHECK_THAT(GetError(viewer->Do("set_parameter",
                                 {{"entity", "wall_east"}, {"name", "velocity"}, {"value", 1}})),
             Contains("\"wall_east\" declare no changeable parameter"));
  CHECK_THAT(GetError(viewer->Do("set_parameter", {{"value", 1}})), Contains("\"name\""));
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

}  // namespace live_lines_test
