#ifndef ARGOS3_COMPAT_CORE_UTILITY_SIGNAL_PROCESSING_H
#define ARGOS3_COMPAT_CORE_UTILITY_SIGNAL_PROCESSING_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/**
 * Mean and variance of a stream of numbers, in constant memory.
 * Source: Welford, Note on a method for calculating corrected sums of squares and products,
 *         Technometrics 4 (1962).
 */
class CStats {
 public:
  CStats() = default;

  /** 0 if there are no numbers. */
  Real GetMean() const { return m_mean; }

  /** The sample variance, with n - 1 in the denominator; 0 if there are fewer than two numbers. */
  Real GetVariance() const;

  /** The square root of the variance. */
  Real GetStdDev() const;

  void Append(Real value);

 private:
  UInt64 m_count = 0;
  Real m_mean = 0.0;
  Real m_sumOfSquares = 0.0;  // of the differences from the mean
};

/**
 * The discrete RC low-pass filter: output = x + a * (previous output - x). The first output is the
 * first value.
 */
class CRCLowPassFilter {
 public:
  /**
   * @param smoothingFactor  a, in [0,1): 0 disables smoothing, values near 1 follow slowly. For a
   *   time constant RC and a tick T, a = RC / (RC + T).
   */
  CRCLowPassFilter(Real smoothingFactor) : m_smoothingFactor(smoothingFactor) {}

  /** @return the output for the next value. */
  Real Filter(Real value);

  /** Clears the filter: the next output is the next value. */
  void Reset() { m_hasOutput = false; }

 private:
  Real m_smoothingFactor;
  Real m_output = 0.0;
  bool m_hasOutput = false;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/math/general.h>
#endif

#endif
