#include <argos3/campaign/execution/collected_columns.h>
#include <argos3/testing/unit/campaign/campaign_files.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace collected_columns_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

SCollectedMetric MakeFileMetric(const std::string& value, const std::string& time = "") {
  SCollectedMetric metric;
  metric.Source = SCollectedMetric::ESource::File;
  metric.Name = "food";
  metric.Pattern = "*.csv";
  metric.ValueColumn = value;
  metric.TimeColumn = time;
  metric.IsSeries = !time.empty();
  return metric;
}

SRunResult Collect(const std::string& text, const std::vector<SCollectedMetric>& metrics) {
  const CTemporaryFolder folder;
  folder.Write("a.csv", text);
  // the first by name counts
  folder.Write("b.csv", "food\n99\n");
  SRunResult result;
  CollectColumns(metrics, folder.Path(""), result);
  return result;
}

}  // namespace

TEST_CASE("collected columns: cells are separated and quoted in several ways",
          "[campaign][execution]") {
  const auto [text, expected] = GENERATE(table<std::string, Real>({
      {"tick,food\n1,2\n3,4.5\n", 4.5},
      {"tick, food ,x\n1 , 2 , 3\n", 2},
      {"tick;food\r\n1;2\r\n", 2},
      {"tick\tfood\n1\t2", 2},
      {"  tick   food \n  1   2  \n", 2},
      {"# argos3\n\ntick,food\n# food,tick\n1,2\n\n", 2},
      // a separator in a quoted cell belongs to it
      {"\"a,b c\",food\n\"1;2,3\",4\n", 4},
      // empty cells count, but not after the last separator
      {"a,b,food\n,,3\n", 3},
      {"a;;food\n1;;3\n", 3},
      {"a\t\tfood\n1\t\t3\n", 3},
      {"a,food\n1,-2e3,\n", -2000},
      {"food,a\n1,7\n", 1},
  }));
  CAPTURE(text);
  const SRunResult result = Collect(text, {MakeFileMetric("food")});
  REQUIRE(result.Metrics.size() == 1);
  CHECK(result.Metrics[0].Name == "food");
  CHECK(result.Metrics[0].Value == expected);
  CHECK(result.Series.empty());
}

TEST_CASE("collected columns: what is no number is missing", "[campaign][execution]") {
  const std::string row =
      GENERATE(std::string("1,"), std::string("1"), std::string("1,x"), std::string("1,2x"));
  const SRunResult result = Collect("tick,food\n1,5\n" + row + '\n', {MakeFileMetric("food")});
  CHECK(std::isnan(result.Metrics.at(0).Value));
  // no row at all
  CHECK(std::isnan(Collect("tick,food\n", {MakeFileMetric("food")}).Metrics.at(0).Value));
}

TEST_CASE("collected columns: series have whole ticks", "[campaign][execution]") {
  const SRunResult result =
      Collect("tick,food\n0,1\n10,\n4294967295,3\n", {MakeFileMetric("food", "tick")});
  REQUIRE(result.Series.size() == 1);
  CHECK(result.Series[0].Ticks == std::vector<UInt32>{0, 10, 4294967295});
  CHECK(result.Series[0].Values[0] == 1.0);
  CHECK(std::isnan(result.Series[0].Values[1]));
  // its last value is the number of the run, unless another metric of the name is
  REQUIRE(result.Metrics.size() == 1);
  CHECK(result.Metrics[0].Value == 3.0);
  SCollectedMetric number = MakeFileMetric("tick");
  const SRunResult both = Collect("tick,food\n5,1\n", {MakeFileMetric("food", "tick"), number});
  REQUIRE(both.Metrics.size() == 1);
  CHECK(both.Metrics[0].Value == 5.0);
  const std::string time = GENERATE("-1", "0.5", "4294967296", "x", "");
  CHECK_THAT(
      CatchText([&] { Collect("tick,food\n" + time + ",1\n", {MakeFileMetric("food", "tick")}); }),
      Contains("a.csv: times must be whole ticks, found "));
}

TEST_CASE("collected columns: files and columns that are missing are errors",
          "[campaign][execution]") {
  const auto collect = [](const std::string& text, const SCollectedMetric& metric) {
    return CatchText([&] { Collect(text, {metric}); });
  };
  CHECK_THAT(collect("tick,food\n", MakeFileMetric("foot")),
             Contains("a.csv has no column \"foot\"; did you mean \"food\"?"));
  CHECK_THAT(collect("tick,food\n", MakeFileMetric("food", "time")),
             Contains("a.csv has no column \"time\""));
  CHECK_THAT(collect("# tick,food\n\n", MakeFileMetric("food")),
             Contains("a.csv has no line with the names of columns"));
  SCollectedMetric metric = MakeFileMetric("food");
  metric.Pattern = "none*.csv";
  CHECK_THAT(collect("", metric), Contains("has written no file \"none*.csv\""));
}

}  // namespace collected_columns_test
