#ifndef RACER_LOOP_FUNCTIONS_H
#define RACER_LOOP_FUNCTIONS_H

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>

#include "racer_controller.h"

/* Places the robot that is evaluated, and computes its fitness. */
class CRacerLoopFunctions : public CLoopFunctions {
 public:
  CRacerLoopFunctions() : m_pcFootBot(NULL), m_pcController(NULL), m_unTrials(0) {}
  virtual ~CRacerLoopFunctions() {}
  virtual void Init(TConfigurationNode& t_node);
  virtual void Reset();
  virtual void PostExperiment();
  void ConfigureFromGenome(const Real* pf_genome) { m_pcController->SetGenome(pf_genome); }
  /* The distance from the start at the end of the trial, in m. */
  Real Performance() const { return m_fPerformance; }
  UInt32 GetTrials() const { return m_unTrials; }

 private:
  CFootBotEntity* m_pcFootBot;
  CRacerController* m_pcController;
  CVector3 m_cStart;
  Real m_fPerformance = 0.0;
  UInt32 m_unTrials;
};

#endif
