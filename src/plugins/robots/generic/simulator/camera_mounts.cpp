#include <argos3/plugins/robots/generic/simulator/camera_mounts.h>

#include <argos3/plugins/simulator/entities/omnidirectional_camera_equipped_entity.h>

namespace argos {

CEntity& MakeOmnidirectionalCamera(CRobotEntity& robot, const CVector3& offset) {
  return robot.MakeOnDemand<COmnidirectionalCameraEquippedEntity>(
      "omnidirectional_camera_0", robot.GetDeviceParameters().OmnidirectionalCamera.Aperture,
      offset);
}

}  // namespace argos
