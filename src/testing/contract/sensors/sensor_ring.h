#ifndef ARGOS3_TESTING_CONTRACT_SENSORS_SENSOR_RING_H
#define ARGOS3_TESTING_CONTRACT_SENSORS_SENSOR_RING_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/testing/support/robot_sizes.h>

#include <cmath>
#include <string>
#include <vector>

namespace argos {

/** Geometry of a robot's sensors around its body. */
struct SSensorRing {
  std::string Tag;
  Real Radius, Height; /**< m */
  std::vector<Real> Angles; /**< rad */
  Real Range = 0.0; /**< m, of proximity sensors */
};

inline SSensorRing FootBotRing() {
  SSensorRing ring{"foot-bot", kFootBotRadius, 0.06, {}, 0.1};
  for (int i = 0; i < 24; ++i) {
    ring.Angles.push_back((7.5 + 15.0 * i) * M_PI / 180.0);
  }
  return ring;
}

inline SSensorRing EyeBotRing() {
  SSensorRing ring = FootBotRing();
  ring.Tag = "eye-bot";
  ring.Radius = 0.255;
  ring.Height = 0.1635;
  ring.Range = 3.0;
  return ring;
}

}  // namespace argos

#endif
