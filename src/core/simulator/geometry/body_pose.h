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

}  // namespace argos

#endif
