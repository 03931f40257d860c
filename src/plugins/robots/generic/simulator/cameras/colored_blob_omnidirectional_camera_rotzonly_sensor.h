#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_COLORED_BLOB_OMNIDIRECTIONAL_CAMERA_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_COLORED_BLOB_OMNIDIRECTIONAL_CAMERA_ROTZONLY_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/simulator/colored_blob_camera.h>
#include <argos3/plugins/simulator/entities/omnidirectional_camera_equipped_entity.h>

namespace argos {

/** The omnidirectional camera of a robot that stays upright; see the manual in the source. */
class CColoredBlobOmnidirectionalCameraRotZOnlySensor
    : public CColoredBlobCamera<CCI_ColoredBlobOmnidirectionalCameraSensor,
                                COmnidirectionalCameraEquippedEntity> {
 public:
  /** @throws CARGoSException if the robot has no "omnidirectional_camera". */
  void SetRobot(CComposableEntity& robot) override;
  /** See CColoredBlobCamera::InitCamera(). */
  void Init(TConfigurationNode& tree) override;
  void Update() override;

 private:
  struct SEye;

  SEye ComputeEye() const;
  void AddBlob(const SEye& eye, const CLEDEntity& led, const SSightPoint& point);

  CEmbodiedEntity* m_body = nullptr;
};

}  // namespace argos

#endif
