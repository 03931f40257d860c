#include <argos3/core/simulator/loading/experiment_parts.h>

#include <argos3/core/simulator/loading/load_warnings.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/placement/arena_filling.h>
#include <argos3/core/simulator/replay/replay.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/tick/loop_hooks.h>
#include <argos3/core/simulator/tick/tick.h>
#include <argos3/core/simulator/tick/tick_times.h>
#include <argos3/core/simulator/visualization/visualization.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/errors/line_marks.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/profiler/profiler.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <utility>

namespace argos {

namespace {

// calls functions, keeps the first exception and prints the others
class CFirstFailure {
 public:
  template <typename STEP>
  void Try(STEP&& step) {
    try {
      step();
    } catch (const std::exception& error) {
      Keep(error.what());
    } catch (...) {
      Keep("[FATAL] an exception that is not a std::exception was thrown");
    }
  }
  std::exception_ptr Get() const { return m_failure; }

 private:
  void Keep(const char* text) {
    if (m_failure == nullptr) {
      m_failure = std::current_exception();
    } else {
      LOGERR << MarkLines(text) << std::endl;
    }
  }

  std::exception_ptr m_failure;
};

}  // namespace

SExperimentParts::SExperimentParts(SSimulationContext& context)
    : Pool(std::make_unique<CThreadPool>(0, CreateSchedule("balance_quantity"))),
      EngineLookup(context),
      m_context(context) {
  m_context.Pool = Pool.get();
}

SExperimentParts::~SExperimentParts() = default;

std::exception_ptr SExperimentParts::Destroy() {
  CFirstFailure failure;
  failure.Try([this] { Outputs.Finish(m_context.Simulator); });
  if (std::exchange(ChecksControllersAtEnd, false)) {
    failure.Try([this] {
      PrintWarnings(FindUnusedControllers(*Document, m_context));
      for (const std::string& unread : Document->DescribeUnreadSettings()) {
        THROW_ARGOSEXCEPTION(unread);
      }
    });
  }
  // users' Destroy() may rely on their Init()
  if (AreLoopFunctionsReady) {
    AreLoopFunctionsReady = false;
    failure.Try([this] {
      CallHook(m_context, "Destroy()", [this] { m_context.LoopFunctions->Destroy(); });
    });
  }
  Outputs.Destroy([&failure](const std::function<void()>& step) { failure.Try(step); });
  if (Visualization != nullptr) {
    failure.Try([this] { Visualization->Destroy(); });
  }
  Visualization.reset();
  Filling.reset();
  failure.Try([this] { m_context.Space->Destroy(); });
  if (!m_context.Space->GetRootEntityVector().empty()) {
    // there was not even the memory to remove them: they refer to engines and media, which stay
    return failure.Get();
  }
  // it follows the entities, which may still request the floor's colour
  OwnLoopFunctions.reset();
  SetLoopFunctions(nullptr);
  for (CMedium* medium : m_context.Media) {
    failure.Try([medium] { medium->Destroy(); });
  }
  m_context.Media.clear();
  Media.clear();
  for (CPhysicsEngine* engine : m_context.Engines) {
    failure.Try([engine] { engine->Destroy(); });
  }
  m_context.Engines.clear();
  Engines.clear();
  failure.Try([this] { FinishProfiling(); });
  if (Rng != nullptr) {
    Rng = nullptr;
    CRandom::RemoveCategory("argos");
  }
  m_context.Loading = CLoadState();
  m_context.IsReplay = false;
  m_context.IsExactReplay = false;
  // joins the workers, so that none is left at the end of the program
  m_context.Pool = nullptr;
  Pool.reset();
  return failure.Get();
}

void SExperimentParts::SetLoopFunctions(CLoopFunctions* loopFunctions) {
  m_context.LoopFunctions = loopFunctions;
  m_context.FloorPainter = loopFunctions;
}

void SExperimentParts::StartProfiling(std::unique_ptr<CProfiler> profiler, CTick& tick) {
  Profiler = std::move(profiler);
  ProfiledTicks = std::make_unique<STickTimes>();
  m_profiledTick = &tick;
  tick.SetTimes(ProfiledTicks.get());
  Profiler->Start();
}

void SExperimentParts::FinishProfiling() {
  if (Profiler == nullptr) {
    return;
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
  Profiler->Stop();
  Profiler->Flush();
}

}  // namespace argos
