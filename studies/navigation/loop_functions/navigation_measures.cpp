#include "navigation_measures.h"

#include "../controllers/navigation_robot.h"

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>

#include <cmath>

using namespace argos;

void CNavigationMeasures::Init(TConfigurationNode& node) {
  TConfigurationNode& params = GetNode(node, "params");
  GetNodeAttribute(params, "scenario", m_scenario);
  if (m_scenario < 1 || m_scenario > 2) {
    THROW_ARGOSEXCEPTION("scenario is " << m_scenario << "; it must be 1 or 2");
  }
  for (auto& [id, entity] : GetSpace().GetEntitiesByType("foot-bot")) {
    auto* robot = any_cast<CFootBotEntity*>(entity);
    auto* controller =
        dynamic_cast<CNavigationRobot*>(&robot->GetControllableEntity().GetController());
    if (controller != nullptr) {  // a target otherwise
      m_robots.push_back({robot, controller, {}, {}, 0, 0});
    }
  }
  Reset();
}

void CNavigationMeasures::Reset() {
  m_numTrips = 0;
  m_sumOfDelays = m_sumOfRotations = 0.0;
  for (std::size_t i = 0; i < m_robots.size(); ++i) {
    SRobot& robot = m_robots[i];
    robot = {robot.Entity, robot.Controller, GetPosition(robot), {}, 0, 0};
    if (m_scenario == 2 || i == 0) {
      robot.Controller->Navigate(i % kNumTargets);
    }
  }
}

CVector2 CNavigationMeasures::GetPosition(const SRobot& robot) {
  const CVector3& position = robot.Entity->GetEmbodiedEntity().GetOriginAnchor().Position;
  return {position.GetX(), position.GetY()};
}

void CNavigationMeasures::CountTrips(SRobot& robot) {
  if (robot.Controller->GetNumArrivals() == robot.NumArrivals) {
    return;
  }
  const UInt32 tick = GetSpace().GetSimulationClock();
  if (robot.NumArrivals > 0) {
    ++m_numTrips;
    m_sumOfDelays += (tick - robot.TripStart) * CPhysicsEngine::GetSimulationClockTick();
  }
  robot.NumArrivals = robot.Controller->GetNumArrivals();
  robot.TripStart = tick;
}

Real CNavigationMeasures::MeasureRotation() {
  CVector2 centre;
  for (SRobot& robot : m_robots) {
    robot.Movement = GetPosition(robot) - robot.Position;
    robot.Position += robot.Movement;
    centre += robot.Position / static_cast<Real>(m_robots.size());
  }
  Real momentum = 0.0;
  Real largest = 0.0;
  for (const SRobot& robot : m_robots) {
    const CVector2 arm = robot.Position - centre;
    momentum += arm.CrossProduct(robot.Movement);
    largest += arm.Length() * robot.Movement.Length();
  }
  return largest > 0.0 ? momentum / largest : 0.0;
}

void CNavigationMeasures::PostStep() {
  for (SRobot& robot : m_robots) {
    CountTrips(robot);
  }
  const Real rotation = MeasureRotation();
  CMetrics& metrics = GetSimulator().GetMetrics();
  metrics.Record("rotation", rotation);
  metrics.Record("trips", m_numTrips);
  if (m_numTrips > 0) {
    metrics.Record("delay", m_sumOfDelays / m_numTrips, "s");
  }
  const UInt32 half = GetSimulator().GetMaxSimulationClock() / 2;
  const UInt32 tick = GetSpace().GetSimulationClock();
  if (tick > half) {
    m_sumOfRotations += rotation;
    const Real mean = m_sumOfRotations / (tick - half);
    metrics.Record("mean_rotation", mean);
    metrics.Record("loop", std::abs(mean));
  }
}

REGISTER_LOOP_FUNCTIONS(CNavigationMeasures, "navigation_measures")
