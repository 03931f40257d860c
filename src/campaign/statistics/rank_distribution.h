#ifndef ARGOS3_CAMPAIGN_STATISTICS_RANK_DISTRIBUTION_H
#define ARGOS3_CAMPAIGN_STATISTICS_RANK_DISTRIBUTION_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <vector>

namespace argos {

/** An exact distribution on 0, ..., max that is symmetric about max / 2. */
class CRankDistribution {
 public:
  /**
   * Wilcoxon's signed-rank statistic under the null hypothesis: the sum of those of 1, ..., n that
   * independent fair coins select.
   *
   * @param n  1 to 1000; time and memory grow as n^3 and n^2.
   * @throws CARGoSException if n is out of range.
   *
   * R: psignrank, qsignrank. Table: F. Wilcoxon and R. A. Wilcox, Some Rapid Approximate
   * Statistical Procedures (1964).
   */
  static CRankDistribution SignedRank(size_t n);

  /**
   * The statistic of Mann and Whitney under the null hypothesis: in how many pairs the value of the
   * first sample is the greater one, all orders of the m + n values being equally probable.
   *
   * @param m,n  1 to 100; time grows as m^2 n^2.
   * @throws CARGoSException if one is out of range.
   *
   * Source: H. B. Mann and D. R. Whitney, "On a test of whether one of two random variables is
   * stochastically larger than the other", Ann. Math. Statist. 18 (1947), recurrence (2).
   * R: pwilcox, qwilcox.
   */
  static CRankDistribution RankSum(size_t m, size_t n);

  size_t GetMax() const { return m_lowerTails.size() - 1; }
  /** P(S <= value). */
  Real ComputeLowerTail(size_t value) const;
  /** P(S >= value). */
  Real ComputeUpperTail(size_t value) const;
  /** The smallest value with P(S <= value) >= probability, but for some roundings; probability in
   * [0,1]. */
  size_t ComputeQuantile(Real probability) const;

 private:
  explicit CRankDistribution(const std::vector<Real>& counts);

  std::vector<Real> m_lowerTails;
};

}  // namespace argos

#endif
