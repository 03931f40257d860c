#include <argos3/core/utility/threads/phase_cost.h>

#include <algorithm>

namespace argos {

namespace {

// weights of a measurement that is faster, and one that is slower, than those before
constexpr Real kWeightOfFaster = 0.5;
constexpr Real kWeightOfSlower = 0.125;
// a measurement that is slower by more than this factor counts as one of this factor
constexpr Real kMaxSlowdown = 4.0;

}  // namespace

size_t DivideIntoRuns(size_t items, UInt32 threads, size_t most) {
  const size_t runs = std::max<size_t>(1, threads) * CPhaseCost::kRunsPerThread;
  return std::clamp<size_t>((items + runs - 1) / runs, 1, most);
}

size_t CPhaseCost::ChooseGrain(size_t items, UInt32 threads) const {
  if (m_grain > 0) {
    return m_grain;
  }
  const size_t even = DivideIntoRuns(items, threads, m_mostItems);
  if (m_secondsPerItem == 0.0) {
    return even;
  }
  if (m_secondsPerItem * static_cast<Real>(items) < kMinSeconds) {
    return std::max<size_t>(1, items);
  }
  const Real worthwhile = kRunSeconds / m_secondsPerItem;
  return worthwhile >= static_cast<Real>(even)
             ? even
             : std::max<size_t>(1, static_cast<size_t>(worthwhile));
}

void CPhaseCost::Add(size_t items, Real seconds) {
  if (items == 0 || !(seconds > 0.0)) {
    return;
  }
  const Real measured = seconds / static_cast<Real>(items);
  if (m_secondsPerItem == 0.0) {
    m_secondsPerItem = measured;
  } else if (measured < m_secondsPerItem) {
    m_secondsPerItem += kWeightOfFaster * (measured - m_secondsPerItem);
  } else {
    m_secondsPerItem +=
        kWeightOfSlower * (std::min(measured, kMaxSlowdown * m_secondsPerItem) - m_secondsPerItem);
  }
}

}  // namespace argos
