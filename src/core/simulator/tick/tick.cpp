#include <argos3/core/simulator/tick/tick.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/tick/tick_times.h>
#include <argos3/core/utility/logging/log_order.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>

namespace argos {

namespace {

using TClock = std::chrono::steady_clock;

Real SecondsSince(TClock::time_point start) {
  return std::chrono::duration<Real>(TClock::now() - start).count();
}

// adds the time of a phase to a sum, if there is one
template <typename PHASE>
void Timed(Real* seconds, PHASE&& phase) {
  if (seconds == nullptr) {
    phase();
    return;
  }
  const TClock::time_point start = TClock::now();
  phase();
  *seconds += SecondsSince(start);
}

// calls step for robots [begin, end); a failure names the robot, its phase and the tick
// @param lookAhead  void(size_t): called before each robot is visited, with its number
template <typename STEP, typename LOOK_AHEAD>
void ForRobots(const std::vector<CControllableEntity*>& robots, size_t begin, size_t end,
               UInt64 firstPlace, const char* phase, UInt32 tick, STEP&& step,
               LOOK_AHEAD&& lookAhead) {
  size_t current = begin;
  CRandom::COwner::CScope randomOwner(nullptr, tick);
  const auto fail = [&](std::exception* error) {
    CTextOutput message;
    message << "robot \"" << robots[current]->GetRootEntity().GetId() << "\": " << phase
            << " threw in tick " << tick;
    throw CARGoSException(message.str(), error);
  };
  try {
    for (; current < end; ++current) {
      lookAhead(current);
      if (robots[current]->IsEnabled()) {
        CARGoSLog::SetSequence(firstPlace + current);
        randomOwner.SetOwner(&robots[current]->GetRandomOwner());
        step(*robots[current]);
      }
    }
  } catch (std::exception& error) {
    fail(&error);
  } catch (...) {
    fail(nullptr);
  }
}

// updates engines or media: those that use the pool themselves one after the other, the rest in
// parallel
template <typename PART>
void UpdateParts(const std::vector<PART*>& parts, CThreadPool& pool, CPhaseCost& cost) {
  InLogOrder(parts.size(), [&](UInt64 firstPlace) {
    const auto update = [&](size_t begin, size_t end, bool onPool) {
      for (size_t i = begin; i < end; ++i) {
        if (parts[i]->UsesThreadPool() == onPool) {
          CARGoSLog::SetSequence(firstPlace + i);
          parts[i]->Update();
        }
      }
    };
    update(0, parts.size(), true);
    pool.ParallelFor(parts.size(), cost,
                     [&](size_t begin, size_t end, UInt32) { update(begin, end, false); });
  });
}

}  // namespace

CTick::CTick(SSimulationContext& context)
    : m_context(context),
      m_actCost(CSpace::kRobotsPerRun),
      m_senseCost(CSpace::kRobotsPerRun),
      m_ghostCost(1),
      m_engineCost(1),
      m_mediumCost(1) {}

void CTick::SetGrain(size_t robots) {
  m_actCost.SetGrain(robots);
  m_senseCost.SetGrain(robots);
}

void CTick::Run() {
  // runs a phase, and adds its time to the tick times if there are any
  const auto phase = [this](Real STickTimes::*time, auto&& run) {
    Timed(m_times != nullptr ? &(m_times->*time) : nullptr, run);
  };

  if (m_context.LoopFunctions == nullptr) {
    THROW_ARGOSEXCEPTION("no experiment is loaded: there is nothing to run");
  }
  CARGoSLog::SetSequence(0);
  m_context.Space->IncreaseSimulationClock();
  phase(&STickTimes::Act, [&] { Act(); });
  phase(&STickTimes::Physics, [&] {
    CollectGhosts();
    UpdatePhysics();
    TransferBodies();
  });
  phase(&STickTimes::Index, [&] { m_context.Index->Rebuild(*m_context.Pool); });
  phase(&STickTimes::Media, [&] { UpdateMedia(); });
  phase(&STickTimes::PreStep, [&] { m_context.LoopFunctions->PreStep(); });
  phase(&STickTimes::SenseAndControl, [&] { SenseAndControl(); });
  phase(&STickTimes::PostStep, [&] { m_context.LoopFunctions->PostStep(); });

  LOG.Flush();
  LOGERR.Flush();
  CARGoSLog::SetSequence(0);
  if (m_times != nullptr) {
    ++m_times->Ticks;
  }
}

// to be called before each loop over robots: users add and remove robots between phases
void CTick::UpdateLookAhead() {
  const UInt64 version = m_context.Space->GetVersionOfControllableEntities();
  if (version != m_robotsOfLookAhead) {
    m_lookAhead.SetRobots(m_context.Space->GetControllableEntities());
    m_robotsOfLookAhead = version;
  }
}

void CTick::Act() {
  UpdateLookAhead();
  const std::vector<CControllableEntity*>& robots = m_context.Space->GetControllableEntities();
  const UInt32 tick = m_context.Space->GetSimulationClock();
  InLogOrder(robots.size(), [&](UInt64 firstPlace) {
    m_context.Pool->ParallelFor(robots.size(), m_actCost, [&](size_t begin, size_t end, UInt32) {
      ForRobots(
          robots, begin, end, firstPlace, "an actuator", tick,
          [](CControllableEntity& robot) { robot.Act(); },
          [this](size_t robot) { m_lookAhead.BeforeAct(robot); });
    });
  });
  for (CMedium* medium : m_context.Media) {
    medium->TakeActs();
  }
}

void CTick::CollectGhosts() {
  const CPhysicsEngine::TVector& engines = m_context.Engines;
  if (std::none_of(engines.begin(), engines.end(),
                   [](const CPhysicsEngine* engine) { return engine->FeelsGhosts(); })) {
    return;
  }
  m_context.Pool->ParallelFor(engines.size(), m_ghostCost, [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      if (engines[i]->FeelsGhosts()) {
        engines[i]->CollectGhosts();
      }
    }
  });
}

void CTick::UpdatePhysics() {
  UpdateParts(m_context.Engines, *m_context.Pool, m_engineCost);
}

void CTick::TransferBodies() {
  for (CPhysicsEngine* engine : m_context.Engines) {
    if (engine->IsEntityTransferNeeded()) {
      engine->TransferEntities();
    }
  }
}

void CTick::UpdateMedia() {
  UpdateParts(m_context.Media, *m_context.Pool, m_mediumCost);
}

void CTick::SenseAndControl() {
  UpdateLookAhead();
  const CPhysicsEngine::TVector& engines = m_context.Engines;
  m_context.Space->SetBodiesOutsideIndex(
      std::any_of(engines.begin(), engines.end(),
                  [](const CPhysicsEngine* engine) { return engine->HasBodiesOutsideIndex(); }));
  const std::vector<CControllableEntity*>& robots = m_context.Space->GetControllableEntities();
  const UInt32 tick = m_context.Space->GetSimulationClock();
  // a controller writes only into its own robot's actuators, which no sensor reads in this phase:
  // so all robots of a run may sense before the first of them is controlled
  std::mutex timesMutex;
  const auto senseAndControl = [&](size_t first, size_t last, UInt64 firstPlace) {
    Real sense = 0.0;
    Real control = 0.0;
    // If a robot fails to sense, those before it are controlled nevertheless, because one of them
    // may fail: the robot that is reported is the first in order, however they are dealt.
    std::exception_ptr failure;
    size_t sensed = first;
    Timed(m_times ? &sense : nullptr, [&] {
      try {
        ForRobots(
            robots, first, last, firstPlace, "a sensor", tick,
            [](CControllableEntity& robot) { robot.Sense(); },
            [&](size_t robot) {
              sensed = robot;
              m_lookAhead.BeforeSense(robot, *m_context.Index);
            });
        sensed = last;
      } catch (...) {
        failure = std::current_exception();
      }
    });
    Timed(m_times ? &control : nullptr, [&] {
      ForRobots(
          robots, first, sensed, firstPlace, "ControlStep()", tick,
          [](CControllableEntity& robot) { robot.ControlStep(); }, [](size_t) {});
    });
    if (failure) {
      std::rethrow_exception(failure);
    }
    if (m_times != nullptr) {
      const std::lock_guard<std::mutex> lock(timesMutex);
      m_times->Sense += sense;
      m_times->Control += control;
    }
  };
  InLogOrder(robots.size(), [&](UInt64 firstPlace) {
    m_context.Pool->ParallelFor(robots.size(), m_senseCost, [&](size_t begin, size_t end, UInt32) {
      for (size_t first = begin; first < end; first += CSpace::kRobotsPerRun) {
        senseAndControl(first, std::min(end, first + CSpace::kRobotsPerRun), firstPlace);
      }
    });
  });
}

}  // namespace argos
