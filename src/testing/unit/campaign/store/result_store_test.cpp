#include <argos3/campaign/store/result_store.h>

#include <argos3/campaign/store/database.h>
#include <argos3/campaign/store/experiment_files.h>
#include <argos3/campaign/store/failed_runs.h>
#include <argos3/testing/unit/campaign/campaign_files.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

namespace result_store_test {

using namespace argos;
using Catch::Matchers::Contains;
typedef std::vector<std::string> TTexts;

namespace {

const std::string kTwoFactors = R"(<factors>
  <factor name="robots" path="//distribute/entity/@quantity" values="5, 10"/>
  <factor name="mode" path="//lua_controller[@id='forage']/params/@speed" values="1, fast"/>
</factors><runs seeds="3"/>)";

/** A campaign of four combinations, and its store. */
struct SFixture {
  CTemporaryFolder Folder;
  SCampaign Campaign = ReadTestCampaign(Folder, kTwoFactors);
  std::unique_ptr<CResultStore> Store;

  SFixture() {
    Reopen();
    Store->Register(Campaign, false);
  }
  void Reopen() {
    Store.reset();
    Store = std::make_unique<CResultStore>(Campaign.ResultsFile, CResultStore::EMode::Write);
  }
  std::string Key(size_t combination) const {
    return Campaign.Combinations[combination].ComputeKey();
  }
  UInt32 Id(size_t combination) const { return Store->GetCombinationId(Key(combination)); }
  // with another text of the experiment
  SCampaign Changed() const {
    SCampaign changed = Campaign;
    const size_t start = changed.ExperimentText.find("length=\"10\"");
    changed.ExperimentText.replace(start, 11, "length=\"20\"");
    return changed;
  }
};

}  // namespace

TEST_CASE("result store: what is stored is read back", "[campaign][store]") {
  SFixture fixture;
  SStoredRun run = MakeRun(fixture.Id(2), 7, 0.1);
  run.Result.Status = ERunStatus::RobotsStopped;
  run.Result.ExitStatus = 3;
  run.Result.Metrics.push_back({"missing", "m", std::nan("")});
  fixture.Store->Add({run});
  fixture.Reopen();

  const std::vector<SStoredRun> listed = fixture.Store->ListRuns();
  REQUIRE(listed.size() == 1);
  CHECK(listed[0].Result.Metrics.empty());
  CHECK(listed[0].Result.Log.empty());
  const auto found = fixture.Store->FindRun(listed[0].Id);
  REQUIRE(found.has_value());
  CHECK(found->Combination == fixture.Id(2));
  CHECK(found->Seed == 7);
  CHECK(found->Generation == 1);
  CHECK(found->Attempt == 1);
  CHECK(found->Started == run.Started);
  CHECK(found->Machine == run.Machine);
  CHECK(found->Version == run.Version);
  const SRunResult& result = found->Result;
  CHECK(result.Status == ERunStatus::RobotsStopped);
  CHECK(result.ExitStatus == 3);
  CHECK(result.StartUpTime == 0.125);
  CHECK(result.WallTime == 2.5);
  CHECK(result.CPUTime == 2.25);
  CHECK(result.TotalWallTime == 3.0);
  CHECK(result.PeakMemory == UInt64{1} << 33);
  CHECK(result.Ticks == 100);
  CHECK(result.Robots == 10);
  CHECK(result.Digest == 0xfedcba9876543210ULL);
  CHECK(result.Log == "line 1\nline 2");
  CHECK(result.LogBytes == 13);
  REQUIRE(result.Metrics.size() == 2);
  CHECK(result.Metrics[0].Value == 0.1);
  CHECK(std::isnan(result.Metrics[1].Value));
  CHECK(result.Metrics[1].Unit == "m");
  const auto series = fixture.Store->ReadSeries("spread");
  REQUIRE(series.size() == 1);
  CHECK(series[0].Seed == 7);
  CHECK(series[0].Series.Unit == "m");
  CHECK(series[0].Series.Ticks == std::vector<UInt32>{0, 10, 20});
  CHECK(series[0].Series.Values == std::vector<Real>{1.0, 0.1 * 7, 0.1});
  CHECK_FALSE(fixture.Store->FindRun(999).has_value());
}

TEST_CASE("result store: factors, combinations and names", "[campaign][store]") {
  SFixture fixture;
  CHECK(fixture.Store->ListFactors() == TTexts{"robots", "mode"});
  const auto combinations = fixture.Store->ListCombinations();
  REQUIRE(combinations.size() == 4);
  CHECK(combinations[1].Values == TTexts{"5", "fast"});
  CHECK(combinations[1].Key == fixture.Key(1));
  CHECK(fixture.Store->ListMetrics().empty());
  fixture.Store->Add({MakeRun(fixture.Id(0), 1, 2.0)});
  CHECK(fixture.Store->ListMetrics() == TTexts{"delivered"});
  CHECK(fixture.Store->ListSeries() == TTexts{"spread"});
  CHECK(fixture.Store->GetUnit("spread", true) == "m");
  CHECK(fixture.Store->GetText("name") == "test");
  CHECK(fixture.Store->GetText("experiment_file") == fixture.Folder.Path("test.argos"));
  CHECK(fixture.Store->GetText("unknown").empty());
  CHECK_THAT(CatchText([&] { fixture.Store->GetCombinationId("a=b\n"); }),
             Contains("has no combination with the values"));
}

TEST_CASE("result store: metrics by combination and seed, of done runs", "[campaign][store]") {
  SFixture fixture;
  SStoredRun crashed = MakeRun(fixture.Id(0), 3, 5.0);
  crashed.Result.Status = ERunStatus::Crashed;
  SStoredRun without = MakeRun(fixture.Id(0), 2, 5.0);
  without.Result.Metrics.clear();
  fixture.Store->Add({MakeRun(fixture.Id(1), 1, 3.0), crashed, without});
  fixture.Store->Add({MakeRun(fixture.Id(0), 1, 2.0)});
  const auto values = fixture.Store->ReadMetric("delivered");
  REQUIRE(values.size() == 3);
  CHECK(values[0].Value == 2.0);
  CHECK(values[1].Seed == 2);
  CHECK(std::isnan(values[1].Value));
  CHECK(values[2].Combination == fixture.Id(1));
  CHECK(values[2].Value == 3.0);
  CHECK(fixture.Store->ReadSeries("spread").size() == 3);
}

TEST_CASE("result store: a retried run replaces the first", "[campaign][store]") {
  SFixture fixture;
  SStoredRun failed = MakeRun(fixture.Id(0), 1, 1.0);
  failed.Result.Status = ERunStatus::TimedOut;
  failed.Result.Metrics.push_back({"other", "", 1.0});
  CHECK_FALSE(fixture.Store->IsStored(fixture.Key(0), 1));
  fixture.Store->Add({failed});
  CHECK(fixture.Store->IsStored(fixture.Key(0), 1));
  CHECK_FALSE(fixture.Store->IsStored(fixture.Key(0), 2));
  CHECK_FALSE(fixture.Store->IsStored(fixture.Key(1), 1));
  fixture.Store->Add({MakeRun(fixture.Id(0), 1, 2.0)});
  const auto runs = fixture.Store->ListRuns();
  REQUIRE(runs.size() == 1);
  CHECK(runs[0].Attempt == 2);
  CHECK(runs[0].Result.Status == ERunStatus::Done);
  CHECK(fixture.Store->FindRun(runs[0].Id)->Result.Metrics.size() == 1);
  // an interrupted run counts as not run, and removes nothing
  SStoredRun interrupted = MakeRun(fixture.Id(0), 1, 9.0);
  interrupted.Result.Status = ERunStatus::Interrupted;
  SStoredRun other = MakeRun(fixture.Id(0), 2, 9.0);
  other.Result.Status = ERunStatus::Interrupted;
  fixture.Store->Add({interrupted, other});
  CHECK(fixture.Store->ListRuns().size() == 1);
  CHECK_FALSE(fixture.Store->IsStored(fixture.Key(0), 2));
}

TEST_CASE("failed runs: at most so many are described, of the combinations of the campaign",
          "[campaign][store]") {
  SFixture fixture;
  std::vector<SStoredRun> runs;
  for (const size_t combination : {0, 1, 2, 3}) {
    SStoredRun run = MakeRun(fixture.Id(combination), 4, 0.0);
    run.Result.Status = combination == 1 ? ERunStatus::Done : ERunStatus::Failed;
    run.Result.Log = "[FATAL] number " + std::to_string(combination);
    runs.push_back(run);
  }
  fixture.Store->Add(runs);
  const std::string text = DescribeFailedRuns(fixture.Campaign, *fixture.Store, 2);
  CHECK_THAT(text, Contains("3 runs failed:\n  robots=5, mode=1, seed=4: failed\n"
                            "    [FATAL] number 0\n") &&
                       Contains("number 2") && !Contains("number 3") && Contains("  and 1 more\n"));
  CHECK_THAT(DescribeFailedRuns(fixture.Campaign, *fixture.Store, 3), !Contains("more"));
  fixture.Campaign.Combinations.erase(fixture.Campaign.Combinations.begin());
  CHECK_THAT(DescribeFailedRuns(fixture.Campaign, *fixture.Store, 2),
             Contains("2 runs failed:") && !Contains("number 0") && !Contains("more"));
}

TEST_CASE("failed runs: the message is the last error that is no detail of another one",
          "[campaign][store]") {
  CHECK(FindErrorMessage("text\n[WARNING] text\n").empty());
  CHECK(FindErrorMessage("[FATAL] one\ntext\n[FATAL] two\ntext\n") == "[FATAL] two");
  CHECK(FindErrorMessage("[FATAL] two") == "[FATAL] two");
  const std::string details =
      GENERATE("[FATAL]   more\n", "[FATAL] stack traceback:\n", "[FATAL] \tmore\n[FATAL]  more\n");
  CHECK(FindErrorMessage("[FATAL] one\ntext\n[FATAL] two\ntext\n" + details) == "[FATAL] two");
  // the line below a crash belongs to it, whatever follows
  CHECK(FindErrorMessage("[FATAL] crash: signal 11\n[FATAL] in robot \"a\"\n[FATAL] frame 1\n") ==
        "[FATAL] crash: signal 11 [FATAL] in robot \"a\"");
}

TEST_CASE("experiment files: the first line that differs is named", "[campaign][store]") {
  CHECK(DescribeFirstDifference("a\nb\n", "a\nb\n").empty());
  CHECK(DescribeFirstDifference("a\n b\n", "a\n\tb \r\n") == "blanks or line breaks");
  CHECK(DescribeFirstDifference("a\n\nb\n", "a\nb\n") == "line 2: 'b' instead of ''");
  CHECK(DescribeFirstDifference("a\n", "a\nb\n") == "line 2: 'b' instead of '(end of the file)'");
  CHECK(DescribeFirstDifference("a\nb\n", "a\n") == "line 2: '(end of the file)' instead of 'b'");
}

TEST_CASE("result store: the view has factors as numbers, and metrics", "[campaign][store]") {
  SFixture fixture;
  fixture.Store->Add({MakeRun(fixture.Id(0), 1, 2.0), MakeRun(fixture.Id(3), 1, 4.0)});
  SStoredRun later = MakeRun(fixture.Id(3), 2, 6.0);
  later.Result.Metrics.push_back({"robots", "", 0.5});
  fixture.Store->Add({later});
  CDatabase database(fixture.Campaign.ResultsFile, CDatabase::EAccess::ReadOnly);
  CQuery query(database,
               "SELECT robots, mode, avg(delivered), typeof(robots), typeof(mode), "
               "max(metric_robots), max(run_robots) FROM results GROUP BY robots, mode ORDER BY "
               "robots");
  REQUIRE(query.Step());
  CHECK(query.GetInteger(0) == 5);
  CHECK(query.GetText(1) == "1");
  CHECK(query.GetReal(2) == 2.0);
  CHECK(query.GetText(4) == "integer");
  REQUIRE(query.Step());
  CHECK(query.GetInteger(0) == 10);
  CHECK(query.GetText(1) == "fast");
  CHECK(query.GetReal(2) == 5.0);
  CHECK(query.GetText(3) == "integer");
  CHECK(query.GetText(4) == "text");
  CHECK(query.GetReal(5) == 0.5);
  CHECK(query.GetInteger(6) == 10);
  CHECK_FALSE(query.Step());
}

TEST_CASE("result store: seeds and levels can be added later", "[campaign][store]") {
  SFixture fixture;
  fixture.Store->Add({MakeRun(fixture.Id(3), 1, 4.0)});
  const UInt32 id = fixture.Id(3);
  const std::string key = fixture.Key(3);
  fixture.Campaign = ReadTestCampaign(fixture.Folder, R"(<factors>
  <factor name="robots" path="//distribute/entity/@quantity" values="1, 10, 20"/>
  <factor name="mode" path="//lua_controller[@id='forage']/params/@speed" values="fast"/>
  </factors><runs seeds="3"/>)");
  CHECK(fixture.Store->Register(fixture.Campaign, false).empty());
  CHECK(fixture.Store->GetCombinationId(key) == id);
  CHECK(fixture.Store->IsStored(key, 1));
  const auto combinations = fixture.Store->ListCombinations();
  REQUIRE(combinations.size() == 3);
  CHECK(combinations[0].Values == TTexts{"1", "fast"});
  CHECK(combinations[1].Id == id);
}

TEST_CASE("result store: combinations with runs stay", "[campaign][store]") {
  SFixture fixture;
  fixture.Store->Add({MakeRun(fixture.Id(0), 1, 4.0)});
  fixture.Campaign.Combinations.erase(fixture.Campaign.Combinations.begin());
  CHECK_THAT(fixture.Store->Register(fixture.Campaign, false),
             Contains("1 combination(s) of earlier runs are no longer in the campaign"));
  const auto combinations = fixture.Store->ListCombinations();
  REQUIRE(combinations.size() == 4);
  CHECK(combinations[3].Values == TTexts{"5", "1"});
}

TEST_CASE("result store: a changed experiment is refused, or a new generation",
          "[campaign][store]") {
  SFixture fixture;
  fixture.Store->Add({MakeRun(fixture.Id(0), 1, 4.0)});
  CHECK(fixture.Store->Register(fixture.Campaign, false).empty());
  const SCampaign changed = fixture.Changed();
  const std::string text = CatchText([&] { fixture.Store->Register(changed, false); });
  CHECK_THAT(text, Contains("test.argos has changed since the runs of 2") &&
                       Contains("(line 5: '<experiment length=\"20\" ticks_per_second=\"10\" "
                                "random_seed=\"1\" />' instead of '<experiment length=\"10\"") &&
                       Contains("--accept-change"));
  CHECK(fixture.Store->IsStored(fixture.Key(0), 1));

  CHECK(fixture.Store->Register(changed, true).empty());
  CHECK_FALSE(fixture.Store->IsStored(fixture.Key(0), 1));
  CHECK(fixture.Store->ListRuns().empty());
  CHECK(fixture.Store->ListMetrics().empty());
  CHECK(fixture.Store->CountOlderRuns() == 1);
  fixture.Store->Add({MakeRun(fixture.Id(0), 1, 5.0)});
  REQUIRE(fixture.Store->ListRuns().size() == 1);
  CHECK(fixture.Store->ListRuns()[0].Generation == 2);
  CHECK(fixture.Store->ReadMetric("delivered")[0].Value == 5.0);
  // the accepted experiment is now the right one
  CHECK(fixture.Store->Register(changed, false).empty());
}

TEST_CASE("result store: other factors are refused", "[campaign][store]") {
  SFixture fixture;
  fixture.Campaign.Factors[1].Name = "speed";
  CHECK_THAT(CatchText([&] { fixture.Store->Register(fixture.Campaign, true); }),
             Contains("has the factors \"robots\", \"mode\", but \"") &&
                 Contains("has \"robots\", \"speed\": choose another name for the results"));
  CHECK(fixture.Store->ListFactors() == TTexts{"robots", "mode"});
}

TEST_CASE("result store: changed scripts and metrics are warnings", "[campaign][store]") {
  SFixture fixture;
  // beside the experiment, after the first registration: no warning of what was not there
  fixture.Folder.Write("forage.lua", "-- 1");
  CHECK(fixture.Store->Register(fixture.Campaign, false).empty());
  fixture.Store->Register(fixture.Changed(), true);
  fixture.Folder.Write("forage.lua", "-- 2");
  fixture.Campaign.Metrics.emplace_back().Name = "delivered";
  SCampaign changed = fixture.Changed();
  const std::string warnings = fixture.Store->Register(changed, false);
  CHECK_THAT(warnings, Contains("forage.lua changed since the runs of 2"));
  CHECK_THAT(warnings, Contains("test.xml: <collect> has changed"));
  CHECK_THAT(warnings, !Contains("guard.lua"));
}

}  // namespace result_store_test
