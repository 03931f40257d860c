#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_WHEEL_MOTION_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_WHEEL_MOTION_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_bodies.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

/** Thrown by CPlanarWorld::Advance() if a wheel speed is not a number; nothing has moved then. */
struct SBadWheelSpeed {
  CDynamics2DModel* Owner;
  Real Left, Right;  // m/s
};

/** The motion that the wheels of a robot command. */
struct SWheelMotion {
  Real Speed;  // m/s, forward
  Real YawRate;  // rad/s
};

/** Reads a robot's wheel speeds. @param tick s. @throws SBadWheelSpeed */
inline SWheelMotion ReadWheels(const SDrivenBody& body, Real tick) {
  const Real left = body.Wheels[0];
  const Real right = body.Wheels[1];
  const Real speed = 0.5 * (left + right);
  const Real yawRate = (right - left) * body.InverseInterwheel;
  if (!std::isfinite(speed) || !std::isfinite(yawRate)) {
    throw SBadWheelSpeed{body.Owner.Model, left, right};
  }
  const Real maxYawRate = kMaxSubsteps * kMaxStepTurn / tick;
  return {std::clamp(speed, -body.MaxSpeed, body.MaxSpeed),
          std::clamp(yawRate, -maxYawRate, maxYawRate)};
}

}  // namespace argos

#endif
