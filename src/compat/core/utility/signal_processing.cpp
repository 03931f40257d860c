#include <argos3/core/utility/signal_processing.h>

#include <cmath>

namespace argos {

Real CStats::GetVariance() const {
  return m_count < 2 ? 0.0 : m_sumOfSquares / static_cast<Real>(m_count - 1);
}

Real CStats::GetStdDev() const {
  return std::sqrt(GetVariance());
}

void CStats::Append(Real value) {
  ++m_count;
  const Real difference = value - m_mean;
  m_mean += difference / static_cast<Real>(m_count);
  m_sumOfSquares += difference * (value - m_mean);
}

Real CRCLowPassFilter::Filter(Real value) {
  m_output = m_hasOutput ? value + m_smoothingFactor * (m_output - value) : value;
  m_hasOutput = true;
  return m_output;
}

}  // namespace argos
