#include <argos3/campaign/statistics/pairwise_points.h>

#include <argos3/campaign/statistics/quantile.h>

#include <algorithm>
#include <bit>
#include <limits>

namespace argos {

namespace {

// an order-preserving map between finite numbers and integers
SInt64 ToInteger(Real value) {
  const auto bits = std::bit_cast<SInt64>(value + 0.0);  // no -0
  return bits >= 0 ? bits : std::numeric_limits<SInt64>::min() - bits;
}

Real ToReal(SInt64 key) {
  return std::bit_cast<Real>(key >= 0 ? key : std::numeric_limits<SInt64>::min() - key);
}

}  // namespace

CPairwisePoints CPairwisePoints::WalshAverages(std::span<const Real> x) {
  CPairwisePoints points;
  points.m_first = Sorted(x);
  for (Real& value : points.m_first) {
    value *= 0.5;
  }
  points.m_second = points.m_first;
  points.m_isOneSample = true;
  return points;
}

CPairwisePoints CPairwisePoints::Differences(std::span<const Real> x, std::span<const Real> y) {
  CPairwisePoints points;
  points.m_first = Sorted(x);
  points.m_second.assign(y.begin(), y.end());
  for (Real& value : points.m_second) {
    value = -value;
  }
  std::sort(points.m_second.begin(), points.m_second.end());
  return points;
}

size_t CPairwisePoints::GetCount() const {
  const size_t n = m_first.size();
  return m_isOneSample ? n * (n + 1) / 2 : n * m_second.size();
}

size_t CPairwisePoints::CountUpTo(Real limit) const {
  size_t count = 0;
  size_t partners = m_second.size();
  size_t withItself = 0;
  for (const Real value : m_first) {
    while (partners > 0 && value + m_second[partners - 1] > limit) {
      --partners;
    }
    count += partners;
    withItself += value + value <= limit ? 1 : 0;
  }
  return m_isOneSample ? (count + withItself) / 2 : count;
}

Real CPairwisePoints::Select(size_t index) const {
  SInt64 lower = ToInteger(m_first.front() + m_second.front());
  SInt64 upper = ToInteger(m_first.back() + m_second.back());
  while (lower < upper) {
    // rounds down, and does not overflow
    const SInt64 middle = (lower & upper) + ((lower ^ upper) >> 1);
    if (CountUpTo(ToReal(middle)) > index) {
      upper = middle;
    } else {
      lower = middle + 1;
    }
  }
  return ToReal(lower);
}

Real CPairwisePoints::ComputeMedian() const {
  const size_t count = GetCount();
  const Real upper = Select(count / 2);
  return count % 2 == 1 ? upper : 0.5 * (Select(count / 2 - 1) + upper);
}

}  // namespace argos
