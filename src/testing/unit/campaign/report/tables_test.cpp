#include "synthetic_campaign.h"

#include <argos3/campaign/report/comparisons.h>
#include <argos3/campaign/report/equal_levels.h>
#include <argos3/campaign/report/page_parts.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/report/summary_tables.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace argos::report_tables_test {

namespace {

constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();
using Catch::Contains;
using Catch::WithinAbs;

}  // namespace

TEST_CASE("summary tables: numbers of each combination", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"10", "5"}}});
  campaign.AddRuns(1, "food", {1, 2, 3, 4, 5}, "items");
  campaign.AddRuns(0, "food", {11, kNone, 13}, "items");
  const std::vector<SSummaryRow> rows = SummarizeMetric(campaign.Open(), "food");
  REQUIRE(rows.size() == 2);
  CHECK(rows[1].Summary.Count == 5);
  CHECK(rows[1].Summary.Mean == 3.0);
  CHECK_THAT(rows[1].Summary.StandardDeviation, WithinAbs(std::sqrt(2.5), 1e-15));
  CHECK(rows[1].Summary.LowerQuartile == 2.0);
  // 3 -+ t(4, 0.975) sqrt(2.5 / 5), t = 2.776445 of published tables
  CHECK_THAT(rows[1].MeanInterval->Lower, WithinAbs(3 - 2.776445 * std::sqrt(0.5), 1e-6));
  CHECK_THAT(rows[1].MeanInterval->Upper, WithinAbs(3 + 2.776445 * std::sqrt(0.5), 1e-6));
  CHECK(rows[1].BootstrapInterval->Lower > 1.0);
  CHECK(rows[1].BootstrapInterval->Lower < 3.0);
  CHECK(rows[0].Summary.Count == 2);
  CHECK(rows[0].Summary.NumMissing == 1);
  CHECK(rows[0].Summary.Median == 12.0);
}

TEST_CASE("summary tables: one value has no interval, an infinite one is named",
          "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddRuns(0, "food", {4});
  campaign.AddRuns(1, "food", {1, std::numeric_limits<Real>::infinity()});
  const std::vector<SSummaryRow> rows = SummarizeMetric(campaign.Open(), "food");
  CHECK(rows[0].Summary.Mean == 4.0);
  CHECK_FALSE(rows[0].MeanInterval.has_value());
  CHECK(rows[0].Problem.empty());
  CHECK_THAT(rows[1].Problem, Contains("inf"));
}

TEST_CASE("summary tables: success rates have Wilson's intervals", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddRuns(0, "food", {1, 2, 3, 4, 5, 6});
  SStoredRun crash;
  crash.Seed = 7;
  crash.Result.Status = ERunStatus::Crashed;
  campaign.AddRun(0, crash);
  const std::vector<SRateRow> rows = ComputeSuccessRates(campaign.Open());
  CHECK(rows[0].NumDone == 6);
  CHECK(rows[0].NumRuns == 7);
  // by hand from Wilson's formula with z = 1.959964
  CHECK_THAT(rows[0].Interval->Lower, WithinAbs(0.48687, 1e-5));
  CHECK_THAT(rows[0].Interval->Upper, WithinAbs(0.97432, 1e-5));
  CHECK(rows[1].NumRuns == 0);
  CHECK_FALSE(rows[1].Interval.has_value());
}

TEST_CASE("comparisons: two levels by ranks, for each level of another factor",
          "[campaign][report]") {
  CSyntheticCampaign campaign({{"speed", {"1", "2"}}, {"robots", {"5", "10"}}});
  campaign.AddRuns(0, "food", {1, 2, 3, 4, 5}, "items");
  campaign.AddRuns(1, "food", {11, 12, 13, 14, 15}, "items");
  campaign.AddRuns(2, "food", {1, 2, 3});
  campaign.AddRuns(3, "food", {1.5, 2.5, kNone, 3.5});
  const SComparisonTable table = CompareLevels(campaign.Open(), {"food", "robots", false, 0});
  REQUIRE(table.Results.size() == 2);
  CHECK(table.Results[0].Context == "speed = 1");
  REQUIRE(table.Results[0].Pairs.size() == 1);
  const SPairComparison& pair = table.Results[0].Pairs[0];
  CHECK(pair.First == "5");
  CHECK(pair.Second == "10");
  // of the 252 orders of 5 + 5 values, two are as extreme
  CHECK_THAT(pair.PValue, WithinAbs(2.0 / 252.0, 1e-12));
  CHECK_THAT(pair.Estimate, WithinAbs(10.0, 1e-12));
  // the third of the sorted differences 6, 7, 7, 8, ...; 4 of 252 orders lie outside on each side
  CHECK_THAT(pair.Interval.Lower, WithinAbs(7.0, 1e-12));
  CHECK_THAT(pair.Interval.Upper, WithinAbs(13.0, 1e-12));
  CHECK_THAT(pair.Interval.Level, WithinAbs(1.0 - 8.0 / 252.0, 1e-12));
  CHECK(
      DescribePair(table, pair) ==
      "Values at robots = 10 are greater than at robots = 5 by 10 items (96.8 % interval 7 to 13, "
      "p = 0.0079).");
  CHECK(DescribeResult(table, table.Results[0]) ==
        "food depends on robots (p = 0.0079, W = 25; Wilcoxon's rank-sum test).");
  CHECK(table.Results[1].NumMissing == 1);
  CHECK_THAT(DescribePair(table, table.Results[1].Pairs[0]),
             Contains("No difference was found between robots = 5 and robots = 10"));
}

TEST_CASE("comparisons: pairs by seed", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  // of the seeds 1 to 6; the last one lacks a value
  campaign.AddRuns(0, "food", {100, 200, 300, 400, 500, 600});
  campaign.AddRuns(1, "food", {101, 202, 303, 404, 505, kNone});
  const SComparisonTable table = CompareLevels(campaign.Open(), {"food", "robots", true, 0});
  REQUIRE(table.Results.size() == 1);
  CHECK(table.Results[0].Test == "Wilcoxon's signed-rank test");
  CHECK(table.Results[0].Statistic == "V = 15");
  CHECK(table.Results[0].NumMissing == 1);
  // two of 2^5 sign patterns are as extreme
  CHECK_THAT(table.Results[0].PValue, WithinAbs(2.0 / 32.0, 1e-12));
  CHECK_THAT(table.Results[0].Pairs[0].Estimate, WithinAbs(3.0, 1e-12));
}

TEST_CASE("comparisons: more levels by Kruskal and Wallis, and Dunn", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10", "20"}}});
  campaign.AddRuns(0, "food", {1, 2, 3, 4, 5});
  campaign.AddRuns(1, "food", {11, 12, 13, 14, 15});
  campaign.AddRuns(2, "food", {21, 22, 23, 24, 25});
  CReportData& data = campaign.Open();
  const SComparisonTable table = CompareLevels(data, {"food", "robots", false, 0});
  const SComparisonResult& result = table.Results.at(0);
  // 12 / (15 16) (15^2 + 40^2 + 65^2) / 5 - 3 16 = 12.5; chi square with 2 degrees: exp(-H / 2)
  CHECK(result.Statistic == "H = 12.5, 2 degrees of freedom");
  CHECK_THAT(result.PValue, WithinAbs(std::exp(-6.25), 1e-12));
  REQUIRE(result.Pairs.size() == 3);
  // z = 5 / sqrt(8) and 10 / sqrt(8), two sides, times 2 and 3 by Holm's method
  CHECK_THAT(result.Pairs[0].PValue,
             WithinAbs(2 * std::erfc(5 / std::sqrt(8.0) / std::sqrt(2.0)), 1e-10));
  CHECK_THAT(result.Pairs[1].PValue,
             WithinAbs(3 * std::erfc(10 / std::sqrt(8.0) / std::sqrt(2.0)), 1e-10));
  CHECK_THAT(result.Pairs[1].Estimate, WithinAbs(20.0, 1e-12));
  // paired: all 5 seeds rank the levels equally, so that Friedman's statistic is 5 (3 - 1)
  const SComparisonTable paired = CompareLevels(data, {"food", "robots", true, 0});
  CHECK(paired.Results.at(0).Statistic == "chi square = 10, 2 degrees of freedom");
}

TEST_CASE("comparisons: errors name what is wrong", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}, {"speed", {"1"}}});
  campaign.AddRuns(0, "delivered", {1, 2});
  CReportData& data = campaign.Open();
  const auto messageOf = [&data](const SComparison& request) -> std::string {
    try {
      CompareLevels(data, request);
    } catch (const CARGoSException& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(messageOf({"deliverd", "robots", false, 0}),
             Contains("no run has recorded the metric \"deliverd\"; did you mean \"delivered\"?"));
  CHECK_THAT(messageOf({"delivered", "robot", false, 0}),
             Contains("there is no factor \"robot\"; did you mean \"robots\"?"));
  CHECK_THAT(messageOf({"delivered", "speed", false, 0}),
             Contains("the factor \"speed\" has one level only"));
  const SComparisonTable table = CompareLevels(data, {"delivered", "robots", false, 0});
  CHECK(table.Results.at(0).Problem == "there is no value at the level 10");
}

TEST_CASE("report text: numbers below a million have no exponent", "[campaign][report]") {
  CHECK(FormatNumber(0.123456) == "0.1235");
  CHECK(FormatNumber(1000.0) == "1000");
  CHECK(FormatNumber(9999.96) == "10000");
  CHECK(FormatNumber(-12345.6) == "-12346");
  CHECK(FormatNumber(2e6) == "2e+06");
  CHECK(FormatNumber(std::nan("")) == "-");
}

TEST_CASE("report text: users' text is escaped", "[campaign][report]") {
  CHECK(EscapeHTML("<a href='x'>&\"\x01\xff") ==
        "&lt;a href=&#39;x&#39;&gt;&amp;&quot;\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(EscapeHTML("\xC3\xA9\xE2\x82\xAC") == "\xC3\xA9\xE2\x82\xAC");
  // overlong, surrogate
  CHECK(EscapeHTML("\xC0\xBC") == "\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(EscapeHTML("\xED\xA0\x80") == "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(MakeLine("a\nb\tc") == "a b c");
  CHECK(QuoteField("a,\"b\"") == "\"a,\"\"b\"\"\"");
  CHECK(FormatPValue(0.0123) == "p = 0.012");
  CHECK(FormatPValue(1e-9) == "p < 0.001");
  CHECK(FormatDuration(3725) == "1 h 2 min");
}

namespace {

// the cells of a page's rows, "a | b\n" for each
std::string ListCells(std::string page) {
  for (const auto& [tag, text] :
       {std::pair("</td><td", " | <"), {"</li>\n", "\n"}, {"</b>", " "}}) {
    for (size_t at = page.find(tag); at != std::string::npos; at = page.find(tag)) {
      page.replace(at, std::string(tag).size(), text);
    }
  }
  std::string cells;
  bool isTag = false;
  for (const char c : page) {
    isTag = isTag || c == '<';
    if (!isTag) {
      cells += c;
    }
    isTag = isTag && c != '>';
  }
  return cells;
}

}  // namespace

TEST_CASE("report page: overview and machines have the sums of all runs", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  struct SRun {
    size_t Combination;
    const char* Machine;
    Real RealTime, CPUTime;  // s
    UInt64 Memory;  // MiB
    ERunStatus Status;
  };
  UInt32 seed = 0;
  for (const SRun& c : {SRun{0, "one", 10.5, 20.25, 64, ERunStatus::Done},
                        SRun{0, "one", 30.0, 40.5, 256, ERunStatus::Crashed},
                        SRun{1, "one", 2.0, 3.0, 128, ERunStatus::Done},
                        SRun{1, "two", 4000.0, 0.5, 32, ERunStatus::Done}}) {
    SStoredRun run;
    run.Seed = ++seed;
    run.Machine = c.Machine;
    run.Version = "1.0";
    run.Result.Status = c.Status;
    run.Result.TotalWallTime = c.RealTime;
    run.Result.CPUTime = c.CPUTime;
    run.Result.PeakMemory = c.Memory << 20U;
    campaign.AddRun(c.Combination, run);
  }
  const CReportData& data = campaign.Open();
  const std::string overview = ListCells(MakeOverview(data));
  // 4042.5 s, 64.25 s
  CHECK_THAT(overview, Contains("; runs from 2026-01-31T12:00:00Z to 2026-01-31T12:00:00Z") &&
                           Contains("4 runs\n1 failed\n2 combinations\n1 h 7 min real time") &&
                           Contains("1 min 4 s CPU time"));
  CHECK_THAT(overview, !Contains("no runs") && !Contains("left out"));
  const std::string machines = ListCells(MakeMachines(data));
  CHECK_THAT(machines, Contains("one | 1.0 | 3 | 42.5 s | 1 min 4 s | 256 MiB\n"));
  CHECK_THAT(machines, Contains("two | 1.0 | 1 | 1 h 6 min | 0.5 s | 32 MiB\n"));
}

TEST_CASE("report page: the set-up lists factors, seeds and limits", "[campaign][report]") {
  CSyntheticCampaign synthetic({{"robots", {"5", "10"}}, {"noise", {"0.5"}}});
  SCampaign& campaign = synthetic.GetCampaign();
  campaign.Constants = {{"//experiment/@length", "100"}};
  const auto setUp = [&synthetic] { return ListCells(MakeSetUp(synthetic.Open())); };
  std::string text = setUp();
  CHECK_THAT(text, Contains("robots | 5, 10 | //robots/@value\nnoise | 0.5 | //noise/@value\n"));
  CHECK_THAT(text, Contains("changed | //experiment/@length = 100\n"));
  CHECK_THAT(text, Contains("combinations | 2\n") && Contains("seeds | 1 to 3, 7\n"));
  CHECK_THAT(text, Contains("limits of a run | real time unlimited, output 10 MiB\n"));
  CHECK_THAT(text, Contains("runs at the same time | one for each processor\n"));
  campaign.Limits = {90.0, 512U << 20U, 1U << 20U};
  campaign.NumExcluded = 3;
  campaign.Jobs = 4;
  campaign.Stopping.Metric = "food";
  campaign.Stopping.Width = 2.5;
  campaign.Stopping.FirstSeed = 20;
  text = setUp();
  CHECK_THAT(text, Contains("combinations | 2, 3 excluded\n"));
  CHECK_THAT(text, Contains("real time 1 min 30 s, memory 512 MiB, output 1 MiB\n"));
  CHECK_THAT(text, Contains("runs at the same time | 4\n"));
  CHECK_THAT(text, Contains("from 20 on, until the 95 % interval of the mean of food is at most "
                            "2.5 wide; 10 to 1000 runs\n"));
  campaign.Stopping.Width = 0.0;
  campaign.Stopping.Relative = 0.05;
  CHECK_THAT(setUp(), Contains("is within 5 % of the mean to each side"));
}

TEST_CASE("report page: at most 50 failed runs and 40 levels are listed", "[campaign][report]") {
  const size_t count = GENERATE(40, 51);
  std::vector<std::string> levels;
  for (size_t i = 0; i < count; ++i) {
    levels.push_back(std::to_string(i + 1));
  }
  CSyntheticCampaign campaign({{"robots", levels}});
  for (size_t i = 0; i < count; ++i) {
    SStoredRun run;
    run.Seed = 1;
    run.Result.Status = ERunStatus::Failed;
    run.Result.ExitStatus = 3;
    campaign.AddRun(i, run);
  }
  const CReportData& data = campaign.Open();
  const std::string failed = MakeFailedRuns(data);
  CHECK_THAT(failed, Contains("<h3>robots = 40, seed 1: <span class=\"status\">failed, exit status "
                              "3</span></h3>"));
  CHECK_THAT(failed, !Contains("End of the output"));
  CHECK((failed.find("robots = 51") == std::string::npos));
  CHECK((failed.find("<p>And 1 more;") != std::string::npos) == (count == 51));
  const std::string setUp = ListCells(MakeSetUp(data));
  CHECK_THAT(setUp,
             Contains(count == 51 ? ", 39, 40, ... (51 in all) | //" : ", 39, 40 | //robots"));
}

TEST_CASE("report page: the first run is the earliest; without factors there is no table of them",
          "[campaign][report]") {
  CSyntheticCampaign campaign(std::vector<std::pair<std::string, std::vector<std::string>>>{});
  campaign.AddRuns(0, "food", {1, 2, 3});
  const CReportData& opened = campaign.Open();
  CHECK_THAT(MakeSetUp(opened), !Contains("<th class=\"text\">factor</th>"));
  {
    CResultStore store(campaign.GetCampaign().ResultsFile, CResultStore::EMode::Write);
    SStoredRun run;
    run.Combination = store.GetCombinationId(campaign.GetCampaign().Combinations[0].ComputeKey());
    run.Seed = 8;
    run.Started = "2026-01-30T12:00:00Z";
    run.Result.Status = ERunStatus::Done;
    store.Add({run});
  }
  CHECK_THAT(MakeOverview(CReportData(campaign.GetCampaign(), campaign.GetStore())),
             Contains("from 2026-01-30T12:00:00Z to 2026-01-31T12:00:00Z"));
}

TEST_CASE("report page: metrics without numbers and runs without values are named",
          "[campaign][report]") {
  CSyntheticCampaign campaign({{"speed", {"1", "2"}}, {"robots", {"5", "10"}}});
  campaign.AddRuns(0, "food", {1, 2, 3, 4, 5, 6}, "items");
  campaign.AddRuns(1, "food", {11, 12, 13, 14, 15, kNone}, "items");
  campaign.AddRuns(2, "food", {1, std::numeric_limits<Real>::infinity()});
  campaign.GetCampaign().Comparisons = {
      {"food", "robots", false, 0}, {"food", "robots", true, 0}, {"fod", "robots", false, 0}};
  const CReportData& data = campaign.Open();
  const std::vector<SComparisonTable> tables = CompareAll(data);
  REQUIRE(tables.size() == 3);
  const std::string page = MakeComparisonSection(tables);
  CHECK_THAT(page, Contains("<h3>food by robots</h3>\n<p><b>speed = 1</b></p>\n"));
  CHECK_THAT(page, Contains("<p class=\"quiet\">1 run left out: without the value.</p>"));
  CHECK_THAT(page, Contains("1 seed left out: without a value at every level.</p>"));
  CHECK_THAT(page,
             Contains("<p><b>speed = 2</b></p>\n<p>Not tested: there is no value at the level "
                      "10.</p>\n<h3>"));
  CHECK_THAT(page, Contains("Not tested: no seed has a value at every level."));
  CHECK_THAT(page, Contains("<p class=\"notice\">Not compared: no run has recorded the metric "
                            "&quot;fod&quot;; did you mean &quot;food&quot;?.</p>"));
  const std::string csv = MakeComparisonCSV(tables);
  // the fields of each line are as many as those of the first one
  CHECK_THAT(csv, Contains("\nfood,robots,false,speed = 2,,,,,,,,,,,,,there is no value at the "
                           "level 10\n"));
  CHECK_THAT(csv, Contains("\nfod,robots,false,,,,,,,,,,,,,,"));
  const std::string metrics = MakeMetricTables(data);
  CHECK_THAT(metrics, Contains("<td class=\"text\">2</td><td class=\"text\">5</td>"
                               "<td class=\"note\" colspan=\"8\">") &&
                          Contains("inf"));
}

TEST_CASE("equal levels: five of them are named, of runs that are done", "[campaign][report]") {
  std::vector<std::string> levels;
  for (int i = 1; i <= 9; ++i) {
    levels.push_back(std::to_string(i));
  }
  CSyntheticCampaign campaign({{"gain", levels}, {"size", {"1"}}});
  for (size_t i = 0; i < levels.size(); ++i) {
    SStoredRun run;
    run.Seed = 1;
    // 8 differs; robots that were stopped are no failure, a crash is one
    run.Result.Status = i == 1   ? ERunStatus::RobotsStopped
                        : i == 8 ? ERunStatus::Crashed
                                 : ERunStatus::Done;
    run.Result.Digest = i == 7 ? 6 : 5;
    campaign.AddRun(i, run);
  }
  const std::vector<std::string> warnings = WarnOfEqualLevels(campaign.Open());
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0],
             Contains("the levels 1, 2, 3, 4, 5 and 2 others of the factor \"gain\" have equal "
                      "final states (digests) in all 6 pairs of runs: it seems to be without"));
  // one pair, of two levels
  std::vector<SCombination>& combinations = campaign.GetCampaign().Combinations;
  combinations.erase(combinations.begin() + 2, combinations.end());
  const std::vector<std::string> two =
      WarnOfEqualLevels(CReportData(campaign.GetCampaign(), campaign.GetStore()));
  REQUIRE(two.size() == 1);
  CHECK_THAT(two[0],
             Contains("the levels 1 and 2 of the factor") && Contains("in the only pair of runs"));
}

TEST_CASE("comparisons: no levels without a partner", "[campaign][report]") {
  CSyntheticCampaign campaign({{"speed", {"1", "2"}}, {"robots", {"5", "10"}}});
  campaign.AddRuns(0, "food", {1, 2, 3, 4, 5});
  campaign.AddRuns(1, "food", {11, 12, 13, 14, 15});
  campaign.AddRuns(2, "food", {21, 22, 23});
  // with 5 and 10 robots at speed 1, only 5 at speed 2
  std::vector<SCombination>& combinations = campaign.GetCampaign().Combinations;
  combinations.pop_back();
  const SComparisonTable table = CompareLevels(campaign.Open(), {"food", "robots", false, 0});
  REQUIRE(table.Results.size() == 1);
  CHECK(table.Results[0].Context == "speed = 1");
  // 10 robots at speed 1, and 5 at speed 2
  combinations.erase(combinations.begin());
  const CReportData data(campaign.GetCampaign(), campaign.GetStore());
  CHECK_THROWS_WITH(CompareLevels(data, {"food", "robots", false, 0}),
                    Contains("no two combinations differ in \"robots\" only"));
}

}  // namespace argos::report_tables_test
