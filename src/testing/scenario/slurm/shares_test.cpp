// Which task executes which runs, and the texts of scripts.

#include <argos3/campaign/slurm/job_scripts.h>
#include <argos3/campaign/slurm/run_share.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace shares_test {

using namespace argos;
using Catch::Contains;

namespace {

SCampaign MakeCampaign(size_t combinations, UInt32 seeds) {
  SCampaign campaign;
  campaign.File = "folder/c.xml";
  campaign.ResultsFile = "folder/results.sqlite";
  for (size_t i = 0; i < combinations; ++i) {
    campaign.Combinations.push_back({{}, {{"path", std::to_string(i)}}});
  }
  campaign.Stopping.Seeds.resize(seeds);
  std::iota(campaign.Stopping.Seeds.begin(), campaign.Stopping.Seeds.end(), 11U);
  return campaign;
}

std::set<std::pair<size_t, UInt32>> ListRuns(const SCampaign& campaign, const SRunShare& share,
                                             const std::vector<SKnownRun>& known = {}) {
  const auto plan = CreateSharePlan(SelectCombinations(campaign, share), share, known);
  std::set<std::pair<size_t, UInt32>> runs;
  while (const auto run = plan->Next()) {
    CHECK(runs.emplace(run->Combination, run->Seed).second);
  }
  return runs;
}

}  // namespace

TEST_CASE("shares: each run is in one of them, and all are about as large", "[campaign][slurm]") {
  const size_t combinations = GENERATE(1, 2, 4, 5, 12);
  const UInt32 tasks = GENERATE(1, 2, 3, 4, 7);
  const UInt32 seeds = 3 * tasks;
  CAPTURE(combinations, tasks);
  const SCampaign campaign = MakeCampaign(combinations, seeds);
  std::set<std::pair<size_t, UInt32>> all;
  for (UInt32 task = 1; task <= tasks; ++task) {
    const auto runs = ListRuns(campaign, {task, tasks});
    std::map<size_t, UInt32> numSeeds;
    for (const auto& run : runs) {
      CHECK(all.insert(run).second);
      ++numSeeds[run.first];
    }
    // each task has as many runs of each combination
    CHECK(numSeeds.size() == combinations);
    for (const auto& [combination, count] : numSeeds) {
      CHECK(count == seeds / tasks);
    }
  }
  CHECK(all.size() == combinations * seeds);
}

TEST_CASE("shares: stored runs change no other run's share", "[campaign][slurm]") {
  const SCampaign campaign = MakeCampaign(3, 8);
  const SRunShare share{2, 4};
  auto runs = ListRuns(campaign, share);
  const auto first = *runs.begin();
  runs.erase(runs.begin());
  CHECK(ListRuns(campaign, share, {{first.first, first.second, 0.0}}) == runs);
}

TEST_CASE("shares: with a stopping rule, a combination is in one of them", "[campaign][slurm]") {
  SCampaign campaign = MakeCampaign(7, 0);
  campaign.Stopping.Metric = "level";
  std::multiset<std::string> keys, expected;
  for (UInt32 task = 1; task <= 3; ++task) {
    for (const SCombination& combination : SelectCombinations(campaign, {task, 3}).Combinations) {
      keys.insert(combination.ComputeKey());
    }
  }
  for (const SCombination& combination : campaign.Combinations) {
    expected.insert(combination.ComputeKey());
  }
  CHECK(keys == expected);
}

TEST_CASE("shares: text that is none is an error", "[campaign][slurm]") {
  CHECK(ParseRunShare("2/4").Number == 2);
  CHECK(ParseRunShare("2/4").Count == 4);
  const std::string text = GENERATE("", "2", "/4", "2/", "0/4", "5/4", "a/4", "2/4x", "-1/4");
  CAPTURE(text);
  CHECK_THROWS_AS(ParseRunShare(text), CARGoSException);
}

TEST_CASE("job scripts: ranges of the array", "[campaign][slurm]") {
  CHECK(FormatArray({1}) == "1");
  CHECK(FormatArray({1, 2, 3, 4}) == "1-4");
  CHECK(FormatArray({2, 4, 5, 9}) == "2,4-5,9");
}

TEST_CASE("job scripts: a task is told to stop before its time limit", "[campaign][slurm]") {
  SCampaign campaign = MakeCampaign(1, 1);
  const auto [limit, wall, expected] = GENERATE(table<std::string, Real, std::string>({
      {"", 0.0, "60"},
      {"", 90.5, "91"},
      {"", 1e9, "65535"},
      {"60", 120.0, "120"},
      // a quarter of two minutes, given in each way
      {"2", 120.0, "30"},
      {"2:00", 120.0, "30"},
      {"0:02:00", 120.0, "30"},
      {"0-0:02", 120.0, "30"},
      {"0-0:02:00", 120.0, "30"},
      {"1-0", 1e9, "21600"},
      {"INFINITE", 120.0, "120"},
  }));
  campaign.Slurm.TimeLimit = limit;
  campaign.Limits.WallTime = wall;
  CAPTURE(limit, wall);
  CHECK_THAT(MakeRunsScript(campaign, {}), Contains("--signal=B:TERM@" + expected + "\n"));
}

TEST_CASE("job scripts: names with blanks and other characters", "[campaign][slurm]") {
  SCampaign campaign = MakeCampaign(1, 1);
  campaign.File = "/a b/it's #1.xml";
  campaign.ResultsFile = "/a b/100%.sqlite";
  SScriptOptions options;
  options.Program = "/my programs/argos3-campaign";
  const std::string script = MakeRunsScript(campaign, options);
  CHECK_THAT(script, Contains("#SBATCH --output=\"/a b/100%%.slurm/runs_1_%a.log\"\n") &&
                         Contains("#SBATCH --job-name=\"it's #1\"\n") &&
                         Contains("exec '/my programs/argos3-campaign' run-share '/a b/it'\\''s "
                                  "#1.xml' ") &&
                         Contains("--part '/a b/100%.parts'/\"$SLURM_ARRAY_TASK_ID\".sqlite"));
}

}  // namespace shares_test
