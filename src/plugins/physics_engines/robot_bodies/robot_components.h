#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_ROBOT_COMPONENTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_ROBOT_COMPONENTS_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

class CEmbodiedEntity;
class CQuadRotorEntity;

/** m/s; assumed greatest speed that a robot at rest reaches in a tick, for the reach of ghosts. */
constexpr Real kStartSpeed = 0.5;

/**
 * Speeds of the left and the right wheel, m/s, of a movable body with a drive; null for others, and
 * for those with propellers.
 * @throws CARGoSException if the body has a drive, but not two wheels.
 */
const Real* FindWheels(CEmbodiedEntity& body);

/**
 * What commands a movable body with propellers; null for others.
 * @throws CARGoSException if the robot has no component "quadrotor".
 */
const CQuadRotorEntity* FindQuadrotor(CEmbodiedEntity& body);

}  // namespace argos

#endif
