#ifndef ARGOS3_CAMPAIGN_STATISTICS_PAIRWISE_POINTS_H
#define ARGOS3_CAMPAIGN_STATISTICS_PAIRWISE_POINTS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <span>
#include <vector>

namespace argos {

/**
 * The points that Hodges-Lehmann estimates and intervals are made of, in ascending order, without
 * storing them.
 *
 * One sample: the n (n + 1) / 2 Walsh averages (x_i + x_j) / 2, i <= j. Two samples: the m n
 * differences x_i - y_j.
 */
class CPairwisePoints {
 public:
  static CPairwisePoints WalshAverages(std::span<const Real> x);
  static CPairwisePoints Differences(std::span<const Real> x, std::span<const Real> y);

  size_t GetCount() const;
  /** The point of an index, from 0, in O((m + n) 64) time. */
  Real Select(size_t index) const;
  /** The Hodges-Lehmann estimate. */
  Real ComputeMedian() const;

 private:
  size_t CountUpTo(Real limit) const;

  // ascending: halves of x twice; or x, and -y
  std::vector<Real> m_first;
  std::vector<Real> m_second;
  bool m_isOneSample = false;
};

}  // namespace argos

#endif
