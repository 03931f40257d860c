#include "arrivals_loop_functions.h"

#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>

void CArrivalsLoopFunctions::Init(TConfigurationNode& t_tree) {
  GetNodeAttribute(t_tree, "output", m_strOutput);
  GetNodeAttribute(t_tree, "line", m_fLine);
  m_cOutput.open(m_strOutput.c_str(), std::ios_base::trunc | std::ios_base::out);
  m_cOutput << "# clock\tarrived\tx_of_first" << std::endl;
}

void CArrivalsLoopFunctions::Reset() {
  m_cOutput.close();
  m_cOutput.open(m_strOutput.c_str(), std::ios_base::trunc | std::ios_base::out);
  m_cOutput << "# clock\tarrived\tx_of_first" << std::endl;
}

void CArrivalsLoopFunctions::Destroy() {
  m_cOutput.close();
}

void CArrivalsLoopFunctions::PostStep() {
  UInt32 unArrived = 0;
  Real fFirst = 0.0;
  CSpace::TMapPerType& cFootBots = GetSpace().GetEntitiesByType("foot-bot");
  for (CSpace::TMapPerType::iterator it = cFootBots.begin(); it != cFootBots.end(); ++it) {
    CFootBotEntity& cFootBot = *any_cast<CFootBotEntity*>(it->second);
    const CVector3& cPosition = cFootBot.GetEmbodiedEntity().GetOriginAnchor().Position;
    if (it == cFootBots.begin())
      fFirst = cPosition.GetX();
    if (cPosition.GetX() > m_fLine)
      ++unArrived;
  }
  m_cOutput << GetSpace().GetSimulationClock() << "\t" << unArrived << "\t" << fFirst << std::endl;
}

REGISTER_LOOP_FUNCTIONS(CArrivalsLoopFunctions, "arrivals_loop_functions")
