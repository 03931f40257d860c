#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_MEASURES_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_MEASURES_H

#include <argos3/core/utility/datatypes/datatypes.h>

/*
 * Dimensions of the foot-bot, as published with ARGoS 3. Lengths in m from the centre of the
 * base; x ahead, y left, z up; angles in degrees, counter-clockwise from straight ahead.
 */

namespace argos {
namespace footbot {

// body
constexpr Real kBodyRadius = 0.085036758;
constexpr Real kBodyHeight = 0.146899733;
constexpr Real kMass = 1.6;  // kg
// kg m^2: m (2R)^2 / 2, four times that of an even disc, as published
constexpr Real kPlanarInertia = 0.5 * kMass * (2.0 * kBodyRadius) * (2.0 * kBodyRadius);

// wheels
constexpr Real kInterwheelDistance = 0.14;
constexpr Real kWheelRadius = 0.029112741;
constexpr Real kMaxDriveForce = 15.0;  // N
constexpr Real kMaxDriveTorque = 150.0;  // N m

// turret
constexpr Real kTurretMass = kMass / 20.0;  // kg
constexpr Real kTurretInertia = kPlanarInertia;  // kg m^2, as published
constexpr Real kMaxTurretTorque = 150.0;  // N m
constexpr Real kFreeTurretTorque = 1e-4;  // N m, while it rotates freely
constexpr Real kTurretProportionalGain = 0.4;  // 1/s
constexpr Real kTurretDerivativeGain = 0.2;

// gripper, in the frame of the turret
constexpr Real kGripperReach = kBodyRadius;  // ahead
constexpr Real kGripperElevation = 0.085;

// ring of proximity sensors, and of light sensors
constexpr UInt32 kNumProximitySensors = 24;
constexpr Real kProximityRingElevation = 0.06;
constexpr Real kProximityRingRadius = kBodyRadius;
constexpr Real kProximityRange = 0.1;
constexpr Real kProximityStartAngle = 7.5;

// ground sensors; ci_footbot_{motor,base}_ground_sensor.h has their positions
constexpr UInt32 kFirstMotorGroundSensor = 0;
constexpr UInt32 kFirstBaseGroundSensor = 4;
constexpr UInt32 kNumGroundSensors = 12;

// distance scanner: ranges of its heads, from the surface of the body
constexpr Real kDistanceScannerElevation = 0.123199866;
constexpr Real kDistanceScannerShortMin = 0.0;
constexpr Real kDistanceScannerShortMax = 0.26;
constexpr Real kDistanceScannerLongMin = 0.12;
constexpr Real kDistanceScannerLongMax = 1.42;

// ring of LEDs, and the beacon above it, on the turret
constexpr UInt32 kNumRingLEDs = 12;
constexpr Real kLEDRingElevation = 0.085;
constexpr Real kLEDRingRadius = kBodyRadius + 0.005;
constexpr Real kLEDRingStartAngle = 15.0;
constexpr Real kBeaconElevation = 0.174249733;

// range and bearing
constexpr Real kRABElevation = 0.1;

// cameras
constexpr Real kOmnidirectionalCameraElevation = 0.288699733;
constexpr Real kPerspectiveCameraReach = kBodyRadius;  // ahead of the centre
constexpr Real kPerspectiveCameraElevation = 0.174249733;

}  // namespace footbot
}  // namespace argos

#endif
