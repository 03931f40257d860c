#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_COLORED_BLOB_PERSPECTIVE_CAMERA_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_COLORED_BLOB_PERSPECTIVE_CAMERA_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>
#include <argos3/plugins/robots/generic/simulator/colored_blob_camera.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>

namespace argos {

/** The perspective camera of any robot; see the manual in the source. */
class CColoredBlobPerspectiveCameraDefaultSensor
    : public CColoredBlobCamera<CCI_ColoredBlobPerspectiveCameraSensor,
                                CPerspectiveCameraEquippedEntity> {
 public:
  /** @throws CARGoSException if the robot has no "perspective_camera". */
  void SetRobot(CComposableEntity& robot) override;
  /** See CColoredBlobCamera::InitCamera(). */
  void Init(TConfigurationNode& tree) override;
  void Update() override;

 private:
  class CEye;

  void AddBlob(const CEye& eye, const CLEDEntity& led, const SSightPoint& point);
};

}  // namespace argos

#endif
