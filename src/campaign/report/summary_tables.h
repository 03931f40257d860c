#ifndef ARGOS3_CAMPAIGN_REPORT_SUMMARY_TABLES_H
#define ARGOS3_CAMPAIGN_REPORT_SUMMARY_TABLES_H

#include <argos3/campaign/report/report_data.h>
#include <argos3/campaign/statistics/confidence_interval.h>
#include <argos3/campaign/statistics/sample_summary.h>

#include <optional>
#include <string>
#include <vector>

namespace argos {

/** Of confidence intervals in reports. */
constexpr Real kReportLevel = 0.95;

/** A metric in the runs of one combination. */
struct SSummaryRow {
  size_t Combination = 0;
  SSampleSummary Summary; /**< of runs that are done; NumMissing: those that have not recorded it */
  std::optional<SConfidenceInterval> MeanInterval; /**< Student's t; from two values */
  std::optional<SConfidenceInterval> BootstrapInterval; /**< BCa, of the mean; from two values */
  std::string Problem; /**< why there are no numbers: a value that is infinite */
};

/** How many runs of one combination are done. */
struct SRateRow {
  size_t Combination = 0;
  size_t NumDone = 0; /**< status "done" */
  size_t NumRuns = 0;
  std::optional<SConfidenceInterval> Interval; /**< Wilson's; none without runs */
};

/** A row for each combination of the campaign. @throws CARGoSException as ReadMetric(). */
std::vector<SSummaryRow> SummarizeMetric(const CReportData& data, const std::string& metric);

/** A row for each combination of the campaign. */
std::vector<SRateRow> ComputeSuccessRates(const CReportData& data);

/** All metrics and combinations as CSV, with all digits. */
std::string MakeSummaryCSV(const CReportData& data);

}  // namespace argos

#endif
