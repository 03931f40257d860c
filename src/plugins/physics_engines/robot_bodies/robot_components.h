#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_ROBOT_COMPONENTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_ROBOT_COMPONENTS_H

#include <argos3/core/simulator/physics_engine/drive_source.h>

namespace argos {

class CEmbodiedEntity;
class CJointEquippedEntity;
class CQuadRotorEntity;
class CRecordedBody;

/** m/s; assumed greatest speed that a robot at rest reaches in a tick, for the reach of ghosts. */
constexpr Real kStartSpeed = 0.5;

/**
 * What commands the drive of a movable body; nothing for others, and for those with propellers.
 * @throws CARGoSException if the body has a drive, but not the component that commands it: two
 *         wheels, or "planar_drive"; or if its drives exclude each other.
 * @param recorded  the user's model that describes the body; nothing is found for such a body
 *                  without it.
 */
CDriveSource FindDrive(CEmbodiedEntity& body, const CRecordedBody* recorded = nullptr);

/**
 * What commands a movable body with propellers; null for others.
 * @throws CARGoSException if the robot has no component "quadrotor".
 */
const CQuadRotorEntity* FindQuadrotor(CEmbodiedEntity& body);

/**
 * The joints of an articulated body; null for others.
 * @throws CARGoSException if the robot has no component "joints".
 */
CJointEquippedEntity* FindJoints(CEmbodiedEntity& body);

}  // namespace argos

#endif
