#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_COLORED_BLOB_OMNIDIRECTIONAL_CAMERA_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_COLORED_BLOB_OMNIDIRECTIONAL_CAMERA_ROTZONLY_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/simulator/entities_in_sight.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

#include <memory>
#include <vector>

namespace argos {

class CLEDEntity;
class CLEDMedium;
class COmnidirectionalCameraEquippedEntity;

/** The omnidirectional camera of a robot that stays upright; see its long description. */
class CColoredBlobOmnidirectionalCameraRotZOnlySensor
    : public CSimulatedSensor,
      public CCI_ColoredBlobOmnidirectionalCameraSensor {
 public:
  /** @throws CARGoSException unless the robot has an "omnidirectional_camera". */
  void SetRobot(CComposableEntity& robot) override;
  /**
   * Reads `medium`, `show_rays`, `noise_std_dev` and `<noise>`.
   * @throws CARGoSException if there is no LED medium of that id, or noise is out of range.
   */
  void Init(TConfigurationNode& tree) override;
  void Enable() override;
  void Disable() override;
  void Update() override;
  void Reset() override;

 private:
  struct SEye;

  void MakeNoise();
  SEye ComputeEye() const;
  void AddBlob(const SEye& eye, const CLEDEntity& led);
  void ListBlobs();

  COmnidirectionalCameraEquippedEntity* m_camera = nullptr;  // of the robot
  CEmbodiedEntity* m_body = nullptr;  // of the robot
  CControllableEntity* m_robot = nullptr;
  CLEDMedium* m_medium = nullptr;
  bool m_showRays = false;
  Real m_noiseStdDev = 0.0;  // fraction of the distance
  std::unique_ptr<CRandomStream> m_shifts;  // only with noise_std_dev
  CDeviceNoise m_noise;
  CEntitiesInSight<CLEDEntity> m_sight;
  std::vector<SBlob> m_blobs;  // what the list of the readings points to
};

}  // namespace argos

#endif
