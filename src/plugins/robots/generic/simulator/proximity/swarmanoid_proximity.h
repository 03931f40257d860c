#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_SWARMANOID_PROXIMITY_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_SWARMANOID_PROXIMITY_H

#include <argos3/plugins/robots/generic/simulator/angular_proximity_sensor.h>

namespace argos {

/**
 * Response of the infrared proximity sensors of the Swarmanoid project's robots, foot-bot and
 * eye-bot: 1 below 0.99 cm, then proportional to 1 / distance.
 * @param distance  from the sensor, m, >= 0.
 *
 * Source: the response curve published with ARGoS 3.
 */
inline Real ComputeSwarmanoidProximity(Real distance) {
  constexpr Real kNear = 0.009889556;  // m
  constexpr Real kScale = 0.0100527;  // m
  constexpr Real kShift = 0.000163144;  // m
  return distance < kNear ? 1.0 : kScale / (distance + kShift);
}

/** Proximity sensors with that response. @tparam INTERFACE  see CAngularProximitySensor. */
template <class INTERFACE>
class CSwarmanoidProximitySensor : public CAngularProximitySensor<INTERFACE> {
 public:
  Real CalculateReading(Real distance) override { return ComputeSwarmanoidProximity(distance); }
};

}  // namespace argos

#endif
