#ifndef ARGOS3_CAMPAIGN_STATISTICS_RANK_TEST_RESULT_H
#define ARGOS3_CAMPAIGN_STATISTICS_RANK_TEST_RESULT_H

#include <argos3/campaign/statistics/confidence_interval.h>

namespace argos {

/** Result of one of Wilcoxon's tests. */
struct SRankTestResult {
  Real Statistic;  // V: sum of the ranks of positive differences; W: Mann and Whitney's count
  Real PValue;
  bool IsExact;  // PValue and Interval come from the exact distribution
  Real Estimate;  // Hodges and Lehmann's, of the centre or of the shift
  SConfidenceInterval Interval;  // interval of the same
};

}  // namespace argos

#endif
