#ifndef ARGOS3_CAMPAIGN_STATISTICS_SEQUENTIAL_MEAN_H
#define ARGOS3_CAMPAIGN_STATISTICS_SEQUENTIAL_MEAN_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>
#include <map>

namespace argos {

/** What the half width of the confidence interval of the mean is measured in. */
enum class EMeanPrecision {
  Absolute,  // the unit of the values
  Relative  // the true mean's magnitude
};

/** When to stop adding runs. */
struct SStoppingRule {
  EMeanPrecision Precision = EMeanPrecision::Absolute;
  Real HalfWidth = 0.0;  // wanted: > 0; below 1 if relative
  Real Level = 0.95;  // level of the interval, in (0,1)
  size_t MinCount = 10;  // values before the rule applies, >= 2
  size_t MaxPositions = 0;  // cap on values including missing ones, >= MinCount
};

enum class EStopDecision { Continue, PrecisionReached, CapReached };

/**
 * Sequential estimate of a mean: values are added until its confidence interval is narrow enough.
 *
 * Values have positions 0, 1, 2, ... (runs in the order of their seeds) and may arrive in any
 * order. The decision takes them in the order of positions and stops at the first position where
 * the rule holds, so it does not depend on which run finishes first; values beyond do not count.
 * A missing value (NaN, a failed run) takes a position but no part in the mean.
 *
 * Absolute precision d: stops at the first n >= MinCount with t(n - 1, Level) s / sqrt(n) <= d.
 * As d goes to 0 the interval covers the mean with probability Level and n approaches
 * (z s / d)^2. Chow and Robbins add 1 / n to s^2 against stopping at a chance s near 0; as
 * that term has no unit, MinCount takes its part, as in Law. A few percent of coverage are lost
 * if MinCount is small, and more for very skewed values. Source: Y. S. Chow and H. Robbins, "On
 * the Asymptotic Theory of Fixed-Width Sequential Confidence Intervals for the Mean", Ann. Math.
 * Statist. 36 (1965).
 *
 * Relative precision g: the same with d = g / (1 + g) |mean of the n values|, which bounds the
 * error relative to the true mean by g. MinCount >= 10 and g <= 0.15 are recommended. A mean
 * near 0 never gets there; the cap ends it. Source: A. M. Law, Simulation Modeling and Analysis,
 * 5th ed. (2015), section 9.4.1; A. Nadas, "An Extension of a Theorem of Chow and Robbins", Ann.
 * Math. Statist. 40 (1969).
 */
class CSequentialMean {
 public:
  /** @throws CARGoSException if a number of the rule is out of its range. */
  explicit CSequentialMean(const SStoppingRule& rule);

  /**
   * Adds the value of a position.
   *
   * @param position  less than MaxPositions; at or beyond the end of the decision without effect.
   * @param value     NaN if missing.
   * @throws CARGoSException if the position has a value or is out of range, or the value is
   * infinite or beyond kMaxValue.
   */
  void Insert(size_t position, Real value);

  EStopDecision GetDecision() const { return m_decision; }
  /** Positions that the decision has taken, without gaps from 0; where it stopped, if it did. */
  size_t GetNumPositions() const { return m_numPositions; }
  /** Values among them. */
  size_t GetCount() const { return m_count; }
  size_t GetNumMissing() const { return m_numPositions - m_count; }
  /** NaN without values. */
  Real GetMean() const;
  /** NaN for fewer than two values. */
  Real GetStandardDeviation() const;
  /** Half the width of the interval now; infinite for fewer than two values. */
  Real GetHalfWidth() const { return m_halfWidth; }
  /** The half width at which to stop, for the mean of now; NaN without values if relative. */
  Real GetTargetHalfWidth() const;
  /**
   * Estimate of the positions after which to stop, from the deviation of now: at least one more
   * than taken, unless stopped, and at most MaxPositions. For planning; the decision ignores it.
   */
  size_t EstimateNumPositions() const;

 private:
  void Take(Real value);
  void Decide();

  SStoppingRule m_rule;
  std::map<size_t, Real> m_waiting;  // values behind a gap
  EStopDecision m_decision = EStopDecision::Continue;
  size_t m_numPositions = 0;
  size_t m_count = 0;
  Real m_mean = 0.0;
  Real m_squares = 0.0;  // sum of squared deviations from the mean
  Real m_halfWidth = std::numeric_limits<Real>::infinity();
};

}  // namespace argos

#endif
