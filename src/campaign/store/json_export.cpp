#include <argos3/campaign/store/result_export.h>

#include <argos3/core/utility/files/output_file.h>
#include <argos3/core/utility/text/lists.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/support/json_quoting.h>

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace argos {

namespace {

std::string FormatNumber(Real value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

// a number if the text is one
std::string FormatLevel(const std::string& text) {
  Real number = 0.0;
  return ParseNumber(text, number) == ENumberParsing::Ok ? FormatNumber(number)
                                                         : QuoteForJson(text);
}

std::string FormatRun(const SStoredRun& run, const std::vector<std::string>& factors,
                      const std::vector<std::string>& levels) {
  const SRunResult& result = run.Result;
  std::string text =
      fmt::format("{{\"id\": {}, \"combination\": {}, \"factors\": {{", run.Id, run.Combination);
  for (size_t f = 0; f < factors.size(); ++f) {
    text += fmt::format("{}{}: {}", f == 0 ? "" : ", ", QuoteForJson(factors[f]),
                        FormatLevel(levels[f]));
  }
  text += fmt::format(
      "}}, \"seed\": {}, \"status\": {}, \"attempt\": {}, \"exit_status\": {}, \"signal\": {}, "
      "\"start_up\": {}, \"wall\": {}, \"cpu\": {}, \"total_wall\": {}, \"memory\": {}, \"ticks\": "
      "{}, \"robots\": {}, \"digest\": \"{:016x}\", \"started\": {}, \"machine\": {}, \"version\": "
      "{}, \"metrics\": {{",
      run.Seed, QuoteForJson(ToText(result.Status)), run.Attempt, result.ExitStatus, result.Signal,
      FormatNumber(result.StartUpTime), FormatNumber(result.WallTime), FormatNumber(result.CPUTime),
      FormatNumber(result.TotalWallTime), result.PeakMemory, result.Ticks, result.Robots,
      result.Digest, QuoteForJson(run.Started), QuoteForJson(run.Machine),
      QuoteForJson(run.Version));
  for (size_t m = 0; m < result.Metrics.size(); ++m) {
    text += fmt::format("{}{}: {}", m == 0 ? "" : ", ", QuoteForJson(result.Metrics[m].Name),
                        FormatNumber(result.Metrics[m].Value));
  }
  return text + "}}";
}

void WriteHead(const CResultStore& store, COutputFile& file) {
  file << "{\"campaign\": " << QuoteForJson(store.GetText("file"))
       << ",\n\"experiment\": " << QuoteForJson(store.GetText("experiment_file"))
       << ",\n\"factors\": [";
  const char* separator = "";
  for (const std::string& factor : store.ListFactors()) {
    file << separator << QuoteForJson(factor);
    separator = ", ";
  }
  file << "],\n\"metrics\": {";
  separator = "";
  for (const std::string& metric : store.ListMetrics()) {
    file << separator << QuoteForJson(metric) << ": " << QuoteForJson(store.GetUnit(metric, false));
    separator = ", ";
  }
  file << '}';
}

void WriteRuns(const CResultStore& store, COutputFile& file) {
  std::map<UInt32, std::vector<std::string>> levels;
  for (const SStoredCombination& combination : store.ListCombinations()) {
    levels[combination.Id] = combination.Values;
  }
  const std::vector<std::string> factors = store.ListFactors();
  file << ",\n\"runs\": [";
  const char* separator = "\n";
  for (const SStoredRun& listed : store.ListRuns()) {
    const SStoredRun run = store.FindRun(listed.Id).value_or(listed);
    file << separator << FormatRun(run, factors, levels.at(run.Combination));
    separator = ",\n";
  }
  file << ']';
}

/** Writes the series of one run after the other. */
class CSeriesWriter {
 public:
  CSeriesWriter(const CResultStore& store, COutputFile& file) : m_store(store), m_file(file) {}

  void Write(const std::string& name) {
    const std::string unit = m_store.GetUnit(name, true);
    bool isOpen = false;
    UInt32 combination = 0;
    UInt32 seed = 0;
    m_store.ForEachPoint(name, [&](UInt32 c, UInt32 s, UInt32 tick, Real value) {
      if (!isOpen || c != combination || s != seed) {
        End(isOpen);
        m_file
            << m_separator
            << fmt::format(
                   "{{\"name\": {}, \"unit\": {}, \"combination\": {}, \"seed\": {}, \"ticks\": [",
                   QuoteForJson(name), QuoteForJson(unit), c, s);
        m_separator = ",\n";
        m_values.clear();
        isOpen = true;
        combination = c;
        seed = s;
      }
      m_file << (m_values.empty() ? "" : ", ") << tick;
      AppendItem(m_values, FormatNumber(value));
    });
    End(isOpen);
  }

 private:
  void End(bool isOpen) {
    if (isOpen) {
      m_file << "], \"values\": [" << m_values << "]}";
    }
  }

  const CResultStore& m_store;
  COutputFile& m_file;
  const char* m_separator = "\n";
  std::string m_values;  // values of the run
};

}  // namespace

void ExportJSON(const CResultStore& store, const std::string& file) {
  COutputFile output(file);
  WriteHead(store, output);
  WriteRuns(store, output);
  output << ",\n\"series\": [";
  CSeriesWriter series(store, output);
  for (const std::string& name : store.ListSeries()) {
    series.Write(name);
  }
  output << "]}\n";
  output.Close();
}

}  // namespace argos
