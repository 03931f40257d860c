// Axes of figures: their scales, and where points are in the pictures.

#include "synthetic_campaign.h"

#include <argos3/campaign/report/figure_drawing.h>
#include <argos3/campaign/report/figure_request.h>
#include <argos3/support/child_process.h>
#include <argos3/testing/support/plot_picture.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace argos::figure_axes_test {

using Catch::Contains;

TEST_CASE("figures: a series has logarithmic axes of values and of time", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  // squares of the time, 10 ticks a second; in the first one the median is 0
  SMetricSeries series{"spread", "m", {0, 1}, {0, 0}};
  for (UInt32 tick = 10; tick <= 100000; ++tick) {
    series.Ticks.push_back(tick);
    series.Values.push_back(tick / 10.0 * tick / 10.0);
  }
  campaign.AddSeries(0, 1, series);
  SFigureRequest request = MakeRequest("series", "spread", "");
  request.IsLogarithmic = request.IsXLogarithmic = true;
  const SFigureDraft draft = MakeFigure(campaign.Open(), request);
  CHECK_THAT(draft.Script,
             Contains("set logscale x\nset xrange [1:10000]\nset xtics ('10^{0}' 1, '10^{1}' 10, "
                      "'10^{2}' 100, '10^{3}' 1000, '10^{4}' 10000)") &&
                 Contains("set logscale y\nset yrange [0.8333333333:120000000]\n"));
  // the second block has the points that are drawn: 150 of each of the four decades
  const size_t drawn = draft.Data.find("# the points that are drawn\n1 1 1 1 1\n");
  REQUIRE(drawn != std::string::npos);
  const auto count =
      std::count(draft.Data.begin() + static_cast<long>(drawn), draft.Data.end(), '\n');
  CHECK(count > 400);
  CHECK(count <= 604);
  CHECK_THAT(draft.Data.substr(drawn), Contains("\n10000 100000000 100000000 100000000 1\n"));
  CHECK_THAT(draft.Script, Contains("data_file index 1 using") && !Contains("every"));
  // at 0 s there is no place on the axis of time, so that only one value is left out
  CHECK_THAT(draft.Caption, Contains("1 time with a median of 0 or less left out."));

  request.IsXLogarithmic = false;
  CHECK_THAT(MakeFigure(campaign.Open(), request).Caption,
             Contains("2 times with a median of 0 or less left out."));
}

TEST_CASE("figures: bands stay positive on a logarithmic axis", "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}});
  campaign.AddSeries(0, 1, {"spread", "m", {1, 2}, {1, 0}});
  campaign.AddSeries(0, 2, {"spread", "m", {1, 2}, {3, 0}});
  SFigureRequest request = MakeRequest("series", "spread", "");
  request.IsLogarithmic = request.ShowsInterval = true;
  // the 95 % t interval of 1 and 3 is 2 - 12.7 to 2 + 12.7; a fifth of the mean takes its place
  CHECK_THAT(MakeFigure(campaign.Open(), request).Data, Contains("\n0.1 0.4 2 14.706"));
  request.Where = "robots == 10";
  CHECK_THROWS_WITH(MakeFigure(campaign.Open(), request), Contains("no run that is done"));
  campaign.AddSeries(1, 1, {"debt", "", {1}, {-1}});
  SFigureRequest debt = MakeRequest("series", "debt", "");
  debt.IsLogarithmic = true;
  CHECK_THROWS_WITH(MakeFigure(campaign.Open(), debt),
                    Contains("at no time the median is positive"));
}

TEST_CASE("figures: boxes and cells on logarithmic scales have tics at round numbers",
          "[campaign][report]") {
  CSyntheticCampaign campaign({{"robots", {"5", "10"}}, {"speed", {"1"}}});
  campaign.AddRuns(0, "food", {1, 1});
  campaign.AddRuns(1, "food", {1000});
  SFigureRequest box = MakeRequest("boxplot", "food", "robots");
  box.IsLogarithmic = true;
  CHECK_THAT(MakeFigure(campaign.Open(), box).Script,
             Contains("set logscale y\nset yrange [0.8333333333:1200]\nset ytics ('1' 1, '10' 10, "
                      "'100' 100, '1000' 1000)\n"));
  SFigureRequest map = MakeRequest("heatmap", "speed", "robots");
  map.Z = "food";
  map.IsLogarithmic = true;
  CHECK_THAT(MakeFigure(campaign.Open(), map).Script,
             Contains("set logscale cb\nset cbrange [1:1000]\nset cbtics ('1' 1, "));
}

TEST_CASE("figures: the axes fill the picture, and points are where their values belong",
          "[campaign][report]") {
  if (FindProgram("gnuplot").empty()) {
    WARN("there is no gnuplot: skipped");
    return;
  }
  using Catch::Matchers::WithinAbs;
  CSyntheticCampaign campaign({{"kind", {"a", "b"}}, {"robots", {"1", "10"}}});
  // in all runs 2 with one robot, 20 with ten, and the time of a series
  SMetricSeries series{"spread", "m", {}, {}};
  for (UInt32 tick = 10; tick <= 100; tick += 10) {
    series.Ticks.push_back(tick);
    series.Values.push_back(tick / 10.0);
  }
  for (size_t i = 0; i < 4; ++i) {
    campaign.AddRuns(i, "food", std::vector<Real>(7, i % 2 == 0 ? 2.0 : 20.0));
    for (UInt32 seed = 1; seed <= 6; ++seed) {
      campaign.AddSeries(i, 20 + seed, series);
    }
  }
  const CReportData& data = campaign.Open();
  const auto draw = [&](const SFigureRequest& request) {
    DrawFigure(data, request, campaign.GetPath("figure.png"));
    CPlotPicture picture(campaign.GetPath("figure.png"));
    const SPixelBox axes = picture.FindAxes();
    CAPTURE(request.Kind, axes.Left, axes.Top, axes.Right, axes.Bottom);
    CHECK(axes.GetWidth() > 0.7 * picture.GetWidth());
    CHECK(axes.GetHeight() > 0.6 * picture.GetHeight());
    return std::pair(std::move(picture), axes);
  };
  constexpr Real kLine = 5.0;  // pixels, for widths of lines
  constexpr Real kPoint = 16.0;  // and for points

  SECTION("a series goes from its first to its last value") {
    const auto [picture, axes] = draw(MakeRequest("series", "spread", ""));
    const SPixelBox line = picture.FindBox(CPlotPicture::kFirstColor, axes);
    CHECK_THAT(line.Right, WithinAbs(axes.Right, kLine));
    // the axis of values begins at 0
    CHECK_THAT((axes.Bottom - line.Top) / (axes.Bottom - line.Bottom), WithinAbs(10.0, 1.0));
  }
  SECTION("boxes are at a quarter and three quarters of two levels") {
    const auto [picture, axes] = draw(MakeRequest("boxplot", "food", "robots"));
    const SPixelBox boxes = picture.FindBox(CPlotPicture::kFirstColor, axes);
    // levels at 0 and 1 of -0.6 to 1.6, with boxes of 0.45; the axis of values begins at 0
    const Real unit = axes.GetWidth() / 2.2;
    CHECK_THAT(boxes.Left, WithinAbs(axes.Left + unit * (0.6 - 0.225), kPoint));
    CHECK_THAT(boxes.Right, WithinAbs(axes.Left + unit * (1.6 + 0.225), kPoint));
    CHECK_THAT((axes.Bottom - boxes.Top) / (axes.Bottom - boxes.Bottom), WithinAbs(10.0, 1.0));
  }
  SECTION("means on logarithmic axes keep a factor of 1.2 from their ends") {
    const auto [picture, axes] = draw(MakeRequest("scaling", "food", "robots"));
    const SPixelBox points = picture.FindBox(CPlotPicture::kFirstColor, axes);
    const Real x = axes.GetWidth() * std::log10(1.2) / std::log10(14.4);
    const Real y = axes.GetHeight() * std::log10(1.2) / std::log10(14.4);
    CHECK_THAT(points.Left, WithinAbs(axes.Left + x, kPoint));
    CHECK_THAT(points.Right, WithinAbs(axes.Right - x, kPoint));
    CHECK_THAT(points.Bottom, WithinAbs(axes.Bottom - y, kPoint));
    CHECK_THAT(points.Top, WithinAbs(axes.Top + y, kPoint));
  }
  SECTION("means of two levels are at the ends of a line") {
    const auto [picture, axes] = draw(MakeRequest("means", "food", "robots"));
    const SPixelBox line = picture.FindBox(CPlotPicture::kFirstColor, axes);
    CHECK_THAT((axes.Bottom - line.Top) / (axes.Bottom - line.Bottom), WithinAbs(10.0, 2.0));
    // as far from one end as from the other
    CHECK_THAT(line.Left - axes.Left, WithinAbs(axes.Right - line.Right, kPoint));
    CHECK(line.GetWidth() > 0.4 * axes.GetWidth());
  }
  SECTION("the cells of a heat map fill its axes, with the ends of the scale") {
    SFigureRequest request = MakeRequest("heatmap", "kind", "robots");
    request.Z = "food";
    DrawFigure(data, request, campaign.GetPath("figure.png"));
    CPlotPicture picture(campaign.GetPath("figure.png"));
    // without the scale of colours
    SPixelBox area = picture.GetWhole();
    area.Right = 0.8 * picture.GetWidth();
    const SPixelBox low = picture.FindBox(0x00204c, area);
    const SPixelBox high = picture.FindBox(0xffe945, area);
    CHECK(high.Right - low.Left > 0.65 * picture.GetWidth());
    CHECK(low.GetHeight() > 0.7 * picture.GetHeight());
    CHECK_THAT(high.GetHeight(), WithinAbs(low.GetHeight(), 2.0));
    CHECK_THAT(high.GetWidth(), WithinAbs(low.GetWidth(), 2.0));
    CHECK(high.Left > low.Right);
  }
  SECTION("a difference of equal series is 0 all the time") {
    const auto [picture, axes] = draw(MakeRequest("difference", "spread", "", "kind"));
    const SPixelBox line = picture.FindBox(CPlotPicture::kFirstColor, axes);
    CHECK_THAT(line.Right, WithinAbs(axes.Right, kLine));
    CHECK(line.GetHeight() < 2.0 * kLine);
  }
}

}  // namespace argos::figure_axes_test
