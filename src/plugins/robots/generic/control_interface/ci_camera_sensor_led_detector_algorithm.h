#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_LED_DETECTOR_ALGORITHM_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_LED_DETECTOR_ALGORITHM_H

#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_algorithm.h>

#include <vector>

namespace argos {

/** Finds LEDs in the pictures of a camera: "led_detector". */
class CCI_CameraSensorLEDDetectorAlgorithm : virtual public CCI_CameraSensorAlgorithm {
 public:
  /** One LED. */
  struct SReading {
    CColor Color;
    CVector2 Center; /**< pixels, as the camera's focal length and principal point define them */

    SReading(const CColor& color, const CVector2& center);
  };

  /** In the order in which their entities were created. */
  const std::vector<SReading>& GetReadings() const;

  const char* GetLabel() const override { return "led_detector"; }
  /** [i] = { color, center } */
  void WriteReadings(CLuaTable& table) const override;

 protected:
  std::vector<SReading> m_tReadings;
};

}  // namespace argos

#endif
