#include <argos3/plugins/robots/generic/simulator/robot_components.h>

#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/plugins/simulator/entities/omnidirectional_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>

namespace argos {

namespace {

// image of every perspective camera of ARGoS 3, pixels
constexpr SInt32 kImageWidth = 640;
constexpr SInt32 kImageHeight = 480;

}  // namespace

CEntity& MakeBattery(CRobotEntity& robot) {
  auto& battery = robot.MakeOnDemand<CBatteryEquippedEntity>("battery_0");
  TConfigurationNode* const tree = robot.GetConfigurationNode();
  if (tree != nullptr && NodeExists(*tree, "battery")) {
    battery.Configure(GetNode(*tree, "battery"));
  } else {
    battery.SetDischargeModel(robot.GetDeviceParameters().Battery.Model);
  }
  return battery;
}

CEntity& MakeGroundSensors(CRobotEntity& robot,
                           const std::shared_ptr<const SGroundSensorLayout>& layout) {
  auto& sensors = robot.MakeOnDemand<CGroundSensorEquippedEntity>("ground_0");
  sensors.SetLayout(layout, {&robot.GetEmbodiedEntity().GetOriginAnchor()});
  return sensors;
}

CEntity& MakeLightSensors(CRobotEntity& robot, const std::shared_ptr<const SRayLayout>& layout) {
  auto& sensors = robot.MakeOnDemand<CLightSensorEquippedEntity>("light_0");
  sensors.SetLayout(layout, {&robot.GetEmbodiedEntity().GetOriginAnchor()});
  return sensors;
}

CEntity& MakeRABComponent(CRobotEntity& robot, const CVector3& offset) {
  const SRABParameters& parameters = robot.GetDeviceParameters().RAB;
  CEmbodiedEntity& body = robot.GetEmbodiedEntity();
  return robot.MakeOnDemand<CRABEquippedEntity>("rab_0", parameters.DataSize, parameters.Range,
                                                body.GetOriginAnchor(), body, offset);
}

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
  // users' code finds the frame of the camera here; not while robots run, which may read anchors
  CEmbodiedEntity& body = robot.GetEmbodiedEntity();
  if (!CRobotsCode::IsRunning() && body.GetAnchors().count("perspective_camera") == 0) {
    const SAnchor& mount = body.GetAnchor(anchor);
    body.AddAnchor("perspective_camera",
                   mount.OffsetPosition + CVector3(offset).Rotate(mount.OffsetOrientation),
                   mount.OffsetOrientation * orientation);
  }
  return camera;
}

}  // namespace argos
