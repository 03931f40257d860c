#include <argos3/plugins/robots/generic/simulator/camera_mounts.h>

#include <argos3/plugins/simulator/entities/omnidirectional_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>

namespace argos {

namespace {

// of every perspective camera of ARGoS 3, pixels
constexpr SInt32 kImageWidth = 640;
constexpr SInt32 kImageHeight = 480;

}  // namespace

CEntity& MakeOmnidirectionalCamera(CRobotEntity& robot, const CVector3& offset) {
  return robot.MakeOnDemand<COmnidirectionalCameraEquippedEntity>(
      "omnidirectional_camera_0", robot.GetDeviceParameters().OmnidirectionalCamera.Aperture,
      offset);
}

CEntity& MakePerspectiveCamera(CRobotEntity& robot, const CVector3& offset,
                               const CQuaternion& orientation, const std::string& anchor) {
  const SPerspectiveCameraParameters& parameters = robot.GetDeviceParameters().PerspectiveCamera;
  auto& camera = robot.MakeOnDemand<CPerspectiveCameraEquippedEntity>(
      "perspective_camera_0", parameters.Aperture, parameters.FocalLength, parameters.Range,
      kImageWidth, kImageHeight, robot.GetEmbodiedEntity().GetAnchor(anchor));
  camera.SetMount(offset, orientation);
  return camera;
}

}  // namespace argos
