#ifndef ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_MEASURES_H
#define ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_MEASURES_H

#include <argos3/core/utility/datatypes/datatypes.h>

/*
 * Dimensions of the eye-bot, as published with ARGoS 3. Lengths in m from the centre of the base;
 * x ahead, y left, z up; angles in degrees, counter-clockwise from straight ahead.
 */

namespace argos {
namespace eyebot {

// body
constexpr Real kBodyRadius = 0.25;  // the length of an arm
constexpr Real kBodyHeight = 0.566;
constexpr Real kMass = 1.0;  // kg
constexpr Real kYawInertia = 0.01;  // kg m^2

// controllers of the propellers
constexpr Real kPositionProportional = 20.0;  // N/m
constexpr Real kPositionDerivative = 10.0;  // N s/m
constexpr Real kYawProportional = 0.5;  // N m/rad
constexpr Real kYawDerivative = 0.1;  // N m s/rad
constexpr Real kVelocityProportional = 20.0;  // N s/m
constexpr Real kVelocityDerivative = 0.0;  // kg
constexpr Real kYawRateProportional = 0.5;  // N m s/rad
constexpr Real kYawRateDerivative = 0.1;  // kg m^2
constexpr Real kMaxForce = 1000.0;  // N, along each axis
constexpr Real kMaxTorque = 1000.0;  // N m

// two rings of LEDs, one above the other, and one LED under an arm
constexpr UInt32 kNumRingLEDs = 16;  // number in each ring
constexpr Real kLEDRingRadius = kBodyRadius + 0.005;
constexpr Real kLowerLEDRingElevation = 0.1535;
constexpr Real kUpperLEDRingElevation = 0.1635;
constexpr Real kLEDRingStartAngle = 11.25;
constexpr Real kExtraLEDRadius = 0.1785;
constexpr Real kExtraLEDAngle = 135.0;
constexpr Real kExtraLEDElevation = 0.1435;

// ring of proximity sensors
constexpr UInt32 kNumProximitySensors = 24;
constexpr Real kProximityRingElevation = 0.1635;
constexpr Real kProximityRingRadius = kBodyRadius + 0.005;
constexpr Real kProximityRange = 3.0;
constexpr Real kProximityStartAngle = 7.5;

// distance scanner, of the foot-bot's type; assumed: at the height of the proximity sensors
constexpr Real kDistanceScannerElevation = kProximityRingElevation;

}  // namespace eyebot
}  // namespace argos

#endif
