// Campaigns on a cluster: a real Slurm, started by the test.

#include "../campaign/campaign_run.h"
#include "../campaign/campaign_world.h"
#include "slurm_cluster.h"

#include <argos3/campaign/store/result_store.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <catch2/catch.hpp>

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

namespace submission_test {

using namespace argos;
using Catch::Contains;

namespace {

constexpr size_t kRuns = 200;

std::string MakeCampaign(const std::string& slurm, const std::string& runs = "seeds='50'") {
  return "<argos-campaign experiment='experiment.argos' results='results.sqlite'>\n"
         "  <factors><factor name='gain' path='loop_functions/@gain' values='1, 2, 3, 4' />"
         "</factors>\n  <runs " +
         runs + " />\n  <collect><metric name='level' /><metric name='ticks' /></collect>\n  " +
         slurm + "\n</argos-campaign>\n";
}

// false, with a warning that names the test, if Slurm is not installed; continuous integration has
// it
bool HasSlurm() {
  const std::string missing = ListMissingPrograms();
  if (missing.empty()) {
    return true;
  }
  INFO("missing: " << missing << "; Debian packages slurm-wlm and munge");
  REQUIRE(std::getenv("CI") == nullptr);
  WARN("skipped: " << Catch::getResultCapture().getCurrentTestName() << ": missing: " << missing);
  return false;
}

// waits until a task has stored some runs. @return the process of the task; 0: it has ended
pid_t AwaitTask(const CTestFolder& folder, int task, size_t runs) {
  const std::string part = folder.Path("results.parts/" + std::to_string(task) + ".sqlite");
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (std::chrono::steady_clock::now() < end) {
    try {
      if (std::filesystem::exists(part + ".lock") &&
          CResultStore(part, CResultStore::EMode::ReadOnly).ListRuns().size() >= runs) {
        // "process 12 on host"
        const std::string owner =
            folder.Read(std::filesystem::relative(part + ".lock", folder.Path(".")).string());
        return owner.empty() ? 0 : std::stoi(owner.substr(owner.find(' ') + 1));
      }
    } catch (const CARGoSException&) {
      // it is being created
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return 0;
}

std::string ReadJobLogs(const CTestFolder& folder, const std::string& name = "results.slurm") {
  std::string text;
  for (const auto& entry : std::filesystem::directory_iterator(folder.Path(name))) {
    const std::string file = entry.path().filename().string();
    text += "\n==> " + file + "\n" + folder.Read(name + "/" + file);
  }
  return text;
}

std::vector<std::string> RunLocally(const std::string& campaign, const std::string& experiment) {
  const CTestFolder folder;
  folder.Write("experiment.argos", experiment);
  folder.Write("c.xml", campaign);
  REQUIRE(folder.RunProgram("argos3-campaign", {"run", "c.xml", "-j", "2"}).Status == 0);
  return ReadTable(folder.Path("results.sqlite"));
}

}  // namespace

TEST_CASE("slurm: tasks are killed in the middle, and the table is that of a local run",
          "[campaign][slurm]") {
  if (!HasSlurm()) {
    return;
  }
  const std::string campaign = MakeCampaign("<slurm tasks='4' jobs='1' partition='test' />");
  const std::string experiment = MakeCampaignExperiment("", 1, 600);
  const std::vector<std::string> expected = RunLocally(campaign, experiment);
  REQUIRE(expected.size() == kRuns);

  const CTestFolder folder;
  folder.Write("experiment.argos", experiment);
  folder.Write("c.xml", campaign);
  const CSlurmCluster cluster;
  const SProgramRun submitted = folder.RunProgram("argos3-campaign", {"submit", "c.xml"});
  INFO(submitted.Out << submitted.Err << cluster.ReadLogs());
  REQUIRE(submitted.Status == 0);
  CHECK_THAT(submitted.Out, Contains("200 runs in 4 tasks"));

  // one dies at once, the other one is cancelled
  const pid_t process = AwaitTask(folder, 2, 3);
  REQUIRE(process > 0);
  REQUIRE(kill(process, SIGKILL) == 0);
  REQUIRE(AwaitTask(folder, 3, 3) > 0);
  const std::string jobs = folder.Read("results.slurm/jobs");
  const std::string first = jobs.substr(jobs.find("\n1 ") + 3);
  REQUIRE(cluster.Command("scancel " + first.substr(0, first.find(' ')) + "_3").Status == 0);

  const SProgramRun second = folder.RunProgram("argos3-campaign", {"submit", "c.xml"});
  CHECK(second.Status == 1);
  CHECK_THAT(second.Err, Contains("still in the queue") && Contains("scancel"));
  const SProgramRun status = folder.RunProgram("argos3-campaign", {"status", "c.xml"});
  CHECK_THAT(status.Out, Contains("parts that are not merged yet") && Contains("task 2: ") &&
                             Contains("submission 1: array job") && Contains("in the queue:"));

  REQUIRE(cluster.AwaitEmptyQueue());
  INFO(ReadJobLogs(folder));
  CHECK(ReadTable(folder.Path("results.sqlite")) == expected);
  CHECK_FALSE(std::filesystem::exists(folder.Path("results.parts")));
  // the runs of both were missing, and none but theirs was submitted again
  CHECK_THAT(folder.Read("results.slurm/runs_2.sh"), Contains("--array=2-3\n"));
  CHECK_THAT(folder.Read("results.slurm/merging_2.log"), Contains("all runs are stored"));
  CHECK_FALSE(std::filesystem::exists(folder.Path("results.slurm/runs_3.sh")));

  const SProgramRun again = folder.RunProgram("argos3-campaign", {"submit", "c.xml"});
  CHECK(again.Status == 0);
  CHECK_THAT(again.Out, Contains("nothing is submitted"));
}

TEST_CASE(
    "slurm: a stopping rule gives the table of a local run, also in a folder with blanks and "
    "quotes",
    "[campaign][slurm]") {
  if (!HasSlurm()) {
    return;
  }
  const std::string campaign =
      MakeCampaign("<slurm tasks='3' jobs='2' />", "until='level' relative='0.5' min='5' max='20'");
  const std::string experiment = MakeCampaignExperiment();
  const std::vector<std::string> expected = RunLocally(campaign, experiment);

  const CTestFolder folder;
  std::filesystem::create_directory(folder.Path("my results"));
  folder.Write("experiment.argos", experiment);
  const std::string results = "results.sqlite";
  std::string elsewhere = campaign;
  elsewhere.replace(campaign.find(results), results.size(), "my results/50% of it.sqlite");
  folder.Write("it's my #1 \\\"campaign\\\".xml", elsewhere);
  const CSlurmCluster cluster;
  const SProgramRun submitted =
      folder.RunProgram("argos3-campaign", {"submit", "it's my #1 \\\"campaign\\\".xml"});
  INFO(submitted.Err);
  REQUIRE(submitted.Status == 0);
  REQUIRE(cluster.AwaitEmptyQueue());
  INFO(ReadJobLogs(folder, "my results/50% of it.slurm"));
  CHECK(ReadTable(folder.Path("my results/50% of it.sqlite")) == expected);
}

TEST_CASE("slurm: runs that are missing are submitted again a limited number of times",
          "[campaign][slurm]") {
  if (!HasSlurm()) {
    return;
  }
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment());
  folder.Write("c.xml", MakeCampaign("<slurm tasks='2' resubmit='1' />", "seeds='2'"));
  const CSlurmCluster cluster;
  // a folder where the database of a task should be: that task fails each time
  std::filesystem::create_directories(folder.Path("results.parts/2.sqlite.lock/occupied"));
  REQUIRE(folder.RunProgram("argos3-campaign", {"submit", "c.xml"}).Status == 0);
  REQUIRE(cluster.AwaitEmptyQueue());
  INFO(ReadJobLogs(folder));
  CHECK(ReadTable(folder.Path("results.sqlite")).size() == 4);
  CHECK_THAT(folder.Read("results.slurm/runs_2_2.log"), Contains("2.sqlite"));
  CHECK_THAT(folder.Read("results.slurm/merging_2.log"), Contains("4 runs are missing"));
  CHECK_FALSE(std::filesystem::exists(folder.Path("results.slurm/runs_3.sh")));
}

TEST_CASE("slurm: a rejected job shows the message of Slurm, and queues nothing",
          "[campaign][slurm]") {
  if (!HasSlurm()) {
    return;
  }
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment());
  folder.Write("c.xml", MakeCampaign("<slurm tasks='2' partition='nowhere' />"));
  const CSlurmCluster cluster;
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"submit", "c.xml"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("invalid partition specified: nowhere"));
  CHECK(cluster.Command("squeue --noheader").Out.empty());
}

TEST_CASE("slurm: a share of a changed campaign is refused", "[campaign][slurm]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment());
  folder.Write("c.xml", MakeCampaign("<slurm tasks='2' />", "seeds='10'"));
  REQUIRE(folder.RunProgram("argos3-campaign", {"run", "c.xml", "--seeds", "1"}).Status == 0);
  const SProgramRun scripts =
      folder.RunProgram("argos3-campaign", {"submit", "c.xml", "--dry-run"});
  const std::string option = "--submission ";
  const std::string digest = scripts.Out.substr(scripts.Out.find(option) + option.size(), 16);
  const std::vector<std::string> arguments = {"run-share", "c.xml",       "--share",      "1/2",
                                              "--part",    "part.sqlite", "--submission", digest};
  REQUIRE(folder.RunProgram("argos3-campaign", arguments).Status == 0);
  // 36 runs are missing; each task takes half of all 40
  CHECK(ReadTable(folder.Path("part.sqlite")).size() == 18);

  SECTION("another experiment") {
    folder.Write("experiment.argos", MakeCampaignExperiment("", 1, 3));
  }
  SECTION("more seeds") {
    folder.Write("c.xml", MakeCampaign("<slurm tasks='2' />", "seeds='11'"));
  }
  // the task, and the job that merges
  for (const auto& job :
       {arguments, std::vector<std::string>{"merge", "c.xml", "--submission", digest}}) {
    CAPTURE(job[0]);
    const SProgramRun run = folder.RunProgram("argos3-campaign", job);
    CHECK(run.Status == 1);
    CHECK_THAT(run.Err, Contains("has changed since it was submitted"));
  }
}

TEST_CASE("slurm: submit --dry-run prints the scripts and changes nothing", "[campaign][slurm]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment());
  folder.Write("c.xml", MakeCampaign("<limits wall='90' memory='1 GiB' />"
                                     "<slurm tasks='3' jobs='4' partition='batch' time='01:00:00' "
                                     "account='swarm'><option value='--nice=10' /></slurm>"));
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"submit", "c.xml", "--dry-run"});
  CHECK(run.Status == 0);
  for (const char* line :
       {"#SBATCH --array=1-3\n", "#SBATCH --partition=batch\n", "#SBATCH --account=swarm\n",
        "#SBATCH --time=01:00:00\n", "#SBATCH --cpus-per-task=4\n", "#SBATCH --mem=4352M\n",
        "#SBATCH --nice=10\n", "#SBATCH --signal=B:TERM@90\n", "--jobs 4\n", "--resubmit 2\n"}) {
    CHECK_THAT(run.Out, Contains(line));
  }
  for (const char* name : {"results.sqlite", "results.slurm", "results.parts"}) {
    CHECK_FALSE(std::filesystem::exists(folder.Path(name)));
  }
}

TEST_CASE("slurm: submit --retry repeats stored runs that have failed", "[campaign][slurm]") {
  const CTestFolder folder;
  // fails with the seed 2
  folder.Write("experiment.argos", MakeCampaignExperiment("throw", 2));
  folder.Write("c.xml", MakeCampaign("<slurm tasks='2' />", "seeds='4'"));
  REQUIRE(folder.RunProgram("argos3-campaign", {"run", "c.xml"}).Status == 3);
  const SProgramRun without =
      folder.RunProgram("argos3-campaign", {"submit", "c.xml", "--dry-run"});
  CHECK_THAT(without.Out, Contains("nothing would be submitted"));
  const SProgramRun scripts =
      folder.RunProgram("argos3-campaign", {"submit", "c.xml", "--dry-run", "--retry"});
  CHECK_THAT(scripts.Out, Contains("#SBATCH --array=1-2\n") && Contains("--jobs 1 --retry\n"));
  const std::string option = "--submission ";
  const std::string digest = scripts.Out.substr(scripts.Out.find(option) + option.size(), 16);
  std::vector<std::string> arguments = {"run-share", "c.xml",       "--share",      "1/2",
                                        "--part",    "part.sqlite", "--submission", digest};
  CHECK(folder.RunProgram("argos3-campaign", arguments).Status == 0);
  CHECK(ReadTable(folder.Path("part.sqlite")).empty());
  arguments.push_back("--retry");
  CHECK(folder.RunProgram("argos3-campaign", arguments).Status == 3);
  // of the four combinations
  CHECK(ReadTable(folder.Path("part.sqlite")).size() == 2);
}

TEST_CASE("slurm: without its commands, submit says what to install", "[campaign][slurm]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment());
  folder.Write("c.xml", MakeCampaign("<slurm tasks='2' />"));
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.Path(".").c_str(), 1);
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"submit", "c.xml"});
  setenv("PATH", path.c_str(), 1);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("sbatch was not found") && Contains("slurm-client"));
  CHECK_FALSE(std::filesystem::exists(folder.Path("results.sqlite")));
}

}  // namespace submission_test
