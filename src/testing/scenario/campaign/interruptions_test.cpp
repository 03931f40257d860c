// Campaigns that are killed or stopped lose no stored run, and can go on.

#include "campaign_run.h"
#include "campaign_world.h"

#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <csignal>
#include <filesystem>
#include <random>

#include <sys/wait.h>
#include <unistd.h>

namespace interruptions_test {

using namespace argos;

namespace {

constexpr size_t kSeeds = FewerIfSanitized(80);
constexpr size_t kRuns = 3 * kSeeds;

std::string MakeCampaign(const std::string& runs, const std::string& isolation) {
  return "<argos-campaign experiment='experiment.argos' results='results.sqlite'>\n"
         "  <factors><factor name='gain' path='loop_functions/@gain' values='1, 2, 3' />"
         "</factors>\n  <runs " +
         runs + " />\n  <execution isolation='" + isolation + "' />\n</argos-campaign>\n";
}

void WriteCampaign(const CTestFolder& folder, const std::string& isolation) {
  folder.Write("experiment.argos", MakeCampaignExperiment("", 1, 2));
  folder.Write("c.xml", MakeCampaign("seeds='" + std::to_string(kSeeds) + "'", isolation));
}

}  // namespace

TEST_CASE("campaign: after kill -9 at any moment, resume completes the same table",
          "[campaign][interruptions]") {
  const std::string isolation = GENERATE("process", "thread");
  CAPTURE(isolation);
  const CTestFolder whole;
  WriteCampaign(whole, isolation);
  REQUIRE(whole.RunProgram("argos3-campaign", {"run", "c.xml", "-j", "2"}).Status == 0);
  const std::vector<std::string> expected = ReadTable(whole.Path("results.sqlite"));
  REQUIRE(expected.size() == kRuns);

  const CTestFolder folder;
  WriteCampaign(folder, isolation);
  std::mt19937 generator(7);
  size_t stored = 0;
  for (int kill = 0; kill < 3; ++kill) {
    const pid_t process = StartCampaign(folder, {"run", "c.xml", "-j", "2"});
    // each time, more runs are there before it dies
    REQUIRE(AwaitRuns(folder.Path("results.sqlite"), stored + 1, process));
    usleep(static_cast<useconds_t>(generator() % 100'000));
    ::kill(process, SIGKILL);
    AwaitCampaign(process);
    stored = ReadTable(folder.Path("results.sqlite")).size();
    CAPTURE(kill, stored);
    if (stored == kRuns) {
      break;
    }
  }
  const SProgramRun rest = folder.RunProgram("argos3-campaign", {"resume", "c.xml", "-j", "2"});
  INFO(rest.Err);
  CHECK(rest.Status == 0);
  CHECK(ReadTable(folder.Path("results.sqlite")) == expected);
}

TEST_CASE("campaign: Ctrl-C finishes what runs, stores it, and says how to go on",
          "[campaign][interruptions]") {
  const int signal = GENERATE(SIGINT, SIGTERM);
  const CTestFolder folder;
  WriteCampaign(folder, "process");
  const pid_t process = StartCampaign(folder, {"run", "c.xml", "-j", "2"});
  REQUIRE(AwaitRuns(folder.Path("results.sqlite"), 1, process));
  kill(process, signal);
  CHECK(AwaitCampaign(process) == 128 + signal);
  const size_t stored = ReadTable(folder.Path("results.sqlite")).size();
  CHECK(stored >= 1);
  CHECK(stored < kRuns);
  const SProgramRun rest = folder.RunProgram("argos3-campaign", {"resume", "c.xml", "-j", "2"});
  CHECK(rest.Status == 0);
  CHECK(ReadTable(folder.Path("results.sqlite")).size() == kRuns);
}

TEST_CASE("campaign: results that are removed end it with an error", "[campaign][interruptions]") {
  const CTestFolder folder;
  WriteCampaign(folder, "thread");
  const pid_t process = StartCampaign(folder, {"run", "c.xml", "-j", "1"});
  REQUIRE(AwaitRuns(folder.Path("results.sqlite"), 1, process));
  std::filesystem::remove(folder.Path("results.sqlite"));
  CHECK(AwaitCampaign(process) == 1);
}

TEST_CASE("campaign: a second signal kills runs that hang", "[campaign][interruptions]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment("hang", 3));
  folder.Write("c.xml", MakeCampaign("seeds='4'", "process"));
  const pid_t process = StartCampaign(folder, {"run", "c.xml", "-j", "1"});
  // the seventh run hangs
  REQUIRE(AwaitRuns(folder.Path("results.sqlite"), 6, process));
  kill(process, SIGINT);
  usleep(300'000);
  CHECK(waitpid(process, nullptr, WNOHANG) == 0);
  kill(process, SIGINT);
  CHECK(AwaitCampaign(process) == 128 + SIGINT);
  CHECK(ReadTable(folder.Path("results.sqlite")).size() == 6);
}

}  // namespace interruptions_test
