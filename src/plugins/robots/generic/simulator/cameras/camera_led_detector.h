#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_LED_DETECTOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_LED_DETECTOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/simulator/camera_detector.h>

namespace argos {

class CLEDEntity;
class CLEDMedium;

/** Finds LEDs and lights in the pictures of a camera. */
class CCameraLEDDetector : public CCameraDetector<CLEDEntity, CLEDMedium, 1>,
                           public CCI_CameraSensorLEDDetectorAlgorithm {
 public:
  void Reset() override;
  void Update(const CPinholeCamera& camera) override;
  CCI_CameraSensorAlgorithm& GetCIAlgorithm() override { return *this; }

 protected:
  std::string GetMediumKind() const override { return "an LED medium"; }
};

}  // namespace argos

#endif
