#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>

namespace argos {

CDynamics2DModel::CDynamics2DModel(CDynamics2DEngine& engine, CEmbodiedEntity& entity,
                                   const Real* wheels)
    : CDescribedBodyModel(engine, entity), m_root(entity.GetRootEntity()), m_wheels(wheels) {
  // those that are made on demand, later, are told of
  if (const auto* const robot = dynamic_cast<CComposableEntity*>(&m_root)) {
    for (CEntity* component : robot->GetExistingComponents()) {
      SetComponent(*component, true);
    }
  }
}

CDynamics2DEngine& CDynamics2DModel::GetDynamics2DEngine() const {
  return static_cast<CDynamics2DEngine&>(m_cEngine);
}

void CDynamics2DModel::Replace() {
  GetDynamics2DEngine().MarkDisplaced(*this);
}

void CDynamics2DModel::ConfirmMove() {
  GetDynamics2DEngine().Replace(*this);
}

void CDynamics2DModel::ComponentAdded(CEntity& component) {
  SetComponent(component, true);
  GetDynamics2DEngine().UpdateManipulator(*this);
}

void CDynamics2DModel::ComponentRemoved(CEntity& component) {
  SetComponent(component, false);
  GetDynamics2DEngine().UpdateManipulator(*this);
}

void CDynamics2DModel::SetComponent(CEntity& component, bool isThere) {
  if (auto* const gripper = dynamic_cast<CGripperEquippedEntity*>(&component)) {
    m_gripper = isThere ? gripper : nullptr;
  } else if (auto* const turret = dynamic_cast<CTurretEntity*>(&component)) {
    m_turret = isThere ? turret : nullptr;
  }
}

void CDynamics2DModel::CalculateBoundingBox() {
  m_sBoundingBox = ComputePlanarBounds(m_cEmbodiedEntity);
}

}  // namespace argos
