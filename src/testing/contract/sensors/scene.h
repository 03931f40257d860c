#ifndef ARGOS3_TESTING_CONTRACT_SENSORS_SCENE_H
#define ARGOS3_TESTING_CONTRACT_SENSORS_SCENE_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/robot_world.h>
#include <argos3/testing/support/statistics.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace argos {

/** XML of a light in the medium "leds". @param position m. */
inline std::string LampText(const std::string& id, const CVector3& position, Real intensity) {
  return "<light id=\"" + id + "\" position=\"" + ToText(position) + "\" intensity=\"" +
         ToText(intensity) + "\" color=\"yellow\" medium=\"leds\"/>";
}

/** XML of a device with noise on one of its quantities. @param device "tag attributes". */
inline std::string WithNoise(const std::string& device, const std::string& noise) {
  return "<" + device + "><noise " + noise + "/></" + device.substr(0, device.find(' ')) + ">";
}

/** The distribution functions of U[min, max] and of Rayleigh(sigma). */
inline Real UniformDistribution(Real value, Real min, Real max) {
  return std::clamp((value - min) / (max - min), 0.0, 1.0);
}
inline Real RayleighDistribution(Real value, Real sigma) {
  return value <= 0.0 ? 0.0 : 1.0 - std::exp(-value * value / (2.0 * sigma * sigma));
}

}  // namespace argos

#endif
