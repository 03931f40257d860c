#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_MESSAGE_LIMIT_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_MESSAGE_LIMIT_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <algorithm>
#include <chrono>

namespace argos {

/** Lets through so many messages a second, and as many at once after a pause. */
class CMessageLimit {
 public:
  using TClock = std::chrono::steady_clock;
  static constexpr Real kMessagesPerSecond = 100.0;

  /** @return false if this message is one too many. */
  bool Take(TClock::time_point now) {
    const std::chrono::duration<Real> passed = now - m_last;
    m_last = now;
    m_left = std::min(m_left + passed.count() * kMessagesPerSecond, kMessagesPerSecond);
    if (m_left < 1.0) {
      return false;
    }
    m_left -= 1.0;
    return true;
  }

 private:
  Real m_left = kMessagesPerSecond;
  TClock::time_point m_last = TClock::now();
};

}  // namespace argos

#endif
