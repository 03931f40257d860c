#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_body.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_engine.h>

namespace argos {

CPointMass3DBody::CPointMass3DBody(CPointMass3DEngine& engine, CEmbodiedEntity& entity, EKind kind)
    : CDescribedBodyModel(engine, entity), m_root(entity.GetRootEntity()), m_kind(kind) {
  // those that are made on demand, later, are told of
  if (const auto* const robot = dynamic_cast<CComposableEntity*>(&m_root)) {
    for (CEntity* component : robot->GetExistingComponents()) {
      ComponentAdded(*component);
    }
  }
}

void CPointMass3DBody::ComponentAdded(CEntity& component) {
  if (auto* const turret = dynamic_cast<CTurretEntity*>(&component)) {
    m_turret = turret;
  }
}

void CPointMass3DBody::ComponentRemoved(CEntity& component) {
  if (&component == m_turret) {
    m_turret = nullptr;
  }
}

void CPointMass3DBody::Replace() {
  static_cast<CPointMass3DEngine&>(m_cEngine).Replace(*this);
}

}  // namespace argos
