#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_ROBOT_BODY_MODEL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_ROBOT_BODY_MODEL_H

#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/core/simulator/physics_engine/drive_source.h>

namespace argos {

class CGripperEquippedEntity;
class CTurretEntity;

/** A described body with the components of its robot that engines act upon. */
class CRobotBodyModel : public CDescribedBodyModel {
 public:
  CRobotBodyModel(CDescribedBodyEngine& engine, CEmbodiedEntity& entity, const CDriveSource& drive);

  /** Handles grippers and turrets. */
  void ComponentAdded(CEntity& component) override;
  void ComponentRemoved(CEntity& component) override;

 protected:
  /** Informs the engine that the gripper or the turret was added or removed. */
  virtual void ManipulatorChanged() = 0;

  CDriveSource m_drive;  // see FindDrive()
  CGripperEquippedEntity* m_gripper = nullptr;  // of the robot; null if it has none
  CTurretEntity* m_turret = nullptr;  // of the robot; null if it has none

 private:
  void SetComponent(CEntity& component, bool isPresent);
};

}  // namespace argos

#endif
