#ifndef ARGOS3_CAMPAIGN_STATISTICS_SAMPLE_CHECKS_H
#define ARGOS3_CAMPAIGN_STATISTICS_SAMPLE_CHECKS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <span>
#include <string_view>
#include <vector>

namespace argos {

/** Greatest magnitude of a value that the statistics accept: squares of values stay finite. */
constexpr Real kMaxValue = 1e150;

/**
 * Checks a sample before anything is computed from it.
 *
 * @param name  what messages call the sample, "the sample" or "x".
 * @throws CARGoSException if there are fewer than minCount values, or if one is NaN, infinite or
 * of a magnitude above kMaxValue; the text names its place, counted from 1.
 */
void RequireSample(std::span<const Real> values, size_t minCount, std::string_view name);

/** As RequireSample() for each group, of which there must be at least minGroups. */
void RequireGroups(std::span<const std::vector<Real>> groups, size_t minGroups, size_t minCount);

/** @throws CARGoSException unless two samples of pairs have equally many values. */
void RequirePairs(std::span<const Real> x, std::span<const Real> y);

/** @throws CARGoSException unless a confidence level is above 0 and below 1. */
void RequireLevel(Real level);

/** @throws CARGoSException unless a probability is in [0,1]. */
void RequireProbability(Real probability, std::string_view name);

}  // namespace argos

#endif
