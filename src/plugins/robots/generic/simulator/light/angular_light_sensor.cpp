#include <argos3/plugins/robots/generic/simulator/angular_light_sensor.h>

#include <argos3/plugins/robots/generic/simulator/device_manual.h>

namespace argos {

std::string AngularLightManual(const std::string& tag) {
  return R"(A ring of 24 sensors, counter-clockwise from 7.5 degrees in steps of 15. A light of intensity I > 0 is visible
along the straight line from the centre of the robot's base, unless a body other than the robot's own is on that line.
With D = length of that line / I, and delta the angle in [0,pi] between the light's azimuth and the sensor's, it adds

  g(D) max(0, 1 - 2 delta / pi),  where g(D) = exp(-2 D) for D <= 2.5, otherwise 0

to the reading. The contributions of all lights add up, and the sum is clamped to [0,1]. A light exactly above the robot
has no azimuth: every sensor then gets the mean over all of them, g(D) / 4.
)" + RayReadingsManual(tag, "rot_z_only", "a ray to each light within D <= 2.5");
}

}  // namespace argos
