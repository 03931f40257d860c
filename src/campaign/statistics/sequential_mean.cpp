#include <argos3/campaign/statistics/sequential_mean.h>

#include <argos3/campaign/statistics/mean_interval.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <cmath>

namespace argos {

CSequentialMean::CSequentialMean(const SStoppingRule& rule) : m_rule(rule) {
  RequireLevel(rule.Level);
  const bool isRelative = rule.Precision == EMeanPrecision::Relative;
  // the condition is false for NaN, too
  if (!(rule.HalfWidth > 0.0 && rule.HalfWidth < (isRelative ? 1.0 : kMaxValue))) {
    THROW_ARGOSEXCEPTION("stopping rule: half width "
                         << rule.HalfWidth << "; it must be positive"
                         << (isRelative ? ", and below 1 as a share of the mean" : ", and finite"));
  }
  if (rule.MinCount < 2) {
    THROW_ARGOSEXCEPTION("stopping rule: least number of values "
                         << rule.MinCount << "; at least 2 are needed for a deviation");
  }
  if (rule.MaxPositions < rule.MinCount) {
    THROW_ARGOSEXCEPTION("stopping rule: greatest number of values "
                         << rule.MaxPositions << " is below the least, " << rule.MinCount);
  }
}

void CSequentialMean::Insert(size_t position, Real value) {
  if (position >= m_rule.MaxPositions) {
    THROW_ARGOSEXCEPTION("stopping rule: position " << position << " is beyond the cap of "
                                                    << m_rule.MaxPositions << " values");
  }
  if (!std::isnan(value)) {
    RequireSample(std::span(&value, 1), 1, "stopping rule");
  }
  if (m_decision != EStopDecision::Continue && position >= m_numPositions) {
    return;
  }
  if (position < m_numPositions || !m_waiting.emplace(position, value).second) {
    THROW_ARGOSEXCEPTION("stopping rule: position " << position << " has a value already");
  }
  for (auto next = m_waiting.begin(); next != m_waiting.end() && next->first == m_numPositions &&
                                      m_decision == EStopDecision::Continue;
       next = m_waiting.erase(next)) {
    Take(next->second);
    Decide();
  }
  if (m_decision != EStopDecision::Continue) {
    m_waiting.clear();
  }
}

void CSequentialMean::Take(Real value) {
  ++m_numPositions;
  if (std::isnan(value)) {
    return;
  }
  ++m_count;
  const Real deviation = value - m_mean;
  m_mean += deviation / static_cast<Real>(m_count);
  m_squares += deviation * (value - m_mean);
  if (m_count >= 2) {
    m_halfWidth = ComputeMeanHalfWidth(m_count, GetStandardDeviation(), m_rule.Level);
  }
}

void CSequentialMean::Decide() {
  if (m_count >= m_rule.MinCount && m_halfWidth <= GetTargetHalfWidth()) {
    m_decision = EStopDecision::PrecisionReached;
  } else if (m_numPositions >= m_rule.MaxPositions) {
    m_decision = EStopDecision::CapReached;
  }
}

Real CSequentialMean::GetMean() const {
  return m_count > 0 ? m_mean : std::numeric_limits<Real>::quiet_NaN();
}

Real CSequentialMean::GetStandardDeviation() const {
  return m_count > 1 ? std::sqrt(m_squares / static_cast<Real>(m_count - 1))
                     : std::numeric_limits<Real>::quiet_NaN();
}

Real CSequentialMean::GetTargetHalfWidth() const {
  if (m_rule.Precision == EMeanPrecision::Absolute) {
    return m_rule.HalfWidth;
  }
  return m_rule.HalfWidth / (1.0 + m_rule.HalfWidth) * std::abs(GetMean());
}

size_t CSequentialMean::EstimateNumPositions() const {
  if (m_decision != EStopDecision::Continue) {
    return m_numPositions;
  }
  const size_t least = std::max(m_numPositions + 1, m_rule.MinCount + GetNumMissing());
  Real estimate = 0.0;
  if (m_count >= m_rule.MinCount) {
    const Real excess = m_halfWidth / GetTargetHalfWidth();
    estimate = std::ceil(static_cast<Real>(m_numPositions) * excess * excess);
  }
  const auto most = static_cast<Real>(m_rule.MaxPositions);
  return static_cast<size_t>(std::clamp(estimate, std::min(static_cast<Real>(least), most), most));
}

}  // namespace argos
