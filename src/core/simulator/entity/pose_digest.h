#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_POSE_DIGEST_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_POSE_DIGEST_H

#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/** Adds the bits of a pose to a digest. */
inline void AddPose(CDigest& digest, const CVector3& position, const CQuaternion& orientation) {
  digest.Add(position.GetX());
  digest.Add(position.GetY());
  digest.Add(position.GetZ());
  digest.Add(orientation.GetW());
  digest.Add(orientation.GetX());
  digest.Add(orientation.GetY());
  digest.Add(orientation.GetZ());
}

}  // namespace argos

#endif
