#include <argos3/core/simulator/loading/experiment_parts.h>

#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/tick/tick.h>
#include <argos3/core/simulator/tick/tick_times.h>
#include <argos3/core/simulator/visualization/visualization.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/profiler/profiler.h>
#include <argos3/core/utility/threads/thread_pool.h>

namespace argos {

namespace {

// calls step. @return what it threw
template <typename STEP>
std::exception_ptr Catch(STEP&& step) {
  try {
    step();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

}  // namespace

SExperimentParts::SExperimentParts(SSimulationContext& context)
    : Pool(std::make_unique<CThreadPool>(0, CreateSchedule("balance_quantity"))),
      m_context(context) {
  m_context.Pool = Pool.get();
}

SExperimentParts::~SExperimentParts() {
  if (Visualization != nullptr) {
    Visualization->Destroy();
  }
  Visualization.reset();
  m_context.Space->Destroy();
  // after the entities, which may still request the floor's colour
  OwnLoopFunctions.reset();
  SetLoopFunctions(nullptr);
  for (CMedium* medium : m_context.Media) {
    medium->Destroy();
  }
  m_context.Media.clear();
  Media.clear();
  for (CPhysicsEngine* engine : m_context.Engines) {
    engine->Destroy();
  }
  m_context.Engines.clear();
  Engines.clear();
  if (Rng != nullptr) {
    CRandom::RemoveCategory("argos");
  }
  m_context.Loading = CLoadState();
  // joins the workers, so that none is left at the end of the program
  m_context.Pool = nullptr;
  Pool.reset();
}

void SExperimentParts::SetLoopFunctions(CLoopFunctions* loopFunctions) {
  m_context.LoopFunctions = loopFunctions;
  m_context.FloorPainter = loopFunctions;
}

std::exception_ptr SExperimentParts::DestroyLoopFunctions() {
  if (!AreLoopFunctionsReady) {
    return nullptr;
  }
  AreLoopFunctionsReady = false;
  return Catch([this] { m_context.LoopFunctions->Destroy(); });
}

void SExperimentParts::StartProfiling(std::unique_ptr<CProfiler> profiler, CTick& tick) {
  Profiler = std::move(profiler);
  ProfiledTicks = std::make_unique<STickTimes>();
  m_profiledTick = &tick;
  tick.SetTimes(ProfiledTicks.get());
  Profiler->Start();
}

std::exception_ptr SExperimentParts::FinishProfiling() {
  if (Profiler == nullptr) {
    return nullptr;
  }
  m_profiledTick->SetTimes(nullptr);
  const STickTimes& times = *ProfiledTicks;
  Profiler->AddPhase("act", times.Act, times.Ticks);
  Profiler->AddPhase("physics", times.Physics, times.Ticks);
  Profiler->AddPhase("index", times.Index, times.Ticks);
  Profiler->AddPhase("media", times.Media, times.Ticks);
  Profiler->AddPhase("pre-step", times.PreStep, times.Ticks);
  Profiler->AddPhase("sense+control", times.SenseAndControl, times.Ticks);
  Profiler->AddPhase("post-step", times.PostStep, times.Ticks);
  return Catch([this] {
    Profiler->Stop();
    Profiler->Flush();
    Profiler.reset();
  });
}

}  // namespace argos
