#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_DESCRIBED_BODY_MODEL_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_DESCRIBED_BODY_MODEL_H

#include <argos3/core/simulator/physics_engine/physics_model.h>

namespace argos {

class CEntity;

/** The body of a root entity, if it says what it is (SBodyDescription); else null. */
CEmbodiedEntity* FindDescribedBody(CEntity& root);

/**
 * A body that an engine builds from its SBodyDescription: what such models have in common.
 *
 * The state that moves is the engine's; so nothing is read from the entity body by body.
 */
class CDescribedBodyModel : public CPhysicsModel {
 public:
  using CPhysicsModel::CPhysicsModel;

  /** Does nothing: the engine reads actuated components where they keep their values. */
  void UpdateFromEntityStatus() override {}
  /**
   * Puts the body, at rest, where its origin anchor is already.
   * @throws CARGoSException if the pose is not finite; nothing has moved then.
   */
  void MoveTo(const CVector3& position, const CQuaternion& orientation) override;
  void CalculateBoundingBox() override;
  /** True if a solid of this body overlaps one of another body by more than a rounding. */
  bool IsCollidingWithSomething() const override;

 protected:
  /** Takes over the pose of the origin anchor; the body is at rest, its past forgotten. */
  virtual void Replace() = 0;
};

}  // namespace argos

#endif
