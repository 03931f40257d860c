#ifndef USER_LOOP_FUNCTIONS_H
#define USER_LOOP_FUNCTIONS_H

/* Loop functions as users of ARGoS 3 write them, with every hook. */

#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/rng.h>

using namespace argos;

class CUserLoopFunctions : public CLoopFunctions {
 public:
  CUserLoopFunctions();
  virtual ~CUserLoopFunctions() {}

  virtual void Init(TConfigurationNode& t_tree);
  virtual void Reset();
  virtual void Destroy();
  virtual CColor GetFloorColor(const CVector2& c_position_on_plane);
  virtual void PreStep();
  virtual void PostStep();
  virtual bool IsExperimentFinished();
  virtual void PostExperiment();

  /* these can be overridden too */
  virtual void MoveEntity(CPositionalEntity& c_entity, const CVector3& c_position,
                          const CQuaternion& c_orientation);
  virtual bool MoveEntity(CEmbodiedEntity& c_entity, const CVector3& c_position,
                          const CQuaternion& c_orientation, bool b_check_only = false,
                          bool b_ignore_collisions = false);
  virtual void AddEntity(CEntity& c_entity);
  virtual void RemoveEntity(const std::string& str_entity_id);
  virtual void RemoveEntity(CEntity& c_entity);

  const std::vector<CVector2>& GetItems() const { return m_cItems; }
  UInt32 GetTotalSteps() const { return m_unTotalSteps; }
  UInt32 GetVisited() const { return m_unVisited; }
  bool WasPostExperiment() const { return m_bPostExperiment; }

 private:
  CRange<Real> m_cArenaSideX, m_cArenaSideY;
  std::vector<CVector2> m_cItems;
  CFloorEntity* m_pcFloor;
  CRandom::CRNG* m_pcRNG;
  std::string m_strOutput;
  std::ofstream m_cOutput;
  std::map<std::string, std::vector<CVector3> > m_tWaypoints;
  UInt32 m_unTotalSteps;
  UInt32 m_unVisited;
  bool m_bPostExperiment;
};

#endif
