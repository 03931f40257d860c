#include "racer_loop_functions.h"

void CRacerLoopFunctions::Init(TConfigurationNode& t_node) {
  GetNodeAttribute(t_node, "start", m_cStart);
  m_pcFootBot = new CFootBotEntity("fb", "racer", m_cStart);
  AddEntity(*m_pcFootBot);
  m_pcController =
      &dynamic_cast<CRacerController&>(m_pcFootBot->GetControllableEntity().GetController());
}

void CRacerLoopFunctions::Reset() {
  if (!MoveEntity(m_pcFootBot->GetEmbodiedEntity(), m_cStart, CQuaternion(), false)) {
    LOGERR << "Can't move the robot to " << m_cStart << std::endl;
  }
}

void CRacerLoopFunctions::PostExperiment() {
  m_fPerformance = Distance(m_pcFootBot->GetEmbodiedEntity().GetOriginAnchor().Position, m_cStart);
  ++m_unTrials;
}

REGISTER_LOOP_FUNCTIONS(CRacerLoopFunctions, "racer_loop_functions")
