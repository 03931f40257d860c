#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_ANCHOR_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_ANCHOR_H

#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/core/utility/memory/object_slabs.h>

#include <string>

namespace argos {

class CEmbodiedEntity;

/**
 * A named frame that moves with a body.
 *
 * Data members are public and addressable: users keep references to them. Position and Orientation
 * are in the world frame and are written by the engine that owns the body, after its physics;
 * those of an anchor that is not enabled keep their last value.
 */
struct SAnchor : SBodyPose, CSlabObject {
  CEmbodiedEntity& Body;
  std::string Id;
  UInt32 Index; /**< 0 is the origin anchor */
  CVector3 OffsetPosition; /**< position in the frame of the origin anchor, m */
  CQuaternion OffsetOrientation; /**< orientation in the frame of the origin anchor */
  UInt32 InUseCount = 0;
  UInt32 InUseCountAtStart = 0; /**< is restored by ReturnToStart() */

  SAnchor(CEmbodiedEntity& body, const std::string& id, UInt32 index,
          const CVector3& offsetPosition, const CQuaternion& offsetOrientation,
          const CVector3& position, const CQuaternion& orientation);
  /** A snapshot, which is not an anchor of the body: it must not be enabled. */
  SAnchor(const SAnchor&) = default;
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

/** Where views draw what is mounted on an anchor: an anchor that is not enabled keeps its place on
 * the body. */
SBodyPose ComputeVisiblePose(const SAnchor& anchor);

}  // namespace argos

#endif
