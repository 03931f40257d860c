#ifndef ARGOS3_CORE_UTILITY_THREADS_SCHEDULE_H
#define ARGOS3_CORE_UTILITY_THREADS_SCHEDULE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/plugins/factory.h>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * Distributes the items 0..n-1 of a parallel phase over threads; has no effect on results. A new
 * schedule is one new class, in any library: REGISTER_SCHEDULE() gives it the label that an
 * experiment file refers to as `<system method="...">`.
 */
class CSchedule {
 public:
  virtual ~CSchedule() = default;

  /**
   * Starts a phase; called by one thread while no other is inside Next().
   * @param items    number of items.
   * @param grain    items that should stay together, >= 1.
   * @param threads  number of threads that will call Next(), >= 1.
   */
  virtual void Start(size_t items, size_t grain, UInt32 threads) = 0;
  /**
   * Gives @p thread its next chunk of items [begin, end).
   * @return false if there is nothing left for it. Safe on all threads at once.
   */
  virtual bool Next(UInt32 thread, size_t& begin, size_t& end) = 0;
};

/** Equal shares, fixed beforehand: XML `balance_quantity`. */
class CBalanceQuantitySchedule : public CSchedule {
 public:
  void Start(size_t items, size_t grain, UInt32 threads) override;
  bool Next(UInt32 thread, size_t& begin, size_t& end) override;

 private:
  struct alignas(64) STaken {
    bool Value = false;
  };
  size_t m_items = 0;
  size_t m_share = 0;
  std::vector<STaken> m_taken;  // says by thread whether it has had its share
};

/**
 * Threads fetch the next chunk when they finish one: XML `balance_length`.
 *
 * Source: h-dispatch, in C. Pinciroli's thesis, ch. 4.
 */
class CBalanceLengthSchedule : public CSchedule {
 public:
  void Start(size_t items, size_t grain, UInt32 threads) override;
  bool Next(UInt32 thread, size_t& begin, size_t& end) override;

 private:
  size_t m_items = 0;
  size_t m_chunk = 1;
  std::atomic<size_t> m_next{0};
};

/**
 * Makes the schedule of that XML name: one of the above, or one that a library has registered.
 * @throws CARGoSException that lists the known names, if there is none.
 */
std::unique_ptr<CSchedule> CreateSchedule(const std::string& method);

}  // namespace argos

/** Makes a schedule known by a label; see REGISTER_SYMBOL(). */
#define REGISTER_SCHEDULE(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, LONG_DESCRIPTION, \
                          STATUS)                                                                 \
  REGISTER_SYMBOL(CSchedule, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION,                \
                  LONG_DESCRIPTION, STATUS)

#endif
