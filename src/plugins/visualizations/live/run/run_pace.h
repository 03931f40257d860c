#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_RUN_PACE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_RUN_PACE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <chrono>

namespace argos {

/** When the next tick is due, and how fast ticks are. */
class CRunPace {
 public:
  using TClock = std::chrono::steady_clock;
  /** A run that is late by more than this does not catch up. */
  static constexpr std::chrono::milliseconds kMaxLateness{200};

  explicit CRunPace(Real tickLength) : m_tickLength(tickLength) {}

  /** @param speed  simulated seconds in a second; 0: as fast as it goes. */
  void SetSpeed(Real speed) { m_speed = speed; }
  Real GetSpeed() const { return m_speed; }
  /** The run goes on after a pause: the next tick is due now. */
  void Restart(TClock::time_point now);
  bool IsDue(TClock::time_point now) const { return m_speed == 0.0 || now >= m_due; }
  TClock::time_point GetDueTime() const { return m_due; }
  void CountTick(TClock::time_point now);
  /** Measured over about the last second of playing; 0 before. */
  Real GetRealTimeFactor() const { return m_factor; }

 private:
  Real m_tickLength;  // s
  Real m_speed = 1.0;
  TClock::time_point m_due;
  TClock::time_point m_measureStart;
  UInt32 m_numTicks = 0;  // since m_measureStart
  Real m_factor = 0.0;
};

}  // namespace argos

#endif
