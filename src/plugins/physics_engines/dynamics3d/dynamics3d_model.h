#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_DYNAMICS3D_MODEL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_DYNAMICS3D_MODEL_H

#include <argos3/core/simulator/physics_engine/described_body_model.h>

namespace argos {

class CDynamics3DEngine;
class CEntity;
class CGripperEquippedEntity;
class CTurretEntity;
struct SRigidBody;

/** One body of a dynamics3d engine, for the public API and for the engine's add-ons. */
class CDynamics3DModel : public CDescribedBodyModel {
 public:
  /** @param wheels  speeds of the left and the right wheel, m/s, if the body has a drive. */
  CDynamics3DModel(CDynamics3DEngine& engine, CEmbodiedEntity& entity, const Real* wheels);

  /** Takes the body, at rest, where it is now; its grips are forgotten. */
  void ConfirmMove() override;
  /** Grippers and turrets of robots. */
  void ComponentAdded(CEntity& component) override;
  void ComponentRemoved(CEntity& component) override;

  /*
   * For add-ons, while they act on a movable body: where it is and how it moves in this substep,
   * and forces for this substep alone. World frame.
   */
  CVector3 GetCentreOfMass() const; /**< m */
  CQuaternion GetOrientation() const;
  CVector3 GetVelocity() const; /**< of the centre of mass, m/s */
  CVector3 GetAngularVelocity() const; /**< rad/s */
  /** Where the origin anchor is in this substep, m; of bodies that cannot move, too. */
  CVector3 GetOriginPosition() const;
  /** @param force N. @param point where it acts, m. Wakes the body unless the force is 0. */
  void AddForce(const CVector3& force, const CVector3& point);
  /** @param torque N m. */
  void AddTorque(const CVector3& torque);

 protected:
  /** The body is put there in the next tick, unless it is back by then where it was. */
  void Replace() override;

 private:
  friend class CDynamics3DEngine;

  CDynamics3DEngine& GetDynamics3DEngine() const;
  void SetComponent(CEntity& component, bool isThere);

  CEntity& m_root;  // of the body
  const Real* m_wheels;  // m/s, (left, right); null unless the body has a drive; not owned
  CGripperEquippedEntity* m_gripper = nullptr;  // of the robot; null if it has none
  CTurretEntity* m_turret = nullptr;  // of the robot; null if it has none
  SRigidBody* m_body = nullptr;  // in the engine's world; null while there is no world
  size_t m_number = 0;  // in the engine's list of models
  // what the engine has written last: the body is nowhere else, unless somebody has moved it
  CVector3 m_lastPosition;  // m
  CQuaternion m_lastOrientation;
  bool m_wasAwake = true;  // in the last tick
  bool m_isDisplaced = false;  // is it in the engine's list of those?
};

}  // namespace argos

#endif
