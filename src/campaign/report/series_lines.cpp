#include <argos3/campaign/report/series_lines.h>

#include <argos3/campaign/report/figures.h>
#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/report/summary_tables.h>
#include <argos3/campaign/statistics/mean_interval.h>
#include <argos3/campaign/statistics/moments.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace argos {

namespace {

constexpr Real kNoValue = std::numeric_limits<Real>::quiet_NaN();
constexpr size_t kMaxPoints = 600;  // of a line in a figure; the data file has all

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

/** A group with its bands. */
struct SBand {
  SSeriesGroup Group;
  SSeriesBands Bands;
  bool HasEnded = false;  // runs that end before others

  size_t GetLastCount() const { return Bands.Counts.empty() ? 0 : Bands.Counts.back(); }
};

SBand ComputeBand(SSeriesGroup group, const SSeriesStyle& style) {
  SBand band;
  const auto isLonger = [&group](const std::vector<Real>& run) {
    return run.size() != group.Runs.front().size();
  };
  band.HasEnded = std::any_of(group.Runs.begin(), group.Runs.end(), isLonger);
  ApplyToEndedRuns(group.Runs, style.Ended);
  if (!group.Runs.empty()) {
    band.Bands =
        style.ShowsInterval ? ComputeIntervals(group.Runs) : ComputeSeriesBands(group.Runs);
  }
  band.Group = std::move(group);
  return band;
}

void AppendBlock(const SBand& band, SSeriesLines& lines) {
  // an interval may reach below 0 though no value does; fmin() and fmax() ignore NaN
  for (const std::vector<Real>& run : band.Group.Runs) {
    for (const Real value : run) {
      lines.Low = std::fmin(lines.Low, value);
    }
  }
  const SSeriesBands& bands = band.Bands;
  for (size_t i = 0; i < bands.Median.size(); ++i) {
    lines.High = std::fmax(lines.High, bands.Upper[i]);
    lines.Data += FormatForGnuplot(band.Group.Times[i]);
    for (const Real number : {bands.Lower[i], bands.Median[i], bands.Upper[i]}) {
      lines.Data += ' ' + FormatForGnuplot(number);
    }
    lines.Data += fmt::format(" {}\n", bands.Counts[i]);
  }
  lines.Data += bands.Median.empty() ? "NaN NaN NaN NaN 0\n\n\n" : "\n\n";
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
  const bool isCommon = std::all_of(bands.begin(), bands.end(), [&text](const SBand& band) {
    return DescribeRuns(band) == text;
  });
  return isCommon ? text : "";
}

std::string MakeBandPlot(const std::vector<SBand>& all, bool showsCounts) {
  std::string bands;
  std::string lines;
  for (size_t index = 0; index < all.size(); ++index) {
    const SBand& band = all[index];
    const size_t count = band.Bands.Median.size();
    const std::string source = fmt::format("{} index {} every {}", kDataName, index,
                                           (count + kMaxPoints - 1) / kMaxPoints + (count == 0));
    const char* const color = GetColor(index);
    if (band.Group.Runs.size() > 1) {
      bands += fmt::format(
          "{} using 1:2:4 with filledcurves fillstyle transparent solid 0.2 noborder linecolor rgb "
          "'{}' notitle, \\\n  ",
          source, color);
    }
    // with fewer runs it is dashed, below the part of all runs
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

std::string DescribeEnding(const std::vector<SBand>& bands, EEndedRuns rule) {
  if (std::none_of(bands.begin(), bands.end(), [](const SBand& band) { return band.HasEnded; })) {
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
  SSeriesLines lines{"", "", kNoValue, kNoValue, {}, "", ""};
  std::vector<SBand> bands;
  for (SSeriesGroup& group : groups) {
    bands.push_back(ComputeBand(std::move(group), style));
    const SBand& band = bands.back();
    lines.Data +=
        "# " +
        MakeLine(band.Group.Title + (band.Group.Title.empty() ? "" : ": ") + DescribeRuns(band)) +
        '\n';
    AppendBlock(band, lines);
    if (!band.Group.Runs.empty()) {
      lines.Counts.push_back(band.Group.Runs.size());
    }
  }
  lines.CommonRuns = style.JoinsCounts ? FindCommonRuns(bands) : "";
  lines.Plot = MakeBandPlot(bands, lines.CommonRuns.empty());
  lines.Ending = DescribeEnding(bands, style.Ended);
  return lines;
}

}  // namespace argos
