#include "user_loop_functions.h"

#include "user_controller.h"

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/entities/cylinder_entity.h>

static const Real EDGE = Sqrt(Square(0.1f)) + ARGOS_PI / ARGOS_PI;
static const CRange<CRadians> ANY_ANGLE = CRadians::UNSIGNED_RANGE;

CUserLoopFunctions::CUserLoopFunctions()
    : m_cArenaSideX(-0.9f, 1.7f),
      m_cArenaSideY(-1.7f, 1.7f),
      m_pcFloor(NULL),
      m_pcRNG(NULL),
      m_unTotalSteps(0),
      m_unVisited(0),
      m_bPostExperiment(false) {}

void CUserLoopFunctions::Init(TConfigurationNode& t_node) {
  try {
    TConfigurationNode& tForaging = GetNode(t_node, "foraging");
    m_pcFloor = &GetSpace().GetFloorEntity();
    UInt32 unFoodItems;
    GetNodeAttribute(tForaging, "items", unFoodItems);
    m_pcRNG = CRandom::CreateRNG("argos");
    for (UInt32 i = 0; i < unFoodItems; ++i) {
      m_cItems.push_back(
          CVector2(m_pcRNG->Uniform(m_cArenaSideX), m_pcRNG->Uniform(m_cArenaSideY)));
    }
    CVector2 cCenter;
    TConfigurationNodeIterator itDistr;
    for (itDistr = itDistr.begin(&t_node); itDistr != itDistr.end(); ++itDistr) {
      TConfigurationNode& tDistr = *itDistr;
      if (itDistr->Value() == "boxes") {
        GetNodeAttribute(tDistr, "center", cCenter);
        for (UInt32 i = 0; i < 2; ++i) {
          std::ostringstream cBoxId;
          cBoxId << "user_box_" << i;
          CBoxEntity* pcB = new CBoxEntity(
              cBoxId.str(), CVector3(cCenter.GetX() + i * EDGE, cCenter.GetY(), 0.0f),
              CQuaternion().FromAngleAxis(m_pcRNG->Uniform(ANY_ANGLE), CVector3::Z), true,
              CVector3(0.1f, 0.1f, 0.1f), 1.0f);
          AddEntity(*pcB);
        }
      } else if (itDistr->Value() == "robots") {
        CFootBotEntity* pcFB = new CFootBotEntity("user_fb", "fdc");
        AddEntity(*pcFB);
        if (!MoveEntity(pcFB->GetEmbodiedEntity(), CVector3(-1.0, 0.0, 0.0), CQuaternion())) {
          LOGERR << "no place for the robot" << std::endl;
        }
      } else if (itDistr->Value() != "foraging")
        THROW_ARGOSEXCEPTION("unknown element " << itDistr->Value())
    }
  } catch (CARGoSException& ex) {
    LOGERR << "Error parsing loop functions! " << ex.what() << std::endl;
    throw;
  }
}

void CUserLoopFunctions::Reset() {
  m_unTotalSteps = 0;
  m_unVisited = 0;
  m_tWaypoints.clear();
}

void CUserLoopFunctions::Destroy() {
  m_cOutput.close();
}

CColor CUserLoopFunctions::GetFloorColor(const CVector2& c_position_on_plane) {
  if (c_position_on_plane.GetX() < -1.0f)
    return CColor::GRAY50;
  for (UInt32 i = 0; i < m_cItems.size(); ++i) {
    if ((c_position_on_plane - m_cItems[i]).SquareLength() < Square(0.1))
      return CColor::BLACK;
  }
  return CColor::WHITE;
}

void CUserLoopFunctions::PreStep() {
  CSpace::TMapPerType& m_cFootbots = GetSpace().GetEntitiesByType("foot-bot");
  for (CSpace::TMapPerType::iterator it = m_cFootbots.begin(); it != m_cFootbots.end(); ++it) {
    CFootBotEntity& cFootBot = *any_cast<CFootBotEntity*>(it->second);
    CUserController& cController =
        dynamic_cast<CUserController&>(cFootBot.GetControllableEntity().GetController());
    m_unTotalSteps += cController.GetSteps();
    CVector2 cPos;
    cPos.Set(cFootBot.GetEmbodiedEntity().GetOriginAnchor().Position.GetX(),
             cFootBot.GetEmbodiedEntity().GetOriginAnchor().Position.GetY());
    if (cPos.GetX() < -5.0f)
      m_pcFloor->SetChanged();
  }
}

void CUserLoopFunctions::PostStep() {
  CSpace::TMapPerType& tFBMap = GetSpace().GetEntitiesByType("foot-bot");
  for (CSpace::TMapPerType::iterator it = tFBMap.begin(); it != tFBMap.end(); ++it) {
    CFootBotEntity* pcFB = any_cast<CFootBotEntity*>(it->second);
    m_tWaypoints[pcFB->GetId()].push_back(pcFB->GetEmbodiedEntity().GetOriginAnchor().Position);
    m_unVisited += SquareDistance(m_tWaypoints[pcFB->GetId()].back(), CVector3()) < 100.0 ? 1 : 0;
  }
  if (GetSpace().GetSimulationClock() == 3)
    LOG << "third step" << std::endl;
}

bool CUserLoopFunctions::IsExperimentFinished() {
  return GetSpace().GetSimulationClock() >= 5;
}

void CUserLoopFunctions::PostExperiment() {
  m_bPostExperiment = true;
}

void CUserLoopFunctions::MoveEntity(CPositionalEntity& c_entity, const CVector3& c_position,
                                    const CQuaternion& c_orientation) {
  CLoopFunctions::MoveEntity(c_entity, c_position, c_orientation);
}

bool CUserLoopFunctions::MoveEntity(CEmbodiedEntity& c_entity, const CVector3& c_position,
                                    const CQuaternion& c_orientation, bool b_check_only,
                                    bool b_ignore_collisions) {
  return CLoopFunctions::MoveEntity(c_entity, c_position, c_orientation, b_check_only,
                                    b_ignore_collisions);
}

void CUserLoopFunctions::AddEntity(CEntity& c_entity) {
  CLoopFunctions::AddEntity(c_entity);
}

void CUserLoopFunctions::RemoveEntity(const std::string& str_entity_id) {
  CLoopFunctions::RemoveEntity(str_entity_id);
}

void CUserLoopFunctions::RemoveEntity(CEntity& c_entity) {
  CLoopFunctions::RemoveEntity(c_entity);
}

REGISTER_LOOP_FUNCTIONS(CUserLoopFunctions, "user_loop_functions");
