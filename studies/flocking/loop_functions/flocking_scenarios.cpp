#include "flocking_scenarios.h"

#include "../controllers/flocking_robot.h"

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>

using namespace argos;

void CFlockingScenarios::Init(TConfigurationNode& node) {
  TConfigurationNode& params = GetNode(node, "params");
  GetNodeAttribute(params, "scenario", m_scenario);
  if (m_scenario < 1 || m_scenario > 3) {
    THROW_ARGOSEXCEPTION("scenario is " << m_scenario << "; it must be 1, 2 or 3");
  }
  GetNodeAttributeOrDefault(params, "settled", m_settledTime, m_settledTime);
  m_rng = CRandom::CreateRNG("argos");
  m_ends = ComputeEnds();
  for (auto& [id, entity] : GetSpace().GetEntitiesByType("foot-bot")) {
    auto* robot = any_cast<CFootBotEntity*>(entity);
    m_robots.push_back(robot);
    m_controllers.push_back(
        &dynamic_cast<CFlockingRobot&>(robot->GetControllableEntity().GetController()));
  }
  Reset();
}

std::vector<UInt32> CFlockingScenarios::ComputeEnds() const {
  const UInt32 length = CSimulator::GetInstance().GetMaxSimulationClock();
  std::vector<UInt32> ends;
  for (UInt32 phase = 1; phase <= m_scenario; ++phase) {
    ends.push_back(length * phase / m_scenario);
  }
  return ends;
}

void CFlockingScenarios::Reset() {
  m_towardsLight = false;
  m_hasRisen = false;
  m_informed = DrawRobot({});
  Inform(m_informed, false);
  m_phase = 0;
  m_sumOfOrder = m_sumOfAccuracy = 0.0;
  Measure();
}

std::size_t CFlockingScenarios::DrawRobot(std::optional<std::size_t> except) {
  std::size_t robot = 0;
  do {
    robot = m_rng->Uniform(CRange<UInt32>(0, static_cast<UInt32>(m_robots.size())));
  } while (robot == except);
  return robot;
}

void CFlockingScenarios::Inform(std::size_t robot, bool second) {
  const bool towardsLight = second || m_towardsLight;
  m_controllers[robot]->SetGoal(
      CFlockingRobot::SGoal{towardsLight ? CRadians::ZERO : CRadians::PI, second});
}

void CFlockingScenarios::BeginPhase(std::size_t phase) {
  m_phase = phase;
  m_sumOfOrder = m_sumOfAccuracy = 0.0;
  if (m_scenario == 2) {
    // the target moves; another robot knows it
    m_controllers[m_informed]->SetGoal({});
    m_towardsLight = true;
    m_informed = DrawRobot(m_informed);
    Inform(m_informed, false);
  } else if (phase == 1) {
    Inform(DrawRobot(m_informed), true);
  } else {
    for (std::size_t robot = 0; robot < m_robots.size(); ++robot) {
      if (robot != m_informed) {
        m_controllers[robot]->SetGoal({});
      }
    }
  }
}

void CFlockingScenarios::PostStep() {
  Measure();
  const UInt32 tick = GetSpace().GetSimulationClock();
  const auto ticksPerSecond = CPhysicsEngine::GetInverseSimulationClockTick();
  if (!m_hasRisen && m_phase == 0 && (m_accuracy >= 0.9 || tick == m_ends[0])) {
    m_hasRisen = true;
    Record("rise", tick / ticksPerSecond);
  }
  const UInt32 settled = static_cast<UInt32>(m_settledTime * ticksPerSecond);
  if (tick + settled > m_ends[m_phase]) {
    m_sumOfOrder += m_order;
    m_sumOfAccuracy += m_accuracy;
  }
  if (tick != m_ends[m_phase]) {
    return;
  }
  const std::string number = std::to_string(m_phase + 1);
  Record("order_" + number, m_sumOfOrder / settled);
  Record("accuracy_" + number, m_sumOfAccuracy / settled);
  if (m_phase + 1 < m_ends.size()) {
    BeginPhase(m_phase + 1);
  }
}

void CFlockingScenarios::Measure() {
  CVector2 sum;
  for (CFootBotEntity* robot : m_robots) {
    CRadians yaw;
    CRadians pitch;
    CRadians roll;
    robot->GetEmbodiedEntity().GetOriginAnchor().Orientation.ToEulerAngles(yaw, pitch, roll);
    sum += CVector2(1.0, yaw);
  }
  const CVector2 mean = sum / static_cast<Real>(m_robots.size());
  m_order = mean.Length();
  // the order times the cosine is the part of the mean in the direction of the target
  m_accuracy = (1.0 + (m_towardsLight ? -mean.GetX() : mean.GetX())) / 2.0;
  Record("order", m_order);
  Record("accuracy", m_accuracy);
}

void CFlockingScenarios::Record(const std::string& name, Real value) {
  GetSimulator().GetMetrics().Record(name, value);
}

REGISTER_LOOP_FUNCTIONS(CFlockingScenarios, "flocking_scenarios")
