#include <argos3/campaign/statistics/rank_p_value.h>

#include <argos3/campaign/statistics/probability.h>

#include <algorithm>
#include <cmath>

namespace argos {

Real ComputeExactPValue(size_t statistic, const CRankDistribution& distribution,
                        EAlternative alternative) {
  const Real lower = distribution.ComputeLowerTail(statistic);
  const Real upper = distribution.ComputeUpperTail(statistic);
  switch (alternative) {
    case EAlternative::Less:
      return lower;
    case EAlternative::Greater:
      return upper;
    case EAlternative::TwoSided:
      break;
  }
  return std::min(1.0, 2.0 * std::min(lower, upper));
}

Real ComputeNormalPValue(Real excess, Real deviation, EAlternative alternative) {
  if (deviation <= 0.0) {
    return 1.0;
  }
  switch (alternative) {
    case EAlternative::Less:
      return ComputeNormalLowerTail((excess + 0.5) / deviation);
    case EAlternative::Greater:
      return ComputeNormalUpperTail((excess - 0.5) / deviation);
    case EAlternative::TwoSided:
      break;
  }
  const Real distance = std::abs(excess);
  const Real corrected = distance > 0.0 ? distance - 0.5 : 0.0;
  return std::min(1.0, 2.0 * ComputeNormalUpperTail(corrected / deviation));
}

}  // namespace argos
