#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>

using namespace argos;

/* Measures the speed of each robot between the last two ticks. */
class CSpeedsLoopFunctions : public CLoopFunctions {
 public:
  virtual void PostStep() {
    CSpace::TMapPerType& cFootBots = GetSpace().GetEntitiesByType("foot-bot");
    for (auto& tEntry : cFootBots) {
      CVector3 cNow =
          any_cast<CFootBotEntity*>(tEntry.second)->GetEmbodiedEntity().GetOriginAnchor().Position;
      m_mapSpeeds[tEntry.first] =
          Distance(cNow, m_mapPositions[tEntry.first]) / CPhysicsEngine::GetSimulationClockTick();
      m_mapPositions[tEntry.first] = cNow;
    }
  }
  virtual void PostExperiment() {
    for (auto& tEntry : m_mapSpeeds)
      LOG << "speed of " << tEntry.first << ": " << tEntry.second << " m/s" << std::endl;
  }

 private:
  std::map<std::string, CVector3> m_mapPositions;
  std::map<std::string, Real> m_mapSpeeds;
};

REGISTER_LOOP_FUNCTIONS(CSpeedsLoopFunctions, "speeds_loop_functions")
