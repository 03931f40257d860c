#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINTMASS3D_MODEL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINTMASS3D_MODEL_H

#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/utility/math/ray3.h>

namespace argos {

class CPointMass3DEngine;

/**
 * A body with its own law of motion: users derive from this for bodies that an SBodyDescription
 * cannot express.
 *
 * In each tick the engine calls UpdateFromEntityStatus(), then Step() GetIterations() times, then
 * UpdateEntityStatus(), which writes m_cPosition into the origin anchor and updates the other
 * anchors, the bounding box and the entity's components. A derived class that rotates the body
 * registers its own method for the origin anchor (RegisterAnchorMethod()).
 *
 * Bind it to an entity with REGISTER_STANDARD_POINTMASS3D_OPERATIONS_ON_ENTITY (see
 * pointmass3d_engine.h). Unless the entity's body also has a description, rays reach the body only
 * through CheckIntersectionWithRay(), which makes all rays of the experiment slower.
 */
class CPointMass3DModel : public CPhysicsModel {
 public:
  CPointMass3DModel(CPointMass3DEngine& engine, CEmbodiedEntity& body);

  /** Sets the position of the body, at rest. */
  void MoveTo(const CVector3& position, const CQuaternion& orientation) override;
  /** Called by a reset of the experiment: sets the initial position, at rest. */
  virtual void Reset();

  /** Moves the body by one substep, of GetEngine().GetPhysicsClockTick() seconds. */
  virtual void Step() = 0;
  void CalculateBoundingBox() override = 0;
  void UpdateFromEntityStatus() override = 0;

  /** True if its bounding box shares a point with that of another body of the engine. */
  bool IsCollidingWithSomething() const override;
  /**
   * @param tOnRay  set to the point of intersection, as a fraction of the ray's length, if any.
   * @return true if the ray intersects this body.
   */
  virtual bool CheckIntersectionWithRay(Real& tOnRay, const CRay3& ray) const = 0;

  /** World frame: m, m/s, m/s^2. */
  const CVector3& GetPosition() const { return m_cPosition; }
  void SetPosition(const CVector3& position) { m_cPosition = position; }
  const CVector3& GetVelocity() const { return m_cVelocity; }
  void SetVelocity(const CVector3& velocity) { m_cVelocity = velocity; }
  const CVector3& GetAcceleration() const { return m_cAcceleration; }
  void SetAcceleration(const CVector3& acceleration) { m_cAcceleration = acceleration; }

  /** Writes m_cPosition into the origin anchor. */
  void UpdateOriginAnchor(SAnchor& anchor);

 protected:
  CPointMass3DEngine& m_cPM3DEngine;
  CVector3 m_cPosition;  // of the origin anchor, m
  CVector3 m_cVelocity;  // m/s
  CVector3 m_cAcceleration;  // m/s^2
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_engine.h>
#endif

#endif
