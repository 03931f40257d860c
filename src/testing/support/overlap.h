#ifndef ARGOS3_TESTING_SUPPORT_OVERLAP_H
#define ARGOS3_TESTING_SUPPORT_OVERLAP_H

#include <argos3/core/simulator/space/space.h>

#include <vector>

namespace argos::testing {

/**
 * Overlaps of robots with other bodies, in shares of their radius. Robots count as discs, tilted
 * ones as two discs at their base and their top.
 */
struct SOverlaps {
  std::vector<Real> WithRobots; /**< one entry for each disc: its deepest overlap with a disc */
  std::vector<Real> WithWalls; /**< one entry for each disc: its deepest overlap with a box */
  /** as WithRobots, but only for discs closer to another one than kTouchingGap */
  std::vector<Real> Touching;

  static constexpr Real kTouchingGap = 0.01; /**< in shares of the radius */

  /** The q-quantile of a sample, q in [0,1]; reorders it. */
  static Real Quantile(std::vector<Real>& sample, Real q);
};

/** Measures every robot of the space and appends to @p overlaps. */
void MeasureOverlaps(CSpace& space, SOverlaps& overlaps);

}  // namespace argos::testing

#endif
