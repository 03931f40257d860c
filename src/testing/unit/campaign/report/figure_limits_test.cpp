// What figures cap, leave out and refuse.

#include "synthetic_campaign.h"

#include <argos3/campaign/report/figure_drawing.h>
#include <argos3/campaign/report/figure_request.h>
#include <argos3/campaign/report/figures.h>

#include <catch2/catch.hpp>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace argos::figure_limits_test {

namespace {

constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
using Catch::Contains;

std::vector<std::string> MakeLevels(size_t count) {
  std::vector<std::string> levels;
  for (size_t i = 0; i < count; ++i) {
    levels.push_back(std::to_string(i + 1));
  }
  return levels;
}

}  // namespace

TEST_CASE("figures: whiskers end at the last values in reach, or at the box",
          "[campaign][report]") {
  const auto [values, row] = GENERATE(table<std::vector<Real>, std::string>({
      // the quartiles are 75 and 100, the reach is 37.5; the last value in reach is in the box
      {{0, 100, 100, 100}, "0 75 75 100 100 100 4\n"},
      {{0, 0, 0, 100}, "0 0 0 0 25 25 4\n"},
      // -94 is below 2 - 1.5 2, and -1 is where the reach ends
      {{-94, -1, 2, 3, 3, 3, 4, 4, 4}, "0 -1 2 3 4 4 9\n"},
      {{4, 4, 4, 3, 3, 3, 2, 7, 100}, "0 2 3 4 4 4 9\n"},
      // infinite and missing values do not count
      {{1, 2, 3, kInfinity, kNone}, "0 1 1.5 2 2.5 3 3\n"},
  }));
  CSyntheticCampaign campaign({{"robots", MakeLevels(1)}});
  campaign.AddRuns(0, "food", values);
  CHECK_THAT(MakeFigure(campaign.Open(), MakeRequest("boxplot", "food", "robots")).Data,
             Contains("number of values\n" + row));
}

TEST_CASE("figures: boxes of more than 100 values are drawn without points", "[campaign][report]") {
  const size_t count = GENERATE(100, 101);
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddRuns(0, "food", std::vector<Real>(count, 3.0));
  campaign.AddRuns(1, "food", {1, 2});
  const SFigureDraft draft = MakeFigure(campaign.Open(), MakeRequest("boxplot", "food", "robots"));
  const bool hasPoints = count == 100;
  CHECK((draft.Script.find(" with points ") != std::string::npos) == hasPoints);
  CHECK((draft.Caption.find("Points are the runs.") != std::string::npos) == hasPoints);
}

TEST_CASE("figures: widths of boxes share a level, and a single one is at most 0.45 wide",
          "[campaign][report]") {
  const auto [kinds, width] = GENERATE(
      table<size_t, std::string>({{1, "0.45"}, {2, "0.34"}, {4, "0.17"}}));  // 0.85 0.8 / kinds
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}, {"kind", MakeLevels(kinds)}});
  campaign.AddRuns(0, "food", {1, 2});
  CHECK_THAT(MakeFigure(campaign.Open(), MakeRequest("boxplot", "food", "robots", "kind")).Script,
             Contains("set boxwidth " + width + '\n'));
}

TEST_CASE("figures: the colours of nine groups can be told apart", "[campaign][report]") {
  const size_t count = GENERATE(9, 10);
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}, {"kind", MakeLevels(count)}});
  campaign.AddRuns(0, "food", {1, 2});
  campaign.AddSeries(0, 9, {"spread", "m", {1}, {1}});
  const CReportData& data = campaign.Open();
  const SFigureRequest request = MakeRequest("boxplot", "food", "robots", "kind");
  const std::vector<SFigureRequest> requests = ListFigureRequests(data);
  REQUIRE(requests.size() == 2);
  if (count == 9) {
    CHECK_NOTHROW(MakeFigure(data, request));
    CHECK(requests[0].Group == "kind");
  } else {
    CHECK_THROWS_WITH(MakeFigure(data, request),
                      Contains("group=\"kind\": the factor has 10 levels; the colours of at most 9 "
                               "groups can be told apart"));
    // a report without <figures> has no groups then
    CHECK(requests[0].Group.empty());
  }
  CHECK(requests[1].Group == "robots");
}

TEST_CASE("figures: a campaign without varied factors has series only", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", MakeLevels(1)}});
  campaign.AddRuns(0, "food", {1, 2});
  campaign.AddSeries(0, 9, {"spread", "m", {1}, {1}});
  const std::vector<SFigureRequest> requests = ListFigureRequests(campaign.Open());
  REQUIRE(requests.size() == 1);
  CHECK(requests[0].Kind == "series");
  CHECK(requests[0].Group.empty());
}

TEST_CASE("figures: names of files have at most 100 plain letters", "[campaign][report]") {
  SFigureRequest request = MakeRequest("means", "food per\xC3\xA9/min", "robots", "kind");
  CHECK(MakeFigureName(request) == "means_food-per---min_robots_kind");
  request.File = "aZ09_-.b";
  CHECK(MakeFigureName(request) == "aZ09_--b");
  request.File = std::string(100, 'a') + "b";
  CHECK(MakeFigureName(request) == std::string(100, 'a'));
  request.File.pop_back();
  CHECK(MakeFigureName(request) == std::string(100, 'a'));
}

TEST_CASE("figures: attributes of the campaign file have ranges and words", "[campaign][report]") {
  const SCampaign campaign;
  const auto read = [&campaign](const std::string& name, const std::string& value) {
    return MakeFigureRequest(campaign, {"means", {{name, value}}, 7});
  };
  CHECK(read("width", "100").Width == 100);
  CHECK(read("height", "4000").Height == 4000);
  CHECK(read("scale", "log").IsLogarithmic);
  CHECK_FALSE(read("scale", "linear").IsLogarithmic);
  CHECK(read("xscale", "log").IsXLogarithmic);
  CHECK_FALSE(read("xscale", "linear").IsXLogarithmic);
  CHECK(read("bars", "deviation").HasDeviationBars);
  CHECK_FALSE(read("bars", "interval").HasDeviationBars);
  CHECK(read("band", "interval").ShowsInterval);
  CHECK_FALSE(read("band", "quartiles").ShowsInterval);
  CHECK(read("ended", "hold").EndedRuns == EEndedRuns::Hold);
  CHECK(read("ended", "drop").EndedRuns == EEndedRuns::Drop);
  CHECK(read("ended", "survivors").EndedRuns == EEndedRuns::Survivors);
  CHECK(read("reference", "-2.5").Reference == -2.5);
  const auto [name, value, message] = GENERATE(table<std::string, std::string, std::string>({
      {"width", "99", "\"width\": \"99\" is no number of pixels from 100 to 4000"},
      {"height", "4001", "\"height\": \"4001\" is no number of pixels"},
      {"height", "high", "\"height\": \"high\" is no number of pixels"},
      {"scale", "sqrt", "\"scale\": \"sqrt\" is neither linear nor log"},
      {"bars", "sd", "\"bars\": \"sd\" is neither interval nor deviation"},
      {"ended", "keep", "\"ended\": \"keep\" is none of survivors, hold and drop"},
      {"reference", "inf", "\"reference\": \"inf\" is no finite number"},
  }));
  CHECK_THROWS_WITH(read(name, value), Contains(message) && Contains(":7: <means>"));
}

TEST_CASE("figures: a range of one value is widened", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}, {"speed", {"1"}}});
  const auto [value, logarithmic, linear] = GENERATE(table<Real, std::string, std::string>({
      // a factor of 1.2 to each side, in which there is one round number
      {50, "set logscale cb\nset cbrange [20:100]\n", "set cbrange [45:55]\n"},
      {0, "", "set cbrange [-1e-09:1e-09]\n"},
  }));
  campaign.AddRuns(0, "food", {value});
  campaign.AddRuns(1, "food", {value, kInfinity});
  SFigureRequest map = MakeRequest("heatmap", "speed", "robots");
  map.Z = "food";
  const CReportData& data = campaign.Open();
  CHECK_THAT(MakeFigure(data, map).Script, Contains(linear));
  map.IsLogarithmic = true;
  if (value > 0) {
    CHECK_THAT(MakeFigure(data, map).Script, Contains(logarithmic));
  } else {
    CHECK_THROWS_WITH(MakeFigure(data, map), Contains("\"food\" has the value 0"));
  }
}

TEST_CASE("figures: a heat map needs two factors, and has numbers in up to 100 cells",
          "[campaign][report]") {
  const size_t count = GENERATE(10, 11);
  CSyntheticCampaign campaign({{"a", MakeLevels(count)}, {"b", MakeLevels(10)}});
  for (size_t i = 0; i < 10 * count; ++i) {
    campaign.AddRuns(i, "food", {static_cast<Real>(i)});
  }
  SFigureRequest map = MakeRequest("heatmap", "b", "a");
  map.Z = "food";
  const CReportData& data = campaign.Open();
  CHECK((MakeFigure(data, map).Script.find(" with labels ") != std::string::npos) == (count == 10));
  map.Y = "a";
  CHECK_THROWS_WITH(MakeFigure(data, map),
                    Contains("needs two different factors, but x and y are both \"a\""));
}

TEST_CASE("figures: without a finite value there is none", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}, {"speed", {"1"}}});
  campaign.AddRuns(0, "food", {kInfinity, -kInfinity, kNone});
  const CReportData& data = campaign.Open();
  const auto [kind, y, z] = GENERATE(table<std::string, std::string, std::string>(
      {{"boxplot", "food", ""}, {"means", "food", ""}, {"heatmap", "speed", "food"}}));
  SFigureRequest request = MakeRequest(kind, y, "robots");
  request.Z = z;
  CHECK_THROWS_WITH(MakeFigure(data, request), Contains("no run has") && Contains("\"food\""));
}

TEST_CASE("figures: x may be a metric, of which only finite values count", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  const std::vector<std::pair<Real, Real>> runs = {{2, 10}, {4, 30}, {kInfinity, 1000}};
  for (size_t i = 0; i < runs.size(); ++i) {
    SStoredRun run;
    run.Seed = static_cast<UInt32>(i + 1);
    run.Result.Status = ERunStatus::Done;
    run.Result.Metrics = {{"energy", "J", runs[i].first}, {"food", "", runs[i].second}};
    campaign.AddRun(0, run);
  }
  SFigureRequest request = MakeRequest("means", "food", "energy");
  request.HasDeviationBars = true;
  const SFigureDraft draft = MakeFigure(campaign.Open(), request);
  // one point: x 3, mean 20, deviation sqrt(200)
  CHECK_THAT(draft.Data, Contains("number of runs\n# \n3 20 5.857864376 34.14213562 2\n\n\n"));
  // an axis of one value reaches 1 to each side
  CHECK_THAT(draft.Script, Contains("'energy (J)'") && Contains("set xrange [2:4]\n"));
}

TEST_CASE("figures: captions of means name the logarithmic axes", "[campaign][report]") {
  const auto [isX, isY, text] = GENERATE(table<bool, bool, std::string>({
      {true, true, "food against robots, logarithmic axes: means"},
      {true, false, "food against robots, logarithmic in robots: means"},
      {false, true, "food against robots, logarithmic in food: means"},
      {false, false, "food against robots: means"},
  }));
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddRuns(0, "food", {7, 9});
  SFigureRequest request = MakeRequest("means", "food", "robots");
  request.IsXLogarithmic = isX;
  request.IsLogarithmic = isY;
  CHECK_THAT(MakeFigure(campaign.Open(), request).Caption, Contains(text));
}

TEST_CASE("figures: a factor precedes a metric of its name", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddRuns(0, "robots", {7, 9});
  CHECK_THAT(MakeFigure(campaign.Open(), MakeRequest("means", "robots", "robots")).Data,
             Contains("\n5 8 "));
}

TEST_CASE("figures: a power law needs two points and three runs", "[campaign][report]") {
  const auto [first, second, isFitted] =
      GENERATE(table<std::vector<Real>, std::vector<Real>, bool>({
          {{1, 1, 1}, {}, false},
          {{1}, {10}, false},
          {{1, 1}, {10}, true},
      }));
  CSyntheticCampaign campaign({{"robots", {"1", "10"}}});
  campaign.AddRuns(0, "food", first);
  campaign.AddRuns(1, "food", second);
  const std::string script =
      MakeFigure(campaign.Open(), MakeRequest("scaling", "food", "robots")).Script;
  CHECK((script.find("exponent 1") != std::string::npos) == isFitted);
  CHECK((script.find(" * x ** ") != std::string::npos) == isFitted);
}

TEST_CASE("figures: times without a value stay empty", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddSeries(0, 1, {"spread", "m", {10, 20, 30}, {1, kNone, kNone}});
  campaign.AddSeries(0, 2, {"spread", "m", {10, 20, 30}, {1, kNone, 4}});
  SFigureRequest request = MakeRequest("series", "spread", "");
  request.ShowsInterval = GENERATE(false, true);
  CHECK_THAT(MakeFigure(campaign.Open(), request).Data,
             Contains("\n1 1 1 1 2\n2 NaN NaN NaN 0\n3 4 4 4 1\n"));
}

TEST_CASE("figures: time is in ticks if their rate is varied or unknown", "[campaign][report]") {
  const auto [kind, row, label] = GENERATE(table<std::string, std::string, std::string>({
      {"10 a second", "\n2 1 1 1 1\n", "'time (s)'"},
      {"varied", "\n20 1 1 1 1\n", "'time (ticks)'"},
      {"unknown", "\n20 1 1 1 1\n", "'time (ticks)'"},
  }));
  CSyntheticCampaign campaign({{"rate", {"5", "10"}}});
  if (kind == "varied") {
    for (SCombination& combination : campaign.GetCampaign().Combinations) {
      combination.Settings.push_back(
          {"//experiment/@ticks_per_second", combination.Values.front()});
    }
  } else if (kind == "unknown") {
    campaign.GetCampaign().ExperimentText = "<argos-configuration/>";
  }
  campaign.AddSeries(0, 1, {"spread", "m", {20}, {1}});
  const SFigureDraft draft = MakeFigure(campaign.Open(), MakeRequest("series", "spread", ""));
  CHECK_THAT(draft.Data, Contains(row));
  CHECK_THAT(draft.Script, Contains(label));
}

}  // namespace argos::figure_limits_test
