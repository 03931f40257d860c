#include <argos3/testing/support/closed_form/differential_drive.h>

#include <cmath>

namespace argos::testing {

SPose IntegrateDifferentialDrive(const SPose& start, Real left, Real right, Real interwheelDistance,
                                 Real duration) {
  const Real v = 0.5 * (left + right);
  const Real w = (right - left) / interwheelDistance;
  if (w == 0.0) {
    return {start.X + v * duration * std::cos(start.Yaw),
            start.Y + v * duration * std::sin(start.Yaw), start.Yaw};
  }
  const Real yaw = start.Yaw + w * duration;
  return {start.X + v / w * (std::sin(yaw) - std::sin(start.Yaw)),
          start.Y - v / w * (std::cos(yaw) - std::cos(start.Yaw)), yaw};
}

}  // namespace argos::testing
