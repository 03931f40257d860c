#ifndef ARGOS3_CAMPAIGN_DESIGN_REDUCTIONS_H
#define ARGOS3_CAMPAIGN_DESIGN_REDUCTIONS_H

#include <argos3/campaign/design/campaign.h>

#include <span>

namespace argos {

/** The values of a metric at the ends of a run's ticks, as far as they were set. */
struct SObservedValues {
  UInt64 Count = 0;
  Real Sum = 0.0, Min = 0.0, Max = 0.0; /**< 0 without values */
};

/** One of the words of <metric of="..."/>. */
struct SReduction {
  SCollectedMetric::EReduction Value;
  const char* Word;
  /** Called with one value at least. Null: the metric is read after the run, and not in its ticks.
   */
  Real (*Compute)(const SObservedValues& values);
};

/** All reductions, in the order of their enumerators. */
std::span<const SReduction> ListReductions();

/** The row of a reduction. */
const SReduction& FindReduction(SCollectedMetric::EReduction value);

}  // namespace argos

#endif
