#ifndef ARGOS3_CORE_UTILITY_PROFILER_PROFILER_H
#define ARGOS3_CORE_UTILITY_PROFILER_PROFILER_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/files/output_file.h>

#include <chrono>
#include <mutex>
#include <string>
#include <vector>

namespace argos {

/**
 * Measures the time of a run and writes it to a file.
 *
 * Use: Start(); the run; AddPhase() for each of its phases; Stop(); Flush(). Worker threads call
 * CollectThreadResourceUsage() before they end, all other functions must be called by one
 * thread.
 */
class CProfiler {
 public:
  /**
   * @param file      target of Flush().
   * @param format    "human_readable": a report; "table": a line of column names, unless the file
   *   is not empty, and a line of values, separated by tabs.
   * @param truncate  false: append to the file.
   * @throws CARGoSException if the format is unknown or the file cannot be written.
   */
  CProfiler(const std::string& file, const std::string& format, bool truncate = true);

  /** Checks both, and changes nothing. @throws CARGoSException as the constructor. */
  static void Check(const std::string& file, const std::string& format);

  /** Starts the wall clock. */
  void Start();

  /**
   * Adds a phase to the report, which lists them in this order.
   * @param seconds  wall time spent in it.
   * @param count    how often it ran.
   */
  void AddPhase(const std::string& name, Real seconds, UInt64 count);

  /** Adds the calling thread's processor time to those of the worker threads. Thread safe. */
  void CollectThreadResourceUsage();

  /** Stops the wall clock and reads the resource usage of the process. */
  void Stop();

  /** Writes the result. @throws CARGoSException on failure. */
  void Flush();

  /** Wall time between Start() and Stop(), s. */
  Real GetWallTime() const;

 private:
  typedef std::chrono::steady_clock TClock;

  struct SPhase {
    std::string Name;
    Real Seconds = 0.0;
    UInt64 Count = 0;
  };

  // values of getrusage()
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
  COutputFile m_output;  // open from the beginning if it was truncated
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
