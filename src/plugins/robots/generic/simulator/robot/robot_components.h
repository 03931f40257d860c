#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_ROBOT_COMPONENTS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_ROBOT_COMPONENTS_H

#include <argos3/plugins/robots/generic/simulator/robot_entity.h>
#include <argos3/plugins/simulator/entities/ground_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>

#include <memory>
#include <string>

namespace argos {

/*
 * Create the components that several types of robots have, for SComponentOnDemand::Make.
 */

/** Creates the "battery" from the child `<battery>` of the robot, or from its parameters. */
CEntity& MakeBattery(CRobotEntity& robot);
/** Creates the "ground_sensors", on the origin anchor. */
CEntity& MakeGroundSensors(CRobotEntity& robot,
                           const std::shared_ptr<const SGroundSensorLayout>& layout);
/** Creates the "light_sensors", on the origin anchor. */
CEntity& MakeLightSensors(CRobotEntity& robot, const std::shared_ptr<const SRayLayout>& layout);
/**
 * Creates the "rab", with the range and the message size of the robot's parameters.
 * @param offset  of the device from the body's origin, in the body's frame, m.
 */
CEntity& MakeRABComponent(CRobotEntity& robot, const CVector3& offset);
/**
 * Creates the "omnidirectional_camera", with the aperture of the robot's parameters.
 * @param offset  from the origin of the body, m.
 */
CEntity& MakeOmnidirectionalCamera(CRobotEntity& robot, const CVector3& offset);
/**
 * Creates the "perspective_camera", with the robot's parameters and an image of 640 x 480 pixels.
 * @param offset       in the frame of the anchor, m.
 * @param orientation  in the frame of the anchor: it rotates the x axis to the direction of view,
 *                     and the z axis to the upward direction of the image.
 * @param anchor       of the body; the camera moves with it.
 */
CEntity& MakePerspectiveCamera(CRobotEntity& robot, const CVector3& offset,
                               const CQuaternion& orientation,
                               const std::string& anchor = "origin");

}  // namespace argos

#endif
