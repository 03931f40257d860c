#ifndef ARGOS3_CORE_SIMULATOR_PROGRAM_PROGRESS_H
#define ARGOS3_CORE_SIMULATOR_PROGRAM_PROGRESS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <chrono>
#include <memory>
#include <string>

namespace argos {

class CSimulator;

/** Progress of a run. */
struct SProgress {
  UInt32 Ticks = 0;
  UInt32 MaxTicks = 0; /**< 0 = unlimited */
  Real TickLength = 0.0; /**< s */
  Real WallSeconds = 0.0; /**< since the start of the run */
};

/**
 * "tick 120/600 (20 %), 0:13 left, 35.2 x real time, 12 s simulated"; without a limit on ticks,
 * percentage and time left are omitted.
 */
std::string DescribeProgress(const SProgress& progress);

/**
 * A terminal line with the progress of the run, displayed during the lifetime of the object.
 *
 * It is redrawn at most five times a second, and erased before other output to std::cout or
 * std::cerr. Does nothing if the standard error is not a terminal.
 */
class CProgressLine {
 public:
  /** @param simulator  must outlive this object. */
  explicit CProgressLine(CSimulator& simulator);
  /** Erases the line. */
  ~CProgressLine();
  CProgressLine(const CProgressLine&) = delete;
  CProgressLine& operator=(const CProgressLine&) = delete;

  /** Call it after each tick, on the thread that runs the loop. */
  void Update();

 private:
  using TClock = std::chrono::steady_clock;
  class CScreen;
  class CGuard;

  CSimulator& m_simulator;
  TClock::time_point m_start;
  TClock::time_point m_nextDrawing;
  UInt32 m_firstTick;
  std::unique_ptr<CScreen> m_screen;  // null: no terminal
  std::unique_ptr<CGuard> m_outGuard;
  std::unique_ptr<CGuard> m_errGuard;
};

}  // namespace argos

#endif
