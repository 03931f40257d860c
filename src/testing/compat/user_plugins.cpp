#include "user_plugins.h"

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/box.h>

namespace argos {

/* Entities                             */

CUserRobotEntity::CUserRobotEntity()
    : CComposableEntity(NULL),
      m_pcControllableEntity(NULL),
      m_pcEmbodiedEntity(NULL),
      m_pcHorn(NULL) {}

CUserRobotEntity::CUserRobotEntity(const std::string& str_id, const std::string& str_controller_id,
                                   const CVector3& c_position, const CQuaternion& c_orientation)
    : CComposableEntity(NULL, str_id) {
  m_pcEmbodiedEntity = new CEmbodiedEntity(this, "body_0", c_position, c_orientation);
  AddComponent(*m_pcEmbodiedEntity);
  m_pcHorn = new CUserHornEntity(this, "horn_0");
  AddComponent(*m_pcHorn);
  m_pcControllableEntity = new CControllableEntity(this, "controller_0");
  AddComponent(*m_pcControllableEntity);
  m_pcControllableEntity->SetController(str_controller_id);
  UpdateComponents();
}

void CUserRobotEntity::Init(TConfigurationNode& t_tree) {
  try {
    CComposableEntity::Init(t_tree);
    m_pcEmbodiedEntity = new CEmbodiedEntity(this);
    AddComponent(*m_pcEmbodiedEntity);
    m_pcEmbodiedEntity->Init(GetNode(t_tree, "body"));
    m_pcHorn = new CUserHornEntity(this, "horn_0");
    AddComponent(*m_pcHorn);
    m_pcControllableEntity = new CControllableEntity(this);
    AddComponent(*m_pcControllableEntity);
    m_pcControllableEntity->Init(GetNode(t_tree, "controller"));
    UpdateComponents();
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED("Failed to initialize entity \"" << GetId() << "\".", ex);
  }
}

void CUserRobotEntity::Reset() {
  CComposableEntity::Reset();
  UpdateComponents();
}

void CUserRobotEntity::Destroy() {
  CComposableEntity::Destroy();
}

void CUserRobotEntity::UpdateComponents() {
  if (m_pcHorn->IsEnabled())
    m_pcHorn->Update();
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CUserHornEntity);

REGISTER_ENTITY(CUserRobotEntity, "user-robot", "A User [user@example.org]", "1.0",
                "A robot of a user.", "Long.", "Under development")
REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CUserRobotEntity);

/* Medium, engine, visualization        */

REGISTER_MEDIUM(CUserMedium, "user_medium", "A User", "1.0", "A medium of a user.", "Long.",
                "Usable");

CUserModel::CUserModel(CPhysicsEngine& c_engine, CEmbodiedEntity& c_entity)
    : CPhysicsModel(c_engine, c_entity),
      m_cPosition(c_entity.GetOriginAnchor().Position),
      m_cOrientation(c_entity.GetOriginAnchor().Orientation) {
  RegisterAnchorMethod<CUserModel>(c_entity.GetOriginAnchor(), &CUserModel::UpdateOriginAnchor);
  CalculateBoundingBox();
}

void CUserModel::MoveTo(const CVector3& c_position, const CQuaternion& c_orientation) {
  m_cPosition = c_position;
  m_cOrientation = c_orientation;
  CalculateAnchors();
  CalculateBoundingBox();
}

void CUserModel::Restart() {
  m_cPosition = GetEmbodiedEntity().GetOriginAnchor().Position;
  m_cOrientation = GetEmbodiedEntity().GetOriginAnchor().Orientation;
}

void CUserModel::CalculateBoundingBox() {
  GetBoundingBox().MinCorner = m_cPosition - CVector3(0.1, 0.1, 0.0);
  GetBoundingBox().MaxCorner = m_cPosition + CVector3(0.1, 0.1, 0.2);
}

void CUserModel::UpdateOriginAnchor(SAnchor& s_anchor) {
  s_anchor.Position = m_cPosition;
  s_anchor.Orientation = m_cOrientation;
}

void CUserEngine::Init(TConfigurationNode& t_tree) {
  CPhysicsEngine::Init(t_tree);
}

void CUserEngine::Reset() {
  for (CPhysicsModel::TMap::iterator it = m_tPhysicsModels.begin(); it != m_tPhysicsModels.end();
       ++it) {
    static_cast<CUserModel*>(it->second)->Restart();
  }
}

void CUserEngine::Destroy() {
  for (CPhysicsModel::TMap::iterator it = m_tPhysicsModels.begin(); it != m_tPhysicsModels.end();
       ++it) {
    delete it->second;
  }
  m_tPhysicsModels.clear();
}

void CUserEngine::Update() {
  for (CPhysicsModel::TMap::iterator it = m_tPhysicsModels.begin(); it != m_tPhysicsModels.end();
       ++it) {
    it->second->UpdateFromEntityStatus();
    for (size_t i = 0; i < GetIterations(); ++i)
      it->second->UpdatePhysics();
    it->second->UpdateEntityStatus();
  }
}

bool CUserEngine::AddEntity(CEntity& c_entity) {
  CComposableEntity* pcComposable = dynamic_cast<CComposableEntity*>(&c_entity);
  if (pcComposable == NULL || !pcComposable->HasComponent("body") ||
      pcComposable->GetTypeDescription() != "user-robot")
    return false;
  CEmbodiedEntity& cBody = pcComposable->GetComponent<CEmbodiedEntity>("body");
  CUserModel* pcModel = new CUserModel(*this, cBody);
  m_tPhysicsModels[c_entity.GetId()] = pcModel;
  cBody.AddPhysicsModel(GetId(), *pcModel);
  return true;
}

bool CUserEngine::RemoveEntity(CEntity& c_entity) {
  CPhysicsModel::TMap::iterator it = m_tPhysicsModels.find(c_entity.GetId());
  if (it == m_tPhysicsModels.end())
    return false;
  it->second->GetEmbodiedEntity().RemovePhysicsModel(GetId());
  delete it->second;
  m_tPhysicsModels.erase(it);
  return true;
}

void CUserEngine::CheckIntersectionWithRay(TEmbodiedEntityIntersectionData& t_data,
                                           const CRay3& c_ray) const {
  for (CPhysicsModel::TMap::const_iterator it = m_tPhysicsModels.begin();
       it != m_tPhysicsModels.end(); ++it) {
    const SBoundingBox& sBox = it->second->GetBoundingBox();
    CBox cBox(
        sBox.MaxCorner - sBox.MinCorner,
        CVector3(0.5 * (sBox.MinCorner.GetX() + sBox.MaxCorner.GetX()),
                 0.5 * (sBox.MinCorner.GetY() + sBox.MaxCorner.GetY()), sBox.MinCorner.GetZ()));
    Real fTOnRay;
    if (cBox.Intersects(fTOnRay, c_ray) && fTOnRay <= 1.0) {
      t_data.push_back(SEmbodiedEntityIntersectionItem(&it->second->GetEmbodiedEntity(), fTOnRay));
    }
  }
}

REGISTER_PHYSICS_ENGINE(CUserEngine, "user_engine", "A User", "1.0", "An engine of a user.",
                        "Long.", "Usable");

void CUserVisualization::Init(TConfigurationNode& t_tree) {
  GetNodeAttributeOrDefault(t_tree, "frames", m_unFrames, m_unFrames);
}

void CUserVisualization::Execute() {
  while (!m_cSimulator.IsExperimentFinished()) {
    m_cSimulator.UpdateSpace();
    m_unFrames = m_cSpace.GetSimulationClock();
  }
  m_cSimulator.GetLoopFunctions().PostExperiment();
}

REGISTER_VISUALIZATION(CUserVisualization, "user_visualization", "A User", "1.0",
                       "A visualization of a user.", "Long.", "Usable");

}  // namespace argos

/* Devices, at global scope             */

using namespace argos;

class CUserHornDefaultActuator : public CSimulatedActuator, public CCI_UserHornActuator {
 public:
  virtual void SetRobot(CComposableEntity& c_entity) {
    m_pcHorn = &c_entity.GetComponent<CUserHornEntity>("horn");
  }
  virtual void Init(TConfigurationNode& t_tree) { CCI_UserHornActuator::Init(t_tree); }
  virtual void Update() { m_pcHorn->SetVolume(m_fVolume); }
  virtual void Reset() { m_fVolume = 0.0; }
  virtual void Destroy() {}
  virtual void Blow(Real f_volume) { m_fVolume = f_volume; }

 private:
  CUserHornEntity* m_pcHorn = NULL;
  Real m_fVolume = 0.0;
};

/* bases in the other order */
class CUserEarDefaultSensor : public CCI_UserEarSensor, public CSimulatedSensor {
 public:
  virtual void SetRobot(CComposableEntity& c_entity) {
    m_pcHorn = &c_entity.GetComponent<CUserHornEntity>("horn[horn_0]");
    m_pcControllableEntity = &c_entity.GetComponent<CControllableEntity>("controller");
  }
  virtual void Init(TConfigurationNode& t_tree) {
    CCI_UserEarSensor::Init(t_tree);
    GetNodeAttributeOrDefault(t_tree, "show_rays", m_bShowRays, m_bShowRays);
  }
  virtual void Update() {
    m_fReading = m_pcHorn->GetVolume();
    if (m_bShowRays) {
      CRay3 cRay(CVector3(), CVector3::X);
      m_pcControllableEntity->AddCheckedRay(false, cRay);
      m_pcControllableEntity->AddIntersectionPoint(cRay, 0.5);
    }
  }
  virtual void Reset() { m_fReading = 0.0; }

 private:
  CUserHornEntity* m_pcHorn = NULL;
  CControllableEntity* m_pcControllableEntity = NULL;
  bool m_bShowRays = false;
};

REGISTER_ACTUATOR(CUserHornDefaultActuator, "user_horn", "default", "A User", "1.0",
                  "Blows a horn.", "Long.", "Usable");
REGISTER_SENSOR(CUserEarDefaultSensor, "user_ear", "default", "A User", "1.0", "Hears the horn.",
                "Long.", "Usable")
