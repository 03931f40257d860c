#include <argos3/run/run.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/existing_component.h>
#include <argos3/core/simulator/outputs/run_outputs.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/line_marks.h>
#include <argos3/core/utility/files/output_file.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/core/utility/processes/cpu_time.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace argos {

namespace {

void FlushLogs() {
  LOG.Flush();
  LOGERR.Flush();
}

Real GetSeconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<Real>(duration).count();
}

}  // namespace

SRunFailure DescribeFailure() {
  const std::string text = DescribeCurrentException();
  return {MarkLines(text), SaysOutOfMemory(text)};
}

void PrintFailure(const SRunFailure& failure) {
  CARGoSLog& log = LOGERR.HasFailed() && !LOG.HasFailed() ? LOG : LOGERR;
  log << failure.Text << std::endl;
  FlushLogs();
}

bool SaysOutOfMemory(const std::string& text) {
  return text.find("not enough memory") != std::string::npos ||
         text.find("std::bad_alloc") != std::string::npos;
}

std::string TakeFailedOutputs() {
  std::vector<std::string> failures = TakeOutputFailures();
  for (CARGoSLog* log : {&LOG, &LOGERR}) {
    failures.push_back(log->TakeFailure());
  }
  std::string text;
  for (const std::string& failure : failures) {
    text += (text.empty() || failure.empty() ? "" : "\n") + failure;
  }
  return text;
}

std::string DescribeRun(const SRunSummary& summary) {
  std::string text = fmt::format(
      "simulated {:.6g} s in {:.3g} s of wall time (real-time factor {:.3g}, {} tick{}, {} "
      "robot{})",
      summary.SimulatedTime, summary.WallTime,
      summary.WallTime > 0.0 ? summary.SimulatedTime / summary.WallTime : 0.0, summary.Ticks,
      summary.Ticks == 1 ? "" : "s", summary.Robots, summary.Robots == 1 ? "" : "s");
  if (summary.HasOutputs) {
    text += fmt::format(": {:.3g} s for the simulation, {:.3g} s for its outputs",
                        std::max(0.0, summary.WallTime - summary.OutputTime), summary.OutputTime);
  }
  return text;
}

CRun::CRun(CSimulator& simulator, TReport report)
    : m_simulator(simulator), m_report(std::move(report)) {}

CRun::~CRun() {
  Finish();
}

void CRun::CollectWarnings() {
  m_warnings = std::make_unique<CLogObserver>([this](ELogLevel level, const std::string& line) {
    if (level == ELogLevel::Warning && m_summary.Warnings.size() < kMaxWarnings) {
      m_summary.Warnings.push_back(line);
    }
  });
}

bool CRun::Try(const std::function<void()>& step) {
  try {
    step();
    return true;
  } catch (...) {
    m_summary.Failures.push_back(DescribeFailure());
  }
  m_report(m_summary.Failures.back());
  return false;
}

bool CRun::Do(const std::function<void()>& step) {
  return IsGood() && Try(step);
}

bool CRun::Load(const std::function<void()>& load) {
  return Do([&] {
    load();
    m_summary.StartUpTime = GetSeconds(TClock::now() - m_start);
  });
}

bool CRun::Execute(const std::function<void(CSimulator&)>& observe) {
  return Do([&] {
    m_simulator.SetTickObserver(observe);
    const Real cpuTime = GetProcessCPUTime();
    const TClock::time_point start = TClock::now();
    try {
      m_simulator.Execute();
    } catch (...) {
      Measure(start, cpuTime);
      throw;
    }
    Measure(start, cpuTime);
    FlushLogs();
  });
}

void CRun::Measure(TClock::time_point start, Real cpuTime) {
  m_summary.WallTime = GetSeconds(TClock::now() - start);
  m_summary.CPUTime = GetProcessCPUTime() - cpuTime;
  m_simulator.SetTickObserver(nullptr);
  m_summary.Ticks = m_simulator.GetSpace().GetSimulationClock();
  m_summary.SimulatedTime = m_summary.Ticks * m_simulator.GetTickLength();
  m_summary.HasOutputs = !m_simulator.GetOutputs().IsEmpty();
  m_summary.OutputTime = m_simulator.GetOutputs().GetSeconds();
  CountStoppedRobots();
}

void CRun::CountStoppedRobots() {
  const std::vector<CControllableEntity*>& robots =
      m_simulator.GetSpace().GetControllableEntities();
  m_summary.Robots = static_cast<UInt32>(robots.size());
  CountRobotsOutside();
  if (m_simulator.GetRobotFailures().IsEmpty()) {
    return;
  }
  for (const CControllableEntity* robot : robots) {
    m_summary.StoppedRobots += robot->IsStopped() ? 1 : 0;
    m_summary.QuarantinedRobots += robot->IsQuarantined() ? 1 : 0;
  }
  m_summary.RobotErrors = m_simulator.GetRobotFailures().Summarize();
}

void CRun::CountRobotsOutside() {
  const CRange<CVector3>& limits = m_simulator.GetSpace().GetArenaLimits();
  const CRange<Real> x(limits.GetMin().GetX(), limits.GetMax().GetX());
  const CRange<Real> y(limits.GetMin().GetY(), limits.GetMax().GetY());
  for (CControllableEntity* const robot : m_simulator.GetSpace().GetControllableEntities()) {
    const auto* const root = dynamic_cast<const CComposableEntity*>(&robot->GetRootEntity());
    if (root == nullptr || robot->IsQuarantined()) {
      continue;
    }
    const auto* const body = FindExistingComponent<CEmbodiedEntity>(*root);
    if (body == nullptr) {
      continue;
    }
    const CVector3& place = body->GetOriginAnchor().Position;
    if (!x.WithinMinBoundIncludedMaxBoundIncluded(place.GetX()) ||
        !y.WithinMinBoundIncludedMaxBoundIncluded(place.GetY())) {
      if (m_summary.RobotsOutside == 0) {
        m_summary.FirstOutside = root->GetId();
      }
      ++m_summary.RobotsOutside;
    }
  }
}

bool CRun::Destroy() {
  if (!m_isDestroyed) {
    m_isDestroyed = true;
    Try([&] { m_simulator.Destroy(); });
  }
  return IsGood();
}

const SRunSummary& CRun::Finish() {
  Destroy();
  if (m_warnings != nullptr) {
    FlushLogs();
    m_warnings.reset();
  }
  if (!IsGood()) {
    m_summary.Status =
        m_summary.Failures.back().IsOutOfMemory ? ERunStatus::OutOfMemory : ERunStatus::Failed;
  } else if (m_summary.Signal != 0) {
    m_summary.Status = ERunStatus::Interrupted;
  } else {
    // robots that have failed in Destroy() are among them
    m_summary.Status =
        m_simulator.GetRobotFailures().IsEmpty() ? ERunStatus::Done : ERunStatus::RobotsStopped;
  }
  return m_summary;
}

}  // namespace argos
