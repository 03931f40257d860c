#include <argos3/campaign/report/comparisons.h>

#include <argos3/campaign/report/report_text.h>

#include <fmt/format.h>

#include <cmath>

namespace argos {

namespace {

std::string WithUnit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + ' ' + unit;
}

std::string DescribeInterval(const SConfidenceInterval& interval) {
  return fmt::format("{} interval {}", FormatLevel(interval.Level),
                     FormatRange(interval.Lower, interval.Upper));
}

}  // namespace

std::string DescribeResult(const SComparisonTable& table, const SComparisonResult& result) {
  const std::string& factor = table.Request.Factor;
  const std::string metric = MakeLine(table.Request.Metric);
  if (!result.Problem.empty()) {
    return "Not tested: " + result.Problem + '.';
  }
  const std::string numbers =
      fmt::format(" ({}, {}; {}).", FormatPValue(result.PValue), result.Statistic, result.Test);
  return result.PValue < kSignificance
             ? fmt::format("{} depends on {}", metric, factor) + numbers
             : fmt::format("No dependence of {} on {} was found", metric, factor) + numbers;
}

std::string DescribePair(const SComparisonTable& table, const SPairComparison& pair) {
  const std::string& factor = table.Request.Factor;
  const std::string numbers =
      fmt::format("({}, {})", DescribeInterval(pair.Interval), FormatPValue(pair.PValue));
  if (pair.PValue >= kSignificance) {
    return MakeLine(
        fmt::format("No difference was found between {0} = {1} and {0} = {2}: shift {3} "
                    "{4}.",
                    factor, pair.First, pair.Second,
                    WithUnit(FormatNumber(pair.Estimate), table.Unit), numbers));
  }
  return MakeLine(fmt::format("Values at {0} = {2} are {5} than at {0} = {1} by {3} {4}.", factor,
                              pair.First, pair.Second,
                              WithUnit(FormatNumber(std::abs(pair.Estimate)), table.Unit), numbers,
                              pair.Estimate < 0.0 ? "smaller" : "greater"));
}

std::string MakeComparisonCSV(const std::vector<SComparisonTable>& tables) {
  std::string csv =
      "metric,factor,paired,others,test,statistic,p_of_all_levels,first,second,n_first,n_second,"
      "shift,lower,upper,level,p,problem\n";
  for (const SComparisonTable& table : tables) {
    const std::string head = QuoteField(table.Request.Metric) + ',' +
                             QuoteField(table.Request.Factor) + ',' +
                             (table.Request.IsPaired ? "true" : "false") + ',';
    if (!table.Problem.empty()) {
      csv += head + std::string(13, ',') + QuoteField(table.Problem) + '\n';
    }
    for (const SComparisonResult& result : table.Results) {
      if (!result.Problem.empty()) {
        csv += head + QuoteField(result.Context) + std::string(13, ',') +
               QuoteField(result.Problem) + '\n';
        continue;
      }
      for (const SPairComparison& pair : result.Pairs) {
        csv += head + QuoteField(result.Context) + ',' + QuoteField(result.Test) + ',' +
               QuoteField(result.Statistic) + ',' + FormatExactly(result.PValue) + ',' +
               QuoteField(pair.First) + ',' + QuoteField(pair.Second);
        csv += fmt::format(",{},{}", pair.FirstCount, pair.SecondCount);
        for (const Real number : {pair.Estimate, pair.Interval.Lower, pair.Interval.Upper,
                                  pair.Interval.Level, pair.PValue}) {
          csv += ',' + FormatExactly(number);
        }
        csv += ",\n";
      }
    }
  }
  return csv;
}

}  // namespace argos
