#include "trajectory_loop_functions.h"

#include <argos3/core/utility/datatypes/any.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>

using namespace argos;

void CTrajectoryLoopFunctions::Init(TConfigurationNode& node) {
  TConfigurationNode& trajectories = GetNode(node, "trajectories");
  GetNodeAttributeOrDefault(trajectories, "length", m_length, m_length);
  if (m_length == 0) {
    THROW_ARGOSEXCEPTION(trajectories.GetLocation()
                         << ": <trajectories>: \"length\" must be at least 1 tick, found 0");
  }
  AddPositions();
}

void CTrajectoryLoopFunctions::Reset() {
  m_trajectories.clear();
  AddPositions();
}

void CTrajectoryLoopFunctions::PostStep() {
  AddPositions();
}

void CTrajectoryLoopFunctions::AddPositions() {
  for (const auto& [id, entity] : GetSpace().GetEntitiesByType("foot-bot")) {
    CFootBotEntity& robot = *any_cast<CFootBotEntity*>(entity);
    TTrajectory& trajectory = m_trajectories[id];
    trajectory.push_back(robot.GetEmbodiedEntity().GetOriginAnchor().Position);
    if (trajectory.size() > m_length) {
      trajectory.pop_front();
    }
  }
}

REGISTER_LOOP_FUNCTIONS(CTrajectoryLoopFunctions, "trajectory_loop_functions")
