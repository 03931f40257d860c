// What goes wrong in campaigns: runs, disks, results, names.

#include "campaign_run.h"
#include "campaign_world.h"

#include <argos3/campaign/store/result_store.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <csignal>

namespace campaign_faults_test {

using namespace argos;
using Catch::Contains;

namespace {

std::string MakeCampaignText(const std::string& contents) {
  return "<argos-campaign experiment='experiment.argos' results='results.sqlite'>\n" + contents +
         "\n</argos-campaign>\n";
}

// writes the files of a campaign, with an experiment that succeeds, and runs it
SProgramRun RunCampaign(const CTestFolder& folder, const std::string& contents) {
  folder.Write("experiment.argos", MakeCampaignExperiment());
  folder.Write("c.xml", MakeCampaignText(contents));
  return folder.RunProgram("argos3-campaign", {"run", "c.xml"});
}

}  // namespace

TEST_CASE("campaign: crashes in 3 % of runs, a hang and a lack of memory leave a complete campaign",
          "[campaign][program]") {
  if (!kCanLimitMemory) {
    WARN("skipped: a sanitizer leaves no room for a limit of memory");
    return;
  }
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment());
  folder.Write("c.xml", R"(<argos-campaign experiment='experiment.argos'>
  <factors>
    <factor name='deed' path='//params/@what' values='crash, hang, eat'>
      <set path='//params/@period' value='{deed == "crash" and 33 or 0}' />
    </factor>
  </factors>
  <set path='//params/@seed' value='33' />
  <runs seeds='100' />
  <limits wall='10' memory='512 MiB' />
</argos-campaign>)");
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"run", "c.xml", "-j", "2"});
  INFO(run.Out << run.Err);
  CHECK(run.Status == 3);
  CHECK_THAT(run.Out, Contains("5 runs failed:"));
  CHECK_THAT(run.Err,
             Contains("[WARNING] a run has failed: deed=") && Contains("the others go on"));
  const std::vector<std::string> table = ReadTable(folder.Path("c.sqlite"));
  CHECK(table.size() == 300);
  CHECK(std::count_if(table.begin(), table.end(), [](const std::string& line) {
          return line.find(" done ") != std::string::npos;
        }) == 295);

  CHECK(folder.RunProgram("argos3-campaign", {"report", "c.xml"}).Status == 0);
  const std::string page = folder.Read("c.report/report.html");
  struct SFailure {
    std::string Deed, Seed, Status, End;
  };
  const std::vector<SFailure> failures = {
      {"crash", "33", "crashed, signal 11", "ControlStep() in tick 3"},
      {"crash", "66", "crashed, signal 11", "ControlStep() in tick 3"},
      {"crash", "99", "crashed, signal 11", "ControlStep() in tick 3"},
      {"hang", "33", "timeout, signal 9", "the run has reached its limit of wall time"},
      {"eat", "33", "out_of_memory", "not enough memory"}};
  for (const SFailure& failure : failures) {
    CAPTURE(failure.Deed, failure.Seed);
    const size_t place = page.find("deed = " + failure.Deed + ", seed " + failure.Seed +
                                   ": <span class=\"status\">" + failure.Status);
    REQUIRE(place != std::string::npos);
    const std::string section = page.substr(place, page.find("<h3>", place) - place);
    CHECK_THAT(section, Contains("<pre>argos3 -zc experiment.argos --seed " + failure.Seed) &&
                            Contains("//params/@what=" + failure.Deed) &&
                            Contains("End of the output (") && Contains("[FATAL]") &&
                            Contains(failure.End));
  }
}

TEST_CASE("campaign: two managers at once, and no run twice", "[campaign][program]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment("hang", 2));
  folder.Write("c.xml", MakeCampaignText("<runs seeds='3' />"));
  const pid_t first = StartCampaign(folder, {"run", "c.xml", "-j", "1"});
  // the second run hangs
  REQUIRE(AwaitRuns(folder.Path("results.sqlite"), 1, first));
  const std::string owner = "is being written by process " + std::to_string(first) + " on ";
  for (const char* command : {"run", "resume", "retry"}) {
    CAPTURE(command);
    const SProgramRun second = folder.RunProgram("argos3-campaign", {command, "c.xml"});
    CHECK(second.Status == 1);
    CHECK_THAT(second.Err, Contains(owner) && Contains("wait until it ends, or stop it"));
  }
  for (const char* command : {"status", "report"}) {
    CAPTURE(command);
    CHECK(folder.RunProgram("argos3-campaign", {command, "c.xml"}).Status == 0);
  }
  kill(first, SIGINT);
  kill(first, SIGTERM);
  AwaitCampaign(first);
  CHECK(ReadTable(folder.Path("results.sqlite")).size() == 1);
}

TEST_CASE("campaign: a full disk in the middle ends it, and it can be resumed",
          "[campaign][program]") {
  constexpr size_t kNum = 100;
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment());
  folder.Write(
      "c.xml",
      "<argos-campaign experiment='experiment.argos' results='results.sqlite'>\n"
      "  <runs seeds='" +
          std::to_string(kNum) +
          "' />\n"
          "  <collect><metric name='level' series='true' /></collect>\n</argos-campaign>\n");
  // the limit of the size of files stands for the disk
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit limit{230'000, old.rlim_max};
  REQUIRE(setrlimit(RLIMIT_FSIZE, &limit) == 0);
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"run", "c.xml"});
  setrlimit(RLIMIT_FSIZE, &old);
  INFO(run.Err);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err,
             Contains("results.sqlite\": writing failed (") &&
                 Contains("free some space and resume the campaign; what was stored before "
                          "is whole"));
  const size_t stored = ReadTable(folder.Path("results.sqlite")).size();
  CHECK(stored > 0);
  CHECK(stored < kNum);
  const SProgramRun rest = folder.RunProgram("argos3-campaign", {"resume", "c.xml"});
  INFO(rest.Err);
  CHECK(rest.Status == 0);
  CHECK(ReadTable(folder.Path("results.sqlite")).size() == kNum);
}

TEST_CASE("campaign: results of another campaign or program are refused, and left alone",
          "[campaign][program]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment());
  const auto writeCampaign = [&folder](const std::string& factor) {
    folder.Write("c.xml",
                 "<argos-campaign experiment='experiment.argos' results='results.sqlite'>\n"
                 "  <factors><factor name='" +
                     factor +
                     "' path='loop_functions/@gain' values='1, 2' /></factors>\n"
                     "  <runs seeds='1' />\n</argos-campaign>\n");
  };
  writeCampaign("gain");
  REQUIRE(folder.RunProgram("argos3-campaign", {"run", "c.xml"}).Status == 0);
  writeCampaign("loss");
  for (const char* command : {"run", "resume", "retry"}) {
    CAPTURE(command);
    const SProgramRun run = folder.RunProgram("argos3-campaign", {command, "c.xml"});
    CHECK(run.Status == 1);
    CHECK_THAT(run.Err, Contains("results.sqlite\" has the factors \"gain\", but \"c.xml\" has "
                                 "\"loss\": choose another name for the results"));
  }
  CHECK(ReadTable(folder.Path("results.sqlite")).size() == 2);

  folder.Write("results.sqlite", std::string(5000, 'x'));
  for (const char* command : {"run", "status", "report"}) {
    CAPTURE(command);
    const SProgramRun run = folder.RunProgram("argos3-campaign", {command, "c.xml"});
    CHECK(run.Status == 1);
    CHECK_THAT(run.Err, Contains("results.sqlite\": it is not a database"));
  }
  CHECK(folder.Read("results.sqlite") == std::string(5000, 'x'));
}

TEST_CASE("campaign: a metric that no run records is a warning", "[campaign][program]") {
  const CTestFolder folder;
  const SProgramRun run = RunCampaign(folder,
                                      "<runs until='levle' width='1' min='5' max='12' />\n"
                                      "<collect><metric name='levle' /></collect>");
  CHECK(run.Status == 0);
  CHECK_THAT(run.Err, Contains(" runs are done, and none has recorded \"levle\": "));
  const SProgramRun report = folder.RunProgram("argos3-campaign", {"report", "c.xml"});
  CHECK(report.Status == 0);
  CHECK_THAT(folder.Read("c.report/report.html"), Contains("<td>0</td><td>12</td><td>-</td>"));
}

TEST_CASE("campaign: a constant attribute that nothing reads is a warning", "[campaign][program]") {
  const CTestFolder folder;
  const SProgramRun run =
      RunCampaign(folder, "<set path='//experiment/@lenght' value='2' />\n<runs seeds='3' />");
  CHECK(run.Status == 0);
  const size_t place =
      run.Err.find("<experiment>: attribute \"lenght\" is not used by anything; did");
  CHECK(place != std::string::npos);
  // once, not of each run
  CHECK(run.Err.find("lenght", place + 30) == std::string::npos);
}

namespace {

void Insert(std::string& text, const std::string& before, const std::string& inserted) {
  const size_t place = text.find(before);
  REQUIRE(place != std::string::npos);
  text.insert(place, inserted);
}

}  // namespace

TEST_CASE("campaign: a dry run loads the experiment of the first combination",
          "[campaign][program]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment());
  const auto [places, status, text] = GENERATE(table<std::string, int, std::string>(
      {{"1;, 2,0,0", 1, "the experiment cannot be loaded with the first combination"},
       {"1,1,0; -1,", 0, ""}}));
  folder.Write("c.xml",
               MakeCampaignText("<factors><factor name='place' path='//foot-bot[1]/body/@position' "
                                "values='" +
                                places + "' /></factors><runs seeds='2' />"));
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"run", "c.xml", "--dry-run"});
  CHECK(run.Status == status);
  CHECK_THAT(run.Err, Contains(text));
}

TEST_CASE("campaign: warnings have the lines of the experiment's file", "[campaign][program]") {
  const CTestFolder folder;
  std::string experiment = MakeCampaignExperiment();
  Insert(experiment, "<controllers>", "<!-- some\n\nlines -->\n\n");
  Insert(experiment, "id=\"fb0\"", "\n  ");
  Insert(experiment, "id=\"fb1\"", "unused=\"1\" ");
  const auto line =
      1 + std::count(experiment.begin(),
                     experiment.begin() + static_cast<std::ptrdiff_t>(experiment.find("unused")),
                     '\n');
  folder.Write("experiment.argos", experiment);
  folder.Write("c.xml", MakeCampaignText("<set path='//experiment/@length' value='0.5' />\n"
                                         "<set path='//loop_functions/@gainn' value='2' />\n"
                                         "<runs seeds='1' />"));
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"run", "c.xml"});
  CHECK(run.Status == 0);
  CHECK_THAT(run.Err, Contains("experiment.argos:" + std::to_string(line) + ": <foot-bot>"));
  // what the campaign has set is a warning, too
  CHECK_THAT(run.Err, Contains("\"gainn\" is not used by anything"));
}

TEST_CASE("campaign: a <set> of the number of threads reaches the runs", "[campaign][program]") {
  const CTestFolder folder;
  std::string experiment = MakeCampaignExperiment();
  const bool hasSystem = GENERATE(false, true);
  if (hasSystem) {
    Insert(experiment, "<experiment", "<system threads='1' />");
  }
  folder.Write("experiment.argos", experiment);
  folder.Write("c.xml", MakeCampaignText((hasSystem ? "<set path='//system/@threads' value='2' />"
                                                    : "<execution threads='2' />") +
                                         std::string("<runs seeds='1' />")));
  REQUIRE(folder.RunProgram("argos3-campaign", {"run", "c.xml"}).Status == 0);
  const CResultStore store(folder.Path("results.sqlite"), CResultStore::EMode::ReadOnly);
  const std::vector<SStoredRun> runs = store.ListRuns();
  REQUIRE(runs.size() == 1);
  CHECK_THAT(store.FindRun(runs[0].Id)->Result.Log, Contains("Using 2 threads"));
}

TEST_CASE("campaign: a factor without effect is reported", "[campaign][program]") {
  const CTestFolder folder;
  const SProgramRun run = RunCampaign(folder, R"(<factors>
    <factor name='place' path='//foot-bot[1]/body/@position' values='1,1,0; -1,-1,0' />
    <factor name='deed' path='//params/@what' values='none, nothing' />
    <factor name='gain' path='//loop_functions/@gain' values='1, 2, 3' />
  </factors><runs seeds='2' />)");
  CHECK(run.Status == 0);
  CHECK_THAT(run.Err,
             Contains("[WARNING] the levels none and nothing of the factor \"deed\" have equal "
                      "final states (digests) in all 12 pairs of runs: it seems to be without "
                      "effect") &&
                 Contains("[WARNING] all 3 levels of the factor \"gain\" have equal final states "
                          "(digests) in all 16 pairs of runs: it affects metrics, but nothing in "
                          "the simulation") &&
                 !Contains("\"place\""));
}

}  // namespace campaign_faults_test
