#include <argos3/campaign/plot/table_figures.h>

#include <argos3/campaign/plot/table_file.h>
#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

namespace argos {

namespace {

constexpr UInt32 kWidth = 720;  // pixels
constexpr const char* kObjectStyle =
    " behind fillstyle solid 1.0 border linecolor rgb '#555555' fillcolor rgb '#bbbbbb' linewidth "
    "0.6\n";

typedef std::pair<Real, Real> TPlace;

struct SPath {
  std::string Robot;
  std::vector<TPlace> Places;
};

bool IsIn(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

[[noreturn]] void ThrowNoRobot(const std::string& robot, const std::vector<std::string>& others) {
  constexpr size_t kMaxNames = 20;
  std::string names;
  for (size_t i = 0; i < std::min(others.size(), kMaxNames); ++i) {
    names += (i == 0 ? "" : ", ") + others[i];
  }
  THROW_ARGOSEXCEPTION("there are no rows of the robot \"" << robot << "\"; others: " << names);
}

std::vector<SPath> ReadPaths(CTableFile& table, const STrajectoryRequest& request) {
  const size_t run = table.FindColumn("run");
  const size_t time = table.FindColumn("time");
  const size_t x = table.FindColumn("x");
  const size_t y = table.FindColumn("y");
  const size_t robot = table.FindColumn("robot");
  std::vector<SPath> paths;
  std::map<std::string, size_t> pathOf;
  std::vector<std::string> others;
  while (table.ReadRow()) {
    if (table.GetNumber(run) != request.Run || !request.Span.Contains(table.GetNumber(time))) {
      continue;
    }
    const std::string& id = table.GetText(robot);
    if (!request.Robots.empty() && !IsIn(request.Robots, id)) {
      if (!IsIn(others, id)) {
        others.push_back(id);
      }
      continue;
    }
    const TPlace place(table.GetNumber(x), table.GetNumber(y));
    if (std::isnan(place.first) || std::isnan(place.second)) {
      continue;
    }
    const auto [path, isNew] = pathOf.emplace(id, paths.size());
    if (isNew) {
      paths.push_back({id, {}});
    }
    paths[path->second].Places.push_back(place);
  }
  for (const std::string& wanted : request.Robots) {
    if (pathOf.count(wanted) == 0) {
      ThrowNoRobot(wanted, others);
    }
  }
  if (paths.empty()) {
    THROW_ARGOSEXCEPTION(table.GetPath() << ": there are no rows with positions to plot");
  }
  return paths;
}

SPlotArea ComputeArea(const CTableFile& table, const std::vector<SPath>& paths) {
  if (table.GetArena()) {
    return *table.GetArena();
  }
  const TPlace first = paths.front().Places.front();
  SPlotArea area{first.first, first.second, first.first, first.second};
  for (const SPath& path : paths) {
    for (const auto& [x, y] : path.Places) {
      area.LowX = std::min(area.LowX, x);
      area.LowY = std::min(area.LowY, y);
      area.HighX = std::max(area.HighX, x);
      area.HighY = std::max(area.HighY, y);
    }
  }
  return area;
}

// a part of the scale "viridis" (S. van der Walt and N. Smith, matplotlib), by polynomials
UInt32 ComputeShade(Real t) {
  // within 0 and 255 for t from 0 to 1
  const auto channel = [](Real value) { return static_cast<UInt32>(value); };
  return channel(68.0 + t * (-40.0 + t * (-160.0 + t * 380.0))) << 16 |
         channel(1.0 + t * (330.0 - t * 105.0)) << 8 | channel(84.0 + t * (300.0 - t * 360.0));
}

// few robots have colours that are easily distinguished, others a scale from blue to green
UInt32 GetPathColor(size_t index, size_t count) {
  constexpr Real kScalePart = 0.85;
  return count <= kMaxColors
             ? static_cast<UInt32>(std::strtoul(GetColor(index) + 1, nullptr, 16))
             : ComputeShade(kScalePart * static_cast<Real>(index) / static_cast<Real>(count - 1));
}

void AppendPlace(const TPlace& place, UInt32 color, std::string& text) {
  text += FormatForGnuplot(place.first) + ' ' + FormatForGnuplot(place.second) +
          fmt::format(" {}\n", color);
}

// blocks of paths, starts and ends: x, y, colour
std::string MakePathData(const std::vector<SPath>& paths) {
  std::string lines = "# x, y, colour: paths, starts, ends\n";
  std::string starts;
  std::string ends;
  for (size_t i = 0; i < paths.size(); ++i) {
    const UInt32 color = GetPathColor(i, paths.size());
    for (const TPlace& place : paths[i].Places) {
      AppendPlace(place, color, lines);
    }
    lines += i + 1 < paths.size() ? "\n" : "\n\n";
    AppendPlace(paths[i].Places.front(), color, starts);
    AppendPlace(paths[i].Places.back(), color, ends);
  }
  return lines + starts + "\n\n" + ends;
}

std::string MakeRange(const char* axis, Real low, Real high, Real margin) {
  return fmt::format("set {}range [{}:{}]\n", axis, FormatForGnuplot(low - margin),
                     FormatForGnuplot(high + margin));
}

// objects are behind the paths: they may have been moved
std::string MakeObjects(const CTableFile& table) {
  std::string text;
  for (const TNumberGroups& polygon : table.GetPolygons()) {
    text += "set object polygon from ";
    for (const std::vector<Real>& corner : polygon) {
      text += FormatForGnuplot(corner[0]) + ',' + FormatForGnuplot(corner[1]) + " to ";
    }
    text += FormatForGnuplot(polygon[0][0]) + ',' + FormatForGnuplot(polygon[0][1]) + kObjectStyle;
  }
  for (const std::vector<Real>& circle : table.GetCircles()) {
    text += "set object circle at " + FormatForGnuplot(circle[0]) + ',' +
            FormatForGnuplot(circle[1]) + " size " + FormatForGnuplot(circle[2]) + kObjectStyle;
  }
  return text;
}

std::string MakePathPlot(const std::vector<SPath>& paths) {
  constexpr size_t kMaxThickPaths = 60;
  const bool isThick = paths.size() <= kMaxThickPaths;
  const Real size = isThick ? 0.9 : 0.3;
  std::string plot = fmt::format(
      "plot {0} index 0 using 1:2:3 with lines linewidth {1} linecolor rgb variable notitle, \\\n"
      "  {0} index 1 using 1:2:3 with points pointtype 7 pointsize {2:.2f} linecolor rgb variable "
      "notitle, \\\n"
      "  {0} index 2 using 1:2:3 with points pointtype 6 pointsize {3} linewidth 1.5 linecolor rgb "
      "variable notitle",
      kDataName, isThick ? 1.3 : 0.4, 0.6 * size, size);
  for (size_t i = 0; i < paths.size() && paths.size() <= kMaxColors; ++i) {
    plot += fmt::format(", \\\n  keyentry with lines linewidth 2 linecolor rgb '{}' title {}",
                        GetColor(i), QuoteForGnuplot(paths[i].Robot));
  }
  return plot + '\n';
}

}  // namespace

SFigureDraft MakeTrajectoryFigure(const STrajectoryRequest& request, SFigureLook& look) {
  CTableFile table(request.File);
  const std::vector<SPath> paths = ReadPaths(table, request);
  const SPlotArea area = ComputeArea(table, paths);
  const Real width = area.HighX - area.LowX;
  const Real height = area.HighY - area.LowY;
  const bool hasKey = paths.size() <= kMaxColors;

  // the arena fills the width beside the labels; tall ones are limited
  const Real ratio = width > 0.0 ? height / width : 1.0;
  look.Width = kWidth;
  look.Height =
      static_cast<UInt32>(std::clamp(600.0 * ratio + 90.0 + (hasKey ? 40.0 : 0.0), 300.0, 1000.0));
  SFigureDraft draft;
  draft.Data = MakePathData(paths);
  const Real margin = 0.02 * std::max({width, height, 1e-6});
  draft.Script = MakeStyle("", "x, m", "y, m") +
                 "set border 15\nunset grid\nset size ratio -1\n"
                 "set key outside bottom center horizontal width 1\n" +
                 MakeRange("x", area.LowX, area.HighX, margin) +
                 MakeRange("y", area.LowY, area.HighY, margin) + MakeObjects(table) +
                 MakePathPlot(paths);
  return draft;
}

}  // namespace argos
