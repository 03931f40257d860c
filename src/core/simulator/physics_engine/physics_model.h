#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_PHYSICS_MODEL_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_PHYSICS_MODEL_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/core/utility/memory/object_slabs.h>

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
 * A named frame that moves with a body.
 *
 * Data members are public and addressable: users keep references to them. Position and Orientation
 * are in the world frame and are written by the engine that owns the body, after its physics;
 * those of an anchor that is not enabled keep their last value.
 */
struct SAnchor : CSlabObject {
  CEmbodiedEntity& Body;
  std::string Id;
  UInt32 Index; /**< 0 is the origin anchor */
  CVector3 OffsetPosition; /**< in the frame of the origin anchor, m */
  CQuaternion OffsetOrientation; /**< in the frame of the origin anchor */
  CVector3 Position; /**< world frame, m */
  CQuaternion Orientation; /**< world frame */
  UInt32 InUseCount = 0;
  UInt32 InUseCountAtStart = 0; /**< what ReturnToStart() restores */

  SAnchor(CEmbodiedEntity& body, const std::string& id, UInt32 index,
          const CVector3& offsetPosition, const CQuaternion& offsetOrientation,
          const CVector3& position, const CQuaternion& orientation);
  SAnchor(const SAnchor&) = delete;
  SAnchor& operator=(const SAnchor&) = delete;

  /** Keeps this anchor's pose current from now on; calls are counted. */
  void Enable();
  /** Undoes one Enable(). @throws CARGoSException for the origin, which is always in use. */
  void Disable();
  /** Restores the use count of the start of the run. */
  void ReturnToStart();
  /** Computes the pose of a rigid part of the body; not for the origin itself. */
  void FollowOrigin();
};

/** Axis-aligned box in the world frame, m. */
struct SBoundingBox {
  CVector3 MinCorner;
  CVector3 MaxCorner;

  /** True if the boxes share a point. */
  bool Intersects(const SBoundingBox& other) const;
};

/**
 * A body inside one physics engine.
 *
 * Third parties derive from this to give an entity a body that its description cannot express.
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

  const SBoundingBox& GetBoundingBox() const { return m_sBoundingBox; }
  SBoundingBox& GetBoundingBox() { return m_sBoundingBox; }
  virtual void CalculateBoundingBox() = 0;
  /** Recomputes every enabled anchor: by its registered method, else rigidly from the origin. */
  virtual void CalculateAnchors();
  virtual bool IsCollidingWithSomething() const = 0;

  /**
   * Called after the last MoveTo() of a command that moves the body for good, also if it did not
   * change the pose; not after a MoveTo() that only tests whether a place is free, or that restores
   * the old pose.
   */
  virtual void ConfirmMove() {}
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
   * Gives the model to another engine, which moves the body from now on.
   *
   * For models that change engines without being destroyed. They use GetEngine(): m_cEngine stays
   * the engine of the constructor.
   */
  void SetEngine(CPhysicsEngine& engine) { m_engine = &engine; }

  CPhysicsEngine& m_cEngine;
  CEmbodiedEntity& m_cEmbodiedEntity;
  SBoundingBox m_sBoundingBox;

 private:
  void RegisterAnchorMethod(UInt32 anchorIndex, std::function<void(SAnchor&)> method);

  CPhysicsEngine* m_engine;  // the present one
  // by anchor index, an empty function = rigid; null if no method was registered
  std::unique_ptr<std::vector<std::function<void(SAnchor&)>>> m_anchorMethods;
};

}  // namespace argos

#endif
