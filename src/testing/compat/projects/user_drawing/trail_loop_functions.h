#ifndef TRAIL_LOOP_FUNCTIONS_H
#define TRAIL_LOOP_FUNCTIONS_H

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>

using namespace argos;

class CTrailLoopFunctions : public CLoopFunctions {
 public:
  typedef std::map<CFootBotEntity*, std::vector<CVector3> > TWaypointMap;

  virtual ~CTrailLoopFunctions() {}

  virtual void Init(TConfigurationNode& t_tree);
  virtual void Reset();
  virtual void PostStep();

  inline const TWaypointMap& GetWaypoints() const { return m_tWaypoints; }

 private:
  TWaypointMap m_tWaypoints;
};

#endif
