// Runs that start where another run was.

#include "../command_line/program_run.h"

#include <argos3/core/simulator/replay/replay.h>

#include <catch2/catch.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace recorded_start_test {

using namespace argos;
using Catch::Contains;

namespace {

// ten robots that drive about, a crate and a lamp; with the states of the run in states.csv
constexpr char kExperiment[] = R"(<argos-configuration>
  <framework><experiment length="20" ticks_per_second="10" random_seed="3" /></framework>
  <controllers>
    <lua_controller id="lua">
      <actuators><differential_steering implementation="default" /></actuators>
      <sensors />
      <params script="robot.lua" />
    </lua_controller>
  </controllers>
  <arena size="4,4,1" walls="0.1,0.3">
    <light id="lamp" position="1,1,0.5" color="yellow" intensity="1" medium="leds" />
    <box id="crate" size="0.3,0.2,0.2" movable="true" mass="0.5"><body position="0.5,0,0" /></box>
    <distribute>
      <position method="uniform" min="-1.5,-1.5,0" max="1.5,1,0" />
      <orientation method="uniform" min="0,0,0" max="360,0,0" />
      <entity quantity="10" max_trials="100"><foot-bot id="fb"><controller config="lua" /></foot-bot></entity>
    </distribute>
  </arena>
  <physics_engines><ENGINE id="engine" /></physics_engines>
  <media><led id="leds" /></media>
  <outputs>
    <recording file="run.rec" precision="exact" />
    <table file="states.csv" fields="pose" />
  </outputs>
</argos-configuration>
)";
constexpr char kRobot[] = R"(
  function step() robot.wheels.set_velocity(robot.random.uniform(0, 15), robot.random.uniform(0, 15)) end
)";

void Write(const CTestFolder& folder, const std::string& engine) {
  std::string text = kExperiment;
  text.replace(text.find("ENGINE"), 6, engine);
  folder.Write("run.argos", text);
  folder.Write("robot.lua", kRobot);
}

// "id,x,y,..." of each robot at a tick, without the columns before
std::vector<std::string> ReadStates(const CTestFolder& folder, const std::string& file, int tick) {
  std::vector<std::string> states;
  std::istringstream lines(folder.Read(file));
  const std::string start = "0," + std::to_string(tick) + ",";
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(start, 0) == 0) {
      states.push_back(line.substr(line.find(',', start.size()) + 1));
    }
  }
  return states;
}

SProgramRun Start(const CTestFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(),
                   {"-zc", "run.argos", "--set", "//arena/@start_from=run.rec", "--set",
                    "//recording/@file=second.rec", "--set", "//table/@file=second.csv"});
  return folder.Run(arguments);
}

}  // namespace

TEST_CASE("recorded start: a run begins where another one was, to the bit", "[recording]") {
  const CTestFolder folder;
  const std::string engine =
      GENERATE(as<std::string>{}, "dynamics2d", "kinematics2d", "dynamics3d");
  CAPTURE(engine);
  Write(folder, engine);
  REQUIRE(folder.Run({"-zc", "run.argos"}).Status == 0);
  const auto [at, tick] =
      GENERATE(table<std::string, int>({{"150", 150}, {"7.5s", 75}, {"", 200}}));
  CAPTURE(at);
  std::vector<std::string> arguments = {"--length", "1"};
  if (!at.empty()) {
    arguments.insert(arguments.end(), {"--set", "//arena/@start_at=" + at});
  }
  const SProgramRun run = Start(folder, arguments);
  CAPTURE(run.Err);
  REQUIRE(run.Status == 0);
  CHECK_THAT(run.Out, Contains("12 of 16 entities start where they were in"));
  const std::vector<std::string> states = ReadStates(folder, "states.csv", tick);
  REQUIRE(states.size() >= 10);
  CHECK(ReadStates(folder, "second.csv", 0) == states);
  CHECK(ReadStates(folder, "second.csv", 0) != ReadStates(folder, "states.csv", 0));
}

TEST_CASE("recorded start: what cannot be is refused", "[recording]") {
  const CTestFolder folder;
  Write(folder, "dynamics2d");
  REQUIRE(folder.Run({"-zc", "run.argos"}).Status == 0);
  const auto [set, text] = GENERATE(table<std::string, std::string>(
      {{"//arena/@start_at=300", "has no state at tick 300: it has ticks 0 to 200"},
       {"//arena/@start_at=soon", "must be a tick, such as 100, or a time in seconds"},
       {"//arena/@start_from=none.rec", "there is no recording \"none.rec\""},
       {"//arena/@start_from=robot.lua", "\"robot.lua\" is no recording"},
       {"//arena/@redistribute=true", "contradict each other"}}));
  const SProgramRun run = Start(folder, {"--set", set});
  CAPTURE(set);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("run.argos:10: <arena>: \"start_from\"") && Contains(text));
}

TEST_CASE("recorded start: nothing of the arena, or something new where a robot was",
          "[recording]") {
  const CTestFolder folder;
  Write(folder, "dynamics2d");
  REQUIRE(folder.Run({"-zc", "run.argos"}).Status == 0);
  const std::string text = folder.Read("run.argos");
  SECTION("other ids") {
    const SProgramRun run = Start(
        folder, {"--set", "//foot-bot/@id=r", "--set", "//light/@id=l", "--set", "//box/@id=b"});
    CHECK(run.Status == 1);
    CHECK_THAT(run.Err, Contains("nothing of the arena that can move is in \"run.rec\""));
  }
  SECTION("a pillar on the crate") {
    std::string changed = text;
    changed.insert(changed.find("<distribute>"),
                   "<cylinder id='pillar' radius='0.05' height='0.2' movable='false'>"
                   "<body position='0.7,0.5,0' /></cylinder>");
    changed.replace(changed.find("0.5,0,0"), 7, "-1.8,1.8,0");
    folder.Write("run.argos", changed);
    // the crate was at (0.5, 0) in the recording
    const SProgramRun run = Start(
        folder, {"--set", "//arena/@start_at=0", "--set", "//cylinder/body/@position=0.5,0,0"});
    CHECK(run.Status == 1);
    CHECK_THAT(run.Err, Contains("\"crate\" would overlap \"pillar\" at (0.5,0,0)"));
  }
  SECTION("a time without a recording") {
    const SProgramRun run = folder.Run({"-zc", "run.argos", "--set", "//arena/@start_at=3"});
    CHECK(run.Status == 1);
    CHECK_THAT(run.Err, Contains("<arena>: \"start_at\" needs \"start_from\", a recording"));
  }
}

TEST_CASE("recorded start: times are ticks or seconds", "[recording]") {
  CHECK(ParseReplayTime("100")->Value == 100.0);
  CHECK_FALSE(ParseReplayTime("100")->IsInSeconds);
  CHECK(ParseReplayTime("12.5s")->Value == 12.5);
  CHECK(ParseReplayTime("12.5s")->IsInSeconds);
  for (const char* const text : {"", "s", "-1", "-1s", "1.5", "x"}) {
    CAPTURE(text);
    CHECK_FALSE(ParseReplayTime(text).has_value());
  }
}

}  // namespace recorded_start_test
