#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_body_model.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>

namespace argos {

CRobotBodyModel::CRobotBodyModel(CDescribedBodyEngine& engine, CEmbodiedEntity& entity,
                                 const CDriveSource& drive)
    : CDescribedBodyModel(engine, entity), m_drive(drive) {
  // ComponentAdded() reports components that are created later
  if (const auto* const robot = dynamic_cast<CComposableEntity*>(&m_root)) {
    for (CEntity* component : robot->GetExistingComponents()) {
      SetComponent(*component, true);
    }
  }
}

void CRobotBodyModel::ComponentAdded(CEntity& component) {
  SetComponent(component, true);
  ManipulatorChanged();
}

void CRobotBodyModel::ComponentRemoved(CEntity& component) {
  SetComponent(component, false);
  ManipulatorChanged();
}

void CRobotBodyModel::SetComponent(CEntity& component, bool isPresent) {
  if (auto* const gripper = dynamic_cast<CGripperEquippedEntity*>(&component)) {
    m_gripper = isPresent ? gripper : nullptr;
  } else if (auto* const turret = dynamic_cast<CTurretEntity*>(&component)) {
    m_turret = isPresent ? turret : nullptr;
  }
}

}  // namespace argos
