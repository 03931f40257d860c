#ifndef ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_MODEL_H
#define ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_MODEL_H

#include <argos3/core/simulator/entity/physics_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/recorded_bodies.h>

#include <map>
#include <string>
#include <vector>

namespace argos {

class CDynamics2DEngine;
struct SBodyDescription;

/**
 * Base of users' models of bodies for dynamics2d, as they were written for ARGoS 3.
 *
 * Such a model describes a body with calls that are recorded (recorded_bodies.h), and commands it
 * with a control. Engines build the body from the record and move it; so the body lives in every
 * engine that builds bodies from descriptions.
 */
class CDynamics2DModel : public CPhysicsModel {
 public:
  typedef std::map<std::string, CDynamics2DModel*> TMap;

  CDynamics2DModel(CDynamics2DEngine& engine, CEmbodiedEntity& entity);

  /** Called after the entity was reset: bodies are at rest at the origin anchor. */
  virtual void Reset() = 0;
  /** Called after each tick, when the origin anchor has its new pose. */
  void UpdateEntityStatus() override;
  void MoveTo(const CVector3& position, const CQuaternion& orientation) override;
  void CalculateBoundingBox() override;
  bool IsCollidingWithSomething() const override;
  /** Does nothing: the engine has written the pose of the anchor already. */
  void UpdateOriginAnchor(SAnchor& /*anchor*/) {}

  CDynamics2DEngine& GetDynamics2DEngine() { return m_cDyn2DEngine; }
  const CDynamics2DEngine& GetDynamics2DEngine() const { return m_cDyn2DEngine; }

 protected:
  /** Adds a body, at a pose in the frame of the origin anchor. @param height m, > 0. */
  void AddPart(cpBody* body, const cpVect& offset, cpFloat angle, Real height);

  CDynamics2DEngine& m_cDyn2DEngine;

 private:
  friend class CModelDescriber;
  friend class CRecordedDynamics2DBody;

  struct SPart {
    cpBody* Body;
    cpVect Offset;  // m
    cpFloat Angle;  // rad
    Real Height;  // m
  };

  /** Adds what only some kinds of models describe. */
  virtual void Describe(SBodyDescription& /*description*/) const {}
  void PlaceParts(const CVector3& position, const CQuaternion& orientation);

  std::vector<SPart> m_parts;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/math/matrix/rotationmatrix3.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>
#endif

#endif
