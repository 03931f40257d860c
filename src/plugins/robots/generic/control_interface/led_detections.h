#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_LED_DETECTIONS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_LED_DETECTIONS_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_algorithm.h>

#include <ostream>
#include <vector>

namespace argos {

/**
 * Base of the algorithms that detect LEDs in the images of a camera. The source of an algorithm
 * includes led_detections_impl.h and instantiates the template.
 * @tparam ALGORITHM  the derived class. Each algorithm has a type of readings of its own, so that
 *                    functions may be overloaded for them.
 */
template <class ALGORITHM>
class CLEDDetections : virtual public CCI_CameraSensorAlgorithm {
 public:
  /** One LED. */
  struct SReading {
    CColor Color;
    CVector2 Center; /**< pixels, as the camera's focal length and principal point define them */

    SReading(const CColor& color, const CVector2& center) : Color(color), Center(center) {}

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReading& reading) {
      return PrintReading(stream, "Color", reading.Color, "Center", reading.Center);
    }
    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const std::vector<SReading>& readings) {
      return PrintReadings(stream, readings);
    }
  };

  /** @return the readings, in the order in which the entities were created. */
  const std::vector<SReading>& GetReadings() const { return m_tReadings; }

  /** [i] = { color, center } */
  void WriteReadings(CLuaTable& table) const override;

 protected:
  std::vector<SReading> m_tReadings;
};

}  // namespace argos

#endif
