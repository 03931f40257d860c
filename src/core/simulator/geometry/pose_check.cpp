#include <argos3/core/simulator/geometry/pose_check.h>

#include <argos3/core/utility/errors/argos_exception.h>

namespace argos::detail {

CQuaternion RepairPose(const std::string& owner, const CVector3& position,
                       const CQuaternion& orientation) {
  constexpr Real kFewDigits = 0.05;  // such as 0.7 for sin(45 degrees)
  for (UInt32 axis = 0; axis < 3; ++axis) {
    if (!(std::abs(position[axis]) <= kMaxCoordinate)) {
      THROW_ARGOSEXCEPTION(owner << ": the position must be three numbers from " << -kMaxCoordinate
                                 << " to " << kMaxCoordinate << " m, found (" << position << ")");
    }
  }
  const Real length = orientation.Length();
  if (!(std::abs(length - 1.0) <= kFewDigits)) {
    THROW_ARGOSEXCEPTION(
        owner << ": the orientation must be a quaternion of length 1, found (w,x,y,z) = ("
              << orientation.GetW() << "," << orientation.GetX() << "," << orientation.GetY() << ","
              << orientation.GetZ() << "), of length " << length);
  }
  CQuaternion unit = orientation;
  return unit.Normalize();
}

}  // namespace argos::detail
