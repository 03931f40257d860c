#ifndef ARGOS3_RUN_RUN_H
#define ARGOS3_RUN_RUN_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/run/run_status.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace argos {

class CLogObserver;
class CSimulator;

/** An error that ended a run, or its destruction. */
struct SRunFailure {
  std::string Text; /**< one or more lines, each of which begins with "[FATAL] " or another mark */
  bool IsOutOfMemory = false; /**< memory was not granted */
};

/** Describes the exception that is being handled. To be called in a catch block. */
SRunFailure DescribeFailure();

/** Prints it on LOGERR, or on LOG if LOGERR cannot be written, and flushes both. */
void PrintFailure(const SRunFailure& failure);

/**
 * @return true if the text of an error, or the end of a log, says that memory was not granted: by
 *   an exception of users' code, which libraries wrap into others, or of Lua.
 */
bool SaysOutOfMemory(const std::string& text);

/**
 * Outputs and logs that could not be written, since the last call.
 * @return one line for each, each line once; empty: none.
 */
std::string TakeFailedOutputs();

/** What is known of a run that has ended. */
struct SRunSummary {
  ERunStatus Status = ERunStatus::Failed;
  int Signal = 0; /**< signal that stopped it; 0: none */
  Real StartUpTime = 0.0; /**< wall time until the first tick, s */
  Real WallTime = 0.0; /**< wall time of the main loop, s */
  Real CPUTime = 0.0; /**< time of all threads of the process in the main loop, s */
  Real OutputTime = 0.0; /**< part of WallTime in which outputs were written, s */
  Real SimulatedTime = 0.0; /**< s */
  UInt32 Ticks = 0;
  UInt32 Robots = 0;
  UInt32 StoppedRobots = 0; /**< robots that errors have stopped, at the end of the main loop */
  UInt32 QuarantinedRobots = 0; /**< number of quarantined ones among the stopped */
  UInt32 RobotsOutside = 0; /**< robots outside of the arena, at the end of the main loop */
  std::string FirstOutside; /**< id of one of them; empty: none */
  bool HasOutputs = false;
  std::string
      RobotErrors; /**< errors of robots that did not end the run, each once; may be empty */
  std::vector<SRunFailure> Failures; /**< in order of occurrence; empty: it ended normally */
  std::vector<std::string> Warnings; /**< see CRun::CollectWarnings() */

  int GetExitStatus() const { return ToExitStatus(Status, Signal); }
};

/** "simulated 10 s in 0.2 s of wall time (real-time factor 50, 100 ticks, 3 robots): ...". */
std::string DescribeRun(const SRunSummary& summary);

/**
 * One run of an experiment in a simulator: loading, the main loop, and destruction, in this order.
 *
 * No step throws: an exception is reported, and becomes an entry in SRunSummary::Failures. A step
 * after one that has failed does nothing, except Destroy(), because loop functions close their
 * files there. The program argos3, each run of a campaign, and programs that embed the simulator
 * use it:
 *
 *   CSimulator simulator;
 *   const CSimulator::CScope scope(simulator);
 *   CRun run(simulator);
 *   run.Load([&] { simulator.SetExperimentFileName("a.argos"); simulator.LoadExperiment(); });
 *   run.Execute();
 *   return run.Finish().GetExitStatus();
 */
class CRun : private CNonCopyable {
 public:
  using TReport = std::function<void(const SRunFailure&)>;

  /** @param report  called for each failure when it occurs. */
  explicit CRun(CSimulator& simulator, TReport report = &PrintFailure);
  /** Destroys the experiment. */
  ~CRun();

  /**
   * Stores warnings in the summary, from now on: lines of all logs of the process that are marked
   * "[WARNING]", at most kMaxWarnings. They are written to the logs, too. One run at a time.
   */
  void CollectWarnings();
  static constexpr size_t kMaxWarnings = 200;

  /** @param load  sets what is to be set, and loads the experiment. @return true if it succeeded.
   */
  bool Load(const std::function<void()>& load);
  /**
   * Runs the visualization until the experiment ends.
   * @param observe  called after each tick; its exception ends the run.
   * @return true if no step has failed.
   */
  bool Execute(const std::function<void(CSimulator&)>& observe = {});
  /** A step of the program that belongs to the run, such as storing its results. The same. */
  bool Do(const std::function<void()>& step);
  /** To be called when a signal has ended the main loop early. */
  void SetSignal(int signal) { m_summary.Signal = signal; }
  /** Destroys the experiment, if it was not destroyed. @return true if no step has failed. */
  bool Destroy();
  /** Destroys the experiment, and sets the status. Calls after it have no effect. */
  const SRunSummary& Finish();

  bool IsGood() const { return m_summary.Failures.empty(); }
  /** What is known so far. */
  const SRunSummary& GetSummary() const { return m_summary; }

 private:
  using TClock = std::chrono::steady_clock;

  bool Try(const std::function<void()>& step);
  void Measure(TClock::time_point start, Real cpuTime);
  void CountStoppedRobots();
  void CountRobotsOutside();

  CSimulator& m_simulator;
  TReport m_report;
  TClock::time_point m_start = TClock::now();
  SRunSummary m_summary;
  bool m_isDestroyed = false;
  std::unique_ptr<CLogObserver> m_warnings;
};

}  // namespace argos

#endif
