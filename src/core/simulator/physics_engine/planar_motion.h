#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_PLANAR_MOTION_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_PLANAR_MOTION_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

#include <algorithm>
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
  Real HalfCos = 1.0;  // cosine of half the heading
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

/** What a drive is told to do: a velocity in the plane, in the frame of the body. */
struct SDriveCommand {
  Real Ahead = 0.0;  // m/s, along the heading
  Real Left = 0.0;  // m/s, across it
  Real YawRate = 0.0;  // rad/s, counter-clockwise

  bool operator==(const SDriveCommand& other) const {
    return Ahead == other.Ahead && Left == other.Left && YawRate == other.YawRate;
  }
  Real ComputeSpeed() const { return Left == 0.0 ? std::abs(Ahead) : std::hypot(Ahead, Left); }
  /** @return true if all numbers are finite. */
  bool IsFinite() const {
    // the difference of an infinite or undefined number and itself is not 0
    return (Ahead - Ahead) + (Left - Left) + (YawRate - YawRate) == 0.0;
  }
  /** The same direction at no more than this speed (m/s). */
  SDriveCommand Limited(Real maxSpeed) const {
    if (Left == 0.0) {
      return {std::clamp(Ahead, -maxSpeed, maxSpeed), 0.0, YawRate};
    }
    const Real scale = std::min(1.0, maxSpeed / std::hypot(Ahead, Left));
    return {scale * Ahead, scale * Left, YawRate};
  }
};

/** A chord of an arc, m, and the pose at its end. */
struct SArc {
  Real DX;
  Real DY;
  SPlanarPose End;
};

/**
 * Follows the circular arc, or the straight line, of a constant command in closed form; exact
 * except for rounding errors.
 * @param duration  s.
 *
 * Source: Thrun, Burgard, Fox, Probabilistic Robotics (2005), ch. 5, velocity motion model, written
 * as a chord: an arc of length L and angle a has a chord of length L sin(a/2) / (a/2), in the
 * direction of the heading half-way.
 */
inline SArc FollowArc(const SPlanarPose& start, const SDriveCommand& command, Real duration) {
  const Real halfTurn = 0.5 * command.YawRate * duration;
  SArc arc;
  arc.End = start;
  Real quarterCos = 1.0;
  Real quarterSin = 0.0;
  Real scale = duration;
  if (halfTurn != 0.0) {
    quarterCos = std::cos(0.5 * halfTurn);
    quarterSin = std::sin(0.5 * halfTurn);
    scale *= 2.0 * quarterSin * quarterCos / halfTurn;
    Turn(arc.End, quarterCos, quarterSin);
  }
  const SPlanarPose& halfWay = arc.End;
  const Real chordX =
      scale * (halfWay.HalfCos * halfWay.HalfCos - halfWay.HalfSin * halfWay.HalfSin);
  const Real chordY = scale * 2.0 * halfWay.HalfSin * halfWay.HalfCos;
  arc.DX = command.Ahead * chordX - command.Left * chordY;
  arc.DY = command.Ahead * chordY + command.Left * chordX;
  if (halfTurn != 0.0) {
    Turn(arc.End, quarterCos, quarterSin);
  }
  arc.End.X = start.X + arc.DX;
  arc.End.Y = start.Y + arc.DY;
  return arc;
}

/**
 * Follows two arcs, one after the other: that of a drive whose command changes.
 * @param duration  s, of both.
 * @param share     of the duration, in [0, 1], in which @p before still holds.
 */
inline SArc FollowArcs(const SPlanarPose& start, const SDriveCommand& before,
                       const SDriveCommand& command, Real duration, Real share) {
  if (share == 0.0 || before == command) {
    return FollowArc(start, command, duration);
  }
  const SArc first = FollowArc(start, before, share * duration);
  SArc both = FollowArc(first.End, command, (1.0 - share) * duration);
  both.DX += first.DX;
  both.DY += first.DY;
  return both;
}

}  // namespace argos

#endif
