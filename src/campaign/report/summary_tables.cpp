#include <argos3/campaign/report/summary_tables.h>

#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/statistics/bootstrap_interval.h>
#include <argos3/campaign/statistics/mean_interval.h>
#include <argos3/campaign/statistics/missing_values.h>
#include <argos3/campaign/statistics/proportion_interval.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <fmt/format.h>

namespace argos {

namespace {

void FillRow(const std::vector<Real>& values, SSummaryRow& row) {
  try {
    row.Summary = Summarize(values);
    const std::vector<Real> present = RemoveMissing(values).Values;
    if (present.size() >= 2) {
      row.MeanInterval = ComputeMeanInterval(present, kReportLevel);
      SBootstrapOptions options;
      options.Level = kReportLevel;
      row.BootstrapInterval = ComputeBcaInterval(present, options);
    }
  } catch (const CARGoSException& error) {
    row = {row.Combination, {}, {}, {}, DescribeProblem(error)};
  }
}

std::string FormatInterval(const std::optional<SConfidenceInterval>& interval) {
  return interval ? FormatExactly(interval->Lower) + ',' + FormatExactly(interval->Upper) : ",";
}

}  // namespace

std::vector<SSummaryRow> SummarizeMetric(const CReportData& data, const std::string& metric) {
  const size_t count = data.GetCampaign().Combinations.size();
  std::vector<std::vector<Real>> values(count);
  for (const SRunValue& value : data.ReadMetric(metric)) {
    values[value.Combination].push_back(value.Value);
  }
  std::vector<SSummaryRow> rows(count);
  for (size_t i = 0; i < count; ++i) {
    rows[i].Combination = i;
    FillRow(values[i], rows[i]);
  }
  return rows;
}

std::vector<SRateRow> ComputeSuccessRates(const CReportData& data) {
  std::vector<SRateRow> rows(data.GetCampaign().Combinations.size());
  for (const SStoredRun& run : data.GetRuns()) {
    SRateRow& row = rows[data.GetCombination(run)];
    ++row.NumRuns;
    row.NumDone += run.Result.Status == ERunStatus::Done ? 1 : 0;
  }
  for (size_t i = 0; i < rows.size(); ++i) {
    rows[i].Combination = i;
    if (rows[i].NumRuns > 0) {
      rows[i].Interval = ComputeProportionInterval(rows[i].NumDone, rows[i].NumRuns, kReportLevel);
    }
  }
  return rows;
}

std::string MakeSummaryCSV(const CReportData& data) {
  std::string csv = "metric,unit";
  for (const SFactor& factor : data.GetCampaign().Factors) {
    csv += ',' + QuoteField(factor.Name);
  }
  csv +=
      ",n,missing,mean,sd,min,lower_quartile,median,upper_quartile,max,t_lower,t_upper,bca_lower,"
      "bca_upper\n";
  for (const std::string& metric : data.GetStore().ListMetrics()) {
    for (const SSummaryRow& row : SummarizeMetric(data, metric)) {
      csv += QuoteField(metric) + ',' + QuoteField(data.GetStore().GetUnit(metric, false));
      for (const std::string& value : data.GetCampaign().Combinations[row.Combination].Values) {
        csv += ',' + QuoteField(value);
      }
      const SSampleSummary& summary = row.Summary;
      csv += fmt::format(",{},{}", summary.Count, summary.NumMissing);
      for (const Real number :
           {summary.Mean, summary.StandardDeviation, summary.Min, summary.LowerQuartile,
            summary.Median, summary.UpperQuartile, summary.Max}) {
        csv += ',' + FormatExactly(number);
      }
      csv += ',' + FormatInterval(row.MeanInterval) + ',' + FormatInterval(row.BootstrapInterval) +
             '\n';
    }
  }
  return csv;
}

}  // namespace argos
