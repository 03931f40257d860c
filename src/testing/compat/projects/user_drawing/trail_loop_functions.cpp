#include "trail_loop_functions.h"

void CTrailLoopFunctions::Init(TConfigurationNode& t_tree) {
  Reset();
}

void CTrailLoopFunctions::Reset() {
  m_tWaypoints.clear();
  PostStep();
}

void CTrailLoopFunctions::PostStep() {
  CSpace::TMapPerType& tFBMap = GetSpace().GetEntitiesByType("foot-bot");
  for (CSpace::TMapPerType::iterator it = tFBMap.begin(); it != tFBMap.end(); ++it) {
    CFootBotEntity* pcFB = any_cast<CFootBotEntity*>(it->second);
    m_tWaypoints[pcFB].push_back(pcFB->GetEmbodiedEntity().GetOriginAnchor().Position);
  }
}

REGISTER_LOOP_FUNCTIONS(CTrailLoopFunctions, "trail_loop_functions")
