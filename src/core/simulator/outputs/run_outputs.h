#ifndef ARGOS3_CORE_SIMULATOR_OUTPUTS_RUN_OUTPUTS_H
#define ARGOS3_CORE_SIMULATOR_OUTPUTS_RUN_OUTPUTS_H

#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace argos {

/**
 * The outputs of one experiment, in the order of the file; says which of their functions is due.
 *
 * Outputs have threads and open files from their first state on. So those of a run in which fork()
 * is called remain with the process that called it: its child goes on without them, and is warned.
 */
class CRunOutputs {
 public:
  bool IsEmpty() const { return m_outputs.empty(); }
  void Add(std::unique_ptr<CRunOutput> output) { m_outputs.push_back(std::move(output)); }

  /**
   * Shows the first state, if that has not been done since the start or the last Reset(). If the
   * clock has gone back, another run begins.
   */
  void Begin(CSimulator& simulator);
  /** Shows the state after a tick; if the experiment was reset in it, this is the first state. */
  void Observe(CSimulator& simulator);
  /** @return true in a tick: the present state has not been shown. */
  bool HasUnseenTick() const;
  /** Ends the run, unless it has not begun, has ended or has failed. */
  void Finish(CSimulator& simulator);
  /** An error has ended the run: outputs are not called again before Reset() or Destroy(). */
  void Abandon() { m_stage = EStage::Over; }
  /** @return true while a function of an output is called. */
  bool IsBusy() const { return m_isBusy; }
  /** Ends the run as Finish(), and prepares for another one. */
  void Reset(CSimulator& simulator);
  /** The same if the run has begun and not ended: for a reset of the space alone. */
  void EndRun(CSimulator& simulator);
  /**
   * Destroys all outputs, the last one first.
   * @param guard  calls the function that it gets, and keeps its exception.
   */
  void Destroy(const std::function<void(const std::function<void()>&)>& guard);

  /** Wall time since the experiment was loaded that outputs have taken, s. */
  double GetSeconds() const { return m_seconds; }

 private:
  enum class EStage { NotBegun, Running, Over };

  void LeaveToParent();
  void Show(CSimulator& simulator);
  void CompareClock(CSimulator& simulator);

  std::vector<std::unique_ptr<CRunOutput>> m_outputs;
  EStage m_stage = EStage::NotBegun;
  std::uint32_t m_numForks = 0;  // count in the process that shows the first state
  std::optional<UInt32> m_lastTick;  // last tick that was shown
  bool m_isBusy = false;
  double m_seconds = 0.0;
};

}  // namespace argos

#endif
