#include <argos3/core/simulator/tick/tick.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/floor_painter.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/simulator/space/robot_records.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/tick/loop_hooks.h>
#include <argos3/core/simulator/tick/tick_times.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/logging/log_order.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <string>
#include <type_traits>

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

// a function that is called of each robot
struct SCall {
  const char* Name;  // such as "ControlStep()"
  bool IsDevice;
};

// a part of the work of a phase: visits [Begin, End)
struct SVisitsOfPhase {
  const std::vector<SRobotVisit>& Visits;
  size_t Begin;
  size_t End;
  UInt32 Thread;  // number of the thread that makes the calls
  UInt64 FirstPlace;  // place of robot 0 in the log
  SCall Call;
};

// call it in a catch block
bool IsErrorOfLoopFunctions() {
  try {
    throw;
  } catch (const CFloorPainterError&) {
    return true;
  } catch (...) {
    return false;
  }
}

// call it in a catch block; it ends the run, or stops the robot
void HandleFailure(SSimulationContext& context, const SCall& call, CControllableEntity& robot) {
  const std::string where = "robot \"" + robot.GetRootEntity().GetId() + "\": " + call.Name +
                            " threw in tick " + std::to_string(*context.Clock);
  if (robot.GetOnError() == EOnError::EndRun || IsErrorOfLoopFunctions()) {
    ThrowWithCause(where);
  }
  robot.Stop(call.IsDevice, where, DescribeCurrentException());
  if (robot.GetOnError() == EOnError::Quarantine) {
    context.Space->QuarantineLater(robot.GetRootEntity());
  }
}

// calls step for the robots
// @param lookAhead  void(size_t): called before each visit, with its number
template <typename STEP, typename LOOK_AHEAD>
void ForRobots(SSimulationContext& context, const SVisitsOfPhase& phase, STEP&& step,
               LOOK_AHEAD&& lookAhead) {
  CRunningCodeScope running(
      {phase.Call.Name, &CControllableEntity::Describe, nullptr, context.Clock, true});
  CRandom::COwner::CScope randomOwner(nullptr, *context.Clock);
  CRobotRecords::CScope records(context.Metrics->GetRobotRecords(), phase.Thread);
  ARGOS_ASSERT(phase.Begin <= phase.End && phase.End <= phase.Visits.size(),
               "visits " << phase.Begin << " to " << phase.End << " of " << phase.Visits.size());
  for (size_t current = phase.Begin; current < phase.End; ++current) {
    try {
      for (; current < phase.End; ++current) {
        lookAhead(current);
        CControllableEntity& robot = *phase.Visits[current].Robot;
        if (robot.IsEnabled()) {
          const UInt32 number = phase.Visits[current].Number;
          CARGoSLog::SetSequence(phase.FirstPlace + number);
          running.SetSubject(&robot);
          randomOwner.SetOwner(&robot.GetRandomOwner());
          records.SetRobot(number);
          step(robot);
        }
      }
    } catch (...) {
      HandleFailure(context, phase.Call, *phase.Visits[current].Robot);
    }
  }
}

// describes an engine or a medium in the report of a crash
template <typename PART>
void DescribePart(const void* part, CSignalSafeText& text) {
  text.Append(std::is_same_v<PART, CMedium> ? "medium \"" : "physics engine \"")
      .Append(static_cast<const PART*>(part)->GetId())
      .Append("\"");
}

// updates an engine or a medium; a failure names it and the tick
template <typename PART>
void UpdatePart(PART& part, SSimulationContext& context) {
  const CRunningCodeScope running({"Update()", &DescribePart<PART>, &part, context.Clock});
  try {
    part.Update();
  } catch (...) {
    ThrowWithCause(SRunningCode::OfThread().ToText() + " threw");
  }
}

// updates engines or media: those that use the pool themselves one after the other, the rest in
// parallel
template <typename PART>
void UpdateParts(const std::vector<PART*>& parts, SSimulationContext& context, CPhaseCost& cost) {
  InLogOrder(parts.size(), [&](UInt64 firstPlace) {
    const auto update = [&](size_t begin, size_t end, bool onPool) {
      for (size_t i = begin; i < end; ++i) {
        if (parts[i]->UsesThreadPool() == onPool) {
          CARGoSLog::SetSequence(firstPlace + i);
          UpdatePart(*parts[i], context);
        }
      }
    };
    update(0, parts.size(), true);
    context.Pool->ParallelFor(parts.size(), cost,
                              [&](size_t begin, size_t end, UInt32) { update(begin, end, false); });
  });
}

}  // namespace

CTick::CTick(SSimulationContext& context)
    : m_context(context),
      m_actCost(CSpace::kRobotsPerChunk),
      m_senseCost(CSpace::kRobotsPerChunk),
      m_ghostCost(1),
      m_engineCost(1),
      m_mediumCost(1),
      m_bundles(context) {}

void CTick::SetGrain(size_t robots) {
  m_actCost.SetGrain(robots);
  m_senseCost.SetGrain(robots);
}

void CTick::Run() {
  using EActivity = CRunState::EActivity;
  // runs a phase, and adds its time to the tick times if there are any
  const auto phase = [this](EActivity activity, Real STickTimes::*time, auto&& run) {
    const CRunState::CScope scope(m_context.Run, activity);
    Timed(m_times != nullptr ? &(m_times->*time) : nullptr, run);
    m_context.RobotFailures.Report();
  };

  if (m_context.LoopFunctions == nullptr) {
    THROW_ARGOSEXCEPTION("no experiment is loaded: there is nothing to run");
  }
  m_context.Run.CheckIsIdle("CSimulator::UpdateSpace()");
  // it is called after a tick that ended with an error
  m_context.Run.DiscardChanges();
  CARGoSLog::SetSequence(0);
  m_context.Space->IncreaseSimulationClock();
  phase(EActivity::Phase, &STickTimes::Act, [&] { Act(); });
  phase(EActivity::Phase, &STickTimes::Physics, [&] {
    CollectGhosts();
    UpdatePhysics();
    TransferBodies();
  });
  phase(EActivity::Phase, &STickTimes::Index, [&] { m_context.Index->Rebuild(*m_context.Pool); });
  phase(EActivity::Phase, &STickTimes::Media, [&] { UpdateMedia(); });
  phase(EActivity::Hook, &STickTimes::PreStep,
        [&] { CallHook(m_context, "PreStep()", [&] { m_context.LoopFunctions->PreStep(); }); });
  phase(EActivity::Phase, &STickTimes::SenseAndControl, [&] {
    SenseAndControl();
    m_context.Run.ApplyComponentChanges();
  });
  phase(EActivity::Hook, &STickTimes::PostStep,
        [&] { CallHook(m_context, "PostStep()", [&] { m_context.LoopFunctions->PostStep(); }); });
  m_context.Run.ApplyChanges();
  {
    const CRunState::CScope scope(m_context.Run, EActivity::Phase);
    m_context.Metrics->UpdateBuiltIns();
  }
  m_context.Metrics->EndTick();
  m_context.RobotFailures.Report();

  LOG.Flush();
  LOGERR.Flush();
  CARGoSLog::SetSequence(0);
  if (m_times != nullptr) {
    ++m_times->Ticks;
  }
}

// call it before each loop over robots: users add and remove robots between phases
void CTick::PlanVisits() {
  const UInt64 version = m_context.Space->GetVersionOfControllableEntities();
  if (version == m_robotsOfVisits) {
    return;
  }
  m_visits.clear();
  m_visits.reserve(m_context.Space->GetControllableEntities().size());
  for (CControllableEntity* robot : m_context.Space->GetControllableEntities()) {
    m_visits.push_back({robot, static_cast<UInt32>(m_visits.size())});
  }
  const auto isBefore = [](const SRobotVisit& a, const SRobotVisit& b) {
    return a.Robot->GetIndex() < b.Robot->GetIndex();
  };
  if (!std::is_sorted(m_visits.begin(), m_visits.end(), isBefore)) {
    std::sort(m_visits.begin(), m_visits.end(), isBefore);
  }
  ARGOS_ASSERT(std::adjacent_find(m_visits.begin(), m_visits.end(),
                                  [](const SRobotVisit& a, const SRobotVisit& b) {
                                    return a.Robot == b.Robot;
                                  }) == m_visits.end(),
               "a robot would be visited twice in a tick");
  m_lookAhead.SetVisits(m_visits);
  m_robotsOfVisits = version;
}

// call it before a loop over robots
void CTick::BeginRecords() {
  m_context.Metrics->GetRobotRecords().Begin(m_context.Space->GetControllableEntities().size(),
                                             m_context.Pool->GetNumThreads());
}

// call it after the loop; robots that do not agree about the unit of a new metric fail
void CTick::TakeRecords(const char* call, bool isDevice) {
  const std::vector<CControllableEntity*>& robots = m_context.Space->GetControllableEntities();
  for (const CMetrics::SFailure& failure : m_context.Metrics->TakeRobotRecords()) {
    try {
      std::rethrow_exception(failure.Error);
    } catch (...) {
      ARGOS_ASSERT(failure.Robot < robots.size(),
                   "robot number " << failure.Robot << " of " << robots.size() << " has failed");
      HandleFailure(m_context, {call, isDevice}, *robots[failure.Robot]);
    }
  }
}

void CTick::Act() {
  PlanVisits();
  BeginRecords();
  InLogOrder(m_visits.size(), [&](UInt64 firstPlace) {
    m_context.Pool->ParallelFor(
        m_visits.size(), m_actCost, [&](size_t begin, size_t end, UInt32 thread) {
          ForRobots(
              m_context, {m_visits, begin, end, thread, firstPlace, {"an actuator", true}},
              [](CControllableEntity& robot) { robot.Act(); },
              [this](size_t visit) { m_lookAhead.BeforeAct(visit); });
        });
  });
  TakeRecords("an actuator", true);
  for (CMedium* medium : m_context.Media) {
    medium->TakeActs();
  }
}

void CTick::CollectGhosts() {
  if (std::ranges::none_of(m_context.Engines, &CPhysicsEngine::SeesGhosts)) {
    return;
  }
  CollectGhostsOfEngines();
  if (m_bundles.Update()) {
    CollectGhostsOfEngines();
  }
}

void CTick::CollectGhostsOfEngines() {
  const CPhysicsEngine::TVector& engines = m_context.Engines;
  m_context.Pool->ParallelFor(engines.size(), m_ghostCost, [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      if (engines[i]->SeesGhosts()) {
        engines[i]->CollectGhosts();
      }
    }
  });
}

void CTick::UpdatePhysics() {
  UpdateParts(m_context.Engines, m_context, m_engineCost);
}

void CTick::TransferBodies() {
  for (CPhysicsEngine* engine : m_context.Engines) {
    if (engine->IsEntityTransferNeeded()) {
      engine->TransferEntities();
    }
  }
}

void CTick::UpdateMedia() {
  UpdateParts(m_context.Media, m_context, m_mediumCost);
}

void CTick::SenseAndControlChunk(size_t first, size_t last, UInt32 thread, UInt64 firstPlace) {
  ARGOS_ASSERT(thread < m_robotTimes.size(), "thread " << thread << " of " << m_robotTimes.size());
  SRobotTimes& times = m_robotTimes[thread];
  // If a robot fails to sense, those before it are controlled nevertheless, because one of them
  // may fail: the robot that is reported is the first in order, however they are dealt.
  std::exception_ptr failure;
  size_t sensed = first;
  Timed(m_times != nullptr ? &times.Sense : nullptr, [&] {
    try {
      ForRobots(
          m_context, {m_visits, first, last, thread, firstPlace, {"a sensor", true}},
          [](CControllableEntity& robot) { robot.Sense(); },
          [&](size_t visit) {
            sensed = visit;
            m_lookAhead.BeforeSense(visit, *m_context.Index);
          });
      sensed = last;
    } catch (...) {
      failure = std::current_exception();
    }
  });
  Timed(m_times != nullptr ? &times.Control : nullptr, [&] {
    ForRobots(
        m_context, {m_visits, first, sensed, thread, firstPlace, {"ControlStep()", false}},
        [](CControllableEntity& robot) { robot.ControlStep(); }, [](size_t) {});
  });
  if (failure) {
    std::rethrow_exception(failure);
  }
}

void CTick::SenseAndControl() {
  const CRobotsCode::CLoop loop;
  PlanVisits();
  BeginRecords();
  m_context.Space->SetBodiesOutsideIndex(
      std::ranges::any_of(m_context.Engines, &CPhysicsEngine::HasBodiesOutsideIndex));
  // a controller writes only into its own robot's actuators, which no sensor reads in this phase:
  // so all robots of a chunk may sense before the first of them is controlled
  m_robotTimes.assign(m_context.Pool->GetNumThreads(), SRobotTimes());
  InLogOrder(m_visits.size(), [&](UInt64 firstPlace) {
    m_context.Pool->ParallelFor(
        m_visits.size(), m_senseCost, [&](size_t begin, size_t end, UInt32 thread) {
          for (size_t first = begin; first < end; first += CSpace::kRobotsPerChunk) {
            SenseAndControlChunk(first, std::min(end, first + CSpace::kRobotsPerChunk), thread,
                                 firstPlace);
          }
        });
  });
  if (m_times != nullptr) {
    for (const SRobotTimes& times : m_robotTimes) {
      m_times->Sense += times.Sense;
      m_times->Control += times.Control;
    }
  }
  TakeRecords("ControlStep()", false);
}

}  // namespace argos
