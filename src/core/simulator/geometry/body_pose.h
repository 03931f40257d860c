#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_BODY_POSE_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_BODY_POSE_H

#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/** Where a frame is, in the world frame. */
struct SBodyPose {
  CVector3 Position; /**< m */
  CQuaternion Orientation;
};

/** A pose given in the frame @p outer, in the frame in which that is given. */
inline SBodyPose Compose(const SBodyPose& outer, const SBodyPose& inner) {
  CVector3 place = inner.Position;
  place.Rotate(outer.Orientation);
  return {outer.Position + place, outer.Orientation * inner.Orientation};
}

/** The pose of the outer frame, in the frame @p pose: Compose(pose, Invert(pose)) is no motion. */
inline SBodyPose Invert(const SBodyPose& pose) {
  const CQuaternion orientation = pose.Orientation.Inverse();
  CVector3 place = -pose.Position;
  place.Rotate(orientation);
  return {place, orientation};
}

}  // namespace argos

#endif
