#include "synthetic_campaign.h"

#include <argos3/campaign/report/campaign_report.h>
#include <argos3/campaign/report/figure_drawing.h>
#include <argos3/campaign/report/figure_request.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/input_file.h>

#include <catch2/catch.hpp>

#include <stdlib.h>

#include <filesystem>
#include <set>

namespace argos::figures_test {

namespace {

using Catch::Contains;

std::string Read(const std::string& path) {
  std::string content;
  std::string problem;
  REQUIRE(ReadInputFile(path, content, problem));
  return content;
}

// the names of all elements
void CollectNames(TConfigurationNode& node, std::set<std::string>& names) {
  names.insert(node.Value());
  TConfigurationNodeIterator child;
  for (child = child.begin(&node); child != child.end(); ++child) {
    CollectNames(*child, names);
  }
}

/** For its lifetime, no program is found. */
class CEmptyPath {
 public:
  CEmptyPath() : m_path(getenv("PATH")) { setenv("PATH", "", 1); }
  ~CEmptyPath() { setenv("PATH", m_path.c_str(), 1); }
  CEmptyPath(const CEmptyPath&) = delete;
  CEmptyPath& operator=(const CEmptyPath&) = delete;

 private:
  std::string m_path;
};

}  // namespace

TEST_CASE("figures: a box has quartiles and whiskers", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddRuns(0, "food", {1, 2, 3, 4, 5, 100});
  campaign.AddRuns(1, "food", {7});
  const SFigureDraft draft = MakeFigure(campaign.Open(), MakeRequest("boxplot", "food", "robots"));
  // quartiles of definition 7: 2.25, 3.5, 4.75; 100 is beyond 4.75 + 1.5 2.5
  CHECK_THAT(draft.Data, Contains("\n0 1 2.25 3.5 4.75 5 6\n1 7 7 7 7 7 1\n"));
  CHECK_THAT(draft.Caption, Contains("1 to 6 runs"));
}

TEST_CASE("figures: a series has its median and quartiles at each time", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddSeries(0, 1, {"spread", "m", {10, 20}, {1, 2}});
  campaign.AddSeries(0, 2, {"spread", "m", {10, 20}, {3, 4}});
  // this run has ended early
  campaign.AddSeries(0, 3, {"spread", "m", {10}, {8}});
  const SFigureDraft draft =
      MakeFigure(campaign.Open(), MakeRequest("series", "spread", "", "robots"));
  CHECK_THAT(draft.Data, Contains("\n1 2 3 5.5 3\n2 2.5 3 3.5 2\n"));
  CHECK_THAT(draft.Script, Contains("'time (s)'") && Contains("'spread (m)'"));
}

TEST_CASE("figures: a series says how many runs it shows, and what became of others",
          "[campaign][report]") {
  // runs of 1 to 10 samples, in which run n has the value n
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  for (UInt32 run = 1; run <= 10; ++run) {
    SMetricSeries series{"spread", "m", {}, {}};
    for (UInt32 sample = 1; sample <= run; ++sample) {
      series.Ticks.push_back(10 * sample);
      series.Values.push_back(run);
    }
    campaign.AddSeries(0, run, series);
  }
  const CReportData& data = campaign.Open();
  SFigureRequest request = MakeRequest("series", "spread", "", "robots");
  request.ShowsInterval = true;
  const SFigureDraft survivors = MakeFigure(data, request);
  // the means of 1 to 10 and of 10 alone
  CHECK_THAT(survivors.Data, Contains(" 5.5 ") && Contains("\n10 10 10 10 1\n"));
  CHECK_THAT(survivors.Script,
             Contains("'robots = 5: 10 runs, 1 at the end'") && Contains("'robots = 10: 0 runs'"));
  CHECK_THAT(survivors.Caption, Contains("Runs that ended before others do not count after"));
  request.EndedRuns = EEndedRuns::Hold;
  const SFigureDraft held = MakeFigure(data, request);
  CHECK_THAT(held.Data, Contains(" 5.5 ") && Contains(" 10\n\n"));
  CHECK_THAT(held.Script, Contains("'robots = 5: 10 runs'"));
  CHECK_THAT(held.Caption, Contains("keep their last value"));
  request.EndedRuns = EEndedRuns::Drop;
  const SFigureDraft dropped = MakeFigure(data, request);
  CHECK_THAT(dropped.Data, Contains("\n1 ") && !Contains("\n2 "));
  CHECK_THAT(dropped.Caption, Contains("Times that not all runs have reached are left out"));
}

TEST_CASE("figures: a difference of two levels has an interval at each time",
          "[campaign][report]") {
  CSyntheticCampaign campaign({{"noise", {"off", "on"}}, {"robots", {"5"}}});
  for (UInt32 seed = 1; seed <= 6; ++seed) {
    campaign.AddSeries(0, seed, {"spread", "m", {10, 20}, {10.0 + seed, 7.0}});
    // less by 1 to 6, in another order of the seeds; one has no second value
    const Real last = 7.0 - seed;
    campaign.AddSeries(
        1, seed,
        {"spread", "m", seed == 6 ? std::vector<UInt32>{10} : std::vector<UInt32>{10, 20},
         seed == 6 ? std::vector<Real>{10.0 + seed - last}
                   : std::vector<Real>{10.0 + seed - last, 1.0}});
  }
  // without a partner
  campaign.AddSeries(0, 7, {"spread", "m", {10}, {1000.0}});
  const SFigureDraft draft =
      MakeFigure(campaign.Open(), MakeRequest("difference", "spread", "", "noise"));
  // R: wilcox.test(1:6, conf.int = TRUE): 3.5, from 1 to 6; five pairs are too few
  CHECK_THAT(draft.Data, Contains("number of pairs\n1 1 3.5 6 6\n") && !Contains("\n2 "));
  CHECK_THAT(draft.Script, Contains("'noise = off minus noise = on'"));
  CHECK_THAT(draft.Caption, Contains("95 % interval") && Contains("of 6 pairs of runs"));
  CHECK_THROWS_WITH(MakeFigure(campaign.Open(), MakeRequest("difference", "spread", "", "robots")),
                    Contains("the factor has 1 levels; a difference is that of two"));
  CHECK_THROWS_WITH(MakeFigure(campaign.Open(), MakeRequest("difference", "spread", "")),
                    Contains("a figure of the kind difference needs group"));
}

TEST_CASE("figures: a difference needs a time with six pairs", "[campaign][report]") {
  CSyntheticCampaign campaign({{"noise", {"off", "on"}}});
  for (UInt32 seed = 1; seed <= 6; ++seed) {
    for (const size_t level : {0, 1}) {
      campaign.AddSeries(level, seed,
                         {"spread", "m", {0, seed == 6 ? 20U : 10U}, {1.0 * seed, 2.0}});
    }
  }
  const CReportData& data = campaign.Open();
  SFigureRequest request = MakeRequest("difference", "spread", "", "noise");
  CHECK_THAT(MakeFigure(data, request).Data, Contains("number of pairs\n0 0 0 0 6\n"));
  // on a logarithmic axis the six at 0 are left out
  request.IsXLogarithmic = true;
  CHECK_THROWS_WITH(MakeFigure(data, request), Contains("at no time there are 6 pairs of runs") &&
                                                   Contains("the series \"spread\""));
}

TEST_CASE("figures: pairs without a difference count in its interval", "[campaign][report]") {
  CSyntheticCampaign campaign({{"noise", {"off", "on"}}});
  for (UInt32 seed = 1; seed <= 9; ++seed) {
    campaign.AddSeries(0, seed, {"spread", "m", {10}, {seed == 9 ? 4.0 : 5.0}});
    campaign.AddSeries(1, seed, {"spread", "m", {10}, {5.0}});
  }
  const SFigureDraft draft =
      MakeFigure(campaign.Open(), MakeRequest("difference", "spread", "", "noise"));
  // without the zeros, all would be -1; of the Walsh averages most are 0
  CHECK_THAT(draft.Data, Contains(" 0 0 9\n"));
}

TEST_CASE("figures: a series may have means with their intervals", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddSeries(0, 1, {"spread", "m", {10, 20}, {1, 7}});
  campaign.AddSeries(0, 2, {"spread", "m", {10}, {3}});
  SFigureRequest request = MakeRequest("series", "spread", "");
  request.ShowsInterval = true;
  const SFigureDraft draft = MakeFigure(campaign.Open(), request);
  // 2 +- 12.706 sqrt(2) / sqrt(2); of one run, none
  CHECK_THAT(draft.Data, Contains("\n1 -10.70620474 2 14.70620474 2\n2 7 7 7 1\n"));
  CHECK_THAT(draft.Caption, Contains("mean (line) and its 95 % t interval at each time (band)"));
  SFigure figure{"series", {{"y", "spread"}, {"band", "sd"}}, 3};
  CHECK_THROWS_WITH(MakeFigureRequest(campaign.GetCampaign(), figure),
                    Contains("\"sd\" is neither quartiles nor interval"));
}

TEST_CASE("figures: scaling fits the exponent", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"1", "10", "100"}}});
  campaign.AddRuns(0, "messages", {2, 2});
  campaign.AddRuns(1, "messages", {200, 200});
  campaign.AddRuns(2, "messages", {20000, 20000});
  const SFigureDraft draft =
      MakeFigure(campaign.Open(), MakeRequest("scaling", "messages", "robots"));
  CHECK_THAT(draft.Script, Contains("'exponent 2 (2 to 2)'"));
  CHECK_THAT(draft.Data, Contains("\n10 200 200 200 2\n"));
}

TEST_CASE("figures: scaling counts runs of 0 in the means, and fits these", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"1", "10", "100", "1000"}}});
  campaign.AddRuns(0, "food", {0, 4});
  campaign.AddRuns(1, "food", {200, 200});
  campaign.AddRuns(2, "food", {20000, 20000});
  campaign.AddRuns(3, "food", {0, 0});
  const SFigureDraft draft = MakeFigure(campaign.Open(), MakeRequest("scaling", "food", "robots"));
  // through the means 2, 200, 20000; without the run of 0 the first one would be 4
  // only the first mean has a deviation, of 1 in its logarithm; the weights of the slope are -1, 0
  // and 1 over 2 log(10): 2 +- 12.7 / (2 log(10))
  CHECK_THAT(draft.Script, Contains("'exponent 2 (-0.759 to 4.76)'"));
  // the t interval of the first one, 2 +- 12.7 2.83 / sqrt(2), leaves the positive numbers
  CHECK_THAT(draft.Data, Contains("\n1 2 0.4 27.41"));
  CHECK_THAT(draft.Data, !Contains("\n1000 "));
  CHECK_THAT(draft.Caption, Contains("fitted to the means") &&
                                Contains("3 runs with values of 0 or less: they count") &&
                                Contains("1 mean of 0 or less left out."));
}

TEST_CASE("figures: axes of values that are not negative begin at 0", "[campaign][report]") {
  const auto [values, command] = GENERATE(table<std::vector<Real>, std::string>({
      {{3, 40, 90}, "set yrange [0:*]\n"},
      // the interval of the mean reaches below 0
      {{0, 0, 90}, "set yrange [0:*]\n"},
      {{0, 0, 0}, "set yrange [0 < * : *]\n"},
      {{1000, 1010, 1020}, "set yrange [0 < * : *]\n"},
      {{-1, 40, 90}, ""},
  }));
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddRuns(0, "food", values);
  campaign.AddSeries(0, 9, {"level", "", {1, 2, 3}, values});
  const CReportData& data = campaign.Open();
  for (const SFigureRequest& request :
       {MakeRequest("boxplot", "food", "robots"), MakeRequest("series", "level", ""),
        MakeRequest("means", "food", "robots")}) {
    CAPTURE(request.Kind, command);
    const std::string script = MakeFigure(data, request).Script;
    const size_t place = script.find("set yrange");
    CHECK((place == std::string::npos ? "" : script.substr(place, command.size())) == command);
  }
}

TEST_CASE("figures: means have intervals, lines and a reference", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"1", "10", "100"}}, {"kind", {"a", "b"}}});
  // one run has no interval; the 95 % t interval of 1 and 3 is 2 - 12.7 to 2 + 12.7
  campaign.AddRuns(0, "speedup", {1, 3});
  campaign.AddRuns(2, "speedup", {0.5});
  campaign.AddRuns(4, "speedup", {4});
  campaign.AddRuns(1, "speedup", {7});
  SFigureRequest request = MakeRequest("means", "speedup", "robots", "kind");
  request.IsXLogarithmic = true;
  request.Reference = 20.0;
  request.ReferenceLabel = "all processors";
  const SFigureDraft draft = MakeFigure(campaign.Open(), request);
  CHECK_THAT(draft.Data, Contains("# kind = a\n1 2 -10.706204") && Contains(" 14.706204") &&
                             Contains("\n10 0.5 0.5 0.5 1\n100 4 4 4 1\n") &&
                             Contains("# kind = b\n1 7 7 7 1\n"));
  CHECK_THAT(draft.Script, Contains("set logscale x\n") && !Contains("logscale y") &&
                               Contains("plot 20 with lines dashtype 2") &&
                               Contains("title 'all processors'") && Contains("title 'kind = a'"));
  CHECK_THAT(draft.Caption, Contains("logarithmic in robots: means of 1 to 2 runs"));

  SECTION("bounds stay positive on a logarithmic axis") {
    request.IsLogarithmic = true;
    const SFigureDraft logarithmic = MakeFigure(campaign.Open(), request);
    CHECK_THAT(logarithmic.Data, Contains("\n1 2 0.4 14.7"));
    CHECK_THAT(logarithmic.Script, Contains("set logscale y\n"));
    request.Reference = 0.0;
    CHECK_THROWS_WITH(MakeFigure(campaign.Open(), request),
                      Contains("\"reference\" has the value 0, which a logarithmic axis"));
  }
  SECTION("a narrow logarithmic axis has at least two tics") {
    request.IsLogarithmic = true;
    request.Reference.reset();
    request.Where = "robots == 10 or robots == 100";
    CHECK_THAT(MakeFigure(campaign.Open(), request).Script,
               Contains("set yrange [0.4166666667:4.8]\nset ytics ('0.5' 0.5, '1' 1, "
                        "'2' 2)"));
    request.Where = "robots == 100";
    CHECK_THAT(MakeFigure(campaign.Open(), request).Script,
               Contains("set yrange [2:5]\nset ytics ('2' 2, '5' 5)"));
  }
  SECTION("bars are standard deviations") {
    request.HasDeviationBars = true;
    const SFigureDraft deviations = MakeFigure(campaign.Open(), request);
    CHECK_THAT(deviations.Data, Contains("\n1 2 0.5857864376 3.414213562 2\n10 0.5 0.5 0.5 1\n"));
    CHECK_THAT(deviations.Caption, Contains("each with standard deviations"));
  }
  SECTION("only runs for which an expression is true") {
    request.Where = "kind == 'a' and robots > 1";
    const SFigureDraft part = MakeFigure(campaign.Open(), request);
    CHECK_THAT(part.Data,
               Contains("# kind = a\n10 0.5") && !Contains("kind = b") && !Contains("\n1 "));
    CHECK_THAT(part.Caption, Contains("Only runs with kind == 'a' and robots > 1."));
    // a factor with one level left is not taken together
    request.Group.clear();
    CHECK_THAT(MakeFigure(campaign.Open(), request).Caption, !Contains("taken together"));
    request.Where = "kind == 'c'";
    CHECK_THROWS_WITH(MakeFigure(campaign.Open(), request),
                      Contains("\"kind == 'c'\" is true for no combination"));
    request.Where = "knd == 'c'";
    CHECK_THROWS_WITH(MakeFigure(campaign.Open(), request), Contains("knd"));
  }
}

TEST_CASE("figures: large and small tics of logarithmic axes are powers of ten",
          "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"1", "1000000"}}});
  campaign.AddRuns(0, "time", {1e-4});
  campaign.AddRuns(1, "time", {4e-4});
  SFigureRequest request = MakeRequest("means", "time", "robots");
  request.IsXLogarithmic = request.IsLogarithmic = true;
  CHECK_THAT(MakeFigure(campaign.Open(), request).Script,
             Contains("'10^{0}' 1, '10^{1}' 10, '10^{2}' 100, '10^{3}' 1000, '10^{4}' 10000, "
                      "'10^{5}' 100000, '10^{6}' 1000000)") &&
                 Contains("'10^{-4}' 0.0001, '2\u00B710^{-4}' 0.0002"));
}

TEST_CASE("figures: a heatmap has the mean of each cell", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}, {"speed", {"1", "2"}}});
  campaign.AddRuns(0, "food", {1, 3});
  campaign.AddRuns(3, "food", {7});
  SFigureRequest request = MakeRequest("heatmap", "speed", "robots");
  request.Z = "food";
  const SFigureDraft draft = MakeFigure(campaign.Open(), request);
  CHECK_THAT(draft.Data, Contains("\n0 0 2 0xffffff\n0 1 NaN ") && Contains("\n1 1 7 0x222222\n"));
}

TEST_CASE("figures: errors name what is wrong", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}, {"kind", {"a", "b"}}});
  campaign.AddRuns(0, "food", {0, 1});
  campaign.AddRuns(1, "debt", {-3, 0});
  campaign.AddSeries(1, 9, {"spread", "m", {1}, {1}});
  const CReportData& data = campaign.Open();
  const auto messageOf = [&data](const SFigureRequest& request) -> std::string {
    try {
      MakeFigure(data, request);
    } catch (const CARGoSException& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(messageOf(MakeRequest("boxplt", "food", "robots")),
             Contains("there is no kind of figure \"boxplt\"; did you mean \"boxplot\"?"));
  CHECK_THAT(messageOf(MakeRequest("boxplot", "fod", "robots")),
             Contains("did you mean \"food\"?"));
  CHECK_THAT(messageOf(MakeRequest("boxplot", "food", "robot")),
             Contains("did you mean \"robots\"?"));
  CHECK_THAT(messageOf(MakeRequest("boxplot", "food", "")), Contains("boxplot needs x"));
  CHECK_THAT(messageOf(MakeRequest("boxplot", "spread", "robots")),
             Contains("\"spread\" is a time series"));
  CHECK_THAT(messageOf(MakeRequest("series", "food", "")),
             Contains("\"food\" is one number of a run"));
  CHECK_THAT(messageOf(MakeRequest("scaling", "food", "kind")), Contains("not all numbers"));
  CHECK_THAT(messageOf(MakeRequest("scaling", "debt", "robots")),
             Contains("no mean of \"debt\" is positive"));
  SFigureRequest logarithmic = MakeRequest("boxplot", "food", "robots");
  logarithmic.IsLogarithmic = true;
  CHECK_THAT(messageOf(logarithmic),
             Contains("\"food\" has the value 0, which a logarithmic axis cannot show"));
  CHECK_THROWS_WITH(DrawFigure(data, MakeRequest("boxplot", "food", "robots"), "x.gif"),
                    Contains("must end in .svg, .png or .pdf"));
  SFigure means{"means", {{"y", "food"}, {"x", "robots"}, {"reference", "high"}}, 13};
  CHECK_THROWS_WITH(
      MakeFigureRequest(campaign.GetCampaign(), means),
      Contains("campaign.xml:13: <means>") && Contains("\"high\" is no finite number"));
  means.Attributes.back() = {"xscale", "lg"};
  CHECK_THROWS_WITH(MakeFigureRequest(campaign.GetCampaign(), means),
                    Contains("attribute \"xscale\": \"lg\" is neither linear nor log"));
  SFigure figure{"boxplot", {{"y", "food"}, {"x", "robots"}, {"width", "wide"}}, 12};
  CHECK_THROWS_WITH(MakeFigureRequest(campaign.GetCampaign(), figure),
                    Contains("campaign.xml:12: <boxplot>") && Contains("no number of pixels"));
}

TEST_CASE("report: without gnuplot there are tables, data and scripts", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddRuns(0, "food", {1, 2, 3, 4, 5}, "items");
  campaign.AddRuns(1, "food", {11, 12, 13, 14, 15}, "items");
  campaign.GetCampaign().Comparisons.push_back({"food", "robots", false, 0});
  campaign.Open();
  const CEmptyPath path;
  const SReportFiles files =
      WriteReport(campaign.GetCampaign(), campaign.GetStore(), campaign.GetPath("report"));
  CHECK(files.NumFigures == 0);
  REQUIRE(files.Problems.size() == 1);
  CHECK_THAT(files.Problems[0], Contains("apt-get install gnuplot-nox"));
  const std::string page = Read(files.Page);
  CHECK_THAT(page, Contains("apt-get install gnuplot-nox"));
  CHECK_THAT(page, Contains("<td>5</td><td>0</td><td>3</td><td>1.581</td><td>3</td><td>2 to 4</td>"
                            "<td>1.037 to 4.963</td>"));
  CHECK_THAT(page,
             Contains("Values at robots = 10 are greater than at robots = 5 by 10 items (96.8 "
                      "% interval 7 to 13, p = 0.0079)."));
  CHECK_THAT(Read(campaign.GetPath("report/tables/summary.csv")),
             Contains("\nfood,items,5,5,0,3,1.5811388300841898,1,2,3,4,5,"));
  CHECK_THAT(Read(campaign.GetPath("report/tables/comparisons.csv")),
             Contains("\nfood,robots,false,,Wilcoxon's rank-sum test,W = 25,"));
  CHECK(std::filesystem::exists(campaign.GetPath("report/figures/boxplot_food_robots.dat")));
  CHECK(std::filesystem::exists(campaign.GetPath("report/figures/boxplot_food_robots.gp")));
  CHECK_THROWS_WITH(DrawFigure(CReportData(campaign.GetCampaign(), campaign.GetStore()),
                               MakeRequest("boxplot", "food", "robots"), "x.svg"),
                    Contains("apt-get install gnuplot-nox"));
}

TEST_CASE("report: the points of numbers in a column are aligned", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddRuns(0, "food", {1, 2});
  campaign.AddRuns(1, "food", {3, 3});
  campaign.Open();
  const SReportFiles files =
      WriteReport(campaign.GetCampaign(), campaign.GetStore(), campaign.GetPath("report"));
  CHECK_THAT(Read(files.Page), Contains("<td>2</td><td>0</td><td>1.5</td><td>0.7071</td>") &&
                                   Contains("<td>2</td><td>0</td><td>3\u2008\u2007</td>"
                                            "<td>0\u2008\u2007\u2007\u2007\u2007</td>"));
}

TEST_CASE("report: hostile names are text, in pages and for gnuplot", "[campaign][report]") {
  const std::string script = "<script>alert(1)</script>";
  const std::string commands = "'; system 'touch pwned' #`touch pwned`";
  CSyntheticCampaign campaign({{"kind", {script, commands}}});
  const std::string metric = "<img src=x onerror=alert(2)>data_file";
  campaign.AddRuns(0, metric, {1, 2, 3}, "\"><script>");
  campaign.AddRuns(1, metric, {4, 5, 6}, "\"><script>");
  SStoredRun crash;
  crash.Seed = 9;
  crash.Machine = "<b>host";
  crash.Result.Status = ERunStatus::Crashed;
  crash.Result.Signal = 11;
  crash.Result.Log = "[FATAL] </pre>" + script + "\n\x1b[31m";
  campaign.AddRun(0, crash);
  campaign.GetCampaign().Title = "5 < 6" + script;
  campaign.GetCampaign().Comparisons.push_back({metric, "kind", false, 0});
  campaign.GetCampaign().Figures = {
      {"boxplot", {{"y", metric}, {"x", "kind"}, {"group", "kind"}}, 1}};
  campaign.Open();
  const SReportFiles files =
      WriteReport(campaign.GetCampaign(), campaign.GetStore(), campaign.GetPath("report"));
  const std::string page = Read(files.Page);
  CHECK_THAT(page, Contains("<h1>5 &lt; 6&lt;script&gt;alert(1)&lt;/script&gt;</h1>"));
  CHECK_THAT(page, Contains("crashed, signal 11"));
  CHECK_THAT(page, Contains("--set"));
  // the page is well-formed XML, so that its elements can be listed
  CConfigurationDocument document;
  REQUIRE_NOTHROW(document.Parse(page.substr(page.find('\n')), "page"));
  std::set<std::string> names;
  CollectNames(document.GetRoot(), names);
  CHECK(names.count("table") == 1);
  CHECK(names.count("script") == 0);
  CHECK(names.count("img") == 0);
  CHECK_FALSE(std::filesystem::exists(campaign.GetPath("report/figures/pwned")));
  if (!FindGnuplotProblem().empty()) {
    WARN("figures not checked: " << FindGnuplotProblem());
    return;
  }
  CHECK(files.Problems.empty());
  CHECK(files.NumFigures == 1);
  CHECK(names.count("svg") == 1);
}

TEST_CASE("report: older generations and removed combinations are counted", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddRuns(0, "food", {1, 2});
  campaign.Open();
  campaign.GetCampaign().ExperimentText += "<!-- changed -->";
  {
    CResultStore store(campaign.GetCampaign().ResultsFile, CResultStore::EMode::Write);
    store.Register(campaign.GetCampaign(), true);
    SStoredRun run;
    run.Combination = store.GetCombinationId(campaign.GetCampaign().Combinations[1].ComputeKey());
    run.Result.Status = ERunStatus::Done;
    store.Add({run});
  }
  campaign.GetCampaign().Combinations.pop_back();
  const CEmptyPath path;
  const std::string page = Read(
      WriteReport(campaign.GetCampaign(), campaign.GetStore(), campaign.GetPath("report")).Page);
  CHECK_THAT(page, Contains("2 runs of earlier versions of the experiment left out"));
  CHECK_THAT(page, Contains("1 run of combinations that the campaign file does not have any more"));
}

TEST_CASE("figures: gnuplot draws all kinds and formats", "[campaign][report]") {
  if (!FindGnuplotProblem().empty()) {
    WARN("skipped: " << FindGnuplotProblem());
    return;
  }
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}, {"speed", {"1", "2"}}});
  for (size_t i = 0; i < 4; ++i) {
    SStoredRun run;
    run.Result.Status = ERunStatus::Done;
    for (UInt32 seed = 1; seed <= 3; ++seed) {
      run.Seed = seed;
      run.Result.Metrics = {{"food", "items", static_cast<Real>(i + seed)}};
      run.Result.Series = {{"spread", "m", {1, 2, 3}, {1.0 * seed, 2.0 * seed, 3.0}}};
      campaign.AddRun(i, run);
    }
  }
  const CReportData& data = campaign.Open();
  SFigureRequest heatmap = MakeRequest("heatmap", "speed", "robots");
  heatmap.Z = "food";
  SFigureRequest means = MakeRequest("means", "food", "robots", "speed");
  means.Reference = 3.0;
  means.Where = "speed > 0";
  const std::vector<SDrawnFigure> figures =
      DrawFigures(data,
                  {MakeRequest("boxplot", "food", "robots", "speed"),
                   MakeRequest("series", "spread", "", "robots"),
                   MakeRequest("scaling", "food", "robots", "speed"), means, heatmap},
                  campaign.GetPath("figures"));
  REQUIRE(figures.size() == 5);
  for (const SDrawnFigure& figure : figures) {
    CAPTURE(figure.Name);
    CHECK(figure.Problem.empty());
    CHECK(figure.SVG.rfind("<svg", 0) == 0);
    const std::string png = Read(campaign.GetPath("figures/" + figure.Name + ".png"));
    CHECK(png.rfind("\x89PNG", 0) == 0);
  }
  DrawFigure(data, heatmap, campaign.GetPath("map.pdf"));
  CHECK(Read(campaign.GetPath("map.pdf")).rfind("%PDF", 0) == 0);
}

}  // namespace argos::figures_test
