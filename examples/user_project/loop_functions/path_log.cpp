#include "path_log.h"

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>

using namespace argos;

void CPathLog::Init(TConfigurationNode& node) {
  GetNodeAttribute(node, "output", m_fileName);
  Start();
}

void CPathLog::Reset() {
  Start();
}

void CPathLog::Destroy() {
  // throws if not all could be written, as "<<" does
  m_file.Close();
}

void CPathLog::Start() {
  m_file.Open(m_fileName);
  m_file << "tick,robot,x,y,driven\n";
  m_paths.clear();
  for (const auto& [id, entity] : GetSpace().GetEntitiesByType("foot-bot")) {
    auto& robot = *any_cast<CFootBotEntity*>(entity);
    m_paths[id].Position = robot.GetEmbodiedEntity().GetOriginAnchor().Position;
  }
}

void CPathLog::PostStep() {
  for (const auto& [id, entity] : GetSpace().GetEntitiesByType("foot-bot")) {
    auto& robot = *any_cast<CFootBotEntity*>(entity);
    const CVector3& position = robot.GetEmbodiedEntity().GetOriginAnchor().Position;
    SPath& path = m_paths[id];
    path.Driven += Distance(position, path.Position);
    path.Position = position;
    m_file << GetSpace().GetSimulationClock() << ',' << id << ',' << position.GetX() << ','
           << position.GetY() << ',' << path.Driven << '\n';
  }
}

void CPathLog::PostExperiment() {
  for (const auto& [id, path] : m_paths) {
    LOG << id << " drove " << path.Driven << " m" << std::endl;
  }
}

REGISTER_LOOP_FUNCTIONS(CPathLog, "path_log")
