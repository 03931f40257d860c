#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_PLANAR_MOTION_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_PLANAR_MOTION_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

#include <cmath>

namespace argos {

/**
 * The pose of a body in the plane, world frame.
 *
 * The heading is stored as cosine and sine of its half, which are the w and z of its quaternion:
 * rotations and the conversion to a quaternion need no trigonometric function.
 */
struct SPlanarPose {
  Real X = 0.0;  // m
  Real Y = 0.0;  // m
  Real HalfCos = 1.0;  // of half the heading
  Real HalfSin = 0.0;

  /** Heading, rad, in (-pi, pi]. */
  Real ComputeYaw() const {
    return std::atan2(2.0 * HalfSin * HalfCos, HalfCos * HalfCos - HalfSin * HalfSin);
  }
  void SetYaw(Real yaw) {
    HalfCos = std::cos(0.5 * yaw);
    HalfSin = std::sin(0.5 * yaw);
  }
};

/** Projects a pose to the plane: of the orientation, only the yaw is kept. */
inline SPlanarPose MakePlanarPose(const CVector3& position, const CQuaternion& orientation) {
  const Real length = std::hypot(orientation.GetW(), orientation.GetZ());
  SPlanarPose pose;
  pose.X = position.GetX();
  pose.Y = position.GetY();
  if (length > 0.0) {
    pose.HalfCos = orientation.GetW() / length;
    pose.HalfSin = orientation.GetZ() / length;
  }
  return pose;
}

/** Rotates @p pose about its position by the angle whose half has this cosine and sine. */
inline void Turn(SPlanarPose& pose, Real halfCos, Real halfSin) {
  const Real c = pose.HalfCos * halfCos - pose.HalfSin * halfSin;
  const Real s = pose.HalfSin * halfCos + pose.HalfCos * halfSin;
  // one Newton step of 1/sqrt keeps the length at 1 over any number of rotations
  const Real scale = 1.5 - 0.5 * (c * c + s * s);
  pose.HalfCos = c * scale;
  pose.HalfSin = s * scale;
}

/** A chord of an arc, m, and the pose at its end. */
struct SArc {
  Real DX;
  Real DY;
  SPlanarPose End;
};

/**
 * Follows the circular arc, or the straight line, of a unicycle in closed form; exact except for
 * rounding errors.
 * @param speed     m/s, along the heading.
 * @param yawRate   rad/s.
 * @param duration  s.
 *
 * Source: Thrun, Burgard, Fox, Probabilistic Robotics (2005), ch. 5, velocity motion model, written
 * as a chord: an arc of length L and angle a has a chord of length L sin(a/2) / (a/2), in the
 * direction of the heading half-way.
 */
inline SArc FollowArc(const SPlanarPose& start, Real speed, Real yawRate, Real duration) {
  const Real halfTurn = 0.5 * yawRate * duration;
  SArc arc;
  arc.End = start;
  Real chord = speed * duration;
  if (halfTurn == 0.0) {
    arc.DX = chord * (start.HalfCos * start.HalfCos - start.HalfSin * start.HalfSin);
    arc.DY = chord * 2.0 * start.HalfSin * start.HalfCos;
  } else {
    const Real quarterCos = std::cos(0.5 * halfTurn);
    const Real quarterSin = std::sin(0.5 * halfTurn);
    chord *= 2.0 * quarterSin * quarterCos / halfTurn;
    Turn(arc.End, quarterCos, quarterSin);
    arc.DX = chord * (arc.End.HalfCos * arc.End.HalfCos - arc.End.HalfSin * arc.End.HalfSin);
    arc.DY = chord * 2.0 * arc.End.HalfSin * arc.End.HalfCos;
    Turn(arc.End, quarterCos, quarterSin);
  }
  arc.End.X = start.X + arc.DX;
  arc.End.Y = start.Y + arc.DY;
  return arc;
}

}  // namespace argos

#endif
