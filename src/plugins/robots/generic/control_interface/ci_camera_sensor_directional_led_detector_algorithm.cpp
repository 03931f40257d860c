#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_directional_led_detector_algorithm.h>

#include <argos3/plugins/robots/generic/control_interface/led_detections_impl.h>

namespace argos {

template class CLEDDetections<CCI_CameraSensorDirectionalLEDDetectorAlgorithm>;

const char* CCI_CameraSensorDirectionalLEDDetectorAlgorithm::GetLabel() const {
  return "directional_led_detector";
}

}  // namespace argos
