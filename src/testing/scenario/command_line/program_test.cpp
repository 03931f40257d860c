// The program from the user's view: exit status, output, files.

#include "program_run.h"

#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <sys/stat.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>
#include <stop_token>
#include <thread>

namespace program_test {

using namespace argos;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

const std::string kBadControllers =
    InBuildTree("testing/plugins/libargos3_test_bad_controllers.so");

// three e-pucks at random places that do not move, for one second
std::string Experiment(const std::string& controller = "test_idle",
                       const std::string& rest = "<visualization/>") {
  return "<argos-configuration>\n"
         "<framework><experiment ticks_per_second=\"10\" length=\"1\" "
         "random_seed=\"1\"/></framework>\n"
         "<controllers><" +
         controller + " id=\"c\" library=\"" + kBadControllers +
         "\"><actuators>"
         "<differential_steering implementation=\"default\"/></actuators><sensors/><params/></" +
         controller +
         "></controllers>\n"
         "<physics_engines><dynamics2d id=\"d\"/></physics_engines>\n<media/>\n"
         "<arena size=\"4,4,1\"><distribute><position method=\"uniform\" min=\"-1,-1,0\" "
         "max=\"1,1,0\"/><orientation method=\"uniform\" min=\"0,0,0\" max=\"360,0,0\"/>"
         "<entity quantity=\"3\" max_trials=\"100\"><e-puck id=\"ep\"><controller config=\"c\"/>"
         "</e-puck></entity></distribute></arena>\n" +
         rest + "\n</argos-configuration>\n";
}

std::string DigestIn(const std::string& text) {
  std::smatch match;
  return std::regex_search(text, match, std::regex("digest: ([0-9a-f]{16})\n")) ? match[1].str()
                                                                                : "";
}

// keeps every core busy during its lifetime
class CLoad {
 public:
  CLoad() {
    for (unsigned int i = 0; i < 2 * std::thread::hardware_concurrency(); ++i) {
      m_threads.emplace_back([](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
        }
      });
    }
  }

 private:
  std::vector<std::jthread> m_threads;
};

// short runs with threads on a busy machine: first valid ones, then ones whose robots throw
void CheckStatusOfShortRuns(unsigned runs) {
  const CTestFolder folder;
  folder.Write("good.argos", Experiment());
  folder.Write("bad.argos", Experiment("test_throws_in_step"));
  const CLoad load;
  for (unsigned run = 0; run < runs; ++run) {
    const std::string threads = std::to_string(2 + run % 7);
    CAPTURE(run, threads);
    REQUIRE(folder.Run({"-c", "good.argos", "--length", "0.1", "--threads", threads}).Status == 0);
    REQUIRE(folder.Run({"-c", "bad.argos", "--threads", threads}).Status == 1);
  }
}

}  // namespace

TEST_CASE("argos3: short runs with threads end with their status on a busy machine",
          "[command_line][threads]") {
  CheckStatusOfShortRuns(FewerIfSanitized(25));
}

TEST_CASE("argos3: 2,000 short runs with threads end with their status on a busy machine",
          "[.][soak][command_line][threads]") {
  CheckStatusOfShortRuns(1000);
}

TEST_CASE("argos3: a run ends with a summary and status 0", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const SProgramRun run = folder.Run({"-c", "e.argos"});
  CHECK(run.Status == 0);
  CHECK(run.Err == "");
  CHECK(std::regex_search(run.Notices,
                          std::regex("\\[INFO\\] simulated 1 s in [0-9.e+-]+ s of wall time "
                                     "\\(real-time factor [0-9.e+-]+, 10 ticks, 3 robots\\)\n")));
  CHECK_THAT(run.Out, Contains("[INFO] Using random seed = 1\n") &&
                          Contains("[INFO] Total experiment length in clock ticks = 10\n"));
}

TEST_CASE("argos3: the end of a run names robots that have left the arena", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  CHECK_THAT(folder.Run({"-c", "e.argos"}).Notices, !Contains("outside of the arena"));
  const SProgramRun run = folder.Run({"-c", "e.argos", "--set", "arena/@size=0.1,0.1,1"});
  CHECK_THAT(run.Notices, Contains("ended outside of the arena, among them \""));
}

TEST_CASE("argos3: without a terminal the output has no colours and no progress line",
          "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const SProgramRun run = folder.Run({"-c", "e.argos", "--length", "5000"});
  CHECK(run.Status == 0);
  CHECK_THAT(run.Out, !Contains("\x1b"));
  CHECK(run.Err == "");
}

TEST_CASE("argos3: the digest repeats and differs between seeds", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const std::string digest = DigestIn(folder.Run({"-c", "e.argos", "--digest"}).Out);
  REQUIRE(digest.size() == 16);
  CHECK(DigestIn(folder.Run({"-zc", "e.argos", "--digest"}).Out) == digest);
  CHECK(DigestIn(folder.Run({"-c", "e.argos", "--digest", "--threads", "2"}).Out) == digest);
  CHECK(DigestIn(folder.Run({"-c", "e.argos", "--digest", "--seed", "1"}).Out) == digest);
  CHECK(DigestIn(folder.Run({"-c", "e.argos", "--digest", "--seed", "2"}).Out) != digest);
  CHECK(DigestIn(folder.Run({"-c", "e.argos"}).Out).empty());
}

TEST_CASE("argos3: --length, --threads, --seed and --set change the run", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const SProgramRun run =
      folder.Run({"-c", "e.argos", "--length", "2", "--threads", "2", "--seed", "77", "--set",
                  "arena/distribute/entity/@quantity=5", "--set", "//e-puck/@id=robot"});
  CHECK(run.Status == 0);
  CHECK_THAT(run.Notices, Contains("simulated 2 s") && Contains("5 robots"));
  CHECK_THAT(run.Out, Contains("Using random seed = 77") && Contains("Using 2 threads"));
  // 0 draws one from the clock, which is not that of the file
  const std::string drawn = folder.Run({"-zc", "e.argos", "--seed", "0"}).Out;
  CHECK_THAT(drawn, Contains("Using random seed = ") && !Contains("seed = 0\n") &&
                        !Contains("seed = 1\n"));
}

TEST_CASE("argos3: --lenient accepts malformed numbers with warnings", "[command_line]") {
  const CTestFolder folder;
  std::string xml = Experiment();
  xml.replace(xml.find("quantity=\"3\""), 12, "quantity=\"3x\"");
  folder.Write("e.argos", xml);
  const SProgramRun strict = folder.Run({"-c", "e.argos"});
  CHECK(strict.Status == 1);
  CHECK_THAT(strict.Err, Contains("e.argos:6") && Contains("found \"3x\""));
  const SProgramRun lenient = folder.Run({"-c", "e.argos", "--lenient"});
  CHECK(lenient.Status == 0);
  CHECK_THAT(lenient.Err, Contains("[WARNING] e.argos:6") && Contains("found \"3x\""));
}

TEST_CASE("argos3: --set without a match is an error", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const SProgramRun run = folder.Run({"-c", "e.argos", "--set", "framwork/experiment/@length=5"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("framwork") && Contains("framework"));
}

TEST_CASE("argos3: logs can be written to files", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment("test_idle", "<nobody_reads_me/>"));
  folder.Write("log.txt", "old content");
  const SProgramRun run =
      folder.Run({"-c", "e.argos", "-l", "log.txt", "-e", "err.txt", "--digest"});
  CHECK(run.Status == 0);
  CHECK(run.Out == "");
  CHECK(run.Err == "");
  CHECK_THAT(folder.Read("log.txt"), Contains("simulated 1 s") && Contains("digest: ") &&
                                         !Contains("old content") && !Contains("\x1b"));
  CHECK_THAT(folder.Read("err.txt"), Contains("[WARNING]") && Contains("nobody_reads_me"));
}

TEST_CASE("argos3: a log file that cannot be written is an error before the run",
          "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const std::string option = GENERATE(as<std::string>{}, "-l", "-e");
  CAPTURE(option);
  const SProgramRun run = folder.Run({"-c", "e.argos", option, "no/such/folder/log.txt"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("no/such/folder/log.txt"));
  CHECK_THAT(run.Out, !Contains("simulated"));
}

TEST_CASE("argos3: a full disk for the log is an error", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const SProgramRun run = folder.Run({"-c", "e.argos", "-l", "/dev/full"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("log could not be written"));
}

TEST_CASE("argos3: help, version and queries end with status 0", "[command_line]") {
  const CTestFolder folder;
  const SProgramRun help = folder.Run({"-h"});
  CHECK(help.Status == 0);
  CHECK_THAT(help.Out, Contains("Usage: argos3"));
  const SProgramRun version = folder.Run({"-v"});
  CHECK(version.Status == 0);
  CHECK_THAT(version.Out, Contains("ARGOS_VERSION="));
  const SProgramRun entities = folder.Run({"-q", "entities"});
  CHECK(entities.Status == 0);
  CHECK_THAT(entities.Out, Contains("AVAILABLE ENTITIES\n\n") && Contains("   [ box ]\n      ") &&
                               Contains("   [ e-puck ]\n      ") && Contains("   [ foot-bot ]\n"));
  const SProgramRun device = folder.Run({"-q", "footbot_proximity"});
  CHECK_THAT(device.Out, Contains("[ footbot_proximity (default) ]\n"));
}

TEST_CASE("argos3: an invalid command line is an error with status 1", "[command_line]") {
  const CTestFolder folder;
  const SProgramRun run = folder.Run({"--configfile", "e.argos"});
  CHECK(run.Status == 1);
  CHECK(run.Out == "");
  CHECK_THAT(run.Err, Contains("[FATAL]") && Contains("--config-file"));
}

TEST_CASE("argos3: a missing file, a folder, and text that is not XML are errors",
          "[command_line][bad_input]") {
  const CTestFolder folder;
  const SProgramRun missing = folder.Run({"-c", "nothing.argos"});
  CHECK(missing.Status == 1);
  CHECK_THAT(missing.Err, Contains("[FATAL]") && Contains("nothing.argos"));
  const SProgramRun directory = folder.Run({"-c", "."});
  CHECK(directory.Status == 1);
  CHECK_THAT(directory.Err, Contains("directory"));
  folder.Write("broken.argos", "<argos-configuration>\n<framework>\n</argos-configuration>\n");
  const SProgramRun broken = folder.Run({"-c", "broken.argos"});
  CHECK(broken.Status == 1);
  CHECK_THAT(broken.Err, Contains("broken.argos:"));
}

TEST_CASE("argos3: a controller that throws ends the run with status 1",
          "[command_line][bad_input]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment("test_throws_in_step"));
  const SProgramRun run = folder.Run({"-c", "e.argos"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("\"ep0\"") && Contains("tired after two steps"));
  CHECK_THAT(run.Out, !Contains("simulated"));
  // earlier log output is not lost
  CHECK_THAT(run.Out, Contains("Using random seed = 1"));
}

TEST_CASE("argos3: a signal ends the run in order, with its own status", "[command_line]") {
  const auto [signal, status] = GENERATE(table<int, int>({{SIGINT, 130}, {SIGTERM, 143}}));
  CAPTURE(signal);
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const SProgramRun run = folder.Run({"-c", "e.argos", "--length", "0", "--digest", "--set",
                                      "framework/experiment/@real_time=true"},
                                     signal, "it runs until");
  CHECK(run.Status == status);
  CHECK_THAT(run.Notices, Contains("the experiment has no length: it runs until") &&
                              Contains("stopped by SIG") && Contains("simulated "));
  CHECK_THAT(run.Out, Contains("digest: "));
}

TEST_CASE("argos3: a file needs no -c, and --check runs nothing and writes nothing",
          "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment("test_idle",
                                     "<visualization><offscreen directory=\"frames\"/>"
                                     "</visualization><outputs><table file=\"t.csv\"/></outputs>"));
  folder.Write("t.csv", "of an earlier run");
  const SProgramRun check = folder.Run({"e.argos", "--check"});
  CHECK(check.Status == 0);
  CHECK(check.Err == "");
  CHECK_THAT(check.Out, Contains("[INFO] e.argos: no errors found; 3 robots; it was not run\n") &&
                            !Contains("simulated"));
  CHECK(folder.Read("t.csv") == "of an earlier run");
  CHECK_FALSE(std::filesystem::exists(folder.Path("frames")));
  CHECK(folder.Run({"-z", "e.argos"}).Status == 0);

  folder.Write("bad.argos", Experiment("test_idle", "<outputs><tabel file=\"t.csv\"/></outputs>"));
  const SProgramRun bad = folder.Run({"bad.argos", "--check"});
  CHECK(bad.Status == 1);
  CHECK_THAT(bad.Err, Contains("there is no output of type <tabel>; did you mean \"table\"?") &&
                          Contains("\n[FATAL] If a library of yours has it"));
}

TEST_CASE("argos3: --check looks at views and outputs, and warns of what they do not read",
          "[command_line]") {
  const CTestFolder folder;
  const auto [element, complaint] = GENERATE(table<std::string, std::string>(
      {{"<visualization><offscreen size='1x1'/></visualization>", "1 pixels are out of range"},
       {"<visualization><offscreen sizee='64x48'/></visualization>", "\"sizee\" is not used"},
       {"<visualization><povray quality='god'/></visualization>", "did you mean \"good\"?"},
       {"<outputs><table file='t.csv' fields='posee'/></outputs>", "did you mean \"pose\"?"},
       {"<outputs><metrics file='m.csv' builtin='dispersio'/></outputs>", "\"dispersion\""},
       {"<outputs><table file='t.xls'/></outputs>", "\"file\" must end in .csv"},
       {"<outputs><table file='e.argos/t.csv'/></outputs>", "\"e.argos\" is no folder"},
       {"<outputs><recording file='no/r.rec'/></outputs>", "there is no folder \"no\""},
       {"<outputs><recording file='e.argos'/></outputs>", "that is no recording"}}));
  CAPTURE(element);
  folder.Write("e.argos", Experiment("test_idle", element));
  const SProgramRun check = folder.Run({"e.argos", "--check"});
  const bool isWarning = complaint.find("not used") != std::string::npos;
  CHECK(check.Status == (isWarning ? 0 : 1));
  CHECK_THAT(check.Err, Contains(complaint));
  CHECK_THAT(folder.Run({"-z", "e.argos", "--check", "--video", "x.avi"}).Err,
             Contains("its name must end in .mp4"));
  // nothing was created
  for (const auto& entry : std::filesystem::directory_iterator(folder.Path("."))) {
    const std::string name = entry.path().filename().string();
    CHECK((name == "e.argos" || name == "stdout.txt" || name == "stderr.txt"));
  }
}

TEST_CASE("argos3: --check keeps the files that users' code would change", "[command_line]") {
  const CTestFolder folder;
  folder.Write("loop.lua", R"(
function init()
  f = assert(io.open("results.csv", "w"))
  f:write("of the check\n")
  f:close()
  -- the code sees what it has written
  f = assert(io.open("results.csv"))
  assert(f:read("a") == "of the check\n")
  f:close()
  f = assert(io.open("log.txt", "a"))
  f:write("more\n")
  f:close()
  assert(os.remove("old.txt"))
  assert(io.open("old.txt") == nil)
  assert(os.rename("name.txt", "other.txt"))
  assert(assert(io.open("other.txt")):read("a") == "of a run")
  assert(os.rename("folder", "moved") and not os.rename("folder", "again"))
  assert(io.open("moved/new.txt", "w")):close()
  assert(io.open("new.txt", "w")):close()
  assert(io.open("no_folder/new.txt", "w") == nil)
  -- what is not there, is removed already, or would leave its folder
  assert(io.open("none.txt", "r+") == nil)
  for _, name in ipairs({"none.txt", "old.txt"}) do assert(os.remove(name) == nil) end
  assert(not os.rename("none.txt", "x.txt") and not os.rename("log.txt", "no_folder/log.txt"))
  -- written, removed and written again
  assert(os.remove("results.csv") and not io.open("results.csv"))
  assert(io.open("results.csv", "a")):close()
  assert(assert(io.open("results.csv")):read("a") == "")
  -- no program reads it
  assert(io.open("fifo", "w")):close()
end
)");
  folder.Write("e.argos", Experiment("test_idle",
                                     "<loop_functions label='lua'><params script='loop.lua'/>"
                                     "</loop_functions>"));
  for (const char* const name : {"results.csv", "log.txt", "old.txt", "name.txt"}) {
    folder.Write(name, "of a run");
  }
  REQUIRE(mkfifo(folder.Path("fifo").c_str(), 0600) == 0);
  REQUIRE(std::filesystem::create_directory(folder.Path("folder")));
  folder.Write("folder/kept.txt", "of a run");
  const SProgramRun check = folder.Run({"e.argos", "--check"});
  CAPTURE(check.Out, check.Err);
  CHECK(check.Status == 0);
  for (const char* const name :
       {"results.csv", "log.txt", "old.txt", "name.txt", "folder/kept.txt"}) {
    CAPTURE(name);
    CHECK(folder.Read(name) == "of a run");
  }
  for (const char* const name : {"other.txt", "new.txt", "moved"}) {
    CAPTURE(name);
    CHECK_FALSE(std::filesystem::exists(folder.Path(name)));
  }
}

TEST_CASE("argos3: a controller is unused if no robot has had it at the end of the run",
          "[command_line]") {
  const CTestFolder folder;
  const bool isAdded = GENERATE(false, true);
  CAPTURE(isAdded);
  folder.Write("robot.lua",
               "function init() end function step() end function reset() end "
               "function destroy() end");
  folder.Write("loop.lua", "function pre_step() if simulation.clock() == 2 and " +
                               std::string(isAdded ? "true" : "false") +
                               " then simulation.add(\"<foot-bot id='late'><body position='1,1,0'/>"
                               "<controller config='late'/></foot-bot>\") end end");
  folder.Write("e.argos", R"(<argos-configuration>
<framework><experiment length="0.5" ticks_per_second="10" random_seed="7"/></framework>
<controllers><lua_controller id="late">
<actuators><differential_steering implementation="default"/></actuators>
<sensors/><params script="robot.lua"/></lua_controller></controllers>
<loop_functions label="lua"><params script="loop.lua"/></loop_functions>
<arena size="6,6,2"/><physics_engines><dynamics2d id="dyn"/></physics_engines><media/>
</argos-configuration>)");
  const std::string warning = "e.argos:3: <lua_controller>: no robot has the controller \"late\"";
  const SProgramRun run = folder.Run({"e.argos"});
  CHECK(run.Status == 0);
  if (isAdded) {
    CHECK_THAT(run.Err, !Contains("no robot has"));
  } else {
    CHECK_THAT(run.Err, Contains(warning));
  }
  // a value of --set is read by the robot, or by none
  const std::string setting = "//lua_controller/params/@script=robot.lua";
  CHECK(folder.Run({"e.argos", "--set", setting}).Status == (isAdded ? 0 : 1));
  // the check cannot know
  CHECK_THAT(folder.Run({"e.argos", "--check"}).Err, Contains(warning));
}

TEST_CASE("argos3: --quiet and --log-level choose the lines of the logs", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment("test_idle", "<nobody_reads_me/>"));
  const SProgramRun quiet = folder.Run({"e.argos", "--quiet", "--digest"});
  CHECK(quiet.Status == 0);
  // what was asked for is printed, and warnings are
  CHECK(std::regex_match(quiet.Out, std::regex("digest: [0-9a-f]{16}\n")));
  CHECK_THAT(quiet.Err, Contains("[WARNING]") && Contains("nobody_reads_me"));
  const SProgramRun errors = folder.Run({"e.argos", "--log-level", "error"});
  CHECK(errors.Out + errors.Err + errors.Notices == "");
  CHECK_THAT(folder.Run({"e.argos"}).Out, !Contains("Loaded library"));
  CHECK_THAT(folder.Run({"e.argos", "--log-level", "debug"}).Out,
             Contains("[DEBUG] Loaded library \"" + kBadControllers));
  CHECK_THAT(folder.Run({"none.argos", "--log-level", "error"}).Err, Contains("[FATAL]"));
}

TEST_CASE("argos3: a run opens only the libraries that it needs", "[command_line][plugins]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const std::string log = folder.Run({"e.argos", "--log-level", "debug"}).Out;
  CHECK_THAT(log, Contains("_epuck.so\"\n") && Contains("_dynamics2d.so\"\n"));
  for (const char* other : {"_eyebot.", "_dynamics3d.", "_offscreen.", "_povray.", "_recording."}) {
    CHECK_THAT(log, !Contains(other));
  }
  // labels of all libraries are known
  folder.Write("typo.argos",
               std::regex_replace(Experiment(), std::regex("dynamics2d"), "dynamics3dd"));
  CHECK_THAT(folder.Run({"typo.argos"}).Err, Contains("did you mean \"dynamics3d\""));
}

TEST_CASE("argos3: a log that is no terminal gets lines about the progress", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const std::vector<std::string> run = {"e.argos", "-l", "log.txt", "--set",
                                        "framework/experiment/@real_time=true"};
  std::vector<std::string> withProgress = run;
  withProgress.insert(withProgress.end(), {"--progress", "0.3"});
  CHECK(folder.Run(withProgress).Status == 0);
  CHECK(std::regex_search(
      folder.Read("log.txt"),
      std::regex("\\[INFO\\] tick [3-9]/10 \\([0-9]+ %\\), 0:0[01] left, [0-9.]+ x real time")));
  CHECK(folder.Run(run).Status == 0);
  CHECK_THAT(folder.Read("log.txt"), !Contains("[INFO] tick "));
}

TEST_CASE("argos3: experiments of the build tree run without a path to their libraries",
          "[command_line]") {
  const CTestFolder folder;
  const SProgramRun run =
      folder.Run({InSourceTree("experiments/diffusion_10.argos"), "-z", "--length", "1"});
  CAPTURE(run.Err);
  CHECK(run.Status == 0);
}

TEST_CASE("argos3: of libraries of several builds the nearest one is loaded, with a warning",
          "[command_line]") {
  const CTestFolder folder;
  std::string xml = Experiment();
  const auto copyTo = [&](const std::string& path) {
    const fs::path file = fs::path(folder.Path(".")) / path;
    fs::create_directories(file.parent_path());
    fs::copy_file(kBadControllers, file);
    return fs::canonical(file).string();
  };
  const std::string working = copyTo("build/libtwo.so");
  const std::string beside = copyTo("project/build/libtwo.so");
  xml.replace(xml.find(kBadControllers), kBadControllers.size(), "build/libtwo");
  fs::create_directories(folder.Path("project/experiments"));
  folder.Write("project/experiments/e.argos", xml);
  const std::string warning = "[WARNING] There are several libraries \"build/libtwo\": \"";
  const std::vector<std::string> run = {"project/experiments/e.argos"};
  // the working directory has one, too
  CHECK_THAT(folder.Run(run).Err,
             Contains(warning + working + "\" is loaded, not \"" + beside + '"'));
  // the variable is an explicit choice
  setenv("ARGOS_PLUGIN_PATH", folder.Path("project").c_str(), 1);
  CHECK_THAT(folder.Run(run).Err,
             Contains(warning + beside + "\" is loaded, not \"" + working + '"'));
  unsetenv("ARGOS_PLUGIN_PATH");
  // there is one only
  fs::remove(working);
  const SProgramRun one = folder.Run(run);
  CHECK(one.Status == 0);
  CHECK_THAT(one.Err, !Contains("several libraries"));
}

TEST_CASE("argos3: users' libraries in the plug-in path are loaded after those that they need",
          "[command_line]") {
  const CTestFolder folder;
  fs::create_symlink(InBuildTree("testing/plugins/libargos3_test_good.so"),
                     fs::path(folder.Path(".")) / "libargos3_test_good.so");
  setenv("ARGOS_PLUGIN_PATH", folder.Path(".").c_str(), 1);
  folder.Write("e.argos", Experiment());
  const SProgramRun run = folder.Run({"e.argos", "--log-level", "debug"});
  unsetenv("ARGOS_PLUGIN_PATH");
  CAPTURE(run.Out, run.Err);
  CHECK(run.Status == 0);
  const std::string log = run.Out + run.Err;
  // which it links; others of this project are opened when they are needed
  const size_t own = log.find("libargos3plugin_simulator_footbot");
  const size_t users = log.find("libargos3_test_good");
  REQUIRE(own != std::string::npos);
  REQUIRE(users != std::string::npos);
  CHECK(own < users);
}

TEST_CASE("argos3: an element with 200,000 attributes takes linear time", "[command_line]") {
  const int attributes = static_cast<int>(FewerIfSanitized(200000));
  std::string params = "<params";
  for (int i = 0; i < attributes; ++i) {
    params += " attribute_" + std::to_string(i) + "=\"1\"";
  }
  std::string xml = Experiment();
  xml.replace(xml.find("<params"), 7, params);
  const CTestFolder folder;
  folder.Write("e.argos", xml);
  // comparing each name with all others takes minutes
  const SProgramRun run = folder.Run({"--check", "e.argos"});
  CHECK(run.Status == 0);
  CHECK_THAT(run.Err, Contains("attribute \"attribute_0\" is not used by anything"));
}

TEST_CASE("argos3: every line of an error has its level", "[command_line]") {
  const CTestFolder folder;
  std::string xml = Experiment();
  xml.replace(xml.find("library=\""), 9, "library=\"none");
  folder.Write("e.argos", xml);
  const SProgramRun run = folder.Run({"e.argos"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err,
             Contains("e.argos:3: <test_idle>: attribute \"library\"\n[FATAL] The library"));
  CHECK(std::regex_match(run.Err, std::regex("(\\[FATAL\\] [^\n]*\n)+")));
}

TEST_CASE("argos3: the completion of bash completes options, plug-ins, files and paths",
          "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  folder.Write("complete.sh",
               "source <(\"$1\" --generate bash)\n"
               "compopt() { :; }\n"
               "COMP_LINE=\"$1 $2\" COMP_POINT=1000\n"
               "_argos3\n"
               "printf '%s\\n' \"${COMPREPLY[@]}\"\n");
  const auto complete = [&](const std::string& line) {
    const std::string command = "cd '" + folder.GetPath() + "' && bash complete.sh '" +
                                InBuildTree("bin/argos3") + "' '" + line + "' >out.txt 2>&1";
    CHECK(std::system(command.c_str()) == 0);
    return folder.Read("out.txt");
  };
  CHECK(complete("--thr") == "--threads\n");
  CHECK(complete("-zc e") == "e.argos\n");
  CHECK(complete("e") == "e.argos\n");
  CHECK(complete("-q footbot_prox") == "footbot_proximity\n");
  CHECK(complete("--log-level w") == "warning\n");
  CHECK(complete("e.argos --set framework/exp") ==
        "framework/experiment/@ticks_per_second=\nframework/experiment/@length=\n"
        "framework/experiment/@random_seed=\n");
  // readline replaces only what follows '@'
  CHECK(complete("e.argos --set framework/experiment/@len") == "length=\n");
}

TEST_CASE("argos3: the attributes of a file have paths that --set takes", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const std::string paths = folder.Run({"--generate", "xpaths", "-c", "e.argos"}).Out;
  CHECK_THAT(paths, Contains("arena/distribute/entity/@quantity\n"));
  std::istringstream lines(paths);
  std::vector<std::string> arguments = {"e.argos", "--check", "--lenient"};
  for (std::string path; std::getline(lines, path);) {
    if (path.find("@quantity") != std::string::npos) {
      arguments.insert(arguments.end(), {"--set", path + "=5"});
    }
  }
  CHECK_THAT(folder.Run(arguments).Out, Contains("no errors found; 5 robots"));
}

}  // namespace program_test
