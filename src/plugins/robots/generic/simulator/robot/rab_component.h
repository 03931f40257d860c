#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_RAB_COMPONENT_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_RAB_COMPONENT_H

#include <argos3/core/utility/math/vector3.h>

namespace argos {

class CEntity;
class CRobotEntity;

/**
 * Makes the component "rab" of a robot, with range and message size of its device parameters; for
 * SComponentOnDemand::Make of types of robots.
 * @param offset  of the device from the body's origin, in the body's frame, m.
 */
CEntity& MakeRABComponent(CRobotEntity& robot, const CVector3& offset);

}  // namespace argos

#endif
