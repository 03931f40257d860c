#ifndef ARGOS3_CAMPAIGN_STATISTICS_GROUP_RANKS_H
#define ARGOS3_CAMPAIGN_STATISTICS_GROUP_RANKS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <span>
#include <vector>

namespace argos {

/** Ranks of the values of several groups among all of them. */
struct SGroupRanks {
  std::vector<Real> RankSums;  // (number of groups)
  size_t Count = 0;  // number of all values
  Real TieTerm = 0.0;  // see SRanking
};

/** @param groups  without NaN. */
SGroupRanks RankGroups(std::span<const std::vector<Real>> groups);

}  // namespace argos

#endif
