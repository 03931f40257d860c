#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_MEASURES_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_MEASURES_H

#include <argos3/core/utility/datatypes/datatypes.h>

/*
 * Dimensions of the Pi-Puck, as published with ARGoS 3. Lengths in m from the centre of the base;
 * x ahead, y left, z up.
 */

namespace argos {
namespace pipuck {

// body: that of dynamics2d; the one of dynamics3d was 6 cm high, and weighed 0.17 kg
constexpr Real kBodyRadius = 0.0362;
constexpr Real kBodyHeight = 0.08;
constexpr Real kMass = 0.4;  // kg
// kg m^2: m (2R)^2 / 2, four times that of an even disc, as published
constexpr Real kPlanarInertia = 0.5 * kMass * (2.0 * kBodyRadius) * (2.0 * kBodyRadius);
constexpr Real kClearance = 0.00125;  // height of the shell above the ground

// wheels
constexpr Real kInterwheelDistance = 0.0565;
constexpr Real kWheelRadius = 0.02125;
constexpr Real kWheelFaceY = 0.0255;  // y of the inner face of the left wheel
constexpr Real kMaxDriveForce = 1.5;  // N
constexpr Real kMaxDriveTorque = 1.5;  // N m

// LEDs: the ring, from the one in front clockwise; then the front LED, then the body LED
constexpr UInt32 kNumRingLEDs = 8;
constexpr Real kRingRadius = 0.0335;
constexpr Real kRingElevation = 0.038;
constexpr Real kFrontLEDX = 0.029;
constexpr Real kFrontLEDY = -0.011;
constexpr Real kFrontLEDElevation = 0.02825;
constexpr Real kBodyLEDElevation = 0.025;
constexpr Real kLEDObservableAngle = 60.0;  // degrees

// radio
constexpr Real kRadioElevation = 0.05;
constexpr Real kRadioRange = 10.0;

}  // namespace pipuck
}  // namespace argos

#endif
