#include <argos3/core/utility/threads/phase_cost.h>

#include <algorithm>

namespace argos {

namespace {

// weights of a measurement that is faster, and one that is slower, than those before
constexpr Real kWeightOfFaster = 0.5;
constexpr Real kWeightOfSlower = 0.125;
// a measurement that is slower by more than this factor counts as one of this factor
constexpr Real kMaxSlowdown = 4.0;

// Of what sharing costs, after each phase that was not shared: the decision for one thread is tried
// again after a few hundred phases.
constexpr Real kRemembered = 1.0 - 1.0 / 512.0;

// adds a measurement to an average
void Average(Real& average, Real measured) {
  if (measured < average) {
    average += kWeightOfFaster * (measured - average);
  } else {
    average += kWeightOfSlower * (std::min(measured, kMaxSlowdown * average) - average);
  }
}

// the same for the cost of an item, 0 before the first measurement
void AverageCost(Real& secondsPerItem, size_t items, Real seconds) {
  if (items == 0 || !(seconds > 0.0)) {
    return;
  }
  const Real measured = seconds / static_cast<Real>(items);
  if (secondsPerItem == 0.0) {
    secondsPerItem = measured;
  } else {
    Average(secondsPerItem, measured);
  }
}

}  // namespace

size_t DivideIntoChunks(size_t items, UInt32 threads, size_t most) {
  const size_t chunks = std::max<size_t>(1, threads) * CPhaseCost::kChunksPerThread;
  return std::clamp<size_t>((items + chunks - 1) / chunks, 1, most);
}

size_t CPhaseCost::ChooseGrain(size_t items, UInt32 threads) const {
  if (m_grain > 0) {
    return m_grain;
  }
  const size_t even = DivideIntoChunks(items, threads, m_mostItems);
  if (m_secondsPerItem == 0.0) {
    return even;
  }
  const Real worthwhile = kChunkSeconds / m_secondsPerItem;
  return worthwhile >= static_cast<Real>(even)
             ? even
             : std::max<size_t>(1, static_cast<size_t>(worthwhile));
}

void CPhaseCost::Add(size_t items, Real seconds) {
  AverageCost(m_secondsPerItem, items, seconds);
}

bool CSharingCost::IsWorthwhile(size_t items, UInt32 threads) const {
  if (m_secondsPerItem == 0.0) {
    return true;
  }
  const Real saved = 1.0 - 1.0 / static_cast<Real>(threads);
  return m_secondsPerItem * static_cast<Real>(items) * saved > m_seconds;
}

void CSharingCost::AddAlone(size_t items, Real seconds) {
  AverageCost(m_secondsPerItem, items, seconds);
  m_seconds = std::max(kMinSeconds, kRemembered * m_seconds);
}

void CSharingCost::AddShared(size_t items, Real seconds, UInt32 threads, size_t callersItems,
                             Real callersSeconds) {
  AverageCost(m_secondsPerItem, callersItems, callersSeconds);
  const Real work = m_secondsPerItem * static_cast<Real>(items);
  Average(m_seconds, std::max(kMinSeconds, seconds - work / static_cast<Real>(threads)));
}

}  // namespace argos
