#ifndef ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_GRIPPING_H
#define ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_GRIPPING_H

#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/recorded_bodies.h>

#include <list>

namespace argos {

class CDynamics2DEngine;
class CEmbodiedEntity;

/**
 * The gripper of a user's model: its shape becomes the sensing disc of the body's description, and
 * is not a solid. Engines grip when the entity is locked, and release when it is unlocked.
 */
class CDynamics2DGripper {
 public:
  typedef std::list<CDynamics2DGripper*> TList;

  /** @param shape  a circle. */
  CDynamics2DGripper(CDynamics2DEngine& engine, CGripperEquippedEntity& entity, cpShape* shape);
  virtual ~CDynamics2DGripper() { SetGrippee(nullptr); }

  bool IsGripping() const { return m_cGripperEntity.IsGripping(); }
  bool IsLocked() const { return m_cGripperEntity.IsLocked(); }
  CGripperEquippedEntity& GetGripperEntity() { return m_cGripperEntity; }
  cpShape* GripperShape() { return m_ptGripperShape; }
  /** Null if it holds nothing, or a body that no user's model describes. */
  CDynamics2DGrippable* GetGrippee() { return m_grippee; }
  /** Null: engines have constraints of their own. */
  cpConstraint* GetConstraint() { return nullptr; }
  /** Distance of the shape from the origin of its body, m. */
  Real GetExtension() const;
  /** Does nothing: engines choose the point that is gripped. */
  void CalculateAnchor(cpArbiter* /*arbiter*/) {}
  /** Does nothing: engines grip. */
  virtual void Grip(CDynamics2DGrippable* /*grippable*/) {}
  /** Releases the body in the next tick. */
  virtual void Release() { m_cGripperEntity.ClearGrippedEntity(); }

 private:
  friend class CDynamics2DGrippable;
  friend class CRecordedDynamics2DBody;

  void SetGrippee(CDynamics2DGrippable* grippee);

  CGripperEquippedEntity& m_cGripperEntity;
  cpShape* m_ptGripperShape;
  CDynamics2DGrippable* m_grippee = nullptr;
};

/** Makes the body of a user's model one that grippers can hold. */
class CDynamics2DGrippable {
 public:
  CDynamics2DGrippable(CEmbodiedEntity& entity, cpShape* shape);
  virtual ~CDynamics2DGrippable();

  CEmbodiedEntity& GetEmbodiedEntity() { return m_cEmbodiedEntity; }
  const CEmbodiedEntity& GetEmbodiedEntity() const { return m_cEmbodiedEntity; }
  cpShape* GetShape() { return m_ptShape; }
  /** @return true if grippers of users' models hold the body, as of the last tick. */
  bool HasGrippers() const { return !m_grippers.empty(); }
  void Attach(CDynamics2DGripper& gripper) { m_grippers.push_back(&gripper); }
  void Remove(CDynamics2DGripper& gripper) { m_grippers.remove(&gripper); }
  void Release(CDynamics2DGripper& gripper) { gripper.Release(); }
  void ReleaseAll();

 private:
  CEmbodiedEntity& m_cEmbodiedEntity;
  cpShape* m_ptShape;
  CDynamics2DGripper::TList m_grippers;
};

}  // namespace argos

#endif
