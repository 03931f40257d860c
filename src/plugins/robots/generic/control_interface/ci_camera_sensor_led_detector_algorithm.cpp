#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_led_detector_algorithm.h>

#include <argos3/plugins/robots/generic/control_interface/led_detections_impl.h>

namespace argos {

template class CLEDDetections<CCI_CameraSensorLEDDetectorAlgorithm>;

const char* CCI_CameraSensorLEDDetectorAlgorithm::GetLabel() const {
  return "led_detector";
}

}  // namespace argos
