#include <argos3/core/simulator/outputs/run_outputs.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/utility/processes/fork_count.h>

#include <chrono>
#include <utility>

namespace argos {

namespace {

// notes that outputs are called during its lifetime, and adds its time
class CStopwatch : private CNonCopyable {
 public:
  CStopwatch(double& seconds, bool& isBusy) : m_seconds(seconds), m_isBusy(isBusy) {
    m_isBusy = true;
  }
  ~CStopwatch() {
    m_isBusy = false;
    m_seconds += std::chrono::duration<double>(TClock::now() - m_start).count();
  }

 private:
  using TClock = std::chrono::steady_clock;

  double& m_seconds;
  bool& m_isBusy;
  TClock::time_point m_start = TClock::now();
};

}  // namespace

// in a child of fork(): threads of outputs that have begun do not exist there, and files are those
// of the parent, so that not even their destructors may run
void CRunOutputs::LeaveToParent() {
  if (m_stage == EStage::NotBegun || m_numForks == CountForks()) {
    return;
  }
  for (std::unique_ptr<CRunOutput>& output : m_outputs) {
    static_cast<void>(output.release());
  }
  LOGERR << "[WARNING] fork() was called after the start of a run: its outputs are written by the "
            "process that called it, not by this child"
         << std::endl;
  m_outputs.clear();
}

void CRunOutputs::Show(CSimulator& simulator) {
  const CStopwatch stopwatch(m_seconds, m_isBusy);
  m_lastTick = *CurrentContext().Clock;
  for (const std::unique_ptr<CRunOutput>& output : m_outputs) {
    output->Observe(simulator);
  }
}

// users' code may set the clock
void CRunOutputs::CompareClock(CSimulator& simulator) {
  if (m_lastTick.has_value() && *CurrentContext().Clock < *m_lastTick) {
    EndRun(simulator);
  }
}

void CRunOutputs::Begin(CSimulator& simulator) {
  CompareClock(simulator);
  if (m_stage == EStage::NotBegun && !IsEmpty()) {
    m_stage = EStage::Running;
    m_numForks = CountForks();
    Show(simulator);
  }
}

void CRunOutputs::Observe(CSimulator& simulator) {
  LeaveToParent();
  CompareClock(simulator);
  if (m_stage == EStage::Running) {
    Show(simulator);
  } else {
    Begin(simulator);
  }
}

bool CRunOutputs::HasUnseenTick() const {
  return m_stage == EStage::Running && m_lastTick != *CurrentContext().Clock;
}

void CRunOutputs::Finish(CSimulator& simulator) {
  LeaveToParent();
  if (m_stage != EStage::Running) {
    return;
  }
  m_stage = EStage::Over;
  const CStopwatch stopwatch(m_seconds, m_isBusy);
  for (const std::unique_ptr<CRunOutput>& output : m_outputs) {
    output->Finish(simulator);
  }
}

void CRunOutputs::Reset(CSimulator& simulator) {
  Finish(simulator);
  m_stage = EStage::NotBegun;
  for (const std::unique_ptr<CRunOutput>& output : m_outputs) {
    output->Reset();
  }
}

void CRunOutputs::EndRun(CSimulator& simulator) {
  if (m_stage == EStage::Running) {
    Reset(simulator);
  }
}

void CRunOutputs::Destroy(const std::function<void(const std::function<void()>&)>& guard) {
  LeaveToParent();
  while (!m_outputs.empty()) {
    const std::unique_ptr<CRunOutput> last = std::move(m_outputs.back());
    m_outputs.pop_back();
    guard([&] { last->Destroy(); });
  }
  m_stage = EStage::NotBegun;
}

}  // namespace argos
