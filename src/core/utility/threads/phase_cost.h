#ifndef ARGOS3_CORE_UTILITY_THREADS_PHASE_COST_H
#define ARGOS3_CORE_UTILITY_THREADS_PHASE_COST_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/**
 * The measured cost of a phase of the tick, which decides in runs of how many items it is dealt to
 * threads, or that one thread does it alone. Has no effect on results.
 */
class CPhaseCost {
 public:
  /** Work that a run should contain, so that dealing it costs little: s. */
  static constexpr Real kRunSeconds = 20e-6;
  /**
   * A phase with less work stays on the calling thread: s. To wake another one, and to wait for
   * it, takes 5 to 20 us, and far longer on a machine that is busy with something else; half of
   * the work must exceed that by a good margin.
   */
  static constexpr Real kMinSeconds = 100e-6;
  /** Runs per thread, at least, so that threads that finish early can take over others' runs. */
  static constexpr size_t kRunsPerThread = 4;

  /** @param mostItems  of a run, >= 1. */
  explicit CPhaseCost(size_t mostItems) : m_mostItems(mostItems) {}

  /** @param grain  items of a run, whatever they cost; 0 for a number by measured cost. */
  void SetGrain(size_t grain) { m_grain = grain; }
  bool IsMeasured() const { return m_grain == 0; }

  /**
   * Returns the number of items of a run, >= 1; @p items if the calling thread should do all.
   *
   * Before the first measurement, each thread gets kRunsPerThread runs, if there are enough items.
   */
  size_t ChooseGrain(size_t items, UInt32 threads) const;

  /** Adds a measurement of one thread. A slow one counts less: the thread may have been suspended.
   */
  void Add(size_t items, Real seconds);

  /** s an item; 0 before the first measurement. */
  Real GetSecondsPerItem() const { return m_secondsPerItem; }

 private:
  size_t m_mostItems;
  size_t m_grain = 0;
  Real m_secondsPerItem = 0.0;
};

/** Items of a run if there should be kRunsPerThread runs for each thread: 1 to @p most. */
size_t DivideIntoRuns(size_t items, UInt32 threads, size_t most);

}  // namespace argos

#endif
