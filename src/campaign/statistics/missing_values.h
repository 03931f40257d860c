#ifndef ARGOS3_CAMPAIGN_STATISTICS_MISSING_VALUES_H
#define ARGOS3_CAMPAIGN_STATISTICS_MISSING_VALUES_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <span>
#include <vector>

namespace argos {

/** The values of a sample that are there; NaN stands for a missing one. */
struct SPresentValues {
  std::vector<Real> Values;  // have the order of the sample
  size_t NumMissing = 0;
};

/** Drops and counts NaN. Every other function of this folder but Summarize(), the bands of series
 * and the stopping rule throws if it is given one. */
SPresentValues RemoveMissing(std::span<const Real> values);

}  // namespace argos

#endif
