#ifndef ARGOS3_CAMPAIGN_REPORT_COMPARISONS_H
#define ARGOS3_CAMPAIGN_REPORT_COMPARISONS_H

#include <argos3/campaign/report/report_data.h>
#include <argos3/campaign/statistics/confidence_interval.h>

#include <string>
#include <vector>

namespace argos {

/** Below this p value, reports speak of a difference. */
constexpr Real kSignificance = 0.05;

/** Two levels of a factor. */
struct SPairComparison {
  std::string First, Second; /**< levels */
  size_t FirstCount = 0, SecondCount = 0; /**< values; equal if they are paired */
  Real Estimate = 0.0; /**< Hodges and Lehmann's, of the second level minus the first */
  SConfidenceInterval Interval{}; /**< interval of the estimate; not adjusted for several pairs */
  Real PValue = 1.0; /**< has two sides; adjusted by Holm's method if there are several pairs */
};

/** The levels of a factor at fixed levels of the other factors. */
struct SComparisonResult {
  std::string Context; /**< "speed = 2, noise = 0"; empty if there are no other factors */
  std::string Test; /**< "Wilcoxon's rank-sum test" */
  std::string Statistic; /**< "W = 12", "H = 8.1, 2 degrees of freedom" */
  Real PValue = 1.0; /**< tests all levels */
  std::vector<SPairComparison> Pairs; /**< are sorted by first, then second level */
  size_t NumMissing = 0; /**< runs without the value, or seeds without one at every level */
  std::string Problem; /**< is set if it could not be tested; the other members are not used then */
};

/** What an element <compare> asks for. */
struct SComparisonTable {
  SComparison Request;
  std::string Unit; /**< unit of the metric */
  std::vector<SComparisonResult> Results; /**< has one for each combination of the other factors */
  std::string Problem; /**< is set if nothing could be compared */
};

/**
 * Compares the levels of a factor, separately for each combination of the other factors.
 *
 * Two levels: Wilcoxon's rank-sum test, or, paired by seed, the signed-rank test. More: Kruskal and
 * Wallis' test with Dunn's comparisons of pairs; paired: Friedman's test of the seeds that have a
 * value at every level, with signed-rank tests of pairs. P values of pairs are adjusted by Holm's
 * method.
 * @throws CARGoSException if the factor or the metric is unknown, or the factor has one level only.
 */
SComparisonTable CompareLevels(const CReportData& data, const SComparison& request);

/** As CompareLevels(), for all comparisons of the campaign; errors become
 * SComparisonTable::Problem. */
std::vector<SComparisonTable> CompareAll(const CReportData& data);

/** A sentence about a result as a whole, such as "The levels of robots differ: ...". */
std::string DescribeResult(const SComparisonTable& table, const SComparisonResult& result);
/** A sentence about a pair: "Values at robots = 10 are greater than at robots = 5 by ...". */
std::string DescribePair(const SComparisonTable& table, const SPairComparison& pair);

/** All pairs as CSV, with all digits. */
std::string MakeComparisonCSV(const std::vector<SComparisonTable>& tables);

}  // namespace argos

#endif
