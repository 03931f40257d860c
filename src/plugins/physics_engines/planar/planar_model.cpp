#include <argos3/plugins/simulator/physics_engines/planar/planar_model.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_engine.h>

namespace argos {

CPlanarModel::CPlanarModel(CPlanarEngine& engine, CEmbodiedEntity& entity, const Real* wheels)
    : CDescribedBodyModel(engine, entity), m_root(entity.GetRootEntity()), m_wheels(wheels) {
  // those that are made on demand, later, are told of
  if (const auto* const robot = dynamic_cast<CComposableEntity*>(&m_root)) {
    for (CEntity* component : robot->GetExistingComponents()) {
      SetComponent(*component, true);
    }
  }
}

void CPlanarModel::ComponentAdded(CEntity& component) {
  SetComponent(component, true);
  static_cast<CPlanarEngine&>(m_cEngine).UpdateManipulator(*this);
}

void CPlanarModel::ComponentRemoved(CEntity& component) {
  SetComponent(component, false);
  static_cast<CPlanarEngine&>(m_cEngine).UpdateManipulator(*this);
}

void CPlanarModel::SetComponent(CEntity& component, bool isThere) {
  if (auto* const gripper = dynamic_cast<CGripperEquippedEntity*>(&component)) {
    m_gripper = isThere ? gripper : nullptr;
  } else if (auto* const turret = dynamic_cast<CTurretEntity*>(&component)) {
    m_turret = isThere ? turret : nullptr;
  }
}

void CPlanarModel::CalculateBoundingBox() {
  m_sBoundingBox = ComputePlanarBounds(m_cEmbodiedEntity);
}

}  // namespace argos
