#include <argos3/campaign/store/result_export.h>

#include <argos3/campaign/store/result_schema.h>
#include <argos3/core/config.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/output_file.h>
#include <argos3/core/utility/text/lists.h>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>

namespace argos {

namespace {

std::string FormatReal(Real value) {
  return std::isnan(value) ? "" : fmt::format("{}", value);
}

// RFC 4180; line breaks become blanks, so that a row is a line
std::string QuoteField(std::string text) {
  for (char& c : text) {
    c = c == '\n' || c == '\r' ? ' ' : c;
  }
  if (text.find_first_of(",\"#") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string MakeHead(const CResultStore& store, const std::string& units) {
  std::string head = "# argos3 " ARGOS_VERSION "-" ARGOS_RELEASE " campaign\n";
  head += "# campaign: " + QuoteField(store.GetText("file")) + '\n';
  head += "# experiment: " + QuoteField(store.GetText("experiment_file")) + '\n';
  head += "# units: " + units + '\n';
  return head;
}

void AddUnit(const std::string& column, const std::string& unit, std::string& units) {
  if (!unit.empty()) {
    AppendItem(units, fmt::format("{} [{}]", column, unit));
  }
}

typedef std::map<UInt32, std::vector<std::string>> TValuesOfCombinations;

TValuesOfCombinations ReadCombinations(const CResultStore& store) {
  TValuesOfCombinations values;
  for (const SStoredCombination& combination : store.ListCombinations()) {
    values[combination.Id] = combination.Values;
  }
  return values;
}

// the columns of the table runs, by name
std::string FormatRunField(const SStoredRun& run, const std::string& column) {
  const SRunResult& result = run.Result;
  const std::map<std::string, std::string> fields = {
      {"id", std::to_string(run.Id)},
      {"combination", std::to_string(run.Combination)},
      {"seed", std::to_string(run.Seed)},
      {"status", ToText(result.Status)},
      {"attempt", std::to_string(run.Attempt)},
      {"exit_status", std::to_string(result.ExitStatus)},
      {"signal", std::to_string(result.Signal)},
      {"start_up", FormatReal(result.StartUpTime)},
      {"wall", FormatReal(result.WallTime)},
      {"cpu", FormatReal(result.CPUTime)},
      {"total_wall", FormatReal(result.TotalWallTime)},
      {"memory", std::to_string(result.PeakMemory)},
      {"ticks", std::to_string(result.Ticks)},
      {"robots", std::to_string(result.Robots)},
      {"digest", fmt::format("{:016x}", result.Digest)},
      {"machine", run.Machine},
      {"version", run.Version},
      {"started", run.Started}};
  return QuoteField(fields.at(column));
}

std::string FormatMetric(const SRunResult& result, const std::string& name) {
  for (const SMetricValue& metric : result.Metrics) {
    if (metric.Name == name) {
      return FormatReal(metric.Value);
    }
  }
  return "";
}

std::string DescribeUnits(const CResultStore& store, const std::vector<SResultColumn>& columns) {
  static const std::map<std::string, std::string> kUnits = {
      {"start_up", "s"}, {"wall", "s"}, {"cpu", "s"}, {"total_wall", "s"}, {"memory", "bytes"}};
  std::string units;
  for (const SResultColumn& column : columns) {
    const auto unit = kUnits.find(column.Source);
    if (column.Kind == SResultColumn::EKind::Metric) {
      AddUnit(column.Title, store.GetUnit(column.Source, false), units);
    } else if (column.Kind == SResultColumn::EKind::Run && unit != kUnits.end()) {
      AddUnit(column.Title, unit->second, units);
    }
  }
  return units;
}

void ExportRuns(const CResultStore& store, const TValuesOfCombinations& combinations,
                const std::string& path) {
  const std::vector<std::string> factors = store.ListFactors();
  const std::vector<SResultColumn> columns = ListResultColumns(factors, store.ListMetrics());
  COutputFile file(path);
  file << MakeHead(store, DescribeUnits(store, columns));
  for (size_t c = 0; c < columns.size(); ++c) {
    file << (c == 0 ? "" : ",") << columns[c].Title;
  }
  file << '\n';
  for (const SStoredRun& listed : store.ListRuns()) {
    const SStoredRun run = store.FindRun(listed.Id).value_or(listed);
    const std::vector<std::string>& values = combinations.at(run.Combination);
    std::string row;
    size_t factor = 0;
    for (const SResultColumn& column : columns) {
      row += row.empty() ? "" : ",";
      switch (column.Kind) {
        case SResultColumn::EKind::Run:
          row += FormatRunField(run, column.Source);
          break;
        case SResultColumn::EKind::Factor:
          row += QuoteField(values.at(factor++));
          break;
        case SResultColumn::EKind::Metric:
          row += FormatMetric(run.Result, column.Source);
          break;
      }
    }
    file << row << '\n';
  }
  file.Close();
}

void ExportSeries(const CResultStore& store, const TValuesOfCombinations& combinations,
                  const std::string& name, const std::string& path) {
  std::string units;
  AddUnit("value", store.GetUnit(name, true), units);
  COutputFile file(path);
  file << MakeHead(store, units);
  // a factor keeps its name, as in runs.csv
  for (const std::string& factor : store.ListFactors()) {
    file << factor << ',';
  }
  file << "seed,tick,value\n";
  store.ForEachPoint(name, [&](UInt32 combination, UInt32 seed, UInt32 tick, Real value) {
    for (const std::string& text : combinations.at(combination)) {
      file << QuoteField(text) << ',';
    }
    file << fmt::format("{},{},{}\n", seed, tick, FormatReal(value));
  });
  file.Close();
}

}  // namespace

void ExportCSV(const CResultStore& store, const std::string& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    THROW_ARGOSEXCEPTION("the folder \"" << folder
                                         << "\" cannot be created: " << problem.message());
  }
  const TValuesOfCombinations combinations = ReadCombinations(store);
  const std::filesystem::path path(folder);
  ExportRuns(store, combinations, (path / "runs.csv").string());
  for (const std::string& name : store.ListSeries()) {
    ExportSeries(store, combinations, name, (path / ("series_" + name + ".csv")).string());
  }
}

}  // namespace argos
