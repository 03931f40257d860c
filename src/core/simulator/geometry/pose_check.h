#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_POSE_CHECK_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_POSE_CHECK_H

#include <argos3/core/utility/configuration/value_range.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

#include <cmath>
#include <string>

namespace argos {

/**
 * Greatest coordinate of a pose, m: the products of such numbers are far from overflow. Engines
 * accept less, such as 1e5 m in the plane.
 */
constexpr Real kMaxCoordinate = kMaxReal;

/** @return true if no number of the pose is NaN or infinite. */
inline bool IsFinitePose(const CVector3& position, const CQuaternion& orientation) {
  const Real sum = position.GetX() + position.GetY() + position.GetZ() + orientation.GetW() +
                   orientation.GetX() + orientation.GetY() + orientation.GetZ();
  // the sum of finite numbers of any use does not overflow; NaN and infinity times 0 are NaN
  return sum * 0.0 == 0.0;
}

namespace detail {
/** The orientation with length 1. @throws CARGoSException as CheckPose(). */
CQuaternion RepairPose(const std::string& owner, const CVector3& position,
                       const CQuaternion& orientation);
}  // namespace detail

/**
 * Checks a pose from users' code or from a file.
 * @param getOwner  returns the owner of the pose, for the message.
 * @return the orientation. If its length differs from 1 by no more than 0.05, as that of numbers
 *   with few digits does, it is scaled to length 1.
 * @throws CARGoSException if a number is not finite, a coordinate exceeds kMaxCoordinate, or the
 *   orientation has another length.
 */
template <typename GET_OWNER>
CQuaternion CheckPose(const GET_OWNER& getOwner, const CVector3& position,
                      const CQuaternion& orientation) {
  constexpr Real kRounding = 1e-9;  // rounding of products of unit quaternions
  // comparisons with NaN are false
  const bool isGood = std::abs(position.GetX()) <= kMaxCoordinate &&
                      std::abs(position.GetY()) <= kMaxCoordinate &&
                      std::abs(position.GetZ()) <= kMaxCoordinate &&
                      std::abs(orientation.SquareLength() - 1.0) <= kRounding;
  return isGood ? orientation : detail::RepairPose(getOwner(), position, orientation);
}

}  // namespace argos

#endif
