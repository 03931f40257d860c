#ifndef ARGOS3_PROGRAM_PROGRESS_H
#define ARGOS3_PROGRAM_PROGRESS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace argos {

class CSimulator;

/** Progress of a run. */
struct SProgress {
  UInt32 Ticks = 0;
  UInt32 MaxTicks = 0; /**< 0 = unlimited */
  Real TickLength = 0.0; /**< s */
  Real WallSeconds = 0.0; /**< time since the start of the run */
};

/**
 * "tick 120/600 (20 %), 0:13 left, 35.2 x real time, 12 s simulated"; without a limit on ticks,
 * percentage and time left are omitted.
 */
std::string DescribeProgress(const SProgress& progress);

/**
 * Shows the progress of the run during the lifetime of the object.
 *
 * On a terminal, a line is redrawn at most five times a second, and erased before other output to
 * std::cout or std::cerr. If lines about the run (CLogControl::Notify()) do not go to a terminal,
 * there is one from time to time.
 */
class CProgressLine : private CNonCopyable {
 public:
  /** Of lines that do not go to a terminal, s of wall time. */
  static constexpr Real kLogPeriod = 60.0;

  /**
   * @param simulator  must outlive this object.
   * @param logPeriod  s, between lines wherever they go; 0: none. Not given: as kLogPeriod says.
   */
  explicit CProgressLine(CSimulator& simulator, std::optional<Real> logPeriod = std::nullopt);
  /** Erases the line. */
  ~CProgressLine();

  /** Call it after each tick, on the thread that runs the loop. */
  void Update();

 private:
  using TClock = std::chrono::steady_clock;
  using TTime = std::chrono::time_point<TClock, std::chrono::duration<Real>>;
  class CScreen;
  class CGuard;

  std::string Describe(TClock::time_point now) const;

  CSimulator& m_simulator;
  TClock::time_point m_start;
  TClock::time_point m_nextDrawing;
  UInt32 m_firstTick;
  Real m_logPeriod;  // s; 0: no lines
  TTime m_nextLogLine;
  std::unique_ptr<CScreen> m_screen;  // null: no terminal
  std::unique_ptr<CGuard> m_outGuard;
  std::unique_ptr<CGuard> m_errGuard;
};

}  // namespace argos

#endif
