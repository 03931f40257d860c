#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERA_MOUNTS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERA_MOUNTS_H

#include <argos3/plugins/robots/generic/simulator/robot_entity.h>

namespace argos {

/*
 * Cameras as components on demand, for the sources of robots: what their SComponentOnDemand::Make
 * functions call.
 */

/**
 * Makes the robot's "omnidirectional_camera", with the aperture of its parameters.
 * @param offset  from the origin of the body, m.
 */
CEntity& MakeOmnidirectionalCamera(CRobotEntity& robot, const CVector3& offset);

}  // namespace argos

#endif
