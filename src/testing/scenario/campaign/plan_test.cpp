// Which runs are executed, in which order, and when there are enough.

#include <argos3/campaign/scheduling/campaign_progress.h>
#include <argos3/campaign/scheduling/metric_watch.h>
#include <argos3/campaign/scheduling/run_plan.h>
#include <argos3/campaign/store/failed_runs.h>
#include <argos3/testing/support/forked.h>
#include <argos3/testing/support/terminal.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <string>

namespace plan_test {

using namespace argos;

namespace {

SCampaign MakeCampaign(size_t combinations) {
  SCampaign campaign;
  campaign.ExperimentFile = "my experiment.argos";
  for (size_t i = 0; i < combinations; ++i) {
    const std::string value = std::to_string(i);
    campaign.Combinations.push_back({{value}, {{"//a/@b", value}}});
  }
  return campaign;
}

SCampaign MakeSequential(size_t combinations) {
  SCampaign campaign = MakeCampaign(combinations);
  campaign.Stopping.Metric = "m";
  campaign.Stopping.Width = 2.0;
  campaign.Stopping.MinRuns = 5;
  campaign.Stopping.MaxRuns = 400;
  campaign.Stopping.FirstSeed = 100;
  return campaign;
}

// of a run: depends on nothing else
SRunResult MakeResult(const SPlannedRun& run) {
  std::mt19937 generator(run.Seed);
  SRunResult result;
  result.Status = run.Seed % 7 == 0 ? ERunStatus::Crashed : ERunStatus::Done;
  const Real deviation = 1.0 + static_cast<Real>(run.Combination);
  result.Metrics = {{"m", "", std::normal_distribution<Real>(5.0, deviation)(generator)}};
  return result;
}

/* Executes a plan with a number of workers, whose runs end in random order. */
std::vector<std::pair<size_t, UInt32>> Execute(CRunPlan& plan, size_t workers, unsigned seed,
                                               size_t most = 1'000'000) {
  std::mt19937 generator(seed);
  std::vector<SPlannedRun> running;
  std::vector<std::pair<size_t, UInt32>> stored;
  for (;;) {
    while (running.size() < workers && stored.size() < most) {
      const auto run = plan.Next();
      if (!run) {
        break;
      }
      running.push_back(*run);
    }
    if (running.empty() || stored.size() >= most) {
      break;
    }
    const size_t chosen = generator() % running.size();
    const SPlannedRun run = running[chosen];
    running.erase(running.begin() + static_cast<std::ptrdiff_t>(chosen));
    if (generator() % 10 == 0) {
      plan.Return(run);  // its worker has died
      continue;
    }
    for (const TFinishedRun& finished : plan.Finish(run, MakeResult(run))) {
      stored.emplace_back(finished.first.Combination, finished.first.Seed);
    }
  }
  std::sort(stored.begin(), stored.end());
  return stored;
}

}  // namespace

TEST_CASE("plan: repetitions are interleaved, known runs left out", "[campaign][plan]") {
  SCampaign campaign = MakeCampaign(3);
  campaign.Stopping.Seeds = {4, 2};
  const auto plan = CRunPlan::Create(campaign, {{1, 4, 0.0}});
  CHECK(plan->CountOpen() == 5);
  std::vector<std::pair<size_t, UInt32>> order;
  while (const auto run = plan->Next()) {
    order.emplace_back(run->Combination, run->Seed);
  }
  using TOrder = std::vector<std::pair<size_t, UInt32>>;
  CHECK(order == TOrder{{0, 4}, {2, 4}, {0, 2}, {1, 2}, {2, 2}});
  CHECK(plan->CountOpen() == 5);
  CHECK(plan->CountCompleteCombinations() == 0);
  CHECK(plan->Finish({1, 2}, SRunResult()).size() == 1);
  CHECK(plan->CountOpen() == 4);
  CHECK(plan->CountCompleteCombinations() == 1);
}

TEST_CASE("plan: a stopping rule stores the same runs for any number of workers",
          "[campaign][plan]") {
  const SCampaign campaign = MakeSequential(3);
  const auto alone = CRunPlan::Create(campaign, {});
  const auto expected = Execute(*alone, 1, 0);
  CHECK(alone->CountOpen() == 0);
  CHECK(alone->CountCompleteCombinations() == 3);
  // the interval is 2 t s / sqrt(n) <= 2: about (1.96 s)^2 values of deviation s, and at least 5
  for (size_t combination = 0; combination < 3; ++combination) {
    const auto runs = std::count_if(expected.begin(), expected.end(),
                                    [&](const auto& run) { return run.first == combination; });
    const Real deviation = 1.0 + static_cast<Real>(combination);
    const Real needed = std::max(5.0, std::pow(1.96 * deviation, 2.0));
    CHECK(static_cast<Real>(runs) > 0.4 * needed);
    CHECK(static_cast<Real>(runs) < 2.5 * needed);
  }
  for (const size_t workers : {1, 2, 3, 8, 64}) {
    for (unsigned seed = 1; seed < 20; ++seed) {
      CAPTURE(workers, seed);
      REQUIRE(Execute(*CRunPlan::Create(campaign, {}), workers, seed) == expected);
    }
  }
}

TEST_CASE("plan: a stopping rule goes on where it was stopped", "[campaign][plan]") {
  const SCampaign campaign = MakeSequential(3);
  const auto expected = Execute(*CRunPlan::Create(campaign, {}), 1, 0);
  for (unsigned seed = 1; seed < 30; ++seed) {
    CAPTURE(seed);
    std::vector<std::pair<size_t, UInt32>> stored =
        Execute(*CRunPlan::Create(campaign, {}), 4, seed, seed);
    std::vector<SKnownRun> known;
    for (const auto& [combination, runSeed] : stored) {
      const SRunResult result = MakeResult({combination, runSeed});
      known.push_back({combination, runSeed,
                       result.Status == ERunStatus::Done ? result.Metrics[0].Value
                                                         : std::numeric_limits<Real>::quiet_NaN()});
    }
    const auto rest = Execute(*CRunPlan::Create(campaign, known), 3, seed);
    stored.insert(stored.end(), rest.begin(), rest.end());
    std::sort(stored.begin(), stored.end());
    CHECK(stored == expected);
  }
}

TEST_CASE("plan: a stopping rule plans no more runs than it will take", "[campaign][plan]") {
  SCampaign campaign = MakeSequential(1);
  campaign.Stopping.MinRuns = 2;
  campaign.Stopping.MaxRuns = GENERATE(400U, 100U);
  const auto plan = CRunPlan::Create(campaign, {});
  // without a deviation: the least number
  const auto first = plan->Next();
  const auto second = plan->Next();
  REQUIRE(first);
  REQUIRE(second);
  CHECK_FALSE(plan->Next());
  CHECK(plan->CountOpen() == 2);
  const auto finish = [&plan](const SPlannedRun& run, Real value) {
    SRunResult result;
    result.Status = ERunStatus::Done;
    result.Metrics = {{"m", "", value}};
    return plan->Finish(run, result).size();
  };
  CHECK(finish(*first, 0.0) == 1);
  CHECK(finish(*second, 2.0) == 1);
  // half the width is 1, that of these values t(1) = 12.7: 2 12.7^2 = 322.9 runs
  const UInt32 planned = std::min(323U, campaign.Stopping.MaxRuns);
  CHECK(plan->CountOpen() == planned - 2);
  for (UInt32 run = 2; run < planned; ++run) {
    CHECK(plan->Next()->Seed == campaign.Stopping.FirstSeed + run);
  }
  CHECK_FALSE(plan->Next());
}

TEST_CASE("plan: values that measure nothing are missing", "[campaign][plan]") {
  SCampaign campaign = MakeSequential(1);
  campaign.Stopping.MinRuns = 2;
  campaign.Stopping.MaxRuns = 3;
  const Real huge = GENERATE(1.1e100, -1e300, std::numeric_limits<Real>::infinity());
  // known, or executed now
  const auto plan = CRunPlan::Create(campaign, {{0, 100, huge}, {0, 99, 1.0}, {0, 103, 1.0}});
  // seeds outside of the rule do not count, the missing value takes a place
  CHECK(plan->CountOpen() == 2);
  SRunResult result;
  result.Status = ERunStatus::Done;
  result.Metrics = {{"m", "", huge}};
  CHECK(plan->Finish(*plan->Next(), result).size() == 1);
  result.Metrics[0].Value = 1e100;
  const auto last = plan->Next();
  REQUIRE(last);
  CHECK(last->Seed == 102);
  CHECK(plan->Finish(*last, result).size() == 1);
  CHECK(plan->CountOpen() == 0);
}

TEST_CASE("plan: a run that comes back is not repeated when its combination has enough",
          "[campaign][plan]") {
  SCampaign campaign = MakeSequential(1);
  campaign.Stopping.MinRuns = 2;
  campaign.Stopping.Width = 100.0;
  const auto plan = CRunPlan::Create(campaign, {});
  const auto first = plan->Next();
  const auto second = plan->Next();
  plan->Return(*second);
  const auto again = plan->Next();
  REQUIRE(again);
  CHECK(again->Seed == second->Seed);
  SRunResult result;
  result.Status = ERunStatus::Done;
  result.Metrics = {{"m", "", 1.0}};
  plan->Finish(*first, result);
  plan->Finish(*again, result);
  plan->Return({0, 102});
  CHECK_FALSE(plan->Next());
}

TEST_CASE("plan: a metric that is missing ends at the cap", "[campaign][plan]") {
  SCampaign campaign = MakeSequential(1);
  campaign.Stopping.Metric = "absent";
  campaign.Stopping.MaxRuns = 40;
  CHECK(Execute(*CRunPlan::Create(campaign, {}), 3, 1).size() == 40);
}

TEST_CASE("failed runs: the command is quoted for a shell", "[campaign][plan]") {
  CHECK(QuoteForShell("plain/a-b_c.argos") == "plain/a-b_c.argos");
  CHECK(QuoteForShell("") == "''");
  CHECK(QuoteForShell("it's $HOME") == "'it'\\''s $HOME'");
  CHECK(QuoteForShell("~") == "'~'");
  SCampaign campaign = MakeCampaign(1);
  campaign.Constants = {{"//c/@d", "1, 2"}};
  CHECK(MakeRepeatCommand(campaign, campaign.Combinations[0], 9) ==
        "argos3 -zc 'my experiment.argos' --seed 9 --set '//c/@d=1, 2' --set //a/@b=0");
}

namespace {

// 45 of 120 runs are finished, 25 of them now
SCampaignProgress MakeProgress() {
  return {.Combinations = 12,
          .CompleteCombinations = 3,
          .KnownRuns = 20,
          .Runs = 25,
          .FailedRuns = 2,
          .OpenRuns = 75,
          .WallSeconds = 2.0};
}

}  // namespace

TEST_CASE("progress of a campaign: text", "[campaign][plan]") {
  SCampaignProgress progress{.Combinations = 12, .OpenRuns = 120};
  CHECK(DescribeCampaignProgress(progress) == "0/120 runs (0 %), 0/12 combinations complete");
  progress = MakeProgress();
  CHECK(DescribeCampaignProgress(progress) ==
        "45/120 runs (37 %), 2 failed, 0:06 left, 3/12 combinations complete, 12.5 runs/s");
  // 75 runs are open, three times those that are finished
  for (const auto& [seconds, left] :
       std::vector<std::pair<Real, std::string>>{{40.0, "2:00"},
                                                 {3599.0 / 3.0, "59:59"},
                                                 {1200.0, "1:00:00"},
                                                 {1'199'999.0, "999:59:57"},
                                                 {1'200'000.0, "more than 1000 h"}}) {
    progress.WallSeconds = seconds;
    CHECK_THAT(DescribeCampaignProgress(progress), Catch::Contains(" failed, " + left + " left, "));
  }
  progress = SCampaignProgress();
  CHECK(DescribeCampaignProgress(progress) == "0/0 runs (100 %), 0/0 combinations complete");
}

namespace {

// what a line of a campaign in progress leaves on a terminal
std::string ShowOnTerminal(unsigned short columns,
                           const std::function<void(CCampaignProgressLine&)>& show) {
  CTerminal terminal(columns);
  REQUIRE(terminal.GetFile() >= 0);
  const int result = CallInFork([&] {
    setenv("TERM", "xterm", 1);
    dup2(terminal.GetFile(), STDERR_FILENO);
    CCampaignProgressLine line(false);
    show(line);
    return 0;
  });
  CHECK(result == 0);
  return terminal.Read();
}

}  // namespace

TEST_CASE("progress of a campaign: the line in a terminal has a bar and no more columns than it",
          "[campaign][plan]") {
  const SCampaignProgress progress = MakeProgress();
  // 45 of 120 runs are 7.5 of 20 places
  const std::string line =
      "[#######.............] 45/120 runs (37 %), 2 failed, 0:06 left, "
      "3/12 combinations complete, 12.5 runs/s";
  const auto finish = [&](CCampaignProgressLine& shown) { shown.Finish(progress); };
  CHECK(ShowOnTerminal(200, finish) == "\r\x1b[K" + line + "\r\n");
  // the last column stays free: a full line wraps around in some terminals
  CHECK(ShowOnTerminal(40, finish) == "\r\x1b[K" + line.substr(0, 39) + "\r\n");
  CHECK(ShowOnTerminal(1, finish) == "\r\x1b[K[\r\n");
  // of an unknown width
  CHECK(ShowOnTerminal(0, finish) == "\r\x1b[K" + line.substr(0, 79) + "\r\n");
}

TEST_CASE("progress of a campaign: the line in a terminal is drawn at most five times a second",
          "[campaign][plan]") {
  SCampaignProgress progress;
  progress.OpenRuns = 1;
  const std::string line =
      "\r\x1b[K[....................] 0/1 runs (0 %), 0/0 combinations complete";
  const std::string text = ShowOnTerminal(100, [&](CCampaignProgressLine& shown) {
    shown.Print("nothing to erase");
    const auto start = std::chrono::steady_clock::now();
    std::chrono::duration<Real> time(0.0);
    while (time.count() < 0.45) {
      shown.Update(progress);
      time = std::chrono::steady_clock::now() - start;
    }
    shown.Update(progress);
    time = std::chrono::steady_clock::now() - start;
    shown.Print(std::to_string(std::floor(time.count() / 0.2)));
  });
  const std::string head = "nothing to erase\r\n";
  REQUIRE(text.substr(0, head.size()) == head);
  size_t place = head.size();
  int drawings = 0;
  for (; text.compare(place, line.size(), line) == 0; place += line.size()) {
    ++drawings;
  }
  CHECK(drawings >= 1);
  const std::string erased = "\r\x1b[K";
  REQUIRE(text.compare(place, erased.size(), erased) == 0);
  // less than five a second on a busy machine
  CHECK(drawings <= std::stoi(text.substr(place + erased.size())));
}

TEST_CASE("metric watch: names metrics that no run has recorded, once", "[campaign][plan]") {
  SCampaign campaign = MakeCampaign(1);
  campaign.Stopping.Metric = "delivred";
  for (const char* name : {"food", "delivred", "late"}) {
    campaign.Metrics.emplace_back().Name = name;
  }
  SRunResult result;
  result.Status = ERunStatus::Done;
  const Real none = std::numeric_limits<Real>::quiet_NaN();
  result.Metrics = {{"food", "", 1.0}, {"delivred", "", none}, {"late", "", none}};
  CMetricWatch watch(campaign);
  CHECK(watch.TakeWarning(true).empty());
  SRunResult failed = result;
  failed.Status = ERunStatus::Failed;
  for (UInt64 i = 0; i + 1 < CMetricWatch::kPatience; ++i) {
    watch.Note(result);
    watch.Note(failed);
    CHECK(watch.TakeWarning(false).empty());
  }
  result.Metrics[2].Value = 0.0;
  watch.Note(result);
  CHECK(watch.TakeWarning(false) ==
        "10 runs are done, and none has recorded \"delivred\": check the name; `argos3 -zc 'my "
        "experiment.argos' --csv FOLDER` writes all metrics to FOLDER/metrics.csv");
  CHECK(watch.TakeWarning(true).empty());

  CMetricWatch brief(campaign);
  brief.Note(result);
  CHECK(brief.TakeWarning(false).empty());
  CHECK(brief.TakeWarning(true).rfind("1 run is done, and none has recorded \"delivred\": ", 0) ==
        0);
}

}  // namespace plan_test
