#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_DIRECTIONAL_LED_DETECTOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_DIRECTIONAL_LED_DETECTOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_directional_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/simulator/camera_detector.h>

namespace argos {

class CDirectionalLEDEntity;
class CDirectionalLEDMedium;

/** Finds directional LEDs that shine on a camera. */
class CCameraDirectionalLEDDetector
    : public CCameraDetector<CDirectionalLEDEntity, CDirectionalLEDMedium, 1>,
      public CCI_CameraSensorDirectionalLEDDetectorAlgorithm {
 public:
  void Reset() override;
  void Update(const CPinholeCamera& camera) override;
  CCI_CameraSensorAlgorithm& GetCIAlgorithm() override { return *this; }

 protected:
  std::string GetMediumKind() const override { return "a directional LED medium"; }
};

}  // namespace argos

#endif
