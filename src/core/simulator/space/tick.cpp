// The tick. What is read in a phase is not written in it, and what is written belongs to one robot
// or one engine: no phase needs a lock, and none depends on the number of threads.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/body_index.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/space/tick_times.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/prefetch.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <algorithm>
#include <chrono>
#include <mutex>

namespace argos {

namespace {

// robots that one thread handles in a row: enough to pay for fetching the run, and few enough that
// what sensing brought into the cache is still there for control
constexpr size_t kRobotGrain = 64;

// of CControllableEntity::PrefetchForAct() and its like
constexpr UInt32 kStages = 4;

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

// runs a phase whose items have the places firstPlace, firstPlace + 1, ... in the log: after what
// was logged before, and in their order whatever thread they run on
template <typename PHASE>
void InLogOrder(size_t items, PHASE&& phase) {
  const UInt64 firstPlace = CARGoSLog::GetSequence() + 1;
  phase(firstPlace);
  CARGoSLog::SetSequence(firstPlace + items);
}

// calls step for robots [begin, end); a failure names the robot, its phase and the tick
// @param prefetch  void(const CControllableEntity&, UInt32 stage): see its PrefetchForAct()
template <typename STEP, typename PREFETCH>
void ForRobots(const std::vector<CControllableEntity*>& robots, size_t begin, size_t end,
               UInt64 firstPlace, const char* phase, UInt32 tick, STEP&& step,
               PREFETCH&& prefetch) {
  size_t current = begin;
  const auto fail = [&](std::exception* error) {
    std::ostringstream message;
    message << "robot \"" << robots[current]->GetRootEntity().GetId() << "\" failed to " << phase
            << " in tick " << tick;
    throw CARGoSException(message.str(), error);
  };
  try {
    for (; current < end; ++current) {
      for (UInt32 stage = 0; stage < kStages; ++stage) {
        const size_t later = current + (kStages - stage) * kBodiesAhead;
        if (later < robots.size()) {
          prefetch(*robots[later], stage);
        }
      }
      if (robots[current]->IsEnabled()) {
        CARGoSLog::SetSequence(firstPlace + current);
        step(*robots[current]);
      }
    }
  } catch (std::exception& error) {
    fail(&error);
  } catch (...) {
    fail(nullptr);
  }
}

}  // namespace

void CSpace::Update() {
  CThreadPool& pool = m_cSimulator.GetThreadPool();
  CLoopFunctions& loopFunctions = m_cSimulator.GetLoopFunctions();
  // runs a phase, and adds its time to the tick times if there are any
  const auto phase = [this](Real STickTimes::*time, auto&& run) {
    Timed(m_tickTimes != nullptr ? &(m_tickTimes->*time) : nullptr, run);
  };

  CARGoSLog::SetSequence(0);
  IncreaseSimulationClock();
  phase(&STickTimes::Act, [&] { Act(pool); });
  phase(&STickTimes::Physics, [&] {
    CollectGhosts(pool);
    UpdatePhysics(pool);
    TransferBodies();
  });
  phase(&STickTimes::Index, [&] { m_bodyIndex->Rebuild(pool); });
  phase(&STickTimes::Media, [&] { UpdateMedia(pool); });
  phase(&STickTimes::PreStep, [&] { loopFunctions.PreStep(); });
  phase(&STickTimes::SenseAndControl, [&] { SenseAndControl(pool); });
  phase(&STickTimes::PostStep, [&] { loopFunctions.PostStep(); });

  LOG.Flush();
  LOGERR.Flush();
  CARGoSLog::SetSequence(0);
  if (m_tickTimes != nullptr) {
    ++m_tickTimes->Ticks;
  }
}

void CSpace::Act(CThreadPool& pool) {
  InLogOrder(m_robots.size(), [&](UInt64 firstPlace) {
    pool.ParallelFor(m_robots.size(), kRobotGrain, [&](size_t begin, size_t end, UInt32) {
      ForRobots(
          m_robots, begin, end, firstPlace, "act", m_simulationClock,
          [](CControllableEntity& robot) { robot.Act(); },
          [](const CControllableEntity& robot, UInt32 stage) { robot.PrefetchForAct(stage); });
    });
  });
  for (CMedium* medium : m_cSimulator.GetMedia()) {
    medium->TakeActs();
  }
}

void CSpace::CollectGhosts(CThreadPool& pool) {
  const CPhysicsEngine::TVector& engines = m_cSimulator.GetPhysicsEngines();
  if (std::none_of(engines.begin(), engines.end(),
                   [](const CPhysicsEngine* engine) { return engine->FeelsGhosts(); })) {
    return;
  }
  pool.ParallelFor(engines.size(), 1, [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      if (engines[i]->FeelsGhosts()) {
        engines[i]->CollectGhosts();
      }
    }
  });
}

void CSpace::UpdatePhysics(CThreadPool& pool) {
  CPhysicsEngine::TVector& engines = m_cSimulator.GetPhysicsEngines();
  InLogOrder(engines.size(), [&](UInt64 firstPlace) {
    const auto update = [&](size_t begin, size_t end, bool onPool) {
      for (size_t i = begin; i < end; ++i) {
        if (engines[i]->UsesThreadPool() == onPool) {
          CARGoSLog::SetSequence(firstPlace + i);
          engines[i]->Update();
        }
      }
    };
    update(0, engines.size(), true);
    pool.ParallelFor(engines.size(), 1,
                     [&](size_t begin, size_t end, UInt32) { update(begin, end, false); });
  });
}

void CSpace::TransferBodies() {
  for (CPhysicsEngine* engine : m_cSimulator.GetPhysicsEngines()) {
    if (engine->IsEntityTransferNeeded()) {
      engine->TransferEntities();
    }
  }
}

void CSpace::UpdateMedia(CThreadPool& pool) {
  CMedium::TVector& media = m_cSimulator.GetMedia();
  InLogOrder(media.size(), [&](UInt64 firstPlace) {
    const auto update = [&](size_t begin, size_t end, bool onPool) {
      for (size_t i = begin; i < end; ++i) {
        if (media[i]->UsesThreadPool() == onPool) {
          CARGoSLog::SetSequence(firstPlace + i);
          media[i]->Update();
        }
      }
    };
    update(0, media.size(), true);
    pool.ParallelFor(media.size(), 1,
                     [&](size_t begin, size_t end, UInt32) { update(begin, end, false); });
  });
}

void CSpace::SenseAndControl(CThreadPool& pool) {
  const CPhysicsEngine::TVector& engines = m_cSimulator.GetPhysicsEngines();
  m_areBodiesOutsideIndex =
      std::any_of(engines.begin(), engines.end(),
                  [](const CPhysicsEngine* engine) { return engine->HasBodiesOutsideIndex(); });
  // a controller writes only into its own robot's actuators, which nobody senses in this phase: so
  // robots of one run may all sense before they are controlled
  std::mutex timesMutex;
  const auto senseAndControl = [&](size_t first, size_t last, UInt64 firstPlace) {
    Real sense = 0.0;
    Real control = 0.0;
    Timed(m_tickTimes ? &sense : nullptr, [&] {
      ForRobots(
          m_robots, first, last, firstPlace, "sense", m_simulationClock,
          [](CControllableEntity& robot) { robot.Sense(); },
          [](const CControllableEntity& robot, UInt32 stage) { robot.PrefetchForSense(stage); });
    });
    Timed(m_tickTimes ? &control : nullptr, [&] {
      ForRobots(
          m_robots, first, last, firstPlace, "be controlled", m_simulationClock,
          [](CControllableEntity& robot) { robot.ControlStep(); },
          [](const CControllableEntity&, UInt32) {});
    });
    if (m_tickTimes != nullptr) {
      const std::lock_guard<std::mutex> lock(timesMutex);
      m_tickTimes->Sense += sense;
      m_tickTimes->Control += control;
    }
  };
  InLogOrder(m_robots.size(), [&](UInt64 firstPlace) {
    pool.ParallelFor(m_robots.size(), kRobotGrain, [&](size_t begin, size_t end, UInt32) {
      for (size_t first = begin; first < end; first += kRobotGrain) {
        senseAndControl(first, std::min(end, first + kRobotGrain), firstPlace);
      }
    });
  });
}

void CSpace::IterateOverControllableEntities(const TControllableEntityIterCBType& callback) {
  InLogOrder(m_robots.size(), [&](UInt64 firstPlace) {
    m_cSimulator.GetThreadPool().ParallelFor(m_robots.size(), kRobotGrain,
                                             [&](size_t begin, size_t end, UInt32) {
                                               for (size_t i = begin; i < end; ++i) {
                                                 CARGoSLog::SetSequence(firstPlace + i);
                                                 callback(m_robots[i]);
                                               }
                                             });
  });
}

}  // namespace argos
