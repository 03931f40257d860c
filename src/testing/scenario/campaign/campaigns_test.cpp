// Whole campaigns by the program argos3-campaign.

#include "campaign_run.h"
#include "campaign_world.h"

#include <argos3/campaign/store/result_store.h>
#include <argos3/core/config.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>

namespace campaigns_test {

using namespace argos;
using Catch::Contains;
using Catch::StartsWith;

namespace {

/* Ten foot-bots among obstacles, two lengths of runs, two speeds. */
std::string MakeDiffusionCampaign(const std::string& attributes) {
  return "<argos-campaign experiment='" + InSourceTree("experiments/diffusion_10.argos") +
         "' results='results.sqlite'>\n"
         "  <factors>\n"
         "    <factor name='length' path='//experiment/@length' values='0.5, 1' />\n"
         "    <factor name='speed' path='//params/@velocity' values='5, 10' />\n"
         "  </factors>\n"
         "  <runs seeds='6' />\n"
         "  <execution " +
         attributes + " />\n</argos-campaign>\n";
}

/* Two robots, the second of which misbehaves in the run with seed 2. */
std::string MakeMisbehavingCampaign(const std::string& attributes = "") {
  return "<argos-campaign experiment='experiment.argos' results='results.sqlite'>\n"
         "  <factors>\n"
         "    <factor name='deed' path='//controllers/*/params/@what'\n"
         "            values='crash, hang, eat, print, exit, throw, none' />\n"
         "  </factors>\n"
         "  <runs seeds='3' />\n"
         "  <limits wall='10' memory='512 MiB' output='1 MiB' />\n"
         "  <execution " +
         attributes + " />\n</argos-campaign>\n";
}

// experiments/ has the library of the controller
void SetPluginPath() {
  setenv("ARGOS_PLUGIN_PATH",
         (InBuildTree("lib/argos3") + ":" + InBuildTree("experiments")).c_str(), 1);
}

}  // namespace

TEST_CASE("campaign: the table does not depend on jobs and isolation", "[campaign][program]") {
  SetPluginPath();
  std::vector<std::string> expected;
  for (const char* isolation : {"process", "thread"}) {
    for (const unsigned jobs : MostIfSanitized({1, 2, 5})) {
      CAPTURE(isolation, jobs);
      const CTestFolder folder;
      folder.Write("c.xml", MakeDiffusionCampaign(std::string("isolation='") + isolation + "'"));
      const SProgramRun run =
          folder.RunProgram("argos3-campaign", {"run", "c.xml", "-j", std::to_string(jobs)});
      INFO(run.Out << run.Err);
      REQUIRE(run.Status == 0);
      CHECK_THAT(run.Err, Contains("24/24 runs (100 %), 4/4 combinations complete"));
      const std::vector<std::string> table = ReadTable(folder.Path("results.sqlite"));
      REQUIRE(table.size() == 24);
      if (expected.empty()) {
        expected = table;
        // of two seeds, the states differ
        CHECK(table[0].substr(table[0].find(' ')) != table[1].substr(table[1].find(' ')));
      }
      CHECK(table == expected);
      CHECK_FALSE(std::filesystem::exists(folder.Path("results.runs")));
    }
  }
}

TEST_CASE("campaign: runs that can be watched have the same results", "[campaign][program]") {
  SetPluginPath();
  if (!std::filesystem::exists(InBuildTree("lib/argos3/on_demand/libargos3_live.so"))) {
    WARN("skipped: there is no live view");
    return;
  }
  const std::string isolation = GENERATE("process", "thread");
  CAPTURE(isolation);
  std::vector<std::string> expected;
  for (const bool isWatched : {false, true}) {
    const CTestFolder folder;
    setenv("XDG_RUNTIME_DIR", folder.Path(".").c_str(), 1);
    folder.Write("c.xml", MakeDiffusionCampaign("isolation='" + isolation + "'"));
    std::vector<std::string> arguments = {"run", "c.xml", "-j", "2"};
    if (isWatched) {
      arguments.push_back("--live-socket");
    }
    const SProgramRun run = folder.RunProgram("argos3-campaign", arguments);
    INFO(run.Out << run.Err);
    REQUIRE(run.Status == 0);
    const std::vector<std::string> table = ReadTable(folder.Path("results.sqlite"));
    expected = isWatched ? expected : table;
    CHECK(table == expected);
    CHECK_THAT(folder.RunProgram("argos3-campaign", {"live"}).Out,
               StartsWith("no run on this computer"));
    const SProgramRun opened = folder.RunProgram("argos3-campaign", {"live", "--open", "1"});
    CHECK(opened.Status == 1);
    CHECK_THAT(opened.Err, Contains("there is no run 1"));
  }
  unsetenv("XDG_RUNTIME_DIR");
}

TEST_CASE("campaign: runs that crash, hang, eat memory or print without end are named",
          "[campaign][program]") {
  if (!kCanLimitMemory) {
    WARN("skipped: a sanitizer leaves no room for a limit of memory");
    return;
  }
  const std::string isolation = GENERATE("isolation='process'", "isolation='thread'");
  CAPTURE(isolation);
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment("none", 2));
  folder.Write("c.xml", MakeMisbehavingCampaign(isolation));
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"run", "c.xml", "-j", "2"});
  INFO(run.Out << run.Err);
  CHECK(run.Status == 3);
  CHECK_THAT(run.Out, Contains("5 runs failed:") && Contains("deed=crash, seed=2: crashed") &&
                          Contains("robot \"fb1\", controller \"c\": ControlStep() in tick 3") &&
                          Contains("deed=hang, seed=2: timeout") &&
                          Contains("deed=eat, seed=2: out_of_memory") &&
                          Contains("deed=exit, seed=2: failed") &&
                          Contains("deed=throw, seed=2: failed") &&
                          Contains("--seed 2 --set '//controllers/*/params/@what=crash'"));
  const std::vector<std::string> table = ReadTable(folder.Path("results.sqlite"));
  CHECK(table.size() == 21);
  const auto done = std::count_if(table.begin(), table.end(), [](const std::string& line) {
    return line.find(" done ") != std::string::npos;
  });
  CHECK(done == 16);

  const SProgramRun status = folder.RunProgram("argos3-campaign", {"status", "c.xml"});
  CHECK(status.Status == 3);
  CHECK_THAT(status.Out, Contains("21 runs stored, 0 to be executed; 7 of 7") &&
                             Contains("crashed: 1") && Contains("done: 16"));

  SECTION("retry repeats those that are asked for") {
    const SProgramRun retry =
        folder.RunProgram("argos3-campaign", {"retry", "c.xml", "--status", "crashed,failed"});
    CHECK(retry.Status == 3);
    CHECK_THAT(retry.Out, Contains("3 runs are repeated"));
    CHECK(ReadTable(folder.Path("results.sqlite")) == table);
    const CResultStore store(folder.Path("results.sqlite"), CResultStore::EMode::ReadOnly);
    const std::vector<SStoredRun> runs = store.ListRuns();
    CHECK(std::count_if(runs.begin(), runs.end(),
                        [](const SStoredRun& stored) { return stored.Attempt == 2; }) == 3);
  }
  SECTION("the command that is printed repeats the failure") {
    const std::string command = "argos3 -zc ";
    const size_t start = run.Out.find(command, run.Out.find("deed=crash"));
    REQUIRE(start != std::string::npos);
    const std::string line = run.Out.substr(start, run.Out.find('\n', start) - start);
    const int end = std::system(
        ("cd " + folder.Path(".") + " && " + InBuildTree("bin/") + line + " >/dev/null 2>&1")
            .c_str());
    CHECK(WEXITSTATUS(end) == 128 + SIGSEGV);
  }
}

TEST_CASE("campaign: retry repeats the runs for which a condition of factors and metrics holds",
          "[campaign][program]") {
  SetPluginPath();
  const CTestFolder folder;
  std::string campaign = MakeDiffusionCampaign("jobs='2'");
  campaign.insert(campaign.find("  <execution"),
                  "<collect><builtin name='dispersion' /></collect>\n");
  folder.Write("c.xml", campaign);
  REQUIRE(folder.RunProgram("argos3-campaign", {"run", "c.xml"}).Status == 0);
  const auto retry = [&folder](const std::string& where) {
    return folder.RunProgram("argos3-campaign", {"retry", "c.xml", "--where", where});
  };
  const auto countSecond = [&folder] {
    const CResultStore store(folder.Path("results.sqlite"), CResultStore::EMode::ReadOnly);
    const std::vector<SStoredRun> runs = store.ListRuns();
    return std::count_if(runs.begin(), runs.end(),
                         [](const SStoredRun& run) { return run.Attempt == 2; });
  };
  const std::vector<std::string> table = ReadTable(folder.Path("results.sqlite"));
  CHECK_THAT(retry("dispersion > 1000").Out,
             Contains("for which \"dispersion > 1000\" is true: nothing is repeated"));
  CHECK(countSecond() == 0);
  CHECK_THAT(retry("speed == 10 and seed <= 2 and dispersion > 0").Out,
             Contains("4 runs are repeated"));
  CHECK(countSecond() == 4);
  CHECK(ReadTable(folder.Path("results.sqlite")) == table);

  const SProgramRun unknown = retry("dispersal > 1");
  CHECK(unknown.Status == 1);
  CHECK_THAT(unknown.Err, Contains("did you mean \"dispersion\"?"));
  const SProgramRun noCondition = retry("dispersion");
  CHECK(noCondition.Status == 1);
  CHECK_THAT(noCondition.Err, Contains("expected a condition"));
}

TEST_CASE("campaign: retry says that there is nothing to repeat", "[campaign][program]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment("throw", 2));
  folder.Write("c.xml",
               "<argos-campaign experiment='experiment.argos' results='results.sqlite'>\n"
               "  <runs seeds='2' />\n</argos-campaign>\n");
  REQUIRE(folder.RunProgram("argos3-campaign", {"run", "c.xml"}).Status == 3);
  const SProgramRun retry =
      folder.RunProgram("argos3-campaign", {"retry", "c.xml", "--status", "crashed,timeout"});
  // the one that has failed remains
  CHECK(retry.Status == 3);
  CHECK_THAT(retry.Out,
             Contains("no stored run has the status crashed, timeout: nothing is repeated\n"));
  CHECK(retry.Err == "");
}

TEST_CASE("campaign: a worker that dies is replaced, and its run is named", "[campaign][program]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment("kill_parent", 2));
  folder.Write("c.xml",
               "<argos-campaign experiment='experiment.argos' results='results.sqlite'>\n"
               "  <runs seeds='6' />\n</argos-campaign>\n");
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"run", "c.xml", "-j", "2"});
  INFO(run.Out << run.Err);
  CHECK(run.Status == 3);
  CHECK_THAT(run.Err, Contains("a worker process has died: signal 9"));
  CHECK_THAT(run.Out, Contains("1 run failed:") && Contains("seed=2: crashed") &&
                          Contains("2 worker processes died while they executed this run"));
  CHECK(ReadTable(folder.Path("results.sqlite")).size() == 6);
}

TEST_CASE("campaign: the file says how many runs are executed at the same time",
          "[campaign][program]") {
  // patience, s: with one job the first run waits in vain
  const auto [attributes, options, patience, met] =
      GENERATE(table<std::string, std::vector<std::string>, std::string, std::string>({
          {"jobs='1'", {}, "0.5", "met=0x0p+0"},
          {"jobs='2'", {}, "30", "met=0x1p+0"},
          {"jobs='1'", {"--jobs", "2"}, "30", "met=0x1p+0"},
          {"jobs='2'", {"--jobs", "1"}, "0.5", "met=0x0p+0"},
      }));
  CAPTURE(attributes, options);
  const CTestFolder folder;
  std::string experiment = MakeCampaignExperiment();
  const std::string gain = "gain=\"1\"";
  experiment.replace(experiment.find(gain), gain.size(),
                     gain + " meet=\"" + folder.Path("") + "\" patience=\"" + patience + '"');
  folder.Write("experiment.argos", experiment);
  folder.Write("c.xml",
               "<argos-campaign experiment='experiment.argos' results='results.sqlite'>\n"
               "  <runs seeds='2' />\n  <execution " +
                   attributes + " />\n</argos-campaign>\n");
  std::vector<std::string> arguments = {"run", "c.xml"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const SProgramRun run = folder.RunProgram("argos3-campaign", arguments);
  INFO(run.Out << run.Err);
  REQUIRE(run.Status == 0);
  const std::vector<std::string> table = ReadTable(folder.Path("results.sqlite"));
  REQUIRE(table.size() == 2);
  CHECK_THAT(table[0], Contains(met));
  CHECK_THAT(table[1], Contains(met));
}

TEST_CASE("campaign: a dry run lists combinations and changes nothing", "[campaign][program]") {
  SetPluginPath();
  const CTestFolder folder;
  folder.Write("c.xml", MakeDiffusionCampaign(""));
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"run", "c.xml", "--dry-run"});
  CHECK(run.Status == 0);
  CHECK(run.Out ==
        "1: length=0.5 speed=5\n2: length=0.5 speed=10\n3: length=1 speed=5\n"
        "4: length=1 speed=10\n4 combinations, 0 excluded\n"
        "6 seeds: 24 runs, 24 of them to be executed\n");
  CHECK_FALSE(std::filesystem::exists(folder.Path("results.sqlite")));
  std::string sequential = MakeDiffusionCampaign("");
  const std::string seeds = "seeds='6'";
  sequential.replace(sequential.find(seeds), seeds.size(),
                     "until='dispersion' relative='0.1' min='3' max='9'");
  folder.Write("c.xml", sequential);
  CHECK_THAT(folder.RunProgram("argos3-campaign", {"run", "c.xml", "--dry-run"}).Out,
             Contains("\n4 combinations, 0 excluded\n3 to 9 runs of each, until the mean of "
                      "dispersion is known: at least 12 runs, 12 of them to be executed\n"));
}

TEST_CASE("campaign: seeds can be added later, and are not repeated", "[campaign][program]") {
  SetPluginPath();
  const CTestFolder folder;
  folder.Write("c.xml", MakeDiffusionCampaign(""));
  REQUIRE(folder.RunProgram("argos3-campaign", {"run", "c.xml", "--seeds", "1:2"}).Status == 0);
  CHECK(ReadTable(folder.Path("results.sqlite")).size() == 8);
  const SProgramRun dry = folder.RunProgram("argos3-campaign", {"run", "c.xml", "--dry-run"});
  CHECK_THAT(dry.Out, Contains("24 runs, 16 of them to be executed"));
  const SProgramRun rest = folder.RunProgram("argos3-campaign", {"resume", "c.xml"});
  INFO(rest.Err);
  CHECK(rest.Status == 0);
  CHECK(ReadTable(folder.Path("results.sqlite")).size() == 24);
  const SProgramRun tables =
      folder.RunProgram("argos3-campaign", {"export", "c.xml", "--csv", "tables"});
  CHECK(tables.Status == 0);
  CHECK_THAT(folder.Read("tables/runs.csv"), Contains("seed"));
}

TEST_CASE("campaign: a stopping rule gives the same runs for any number of jobs",
          "[campaign][program]") {
  std::vector<std::string> expected;
  for (const char* jobs : {"1", "2", "4"}) {
    CAPTURE(jobs);
    const CTestFolder folder;
    folder.Write("experiment.argos", MakeCampaignExperiment());
    folder.Write("c.xml",
                 "<argos-campaign experiment='experiment.argos' results='results.sqlite'>\n"
                 "  <runs until='level' width='1' min='5' max='100' />\n</argos-campaign>\n");
    const SProgramRun run = folder.RunProgram("argos3-campaign", {"run", "c.xml", "-j", jobs});
    INFO(run.Out << run.Err);
    REQUIRE(run.Status == 0);
    const std::vector<std::string> table = ReadTable(folder.Path("results.sqlite"));
    // values have a deviation of 1: (2 x 1.96)^2 = 15
    CHECK(table.size() > 6);
    CHECK(table.size() < 40);
    expected = expected.empty() ? table : expected;
    CHECK(table == expected);
  }
}

TEST_CASE("campaign: mistakes are errors with exit status 1", "[campaign][program]") {
  const CTestFolder folder;
  const std::string campaign = MakeDiffusionCampaign("");
  folder.Write("c.xml", campaign);
  const std::string results = "results='results.sqlite'";
  folder.Write("folder.xml", std::string(campaign).replace(campaign.find(results), results.size(),
                                                           "results='nowhere/x.sqlite'"));
  const auto [arguments, text] = GENERATE(table<std::vector<std::string>, std::string>(
      {{std::vector<std::string>(), "Usage: argos3-campaign"},
       {{"rnu", "c.xml"}, "there is no command \"rnu\"; did you mean \"run\""},
       {{"c.xml"}, "a command is missing before the file, such as `argos3-campaign run c.xml`"},
       {{"run", "c.xml", "--job=3"},
        "the command run has no option \"--job\"; did you mean \"--jobs\"?"},
       {{"run", "c.xml", "d.xml"}, "not expected: d.xml"},
       {{"run", "folder.xml"}, "nowhere\": No such file or directory; create this folder"},
       {{"export", "c.xml", "--csv", "x"}, "begin the campaign with"},
       {{"report", "c.xml"}, "begin the campaign with `argos3-campaign run c.xml`"},
       {{"run"}, "FILE is required"},
       {{"run", "absent.xml"}, "absent.xml"},
       {{"resume", "c.xml"}, "begin the campaign with `argos3-campaign run c.xml`"},
       {{"status", "c.xml"}, "there is no database"},
       {{"retry", "c.xml", "--status", "crashd"}, "did you mean \"crashed\"?"},
       {{"run", "c.xml", "--seeds", "5:2"}, "5:2"},
       {{"export", "c.xml"}, "there is no database"}}));
  const SProgramRun run = folder.RunProgram("argos3-campaign", arguments);
  CAPTURE(text);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err + run.Out, Contains(text));
}

TEST_CASE("campaign: the help of a command is about that command", "[campaign][program]") {
  const CTestFolder folder;
  for (const char* command :
       {"run", "resume", "status", "retry", "export", "report", "submit", "merge"}) {
    CAPTURE(command);
    const SProgramRun run = folder.RunProgram("argos3-campaign", {command, "--help"});
    CHECK(run.Status == 0);
    CHECK_THAT(run.Out, Contains(std::string("Usage: argos3-campaign ") + command) &&
                            !Contains("Examples:"));
    CHECK_THAT(folder.RunProgram("argos3-campaign", {"--help"}).Out,
               Contains(std::string("\n  ") + command) && Contains("Examples:"));
  }
}

TEST_CASE("campaign: each program says its version", "[campaign][program]") {
  const CTestFolder folder;
  for (const char* program : {"argos3", "argos3-campaign", "argos3-plot"}) {
    CAPTURE(program);
    const SProgramRun run = folder.RunProgram(program, {"--version"});
    CHECK(run.Status == 0);
    CHECK(run.Err.empty());
    CHECK_THAT(run.Out, StartsWith("ARGOS_VERSION=" ARGOS_VERSION "-") && !Contains("\n\n"));
  }
}

TEST_CASE("campaign: results cannot be written where there is no right to", "[campaign][program]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment());
  folder.Write("c.xml",
               "<argos-campaign experiment='experiment.argos' results='results.sqlite'>\n"
               "  <runs seeds='1' />\n</argos-campaign>\n");
  REQUIRE(folder.RunProgram("argos3-campaign", {"run", "c.xml"}).Status == 0);
  // below a file no folder can be made, even by root
  folder.Write("file", "");
  const auto [arguments, text] = GENERATE(table<std::vector<std::string>, std::string>(
      {{{"export", "c.xml", "--csv", "file/x"}, "file/x\" cannot be created: Not a directory"},
       {{"export", "c.xml", "--json", "file/x"}, "file/x"},
       {{"export", "c.xml"}, "nothing to export: give --csv FOLDER, --json FILE, or both"},
       {{"report", "c.xml", "-o", "file/x"}, "file/x"},
       {{"report", "c.xml", "--plot", "boxplot"}, "--plot needs -o FILE.svg"},
       {{"report", "c.xml", "--y", "level"}, "give --plot KIND, too"}}));
  const SProgramRun run = folder.RunProgram("argos3-campaign", arguments);
  CAPTURE(text);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains(text));
}

TEST_CASE("campaign: a library that crashes while it is loaded ends the campaign",
          "[campaign][program]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment());
  folder.Write("c.xml",
               "<argos-campaign experiment='experiment.argos' results='results.sqlite'>\n"
               "  <runs seeds='2' />\n</argos-campaign>\n");
  folder.Write("broken.so", "no library");
  setenv("ARGOS_PLUGIN_PATH", folder.Path(".").c_str(), 1);
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"run", "c.xml"});
  unsetenv("ARGOS_PLUGIN_PATH");
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("a worker cannot execute runs") && Contains("broken.so"));
}

TEST_CASE("campaign: built-in metrics of plug-ins", "[campaign][program]") {
  SetPluginPath();
  const CTestFolder folder;
  const auto write = [&folder](const std::string& library) {
    folder.Write("c.xml", "<argos-campaign experiment='" +
                              InSourceTree("experiments/diffusion_10.argos") +
                              "' results='results.sqlite'>\n"
                              "  <set path='//experiment/@length' value='0.5' />\n"
                              "  <runs seeds='2' />\n"
                              "  <collect><builtin name='test_tick' of='mean' library='" +
                              library + "' /></collect>\n</argos-campaign>\n");
  };
  write("libnowhere.so");
  const SProgramRun missing = folder.RunProgram("argos3-campaign", {"run", "c.xml"});
  CHECK(missing.Status != 0);
  CHECK_THAT(missing.Err, Contains("libnowhere.so"));
  write(InBuildTree("testing/plugins/libargos3_test_campaign.so"));
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"run", "c.xml"});
  INFO(run.Out << run.Err);
  REQUIRE(run.Status == 0);
  REQUIRE(folder.RunProgram("argos3-campaign", {"export", "c.xml", "--csv", "csv"}).Status == 0);
  // ticks 1 to 5
  CHECK_THAT(folder.Read("csv/runs.csv"), Contains("test_tick") && Contains(",3\n"));
}

}  // namespace campaigns_test
