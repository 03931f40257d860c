#ifndef ARGOS3_COMPAT_CORE_UTILITY_RATE_H
#define ARGOS3_COMPAT_CORE_UTILITY_RATE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <chrono>

namespace argos {

/** Paces a loop in wall time: call Sleep() at the end of each round. */
class CRate {
 public:
  /**
   * Starts the first round.
   * @param rate  rounds per second, > 0.
   * @throws CARGoSException if the rate is not positive.
   */
  CRate(Real rate);

  /** Wall time since the round started, in microseconds. */
  UInt64 ElapsedUS() const;

  /** Wall time since the round started, in seconds. */
  Real ElapsedS() const;

  /**
   * Sleeps until the end of the round and starts the next one. A round that took too long is not
   * compensated: the next one has its full length.
   */
  void Sleep();

  /** Rounds per second. */
  Real GetRate() const { return m_rate; }

  /** @throws CARGoSException if the rate is not positive. */
  void SetRate(Real rate);

 private:
  typedef std::chrono::steady_clock TClock;

  Real m_rate;
  TClock::duration m_period{};
  TClock::time_point m_start;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/math/general.h>
#endif

#endif
