#ifndef ARGOS3_CORE_UTILITY_PROFILER_PROFILER_H
#define ARGOS3_CORE_UTILITY_PROFILER_PROFILER_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace argos {

/**
 * Measures the time of a run and writes it to a file.
 *
 * Use: AddPhase() for each phase; Start(); in each tick StartPhase() and StopPhase() around each
 * phase; Stop(); Flush(). Phases do not allocate. Worker threads call CollectThreadResourceUsage()
 * before they end; all other functions must be called by one thread.
 */
class CProfiler {
 public:
  typedef std::size_t TPhase;

  /**
   * @param file      target of Flush().
   * @param format    "human_readable": a report; "table": a line of column names, unless the file
   *   is not empty, and a line of values, separated by tabs.
   * @param truncate  false: append to the file.
   * @throws CARGoSException if the format is unknown or the file cannot be written.
   */
  CProfiler(const std::string& file, const std::string& format, bool truncate = true);

  /** Adds a phase; the report keeps this order. @return the argument of StartPhase(). */
  TPhase AddPhase(const std::string& name);

  /** Starts the wall clock. */
  void Start();

  void StartPhase(TPhase phase);
  void StopPhase(TPhase phase);

  /** Adds the calling thread's processor time to those of the worker threads. Thread safe. */
  void CollectThreadResourceUsage();

  /** Stops the wall clock and reads the resource usage of the process. */
  void Stop();

  /** Writes the result. @throws CARGoSException on failure. */
  void Flush();

  /** Wall time between Start() and Stop(), s. */
  Real GetWallTime() const;

  /** Wall time spent in a phase so far, s. */
  Real GetPhaseTime(TPhase phase) const;

  /** The number of StopPhase() calls of a phase. */
  UInt64 GetPhaseCount(TPhase phase) const { return m_phases[phase].Count; }

 private:
  typedef std::chrono::steady_clock TClock;

  struct SPhase {
    std::string Name;
    TClock::time_point Start{};
    TClock::duration Total{};
    UInt64 Count = 0;
  };

  // from getrusage()
  struct SUsage {
    Real UserTime = 0.0;  // s
    Real SystemTime = 0.0;  // s
    SInt64 PeakMemory = 0;  // KiB
    SInt64 MinorFaults = 0;
    SInt64 MajorFaults = 0;
    SInt64 VoluntarySwitches = 0;
    SInt64 InvoluntarySwitches = 0;
  };

  static SUsage GetUsage(int who);
  std::string FormatReport() const;
  std::string FormatTable(bool withHeader) const;

  std::string m_file;
  bool m_isTable;
  TClock::time_point m_start{};
  TClock::time_point m_end{};
  SUsage m_usage;
  std::vector<SPhase> m_phases;
  std::mutex m_threadMutex;
  std::vector<SUsage> m_threads;
};

}  // namespace argos

#endif
