#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_DYNAMICS3D_MODEL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_DYNAMICS3D_MODEL_H

#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_body_model.h>

struct dxBody;

namespace argos {

class CDynamics3DEngine;
struct SRigidBody;

/** One body of a dynamics3d engine, for the public API and for the engine's add-ons. */
class CDynamics3DModel : public CRobotBodyModel {
 public:
  CDynamics3DModel(CDynamics3DEngine& engine, CEmbodiedEntity& entity, const CDriveSource& drive);

  /*
   * For add-ons, while they act on a movable body: its pose and motion in this substep, and forces
   * that act in this substep only. World frame.
   */
  CVector3 GetCentreOfMass() const; /**< m */
  CQuaternion GetOrientation() const;
  CVector3 GetVelocity() const; /**< of the centre of mass, m/s */
  CVector3 GetAngularVelocity() const; /**< rad/s */
  /** Position of the origin anchor in this substep, m; also of immovable bodies. */
  CVector3 GetOriginPosition() const;
  /**
   * Wakes the body unless the force is 0.
   * @param force N. @param point where it acts, m. @param link  of an articulated body; else 0.
   */
  void AddForce(const CVector3& force, const CVector3& point, UInt32 link = 0);
  /** @param torque N m. */
  void AddTorque(const CVector3& torque, UInt32 link = 0);

  /** @return true if the body is a free robot, which is not stepped by ODE: see the README. */
  bool IsFree() const;
  /** @return true if the body stood upright in the last tick and moved in the plane. */
  bool IsUpright() const;
  /** The link of an articulated body that carries an anchor; 0 for other bodies. */
  UInt32 FindLink(const SAnchor& anchor) const;
  /** The pose of an anchor in this substep. @param link  FindLink(anchor). */
  SBodyPose ComputePose(const SAnchor& anchor, UInt32 link) const;

 protected:
  void ManipulatorChanged() override;

 private:
  friend class CDynamics3DEngine;

  // The body in the engine's world, while there is one. ARGOS_ASSERT notices that it is another's.
  SRigidBody& GetBody() const;
  // @return true if the body is in the engine's world, and movable
  bool IsMoved() const;
  // of the frame of the engine's world, m
  const CVector3& GetFrameOrigin() const;
  // to push a link of a movable body with a force or torque; null if there is nothing to push
  dxBody* WakeLink(const CVector3& push, UInt32 link);

  SRigidBody* m_body = nullptr;  // null while there is no world
  // the pose that the engine has written last; the body has another one only after a MoveTo()
  CVector3 m_lastPosition;  // m
  CQuaternion m_lastOrientation;
  bool m_wasAwake = true;  // in the last tick
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/entity/composable_entity.h>
#endif

#endif
