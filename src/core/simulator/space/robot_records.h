#ifndef ARGOS3_CORE_SIMULATOR_SPACE_ROBOT_RECORDS_H
#define ARGOS3_CORE_SIMULATOR_SPACE_ROBOT_RECORDS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/utility/spatial/counting_sort.h>

#include <string>
#include <string_view>
#include <vector>

namespace argos {

/**
 * What robots record in a loop over robots, on several threads at a time: gathered by thread, then
 * taken in the order of the robots.
 *
 * Begin(); on each thread a CScope, SetRobot() before each robot, and Add() from its code; End().
 * A robot is run by one thread in a loop, so its records are in the order of its calls.
 */
class CRobotRecords : private CNonCopyable {
 public:
  struct SRecord {
    UInt32 Robot; /**< number in the loop */
    UInt32 Metric; /**< number of a metric; of an unknown one: of a name of the thread */
    Real Value;
    bool IsKnown;
  };
  /** A metric that did not exist when the loop began. */
  struct SNewMetric {
    std::string Name;
    std::string Unit;
  };

 private:
  // aligned so that no two threads write to one cache line
  struct alignas(64) SThread {
    const CRobotRecords* Owner = nullptr;
    UInt32 Robot = 0;  // robot that runs now
    std::vector<SRecord> Records;
    std::vector<SNewMetric> NewMetrics;
  };

 public:
  /** Makes a thread of the loop the calling one, during its lifetime. */
  class CScope : private CNonCopyable {
   public:
    CScope(CRobotRecords& records, UInt32 thread);
    ~CScope();

    /** To be called before the code of another robot is run. */
    void SetRobot(size_t robot) { m_thread.Robot = static_cast<UInt32>(robot); }

   private:
    SThread& m_thread;
    SThread* const m_previous;
  };

  CRobotRecords() = default;

  /** Starts a loop; drops what a loop that was ended by an exception has left. */
  void Begin(size_t robots, UInt32 threads);
  /** @return false, and does nothing, if the calling thread does not run a robot of this loop. */
  bool TryAdd(UInt32 metric, Real value);
  /** The same for a metric that does not exist yet. */
  bool TryAdd(std::string_view name, std::string_view unit, Real value);
  bool IsEmpty() const;
  /**
   * Ends the loop: calls take(const SRecord&, const SNewMetric*) in the order of robots; the second
   * argument is null for known metrics.
   */
  template <typename TAKE>
  void End(TAKE&& take) {
    if (IsEmpty()) {
      return;
    }
    Sort();
    for (const SSorted& sorted : m_sorted) {
      take(*sorted.Record,
           sorted.Record->IsKnown ? nullptr : &sorted.Thread->NewMetrics[sorted.Record->Metric]);
    }
    Clear();
  }

 private:
  struct SSorted {
    const SRecord* Record;
    const SThread* Thread;
  };

  static SThread*& CurrentThread();
  SThread* FindThread() const;
  void Sort();
  void ReserveForAll(size_t records);
  void Clear();

  size_t m_numRobots = 0;
  std::vector<SThread> m_threads;
  size_t m_capacity = 0;  // records of each thread: with dynamic schedules its share is not known
  CCountingSort m_order;  // sorts all records by robot
  std::vector<SSorted> m_sorted;
};

}  // namespace argos

#endif
