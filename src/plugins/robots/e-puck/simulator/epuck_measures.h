#ifndef ARGOS3_PLUGINS_ROBOTS_E_PUCK_SIMULATOR_EPUCK_MEASURES_H
#define ARGOS3_PLUGINS_ROBOTS_E_PUCK_SIMULATOR_EPUCK_MEASURES_H

#include <argos3/core/utility/datatypes/datatypes.h>

/*
 * Dimensions of the e-puck, as published with ARGoS 3. Lengths in m from the centre of the base;
 * x ahead, y left, z up; angles counter-clockwise from straight ahead.
 */

namespace argos {
namespace epuck {

// body
constexpr Real kBodyRadius = 0.035;
constexpr Real kBodyHeight = 0.086;
constexpr Real kMass = 0.4;  // kg
// kg m^2: m (2R)^2 / 2, four times that of an even disc, as published
constexpr Real kPlanarInertia = 0.5 * kMass * (2.0 * kBodyRadius) * (2.0 * kBodyRadius);

// wheels
constexpr Real kInterwheelDistance = 0.053;
constexpr Real kWheelRadius = 0.0205;
constexpr Real kMaxDriveForce = 1.5;  // N
constexpr Real kMaxDriveTorque = 1.5;  // N m

// proximity sensors; ci_epuck_proximity_sensor.h has their directions
constexpr Real kProximityElevation = 0.06;
constexpr Real kProximityRadius = kBodyRadius;
constexpr Real kProximityRange = 0.1;

// ring of light sensors, with the radius and elevation of the proximity sensors
constexpr UInt32 kNumLightSensors = 8;
constexpr Real kLightRingStartAngle = 22.5;  // degrees

// ground sensors, from right to left
constexpr Real kGroundSensorX = 0.03;
constexpr Real kGroundSensorYs[] = {-0.009, 0.0, 0.009};

// ring of LEDs
constexpr UInt32 kNumLEDs = 8;
constexpr Real kLEDRingElevation = kBodyHeight;
constexpr Real kLEDRingRadius = 0.042;
constexpr Real kLEDRingStartAngle = 11.25;  // degrees

// range and bearing
constexpr Real kRABRange = 0.8;
constexpr UInt32 kRABDataSize = 2;  // bytes
constexpr Real kRABElevation = 0.086;

}  // namespace epuck
}  // namespace argos

#endif
