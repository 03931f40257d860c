#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematics2d_model.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematics2d_engine.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>

namespace argos {

CKinematics2DModel::CKinematics2DModel(CKinematics2DEngine& engine, CEmbodiedEntity& entity,
                                       const Real* wheels)
    : CDescribedBodyModel(engine, entity), m_root(entity.GetRootEntity()), m_wheels(wheels) {
  // those that are made on demand, later, are told of
  if (const auto* const robot = dynamic_cast<CComposableEntity*>(&m_root)) {
    for (CEntity* component : robot->GetExistingComponents()) {
      SetComponent(*component, true);
    }
  }
}

CKinematics2DEngine& CKinematics2DModel::GetKinematics2DEngine() const {
  return static_cast<CKinematics2DEngine&>(m_cEngine);
}

void CKinematics2DModel::Replace() {
  GetKinematics2DEngine().Replace(*this);
}

void CKinematics2DModel::ComponentAdded(CEntity& component) {
  SetComponent(component, true);
  GetKinematics2DEngine().UpdateManipulator(*this);
}

void CKinematics2DModel::ComponentRemoved(CEntity& component) {
  SetComponent(component, false);
  GetKinematics2DEngine().UpdateManipulator(*this);
}

void CKinematics2DModel::SetComponent(CEntity& component, bool isThere) {
  if (auto* const gripper = dynamic_cast<CGripperEquippedEntity*>(&component)) {
    m_gripper = isThere ? gripper : nullptr;
  } else if (auto* const turret = dynamic_cast<CTurretEntity*>(&component)) {
    m_turret = isThere ? turret : nullptr;
  }
}

void CKinematics2DModel::CalculateBoundingBox() {
  m_sBoundingBox = ComputePlanarBounds(m_cEmbodiedEntity);
}

}  // namespace argos
