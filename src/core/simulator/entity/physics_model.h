#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_PHYSICS_MODEL_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_PHYSICS_MODEL_H

#include <argos3/core/simulator/entity/anchor.h>
#include <argos3/core/simulator/geometry/bounding_box.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace argos {

class CEntity;
class CPhysicsEngine;
class CEmbodiedEntity;

/**
 * A body inside one physics engine.
 *
 * Third parties derive from this to give an entity a body that its description cannot express.
 * Declared beside the entity, which calls it; defined beside the engine.
 *
 * In a tick the engine calls UpdateFromEntityStatus() (entity to engine), then UpdatePhysics()
 * in each substep if its documentation says so, then UpdateEntityStatus() (engine to entity).
 */
class CPhysicsModel {
 public:
  typedef std::map<std::string, CPhysicsModel*> TMap;
  typedef std::vector<CPhysicsModel*> TVector;

  CPhysicsModel(CPhysicsEngine& engine, CEmbodiedEntity& entity);
  virtual ~CPhysicsModel() = default;

  CPhysicsEngine& GetEngine() { return *m_engine; }
  const CPhysicsEngine& GetEngine() const { return *m_engine; }
  CEmbodiedEntity& GetEmbodiedEntity() { return m_cEmbodiedEntity; }
  const CEmbodiedEntity& GetEmbodiedEntity() const { return m_cEmbodiedEntity; }

  /**
   * Engine to entity: anchors, bounding box, the entity's components, and the check whether the
   * body has left the engine's region.
   */
  virtual void UpdateEntityStatus();
  /** Entity to engine, at the start of every physics phase. */
  virtual void UpdateFromEntityStatus() = 0;
  /** Called in every substep by engines that support it; does nothing by default. */
  virtual void UpdatePhysics() {}
  /** Puts the body at the pose of the origin anchor: @p position in m, world frame. */
  virtual void MoveTo(const CVector3& position, const CQuaternion& orientation) = 0;

  /**
   * @return the pose in which MoveTo() of the entity puts the body instead of @p pose, because the
   * engine cannot have it there; by default @p pose itself.
   */
  virtual SBodyPose FindPossiblePose(const SBodyPose& pose) const { return pose; }

  const SBoundingBox& GetBoundingBox() const { return m_sBoundingBox; }
  SBoundingBox& GetBoundingBox() { return m_sBoundingBox; }
  virtual void CalculateBoundingBox() = 0;
  /** Recomputes every enabled anchor: by its registered method, else rigidly from the origin. */
  virtual void CalculateAnchors();
  /** True if the body overlaps or touches another one; see CEmbodiedEntity. */
  virtual bool IsCollidingWithSomething() const = 0;
  /**
   * @return true if the body overlaps another one, so that it cannot be placed here. By default
   * what collides overlaps.
   */
  virtual bool IsOverlappingSomething() const { return IsCollidingWithSomething(); }

  /**
   * Called after the last MoveTo() of a command that moves the body permanently, also if it did not
   * change the pose; not after a MoveTo() that only tests whether a place is free, or that restores
   * the old pose.
   */
  virtual void ConfirmMove() {}
  /**
   * Called after ConfirmMove(): moves the body to the engines whose regions it is in now. It may
   * destroy this model.
   */
  void ChangeEngines();
  /**
   * Called while the body is in the engine, after a component that engines act upon was added to
   * the robot, or before it is removed.
   */
  virtual void ComponentAdded(CEntity& /*component*/) {}
  virtual void ComponentRemoved(CEntity& /*component*/) {}

  /** Makes @p method of the derived model compute the pose of @p anchor. */
  template <typename MODEL>
  void RegisterAnchorMethod(const SAnchor& anchor, void (MODEL::*method)(SAnchor&)) {
    RegisterAnchorMethod(anchor.Index, [this, method](SAnchor& target) {
      (static_cast<MODEL*>(this)->*method)(target);
    });
  }

 protected:
  /**
   * Transfers the model to another engine, which moves the body from now on.
   *
   * A model that may be transferred uses GetEngine(): m_cEngine remains the engine of the
   * constructor.
   */
  void SetEngine(CPhysicsEngine& engine) { m_engine = &engine; }

  CPhysicsEngine& m_cEngine;
  CEmbodiedEntity& m_cEmbodiedEntity;
  SBoundingBox m_sBoundingBox;

 private:
  void RegisterAnchorMethod(UInt32 anchorIndex, std::function<void(SAnchor&)> method);

  CPhysicsEngine* m_engine;  // the present one
  // is indexed by anchor; an empty function: rigid; null if no method was registered
  std::unique_ptr<std::vector<std::function<void(SAnchor&)>>> m_anchorMethods;
};

}  // namespace argos

#endif
