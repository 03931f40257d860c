// Recordings replay to the pictures of the run that was recorded, without any of its code.

#include "../command_line/program_run.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace replay_test {

using namespace argos;
using Catch::Contains;

namespace {

std::vector<std::string> ListFrames(const CTestFolder& folder, const std::string& directory) {
  std::vector<std::string> names;
  if (std::filesystem::exists(folder.Path(directory))) {
    for (const auto& entry : std::filesystem::directory_iterator(folder.Path(directory))) {
      if (entry.path().extension() == ".png") {
        names.push_back(entry.path().filename().string());
      }
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

// for all test cases of this program: where the libraries of the experiments are
[[maybe_unused]] const int kPluginPath =
    setenv("ARGOS_PLUGIN_PATH", InBuildTree("experiments").c_str(), 1);

// every file has the same bytes: PNG files of equal pixels do
void CheckSameFrames(const CTestFolder& folder, const std::string& live,
                     const std::string& replayed, size_t number) {
  const std::vector<std::string> names = ListFrames(folder, live);
  REQUIRE(names.size() == number);
  REQUIRE(ListFrames(folder, replayed) == names);
  for (const std::string& name : names) {
    CAPTURE(name);
    CHECK(folder.Read(live + "/" + name) == folder.Read(replayed + "/" + name));
  }
}

void CheckSuccess(const SProgramRun& run) {
  CAPTURE(run.Out, run.Err);
  REQUIRE(run.Status == 0);
}

std::vector<std::string> operator+(std::vector<std::string> all,
                                   const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

const std::vector<std::string> kSmall = {"--set", "//offscreen/@size=320x240"};

std::vector<std::string> Into(const std::string& directory) {
  return {"--set", "//offscreen/@directory=" + directory};
}

// of what an experiment file of this project needs
std::vector<std::string> LiveFlocking() {
  return {"-c",     InSourceTree("experiments/flocking.argos"), "--length", "15", "--record",
          "run.rec"};
}

// Everything that comes, goes and changes: boxes that are added and removed, lamps, a painted
// floor, LEDs, rays, and overlays that need the past. In Lua, so that nothing else is to be built.
constexpr char kLively[] = R"(
<argos-configuration>
  <framework><experiment length="6" ticks_per_second="10" random_seed="3" /></framework>
  <controllers>
    <lua_controller id="lua">
      <actuators>
        <differential_steering implementation="default" />
        <leds implementation="default" medium="leds" />
      </actuators>
      <sensors><footbot_proximity implementation="default" show_rays="true" /></sensors>
      <params script="robot.lua" />
    </lua_controller>
  </controllers>
  <arena size="4,4,1">
    <floor id="floor" source="image" path="floor.png" />
    <light id="lamp" position="1,1,0.5" color="yellow" intensity="1" medium="leds" />
    <box id="wall" size="1,0.1,0.3" movable="false"><body position="0,1.5,0" /></box>
    <box id="crate" size="0.3,0.2,0.2" movable="true" mass="0.5"><body position="0.5,0,0" /></box>
    <cylinder id="drum" radius="0.1" height="0.2" movable="true" mass="0.5">
      <body position="-0.5,0.3,0" />
    </cylinder>
    <distribute>
      <position method="uniform" min="-1.5,-1.5,0" max="1.5,1,0" />
      <orientation method="uniform" min="0,0,0" max="360,0,0" />
      <entity quantity="5" max_trials="100"><foot-bot id="fb"><controller config="lua" /></foot-bot></entity>
    </distribute>
  </arena>
  <physics_engines><dynamics2d id="dyn2d" /></physics_engines>
  <media><led id="leds" /></media>
  <visualization>
    <offscreen directory="out" size="320x240" every="10">
      <overlays><ids /><headings /><trails /><clock /></overlays>
    </offscreen>
  </visualization>
</argos-configuration>
)";

constexpr char kRobotScript[] = R"(
ticks = 0
function init() end
function reset() end
function destroy() end
function step()
  ticks = ticks + 1
  robot.wheels.set_velocity(ticks % 20, 10)
  robot.leds.set_all_colors(ticks % 3 == 0 and "red" or "blue")
end
)";

// a binary PPM: 2 x 2 pixels of four colours
const std::string kFloor =
    std::string("P6\n2 2\n255\n") + "\x80\x10\x10\x10\x80\x10\x10\x10\x80\x70\x70\x10";

}  // namespace

TEST_CASE("replay: flocking gives the frames of the run, pixel for pixel",
          "[scenario][recording]") {
  const CTestFolder folder;
  CheckSuccess(folder.Run(LiveFlocking() + kSmall + Into("live")));
  CheckSuccess(
      folder.Run(std::vector<std::string>{"--replay", "run.rec"} + kSmall + Into("replayed")));
  CheckSameFrames(folder, "live", "replayed", 4);
}

TEST_CASE("replay: rays, LEDs, floor and overlays are as in the run, and nothing of it is needed",
          "[scenario][recording]") {
  const CTestFolder folder;
  folder.Write("e.argos", kLively);
  folder.Write("robot.lua", kRobotScript);
  folder.Write("floor.png", kFloor);
  const SProgramRun live = folder.Run({"-c", "e.argos", "--record", "run.rec"});
  CheckSuccess(live);
  std::filesystem::remove(folder.Path("e.argos"));
  std::filesystem::remove(folder.Path("robot.lua"));
  std::filesystem::remove(folder.Path("floor.png"));
  CheckSuccess(folder.Run(std::vector<std::string>{"--replay", "run.rec"} + Into("replayed")));
  CheckSameFrames(folder, "out", "replayed", 7);
}

TEST_CASE("replay: directional LEDs have the colours of the run", "[scenario][recording]") {
  const CTestFolder folder;
  folder.Write("robot.lua", R"(
function init() end
function reset() end
function destroy() end
function step()
  robot.directional_leds.set_all_colors("red")
end
)");
  folder.Write("e.argos", R"(
<argos-configuration>
  <framework><experiment length="1" ticks_per_second="10" random_seed="3" /></framework>
  <controllers>
    <lua_controller id="lua">
      <actuators><directional_leds implementation="default" /></actuators>
      <sensors />
      <params script="robot.lua" />
    </lua_controller>
  </controllers>
  <arena size="1,1,1">
    <pipuck id="p" led_medium="leds"><body position="0,0,0" /><controller config="lua" /></pipuck>
  </arena>
  <physics_engines><dynamics2d id="dyn2d" /></physics_engines>
  <media><directional_led id="leds" /></media>
  <visualization><offscreen directory="out" size="320x240" every="5" /></visualization>
</argos-configuration>
)");
  CheckSuccess(folder.Run({"-c", "e.argos", "--record", "run.rec"}));
  CheckSuccess(folder.Run(std::vector<std::string>{"--replay", "run.rec"} + Into("replayed")));
  CheckSameFrames(folder, "out", "replayed", 3);
  // they were off in the first frame
  CHECK(folder.Read("out/" + ListFrames(folder, "out").front()) !=
        folder.Read("out/" + ListFrames(folder, "out").back()));
}

TEST_CASE("replay: exact recordings give the same pictures", "[scenario][recording]") {
  const CTestFolder folder;
  CheckSuccess(folder.Run(LiveFlocking() + kSmall + Into("live") +
                          std::vector<std::string>{"--set", "//recording/@precision=exact"}));
  CheckSuccess(
      folder.Run(std::vector<std::string>{"--replay", "run.rec"} + kSmall + Into("replayed")));
  CheckSameFrames(folder, "live", "replayed", 4);
}

TEST_CASE("replay: a part, with another step, in the views of another file",
          "[scenario][recording]") {
  const CTestFolder folder;
  CheckSuccess(folder.Run(LiveFlocking() + std::vector<std::string>{"-z"}));
  folder.Write("views.argos",
               "<argos-configuration><visualization><offscreen directory='views' size='64x64' />"
               "</visualization></argos-configuration>");
  const SProgramRun run = folder.Run(
      {"--replay", "run.rec", "-c", "views.argos", "--from", "2s", "--to", "55", "--every", "10"});
  CheckSuccess(run);
  CHECK_THAT(run.Out, Contains("Replaying ticks 20 to 55") && Contains("random seed 124"));
  // that of the experiment is not what is shown
  CHECK_THAT(run.Out, !Contains("Total experiment length"));
  CHECK(ListFrames(folder, "views") ==
        std::vector<std::string>{"frame_0000000020.png", "frame_0000000030.png",
                                 "frame_0000000040.png", "frame_0000000050.png",
                                 "frame_0000000055.png"});
}

TEST_CASE("replay: outputs of the recorded run are not written again", "[scenario][recording]") {
  const CTestFolder folder;
  folder.Write("floor.png", kFloor);
  folder.Write("robot.lua", kRobotScript);
  std::string experiment = kLively;
  experiment.insert(experiment.find("</argos-configuration>"),
                    "<outputs><table file='table.csv' /></outputs>\n");
  folder.Write("e.argos", experiment);
  CheckSuccess(folder.Run({"-z", "-c", "e.argos", "--record", "run.rec"}));
  const std::string table = folder.Read("table.csv");
  CHECK(table.size() > 1000);
  folder.Write("table.csv", "kept");
  const SProgramRun replay = folder.Run({"-z", "--replay", "run.rec"});
  CheckSuccess(replay);
  CHECK_THAT(replay.Out, Contains("The outputs of the recorded run are not written again"));
  CHECK(folder.Read("table.csv") == "kept");
  // those of another file are what the user asks for
  const SProgramRun other = folder.Run({"-z", "--replay", "run.rec", "-c", "e.argos"});
  CheckSuccess(other);
  CHECK_THAT(other.Out, !Contains("not written again"));
  CHECK(folder.Read("table.csv") != "kept");
}

TEST_CASE("replay: a replay can be recorded, without overwriting what it reads",
          "[scenario][recording]") {
  const CTestFolder folder;
  CheckSuccess(folder.Run(LiveFlocking() + std::vector<std::string>{"-z"}));
  CheckSuccess(folder.Run({"-z", "--replay", "run.rec", "--from", "100", "--record", "part.rec"}));
  const SProgramRun run = folder.Run({"-z", "--replay", "part.rec"});
  CheckSuccess(run);
  CHECK_THAT(run.Out, Contains("Replaying ticks 100 to 150"));
  const SProgramRun same = folder.Run({"-z", "--replay", "run.rec", "--record", "run.rec"});
  CHECK(same.Status == 1);
  CHECK_THAT(same.Err, Contains("--replay and --record are the same file, run.rec"));
}

TEST_CASE("replay: what is recorded of an exact recording is exact", "[scenario][recording]") {
  const CTestFolder folder;
  folder.Write("e.argos", kLively);
  folder.Write("robot.lua", kRobotScript);
  folder.Write(
      "exact.argos",
      "<argos-configuration><outputs><table file='t.csv'/></outputs></argos-configuration>");
  CheckSuccess(folder.Run({"-z", "-c", "e.argos", "--set", "//floor/@source=loop_functions",
                           "--set", "//floor/@pixels_per_meter=1", "--length", "2", "--record",
                           "run.rec", "--set", "//recording/@precision=exact", "--csv", "run"}));
  CheckSuccess(folder.Run({"-z", "--replay", "run.rec", "--record", "part.rec"}));
  CheckSuccess(folder.Run({"-z", "--replay", "part.rec", "--csv", "part"}));
  const auto rows = [&folder](const std::string& name) {
    const std::string text = folder.Read(name);
    return text.substr(text.find("\nrun,"));
  };
  CHECK(rows("part/robots.csv") == rows("run/robots.csv"));
  // the head of a table describes the same solids
  const auto solids = [&folder](const std::string& name) {
    std::istringstream lines(folder.Read(name));
    std::vector<std::string> found;
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("# circle", 0) == 0 || line.rfind("# polygon", 0) == 0) {
        found.push_back(line);
      }
    }
    return found;
  };
  CHECK(solids("run/robots.csv").size() == 3);
  CHECK(solids("part/robots.csv") == solids("run/robots.csv"));
  CHECK_THAT(solids("part/robots.csv").back(), Catch::StartsWith("# circle: -0.5,0.3,0.1"));
}

TEST_CASE("replay: a value of --set that has no effect is an error", "[scenario][recording]") {
  const CTestFolder folder;
  CheckSuccess(folder.Run(LiveFlocking() + std::vector<std::string>{"-z"}));
  const std::string path =
      GENERATE("//experiment/@length", "//experiment/@random_seed",
               "//experiment/@ticks_per_second", "//system/@threads", "//controllers/*/params/@x");
  CAPTURE(path);
  const SProgramRun run = folder.Run({"-z", "--replay", "run.rec", "--set", path + "=2"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("--set " + path + "=2: ") && Contains("is not used by anything"));
}

TEST_CASE("recording: a symbolic link stays, and leads to the recording", "[scenario][recording]") {
  const CTestFolder folder;
  std::filesystem::create_directory(folder.Path("store"));
  std::filesystem::create_symlink("store/run.rec", folder.Path("link.rec"));
  for (int run = 0; run < 2; ++run) {
    CheckSuccess(folder.Run({"-z", "-c", InSourceTree("experiments/flocking.argos"), "--length",
                             "0.5", "--record", "link.rec"}));
    CHECK(std::filesystem::is_symlink(folder.Path("link.rec")));
    CHECK(std::filesystem::is_regular_file(folder.Path("store/run.rec")));
    CheckSuccess(folder.Run({"-z", "--replay", "store/run.rec"}));
  }
}

namespace {

// what the tables of a run and of its replay must have in common
constexpr char kOutputs[] =
    "<table file='robots.csv' fields='pose,lua:mood,lua:ticks,readings:footbot_proximity,leds'/>"
    "<metrics file='metrics.csv'/>";

constexpr char kMoods[] = R"(
ticks = 0
mood = "still"
function init() end
function reset() end
function destroy() end
function step()
  ticks = ticks + 1
  mood = ticks % 7 < 3 and "eager" or robot.id
  robot.wheels.set_velocity(ticks % 20, 10)
  robot.leds.set_all_colors(ticks % 3 == 0 and "red" or "blue")
end
)";

constexpr char kLoop[] = R"(
function init() simulation.metric("food", 0) end
function post_step()
  simulation.metric("food", simulation.clock() % 5)
  simulation.metric("spread", 0.1 * simulation.clock(), "m")
end
)";

// without the lines about the run
std::string ReadRows(const CTestFolder& folder, const std::string& name) {
  std::istringstream in(folder.Read(name));
  std::string rows;
  for (std::string line; std::getline(in, line);) {
    if (line[0] != '#') {
      rows += line + '\n';
    }
  }
  return rows;
}

}  // namespace

TEST_CASE("replay: tables have the recorded fields and metrics, also from a recorded replay",
          "[scenario][recording]") {
  const CTestFolder folder;
  std::string experiment = kLively;
  const std::string fields = "lua:mood, lua:ticks,readings:footbot_proximity";
  const std::string end = "</argos-configuration>";
  experiment.replace(experiment.find(end), end.size(),
                     "<loop_functions label='lua'><params script='loop.lua'/></loop_functions>"
                     "<outputs>" +
                         std::string(kOutputs) +
                         "<recording file='run.rec' precision='exact' fields='" + fields +
                         "'/></outputs>" + end);
  folder.Write("e.argos", experiment);
  folder.Write("robot.lua", kMoods);
  folder.Write("loop.lua", kLoop);
  folder.Write("floor.png", kFloor);
  CheckSuccess(folder.Run({"-zc", "e.argos"}));
  const std::string robots = ReadRows(folder, "robots.csv");
  const std::string metrics = ReadRows(folder, "metrics.csv");
  CHECK_THAT(robots, Contains("lua_mood") && Contains("eager") && Contains("fb3,"));
  CHECK_THAT(metrics, Contains("food,spread"));
  folder.Write("tables.argos",
               "<argos-configuration><outputs>" + std::string(kOutputs) + "</outputs>" + end);
  CheckSuccess(folder.Run({"-z", "--replay", "run.rec", "-c", "tables.argos"}));
  CHECK(ReadRows(folder, "robots.csv") == robots);
  CHECK(ReadRows(folder, "metrics.csv") == metrics);
  CheckSuccess(folder.Run({"-z", "--replay", "run.rec", "--record", "copy.rec", "--set",
                           "//recording/@precision=exact"}));
  CheckSuccess(folder.Run({"-z", "--replay", "copy.rec", "-c", "tables.argos"}));
  CHECK(ReadRows(folder, "robots.csv") == robots);
  CHECK(ReadRows(folder, "metrics.csv") == metrics);
}

TEST_CASE("replay: recorded drawings of user functions and loop functions are in the pictures",
          "[scenario][recording]") {
  const CTestFolder folder;
  std::ifstream in(InSourceTree("experiments/trajectories.argos"));
  std::string experiment((std::istreambuf_iterator<char>(in)), {});
  const std::string functions = "<user_functions label=\"trajectory_user_functions\" />";
  const std::string end = "</argos-configuration>";
  REQUIRE(experiment.find(functions) != std::string::npos);
  experiment.replace(experiment.find(end), end.size(),
                     "<outputs><recording file='run.rec' drawing='true'>" + functions +
                         "</recording></outputs>" + end);
  folder.Write("e.argos", experiment);
  CheckSuccess(folder.Run(std::vector<std::string>{"-c", "e.argos", "--length", "10"} + kSmall +
                          Into("live")));
  const SProgramRun replay =
      folder.Run(std::vector<std::string>{"--replay", "run.rec"} + kSmall + Into("replayed"));
  CheckSuccess(replay);
  CHECK_THAT(replay.Err, Contains("<user_functions> draw nothing in a replay"));
  const std::vector<std::string> names = ListFrames(folder, "live");
  CheckSameFrames(folder, "live", "replayed", names.size());
  const SProgramRun off =
      folder.Run({"-zc", "e.argos", "--length", "10", "--set", "//recording/@drawing=false"});
  CHECK(off.Status == 1);
  CHECK_THAT(off.Err, Contains("<user_functions>, but drawing=\"true\" is missing"));
}

TEST_CASE("recording: fields that cannot be recorded are errors", "[scenario][recording]") {
  const CTestFolder folder;
  const auto error = [&folder](const std::string& fields) {
    const SProgramRun run =
        folder.Run({"-zc", InSourceTree("experiments/flocking.argos"), "--record", "run.rec",
                    "--set", "//recording/@fields=" + fields});
    CHECK(run.Status == 1);
    return run.Err;
  };
  CHECK_THAT(error("batery"), Contains("did you mean \"battery\""));
  CHECK_THAT(error("messages"), Contains("a list of rows") && Contains("<table>"));
  CHECK_THAT(error("pose"), Contains("needs no recording"));
  CHECK_THAT(error("readings:foo"), Contains("no robot has the field \"readings:foo\""));
  CHECK_THAT(error(","), Contains("lists no field"));
}

TEST_CASE("replay: impossible parts and options are errors", "[scenario][recording]") {
  const CTestFolder folder;
  CheckSuccess(folder.Run({"-c", InSourceTree("experiments/flocking.argos"), "--length", "2", "-z",
                           "--record", "run.rec"}));
  const auto error = [&folder](const std::vector<std::string>& arguments) {
    const SProgramRun run =
        folder.Run(std::vector<std::string>{"-z", "--replay", "run.rec"} + arguments);
    CHECK(run.Status == 1);
    return run.Err;
  };
  CHECK_THAT(error({"--from", "30"}), Contains("has no state from tick 30 to tick 20: it has ticks "
                                               "0 to 20, that is 0 s to 2 s"));
  CHECK_THAT(error({"--from", "x"}), Contains("--from x: expected a tick, such as 100, or a time"));
  CHECK_THAT(error({"--every", "0"}), Contains("--every 0: expected a number of ticks"));
  CHECK_THAT(error({"--seed", "1"}), Contains("--seed cannot be used with --replay"));
  CHECK_THAT(error({"--digest"}), Contains("--digest cannot be used with --replay"));
  CHECK(folder.Run({"-c", "x", "--from", "1"}).Status == 1);
}

TEST_CASE("replay: parts of a recording that begins late, or has few states",
          "[scenario][recording]") {
  const CTestFolder folder;
  CheckSuccess(folder.Run({"-c", InSourceTree("experiments/flocking.argos"), "--length", "2", "-z",
                           "--record", "run.rec", "--set", "//recording/@every=4"}));
  CheckSuccess(folder.Run(
      {"-z", "--replay", "run.rec", "--from", "7", "--to", "17", "--record", "part.rec"}));
  const auto replay = [&folder](const std::vector<std::string>& arguments) {
    return folder.Run(std::vector<std::string>{"-z", "--replay", "part.rec"} + arguments);
  };
  const auto [arguments, message] = GENERATE(table<std::vector<std::string>, std::string>({
      {{"--to", "7"}, "has no state from tick 8 to tick 7: it has ticks 8 to 16, that is 0.8 s"},
      {{"--from", "12", "--to", "11"}, "has no state from tick 12 to tick 11"},
      {{"--from", "17"}, "has no state from tick 17 to tick 16"},
      {{"--from", "1e30s"}, "has no state from tick 4294967295 to tick 16"},
      {{"--from", "9", "--to", "11"}, "has no state from tick 9 to tick 11: it has one every "},
  }));
  const SProgramRun refused = replay(arguments);
  CHECK(refused.Status == 1);
  CHECK_THAT(refused.Err, Contains(message));
  // from the first state on, if that is later
  CheckSuccess(replay({"--from", "2", "--to", "1e30s", "--csv", "csv"}));
  std::istringstream rows(folder.Read("csv/metrics.csv"));
  std::vector<std::string> ticks;
  for (std::string row; std::getline(rows, row);) {
    if (row.rfind("0,", 0) == 0) {
      ticks.push_back(row.substr(2, row.find(',', 2) - 2));
    }
  }
  CHECK(ticks == std::vector<std::string>{"8", "12", "16"});
}

TEST_CASE("recording: wrong attributes are errors", "[scenario][recording]") {
  const CTestFolder folder;
  const auto [set, message] = GENERATE(table<std::string, std::string>({
      {"every=0", "attribute \"every\" (ticks) must be at least 1, found 0"},
      {"file=", "attribute \"file\" is empty"},
      {"precision=exakt", "did you mean \"exact\"?"},
  }));
  const SProgramRun run = folder.Run({"-zc", InSourceTree("experiments/flocking.argos"), "--record",
                                      "run.rec", "--set", "//recording/@" + set});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains(message));
}

TEST_CASE("recording: the digest of a run does not change", "[scenario][recording]") {
  const CTestFolder folder;
  const std::vector<std::string> arguments = {"-zc", InSourceTree("experiments/flocking.argos"),
                                              "--length", "5", "--digest"};
  const auto digest = [](const SProgramRun& run) {
    return run.Out.substr(run.Out.find("digest: "), 24);
  };
  const SProgramRun without = folder.Run(arguments);
  CheckSuccess(without);
  const SProgramRun with = folder.Run(arguments + std::vector<std::string>{"--record", "run.rec"});
  CheckSuccess(with);
  CHECK(digest(with) == digest(without));
}

}  // namespace replay_test
