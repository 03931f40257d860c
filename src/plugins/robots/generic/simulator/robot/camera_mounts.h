#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_CAMERA_MOUNTS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_CAMERA_MOUNTS_H

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
/**
 * Makes the robot's "perspective_camera", with the numbers of its parameters and an image of 640 x
 * 480 pixels.
 * @param offset       in the frame of the anchor, m.
 * @param orientation  in the frame of the anchor: it turns the x axis to where the camera looks,
 *                     and the z axis to what is up in its image.
 * @param anchor       the body's, which the camera moves with.
 */
CEntity& MakePerspectiveCamera(CRobotEntity& robot, const CVector3& offset,
                               const CQuaternion& orientation,
                               const std::string& anchor = "origin");

}  // namespace argos

#endif
