#include <argos3/program/exit_guard.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/line_marks.h>
#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/logging/argos_log.h>

#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <exception>

namespace argos {

namespace {

std::atomic<CSimulator*> g_running = nullptr;
std::atomic<pid_t> g_process = 0;

// called by exit(), on the thread that called it
void EndRun(int status, void* /*unused*/) {
  if (g_process != getpid()) {
    return;
  }
  CSimulator* const simulator = g_running.exchange(nullptr);
  if (simulator == nullptr) {
    return;
  }
  const std::string caller = SRunningCode::OfThread().ToText();
  LOGERR << "[WARNING] " << (caller.empty() ? "" : caller + ": ") << "exit(" << status
         << ") was called: the run ends at tick " << simulator->GetSpace().GetSimulationClock()
         << ", and its outputs end here; CSimulator::Terminate() ends a run in order" << std::endl;
  try {
    simulator->CompleteOutputs();
  } catch (const std::exception& error) {
    LOGERR << MarkLines(error.what()) << std::endl;
  } catch (...) {
    LOGERR << "[FATAL] an output was not completed" << std::endl;
  }
  LOG.Flush();
  LOGERR.Flush();
}

}  // namespace

CExitGuard::CExitGuard(CSimulator& simulator) {
  g_process = getpid();
  g_running = &simulator;
  Renew();
}

// a registration cannot be taken back; what is registered last is called first
void CExitGuard::Renew() {
  on_exit(&EndRun, nullptr);
}

CExitGuard::~CExitGuard() {
  g_running = nullptr;
}

}  // namespace argos
