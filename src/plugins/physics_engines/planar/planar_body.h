#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PLANAR_BODY_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PLANAR_BODY_H

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>

#include <string>

namespace argos {

struct SPeriodicity;

// Shared by the 2D engines: XML parameters and acceptance checks.

/** Bounds of the friction of passive bodies on the ground. */
struct SGroundFriction {
  Real Force = 1.49;  // N
  Real Torque = 1.49;  // N m
};

/** Reads a number >= 0; @p value is also its default. @throws CARGoSException if it is negative. */
void ReadNotNegative(TConfigurationNode& node, const std::string& attribute, Real& value);
/**
 * Reads `velocity_lag`, in [0, 1]. Default: one substep of those that the file asks for with
 * `iterations`, else 0.1, as in ARGoS 3, whose bodies move in a substep before their velocities
 * change, and whose tick has ten substeps by default.
 * @param iterations  substeps of a tick.
 * @return the lag, as a share of a tick. @throws CARGoSException if it is out of range.
 */
Real ReadVelocityLag(TConfigurationNode& engine, UInt32 iterations);
/**
 * The last command of the drive of a body that another engine has moved, or, if that does not know,
 * the one that would have moved it so.
 */
SDriveCommand FindCommand(const SBodyMotion& motion, const CEmbodiedEntity& body);
/** Reads the optional `<friction>`. @throws CARGoSException if a number is below 0. */
void ReadGroundFriction(TConfigurationNode& engine, SGroundFriction& box,
                        SGroundFriction& cylinder);

/** Friction of a movable body; 0 without a description of it. */
SGroundFriction ChooseGroundFriction(const SBodyDescription& description,
                                     const SGroundFriction& box, const SGroundFriction& cylinder);

/** @throws CARGoSException if the description is impossible, or the body too large or too far. */
void CheckPlanarBody(const CEmbodiedEntity& body);

/** @throws CARGoSException if a period is not greater than @p necessary, m. */
void RequirePeriod(const SPeriodicity& period, Real necessary);

/** @return true if the body stands on a plane at height @p elevation, m. */
bool IsOnPlane(const CEmbodiedEntity& body, Real elevation);
/** Why an engine with a plane at that height refuses an entity; see ExplainRefusal(). */
std::string ExplainPlanarRefusal(CEntity& entity, Real elevation);

/** The bounding box of a body that is only rotated about the vertical. */
SBoundingBox ComputePlanarBounds(const CEmbodiedEntity& body);
/** The same at @p pose, which the body's origin anchor already has. */
SBoundingBox ComputePlanarBounds(const CEmbodiedEntity& body, const SPlanarPose& pose);

/** Moves the box around an upright disc, whose z range does not change. @param radius m. */
inline void MoveDiscBounds(SBoundingBox& box, const SPlanarPose& pose, Real radius) {
  box.MinCorner.SetX(pose.X - radius);
  box.MinCorner.SetY(pose.Y - radius);
  box.MaxCorner.SetX(pose.X + radius);
  box.MaxCorner.SetY(pose.Y + radius);
}

}  // namespace argos

#endif
