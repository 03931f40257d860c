#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATICS2D_MODEL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATICS2D_MODEL_H

#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_handle.h>

namespace argos {

class CEntity;
class CGripperEquippedEntity;
class CKinematics2DEngine;
class CTurretEntity;

/** One body of a kinematics2d engine, for the public API: its state is in the engine's arrays. */
class CKinematics2DModel : public CDescribedBodyModel {
 public:
  /** @param wheels  speeds of the left and the right wheel, m/s, if the body has a drive. */
  CKinematics2DModel(CKinematics2DEngine& engine, CEmbodiedEntity& entity, const Real* wheels);

  /** Grippers and turrets of robots. */
  void ComponentAdded(CEntity& component) override;
  void ComponentRemoved(CEntity& component) override;
  /** Of bodies that only turn about the vertical: faster than that of any orientation. */
  void CalculateBoundingBox() override;

 protected:
  void Replace() override;

 private:
  friend class CKinematics2DEngine;

  CKinematics2DEngine& GetKinematics2DEngine() const;
  void SetComponent(CEntity& component, bool isThere);

  CEntity& m_root;  // of the body
  const Real* m_wheels;  // m/s, (left, right); null unless the body has a drive; not owned
  CGripperEquippedEntity* m_gripper = nullptr;  // of the robot; null if it has none
  CTurretEntity* m_turret = nullptr;  // of the robot; null if it has none
  SKinematicHandle m_handle;  // where the body is in the engine's arrays
  size_t m_number = 0;  // in the engine's list of models
  bool m_isManipulator = false;  // is it in the engine's list of those?
};

}  // namespace argos

#endif
