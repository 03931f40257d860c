#ifndef ARGOS3_CORE_UTILITY_THREADS_PHASE_COST_H
#define ARGOS3_CORE_UTILITY_THREADS_PHASE_COST_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/**
 * The measured cost of a phase of the tick, which decides in chunks of how many items it is dealt
 * to threads. Has no effect on results.
 */
class CPhaseCost {
 public:
  /** Work that a chunk should contain, so that dealing it costs little: s. */
  static constexpr Real kChunkSeconds = 20e-6;
  /** Chunks per thread, at least, so that threads that finish early can take over others'. */
  static constexpr size_t kChunksPerThread = 4;

  /** @param mostItems  of a chunk, >= 1. */
  explicit CPhaseCost(size_t mostItems) : m_mostItems(mostItems) {}

  /** @param grain  items of a chunk, whatever they cost; 0 for a number by measured cost. */
  void SetGrain(size_t grain) { m_grain = grain; }
  bool IsMeasured() const { return m_grain == 0; }

  /**
   * Returns the number of items of a chunk, >= 1.
   *
   * Before the first measurement, each thread gets kChunksPerThread chunks, if there are enough
   * items.
   */
  size_t ChooseGrain(size_t items, UInt32 threads) const;

  /** Adds a measurement of one thread. Slow ones count less: the thread may have been suspended. */
  void Add(size_t items, Real seconds);

  /** s an item; 0 before the first measurement. */
  Real GetSecondsPerItem() const { return m_secondsPerItem; }

 private:
  size_t m_mostItems;
  size_t m_grain = 0;
  Real m_secondsPerItem = 0.0;
};

/**
 * What it costs to share a phase with other threads: to wake them, and to wait for them. By
 * measurement, because that takes longer where they sleep than while they look for work, and far
 * longer on a machine that is busy with something else. Decides whether a phase is shared. Has no
 * effect on results.
 */
class CSharingCost {
 public:
  /** The least that is assumed, s. */
  static constexpr Real kMinSeconds = 5e-6;

  /** @return whether threads are expected to gain time; true before the first measurement. */
  bool IsWorthwhile(size_t items, UInt32 threads) const;

  /** Adds a phase that the calling thread did alone. Sharing slowly becomes worth a trial. */
  void AddAlone(size_t items, Real seconds);

  /**
   * Adds a phase that threads shared.
   * @param seconds         from its begin to its end, by the clock.
   * @param callersItems    what the calling thread did of it, which tells the cost of an item.
   * @param callersSeconds  the time that it took for that.
   */
  void AddShared(size_t items, Real seconds, UInt32 threads, size_t callersItems,
                 Real callersSeconds);

  /** s of a phase, beside its work. */
  Real GetSeconds() const { return m_seconds; }

 private:
  Real m_secondsPerItem = 0.0;
  Real m_seconds = kMinSeconds;
};

/** Items of a chunk if there should be kChunksPerThread of them for each thread: 1 to @p most. */
size_t DivideIntoChunks(size_t items, UInt32 threads, size_t most);

}  // namespace argos

#endif
