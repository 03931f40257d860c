#include <argos3/campaign/execution/collected_columns.h>

#include <argos3/campaign/execution/metric_collection.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/classic_locale.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <glob.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

namespace argos {

namespace {

std::string FindFile(const std::string& folder, const std::string& pattern) {
  glob_t found{};
  const int error = glob((folder + "/" + pattern).c_str(), 0, nullptr, &found);
  std::string file = error == 0 && found.gl_pathc > 0 ? found.gl_pathv[0] : "";
  globfree(&found);
  if (file.empty()) {
    THROW_ARGOSEXCEPTION("the run has written no file \"" << pattern << "\" to its folder");
  }
  return file;
}

bool IsSeparator(char character) {
  return std::string_view(",;\t ").find(character) != std::string_view::npos;
}

// blanks around other separators count with them
std::vector<std::string> SplitLine(const std::string& line) {
  std::vector<std::string> cells;
  std::string cell;
  bool isQuoted = false;
  bool isPending = true;  // a cell has begun: an empty one counts
  for (const char character : line + "\n") {
    if (character == '"') {
      isQuoted = !isQuoted;
    } else if (character == '\n' || character == '\r' || (!isQuoted && IsSeparator(character))) {
      const bool isBlank = character == ' ' || character == '\n' || character == '\r';
      if (!cell.empty() || (!isBlank && isPending)) {
        cells.push_back(cell);
        isPending = !isBlank;
      } else if (!isBlank) {
        isPending = true;
      }
      cell.clear();
    } else {
      cell += character;
    }
  }
  return cells;
}

Real ToNumber(const std::vector<std::string>& cells, size_t column) {
  const CClassicLocale classic;
  const char* const text = column < cells.size() ? cells[column].c_str() : "";
  char* end = nullptr;
  const Real value = std::strtod(text, &end);
  return end != text && *end == '\0' ? value : std::numeric_limits<Real>::quiet_NaN();
}

size_t FindColumn(const std::vector<std::string>& names, const std::string& name,
                  const std::string& file) {
  const auto place = std::find(names.begin(), names.end(), name);
  if (place == names.end()) {
    THROW_ARGOSEXCEPTION(file << " has no column \"" << name << "\"" << DidYouMean(name, names));
  }
  return static_cast<size_t>(place - names.begin());
}

UInt32 ToTick(Real time, const std::string& file) {
  if (!(time >= 0.0 && time <= std::numeric_limits<UInt32>::max() && std::floor(time) == time)) {
    THROW_ARGOSEXCEPTION(file << ": times must be whole ticks, found " << time);
  }
  return static_cast<UInt32>(time);
}

void CollectColumn(const SCollectedMetric& metric, bool hasNumber, const std::string& folder,
                   SRunResult& result) {
  const std::string file = FindFile(folder, metric.Pattern);
  std::ifstream stream(file);
  std::string line;
  std::vector<std::string> names;
  size_t values = 0;
  size_t times = 0;
  SMetricSeries series{metric.Name, "", {}, {}};
  Real last = std::numeric_limits<Real>::quiet_NaN();
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = SplitLine(line);
    if (cells.empty() || line.front() == '#') {
      continue;
    }
    if (names.empty()) {
      names = cells;
      values = FindColumn(names, metric.ValueColumn, file);
      times = metric.TimeColumn.empty() ? 0 : FindColumn(names, metric.TimeColumn, file);
      continue;
    }
    last = ToNumber(cells, values);
    if (!metric.TimeColumn.empty()) {
      series.Ticks.push_back(ToTick(ToNumber(cells, times), file));
      series.Values.push_back(last);
    }
  }
  if (names.empty()) {
    THROW_ARGOSEXCEPTION(file << " has no line with the names of columns");
  }
  if (hasNumber) {
    result.Metrics.push_back({metric.Name, "", last});
  }
  if (!metric.TimeColumn.empty()) {
    result.Series.push_back(std::move(series));
  }
}

}  // namespace

void CollectColumns(const std::vector<SCollectedMetric>& metrics, const std::string& folder,
                    SRunResult& result) {
  for (const SCollectedMetric& metric : metrics) {
    if (metric.Source == SCollectedMetric::ESource::File) {
      const bool hasNumber = !metric.IsSeries || !IsCollectedAsNumber(metrics, metric.Name);
      CollectColumn(metric, hasNumber, folder, result);
    }
  }
}

}  // namespace argos
