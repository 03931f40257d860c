#include <argos3/campaign/report/series_lines.h>

#include <argos3/campaign/report/figure_parts.h>
#include <argos3/campaign/report/figures.h>
#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/report/summary_tables.h>
#include <argos3/campaign/statistics/mean_interval.h>
#include <argos3/campaign/statistics/moments.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace argos {

namespace {

constexpr Real kNoValue = std::numeric_limits<Real>::quiet_NaN();
constexpr size_t kMaxPoints = 600;  // points of a line in a figure; the data file has all

// means with t intervals at each time, which have width 0 if there is one run only
SSeriesBands ComputeIntervals(const std::vector<std::vector<Real>>& runs) {
  // counts, and checks of the values
  SSeriesBands bands = ComputeSeriesBands(runs);
  std::vector<Real> values;
  for (size_t i = 0; i < bands.Counts.size(); ++i) {
    if (bands.Counts[i] == 0) {
      continue;
    }
    values.clear();
    for (const std::vector<Real>& run : runs) {
      if (i < run.size() && !std::isnan(run[i])) {
        values.push_back(run[i]);
      }
    }
    bands.Median[i] = bands.Lower[i] = bands.Upper[i] = ComputeMoments(values).Mean;
    if (values.size() >= 2) {
      const SConfidenceInterval interval = ComputeMeanInterval(values, kReportLevel);
      bands.Lower[i] = interval.Lower;
      bands.Upper[i] = interval.Upper;
    }
  }
  return bands;
}

// a logarithmic axis has no place for a bound that is not positive: such bands end below the others
Real LimitBound(Real lower, Real middle) {
  constexpr Real kBelowMiddle = 0.2;
  return lower > 0.0 ? lower : kBelowMiddle * middle;
}

/** A group with its bands. */
struct SBand {
  SSeriesGroup Group;
  SSeriesBands Bands;
  bool HasEnded = false;  // runs that end before others
  size_t NumLeftOut = 0;  // times

  size_t GetLastCount() const { return Bands.Counts.empty() ? 0 : Bands.Counts.back(); }
};

// leaves out times whose middle a logarithmic axis cannot show
void KeepPositive(SBand& band) {
  SSeriesBands& bands = band.Bands;
  size_t kept = 0;
  for (size_t i = 0; i < bands.Median.size(); ++i) {
    if (!(bands.Median[i] > 0.0)) {
      band.NumLeftOut += bands.Counts[i] > 0 ? 1 : 0;
      continue;
    }
    band.Group.Times[kept] = band.Group.Times[i];
    bands.Lower[kept] = LimitBound(bands.Lower[i], bands.Median[i]);
    bands.Median[kept] = bands.Median[i];
    bands.Upper[kept] = bands.Upper[i];
    bands.Counts[kept] = bands.Counts[i];
    ++kept;
  }
  band.Group.Times.resize(kept);
  for (std::vector<Real>* values : {&bands.Lower, &bands.Median, &bands.Upper}) {
    values->resize(kept);
  }
  bands.Counts.resize(kept);
}

SBand ComputeBand(SSeriesGroup group, const SSeriesStyle& style) {
  SBand band;
  for (const std::vector<Real>& run : group.Runs) {
    band.HasEnded = band.HasEnded || run.size() != group.Runs.front().size();
  }
  ApplyToEndedRuns(group.Runs, style.Ended);
  if (!group.Runs.empty()) {
    band.Bands =
        style.ShowsInterval ? ComputeIntervals(group.Runs) : ComputeSeriesBands(group.Runs);
  }
  band.Group = std::move(group);
  if (style.IsLogarithmic) {
    KeepPositive(band);
  }
  return band;
}

std::string MakeRow(const SBand& band, size_t i) {
  const SSeriesBands& bands = band.Bands;
  std::string row = FormatForGnuplot(band.Group.Times[i]);
  for (const Real number : {bands.Lower[i], bands.Median[i], bands.Upper[i]}) {
    row += ' ' + FormatForGnuplot(number);
  }
  return row + fmt::format(" {}\n", bands.Counts[i]);
}

// of a line over logarithmic time: so many that they are at equal distances, with the first and the
// last one
std::vector<size_t> ChoosePoints(const std::vector<Real>& times, size_t count) {
  std::vector<size_t> points;
  for (size_t i = 0; i < count; ++i) {
    const Real step = std::log(times[count - 1] / times[0]) / static_cast<Real>(kMaxPoints);
    if (i == 0 || i + 1 == count || std::log(times[i] / times[points.back()]) >= step) {
      points.push_back(i);
    }
  }
  return points;
}

void AppendBlock(const SBand& band, const SSeriesStyle& style, SSeriesLines& lines) {
  // an interval may reach below 0 though no value does; fmin() and fmax() ignore NaN
  for (const std::vector<Real>& run : band.Group.Runs) {
    for (const Real value : run) {
      lines.Low = std::fmin(lines.Low, value);
    }
  }
  constexpr const char* kEmptyBlock = "NaN NaN NaN NaN 0\n\n\n";
  const SSeriesBands& bands = band.Bands;
  for (size_t i = 0; i < bands.Median.size(); ++i) {
    lines.High = std::fmax(lines.High, bands.Upper[i]);
    lines.Data += MakeRow(band, i);
  }
  lines.Data += bands.Median.empty() ? kEmptyBlock : "\n\n";
  if (!style.IsTimeLogarithmic) {
    return;
  }
  lines.Data += "# the points that are drawn\n";
  for (const size_t i : ChoosePoints(band.Group.Times, bands.Median.size())) {
    lines.Data += MakeRow(band, i);
  }
  lines.Data += bands.Median.empty() ? kEmptyBlock : "\n\n";
}

// "10 runs" or "10 runs, 2 at the end"
std::string DescribeRuns(const SBand& band) {
  const size_t count = band.Group.Runs.size();
  const size_t last = band.GetLastCount();
  return Count(count, "run") + (last < count ? fmt::format(", {} at the end", last) : "");
}

std::string MakeBandKey(const SBand& band, bool showsCount) {
  std::string title = band.Group.Title;
  if (showsCount) {
    title += (title.empty() ? "" : ": ") + DescribeRuns(band);
  }
  return title.empty() ? " notitle" : " title " + QuoteForGnuplot(title);
}

// the text of all bands; empty if they differ
std::string FindCommonRuns(const std::vector<SBand>& bands) {
  const std::string text = DescribeRuns(bands.front());
  const bool isCommon = std::ranges::all_of(
      bands, [&text](const std::string& other) { return other == text; }, DescribeRuns);
  return isCommon ? text : "";
}

std::string MakeBandPlot(const std::vector<SBand>& all, bool showsCounts, bool isTimeLogarithmic) {
  std::string bands;
  std::string lines;
  for (size_t index = 0; index < all.size(); ++index) {
    const SBand& band = all[index];
    const size_t count = band.Bands.Median.size();
    const std::string source =
        isTimeLogarithmic ? fmt::format("{} index {}", kDataName, 2 * index + 1)
                          : fmt::format("{} index {} every {}", kDataName, index,
                                        (count + kMaxPoints - 1) / kMaxPoints + (count == 0));
    const char* const color = GetColor(index);
    if (band.Group.Runs.size() > 1) {
      bands += fmt::format(
          "{} using 1:2:4 with filledcurves fillstyle transparent solid 0.2 noborder linecolor rgb "
          "'{}' notitle, \\\n  ",
          source, color);
    }
    // a line of fewer runs is dashed, below the part of all runs
    const bool hasDashes = band.GetLastCount() < band.Group.Runs.size();
    const std::string line = fmt::format(" with lines linewidth 2 linecolor rgb '{}'", color);
    lines += index == 0 ? "" : ", \\\n  ";
    if (hasDashes) {
      lines += source + " using 1:3" + line + " dashtype 3 notitle, \\\n  ";
    }
    lines += source +
             (hasDashes ? fmt::format(" using 1:($5 < {} ? NaN : $3)", band.Group.Runs.size())
                        : std::string(" using 1:3")) +
             line + MakeBandKey(band, showsCounts);
  }
  return "plot " + bands + lines + '\n';
}

// the band's least bound and the first and last time, for the ranges of logarithmic axes
std::string MakeSeriesAxes(const std::vector<SBand>& bands, const SSeriesStyle& style,
                           const SSeriesLines& lines) {
  Real low = lines.High;
  Real first = kNoValue;
  Real last = kNoValue;
  for (const SBand& band : bands) {
    for (size_t i = 0; i < band.Bands.Median.size(); ++i) {
      low = std::fmin(low, band.Bands.Lower[i]);
      first = std::fmin(first, band.Group.Times[i]);
      last = std::fmax(last, band.Group.Times[i]);
    }
  }
  return (style.IsLogarithmic && low > 0.0
              ? MakeLogarithmicAxis("y", low / kLogarithmicMargin, lines.High * kLogarithmicMargin)
              : MakeValueAxis(lines.Low, lines.High)) +
         (style.IsTimeLogarithmic && first > 0.0 ? MakeLogarithmicAxis("x", first, last) : "");
}

std::string DescribeEnding(const std::vector<SBand>& bands, EEndedRuns rule) {
  if (std::ranges::none_of(bands, &SBand::HasEnded)) {
    return "";
  }
  if (rule == EEndedRuns::Hold) {
    return " Runs that ended before others keep their last value.";
  }
  if (rule == EEndedRuns::Drop) {
    return " Times that not all runs have reached are left out.";
  }
  return " Runs that ended before others do not count after their end; dashed: fewer than all "
         "runs.";
}

std::string DescribeLeftOut(const std::vector<SBand>& bands, const SSeriesStyle& style) {
  size_t numTimes = 0;
  bool isEmpty = true;
  for (const SBand& band : bands) {
    numTimes += band.NumLeftOut;
    isEmpty = isEmpty && band.Bands.Median.empty();
  }
  const char* const middle = style.ShowsInterval ? "mean" : "median";
  if (numTimes > 0 && isEmpty) {
    THROW_ARGOSEXCEPTION("at no time the " << middle
                                           << " is positive, and a logarithmic axis shows no other "
                                              "values");
  }
  return numTimes == 0
             ? ""
             : fmt::format(" {} with a {} of 0 or less left out.", Count(numTimes, "time"), middle);
}

}  // namespace

SSeriesGroup MakeSeriesGroup(const std::string& title, const std::vector<TTimedValues>& runs) {
  SSeriesGroup group;
  group.Title = title;
  std::vector<Real>& times = group.Times;
  for (const TTimedValues& run : runs) {
    for (const auto& [time, value] : run) {
      times.push_back(time);
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  for (const TTimedValues& run : runs) {
    std::vector<Real>& values = group.Runs.emplace_back();
    for (const auto& [time, value] : run) {
      const auto place = std::lower_bound(times.begin(), times.end(), time);
      values.resize(static_cast<size_t>(place - times.begin()), kNoValue);
      values.push_back(value);
    }
  }
  return group;
}

SSeriesLines MakeSeriesLines(std::vector<SSeriesGroup> groups, const SSeriesStyle& style) {
  SSeriesLines lines;
  std::vector<SBand> bands;
  for (SSeriesGroup& group : groups) {
    bands.push_back(ComputeBand(std::move(group), style));
    const SBand& band = bands.back();
    lines.Data +=
        "# " +
        MakeLine(band.Group.Title + (band.Group.Title.empty() ? "" : ": ") + DescribeRuns(band)) +
        '\n';
    AppendBlock(band, style, lines);
    if (!band.Group.Runs.empty()) {
      lines.Counts.push_back(band.Group.Runs.size());
    }
  }
  lines.CommonRuns = style.JoinsCounts ? FindCommonRuns(bands) : "";
  lines.Plot = MakeBandPlot(bands, lines.CommonRuns.empty(), style.IsTimeLogarithmic);
  lines.Axes = MakeSeriesAxes(bands, style, lines);
  lines.Ending = DescribeEnding(bands, style.Ended);
  lines.LeftOut = DescribeLeftOut(bands, style);
  return lines;
}

}  // namespace argos
