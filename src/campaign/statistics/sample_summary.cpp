#include <argos3/campaign/statistics/sample_summary.h>

#include <argos3/campaign/statistics/missing_values.h>
#include <argos3/campaign/statistics/moments.h>
#include <argos3/campaign/statistics/quantile.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <algorithm>
#include <vector>

namespace argos {

SSampleSummary Summarize(std::span<const Real> values) {
  const SPresentValues present = RemoveMissing(values);
  RequireSample(present.Values, 0, "sample");
  SSampleSummary summary;
  summary.Count = present.Values.size();
  summary.NumMissing = present.NumMissing;
  if (present.Values.empty()) {
    return summary;
  }
  const SMoments moments = ComputeMoments(present.Values);
  const std::vector<Real> sorted = Sorted(present.Values);
  summary.Mean = moments.Mean;
  summary.StandardDeviation = moments.StandardDeviation;
  summary.Min = sorted.front();
  summary.LowerQuartile = ComputeQuantile(sorted, 0.25);
  summary.Median = ComputeMedian(sorted);
  summary.UpperQuartile = ComputeQuantile(sorted, 0.75);
  summary.Max = sorted.back();
  return summary;
}

}  // namespace argos
