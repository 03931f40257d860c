#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_DESCRIBED_BODY_MODEL_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_DESCRIBED_BODY_MODEL_H

#include <argos3/core/simulator/entity/physics_model.h>

#include <memory>

namespace argos {

class CDescribedBodyEngine;
class CEntity;
class CRecordedBody;
struct SBodyDescription;

/** The "body" of a root entity; null if it has none. */
CEmbodiedEntity* FindEmbodiedEntity(CEntity& root);
/** The body of a root entity, if it has an SBodyDescription with shapes; else null. */
CEmbodiedEntity* FindDescribedBody(CEntity& root);

/**
 * A body that a CDescribedBodyEngine builds from its SBodyDescription: the common part of such
 * models.
 *
 * The engine has the state of motion, so it need not read the entities one by one.
 */
class CDescribedBodyModel : public CPhysicsModel {
 public:
  CDescribedBodyModel(CDescribedBodyEngine& engine, CEmbodiedEntity& entity);
  ~CDescribedBodyModel() override;

  /** Does nothing: the engine reads actuated components where they keep their values. */
  void UpdateFromEntityStatus() override {}
  /**
   * Puts the body, at rest, at the present pose of its origin anchor.
   * @throws CARGoSException if the pose is not finite; nothing has moved then.
   */
  void MoveTo(const CVector3& position, const CQuaternion& orientation) override;
  void ConfirmMove() override;
  void CalculateBoundingBox() override;
  /** @return true if a solid of this body is closer to one of another body than kTouchDistance. */
  bool IsCollidingWithSomething() const override;
  /** @return true if a solid of this body overlaps one of another body by more than a rounding. */
  bool IsOverlappingSomething() const override;

  /** The user's model that describes and commands the body; null if the entity describes it. */
  CRecordedBody* GetRecordedBody() const { return m_recordedBody.get(); }

 protected:
  CEntity& m_root;  // root entity of the body

 private:
  friend class CDescribedBodyEngine;
  friend class CBorderBundles;
  using CPhysicsModel::m_cEngine;  // stale after a transfer: use GetEngine()

  CDescribedBodyEngine& GetDescribedBodyEngine();
  bool Overlaps(const SBodyDescription& description) const;

  size_t m_number = 0;  // place in the engine's list of models
  bool m_isDisplaced = false;  // is in the engine's list of displaced models
  bool m_isBundled = false;  // is in the engine's list of bundled models
  std::unique_ptr<CRecordedBody> m_recordedBody;
};

}  // namespace argos

#endif
