#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PLANAR_BODY_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PLANAR_BODY_H

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>

#include <string>

namespace argos {

// What engines in which bodies stand on a plane have in common: what they read, and whom they take.

/** Bounds of the friction of passive bodies on the ground. */
struct SGroundFriction {
  Real Force = 1.49;  // N
  Real Torque = 1.49;  // N m
};

/** Reads a number >= 0 into @p value, its default. @throws CARGoSException if it is another. */
void ReadNotNegative(TConfigurationNode& node, const std::string& attribute, Real& value);
/** Reads `elevation`, default 0. @return m. @throws CARGoSException if it is not finite. */
Real ReadElevation(TConfigurationNode& engine);
/** Reads `<friction>`, if there is one. @throws CARGoSException if a number is below 0. */
void ReadGroundFriction(TConfigurationNode& engine, SGroundFriction& box,
                        SGroundFriction& cylinder);
/** @throws CARGoSException if the engine has more substeps than would ever end. */
void CheckIterations(TConfigurationNode& node, const CPhysicsEngine& engine);

/** The body of a root entity, if it says what it is and does not fly; else null. */
CEmbodiedEntity* FindPlanarBody(CEntity& root);
/** @throws CARGoSException if no body is like that, or it is too large or far away. */
void CheckPlanarBody(const CEmbodiedEntity& body);
/**
 * Speeds of the left and the right wheel, m/s, of a movable body with a drive; null for others.
 * @throws CARGoSException if it has a drive, but not two wheels.
 */
const Real* FindWheels(CEmbodiedEntity& body);

/** Does it stand on a plane at that height? @param elevation m. */
bool IsOnPlane(const CEmbodiedEntity& body, Real elevation);
/** Why an engine with a plane at that height does not take an entity; see ExplainRefusal(). */
std::string ExplainPlanarRefusal(CEntity& entity, Real elevation);

/** The box around a body that is only turned about the vertical. */
SBoundingBox ComputePlanarBounds(const CEmbodiedEntity& body);
/** The same at @p pose, where the body's origin anchor is already. */
SBoundingBox ComputePlanarBounds(const CEmbodiedEntity& body, const SPlanarPose& pose);

}  // namespace argos

#endif
