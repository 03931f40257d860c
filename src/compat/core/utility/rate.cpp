#include <argos3/core/utility/rate.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <cmath>
#include <thread>

namespace argos {

CRate::CRate(Real rate) : m_rate(rate), m_start(TClock::now()) {
  SetRate(rate);
}

UInt64 CRate::ElapsedUS() const {
  return static_cast<UInt64>(
      std::chrono::duration_cast<std::chrono::microseconds>(TClock::now() - m_start).count());
}

Real CRate::ElapsedS() const {
  return std::chrono::duration<Real>(TClock::now() - m_start).count();
}

void CRate::Sleep() {
  const TClock::time_point end = m_start + m_period;
  if (TClock::now() < end) {
    std::this_thread::sleep_until(end);
    m_start = end;
  } else {
    m_start = TClock::now();
  }
}

void CRate::SetRate(Real rate) {
  if (!(rate > 0.0) || !std::isfinite(rate)) {
    THROW_ARGOSEXCEPTION("The rate is " << rate << " rounds per second, expected a number > 0");
  }
  m_rate = rate;
  m_period = std::chrono::duration_cast<TClock::duration>(std::chrono::duration<Real>(1.0 / rate));
}

}  // namespace argos
