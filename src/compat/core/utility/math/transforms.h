#ifndef ARGOS3_COMPAT_CORE_UTILITY_MATH_TRANSFORMS_H
#define ARGOS3_COMPAT_CORE_UTILITY_MATH_TRANSFORMS_H

#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/**
 * Returns the coordinates of a point in a local frame.
 *
 * @param global       the point, in the global frame.
 * @param translation  the origin of the local frame, in the global frame.
 * @param orientation  rotation from the global axes to the local ones, of length 1.
 */
inline CVector3 GlobalToLocal(CVector3 global, CVector3 translation, CQuaternion orientation) {
  return (global - translation).Rotate(orientation.Inverse());
}

/** Returns the global coordinates of a point in a local frame: the inverse of GlobalToLocal(). */
inline CVector3 LocalToGlobal(CVector3 local, CVector3 translation, CQuaternion orientation) {
  return local.Rotate(orientation) + translation;
}

}  // namespace argos

#endif
