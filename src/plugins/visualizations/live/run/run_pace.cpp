#include <argos3/plugins/simulator/visualizations/live/run/run_pace.h>

namespace argos {

namespace {

constexpr std::chrono::seconds kMeasuredTime(1);

}  // namespace

void CRunPace::Restart(TClock::time_point now) {
  m_due = now;
  m_measureStart = now;
  m_numTicks = 0;
}

void CRunPace::CountTick(TClock::time_point now) {
  if (m_speed > 0.0) {
    m_due += std::chrono::duration_cast<TClock::duration>(
        std::chrono::duration<Real>(m_tickLength / m_speed));
    if (m_due + kMaxLateness < now) {
      m_due = now;
    }
  }
  ++m_numTicks;
  const std::chrono::duration<Real> passed = now - m_measureStart;
  if (passed >= kMeasuredTime) {
    m_factor = m_numTicks * m_tickLength / passed.count();
    m_measureStart = now;
    m_numTicks = 0;
  }
}

}  // namespace argos
