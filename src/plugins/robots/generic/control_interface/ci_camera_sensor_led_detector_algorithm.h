#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_LED_DETECTOR_ALGORITHM_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_LED_DETECTOR_ALGORITHM_H

#include <argos3/plugins/robots/generic/control_interface/led_detections.h>

namespace argos {

/** Detects LEDs in the images of a camera: "led_detector". */
class CCI_CameraSensorLEDDetectorAlgorithm
    : public CLEDDetections<CCI_CameraSensorLEDDetectorAlgorithm> {
 public:
  const char* GetLabel() const override;
};

}  // namespace argos

#endif
