#include <argos3/core/simulator/default_visualization.h>

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/tick/loop_hooks.h>
#include <argos3/core/utility/logging/argos_log.h>

#include <chrono>
#include <thread>

namespace argos {

void CDefaultVisualization::Execute() {
  if (m_cSimulator.IsRealTimeClock()) {
    ExecuteInRealTime();
  } else {
    ExecuteAsFastAsPossible();
  }
  CLoopFunctions& loopFunctions = m_cSimulator.GetLoopFunctions();
  CallHook(m_cSimulator.GetSpace().GetContext(), "PostExperiment()",
           [&loopFunctions] { loopFunctions.PostExperiment(); });
}

void CDefaultVisualization::ExecuteAsFastAsPossible() {
  while (!m_cSimulator.IsExperimentFinished()) {
    m_cSimulator.UpdateSpace();
  }
}

void CDefaultVisualization::ExecuteInRealTime() {
  using TClock = std::chrono::steady_clock;
  const std::chrono::duration<double> tick(CPhysicsEngine::GetSimulationClockTick());
  auto due = TClock::now();
  while (!m_cSimulator.IsExperimentFinished()) {
    m_cSimulator.UpdateSpace();
    due += std::chrono::duration_cast<TClock::duration>(tick);
    const auto now = TClock::now();
    if (now <= due) {
      std::this_thread::sleep_until(due);
    } else {
      const std::chrono::duration<double> late = now - due;
      LOGERR << "[WARNING] tick " << m_cSimulator.GetSpace().GetSimulationClock() << " ended "
             << late.count() << " s late" << std::endl;
      due = now;
    }
  }
}

}  // namespace argos
