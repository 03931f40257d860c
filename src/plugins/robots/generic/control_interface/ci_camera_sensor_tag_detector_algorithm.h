#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_TAG_DETECTOR_ALGORITHM_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CAMERA_SENSOR_TAG_DETECTOR_ALGORITHM_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_algorithm.h>

#include <ostream>
#include <array>
#include <string>
#include <vector>

namespace argos {

/** Detects tags in the images of a camera: "tag_detector". */
class CCI_CameraSensorTagDetectorAlgorithm : virtual public CCI_CameraSensorAlgorithm {
 public:
  /** One tag. */
  struct SReading {
    std::string Payload;
    CVector2 Center; /**< pixels, as the camera's focal length and principal point define them */
    /** pixels: first the corner at (+,+) in the tag's frame, then counter-clockwise on the tag */
    std::array<CVector2, 4> Corners;

    SReading();
    SReading(const std::string& payload, const CVector2& center,
             const std::array<CVector2, 4>& corners);

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReading& reading) {
      PrintReading(stream, "Payload", reading.Payload, "Center", reading.Center, "Corners",
                   reading.Corners[0]);
      for (std::size_t i = 1; i < reading.Corners.size(); ++i) {
        stream << " <" << reading.Corners[i] << ">";
      }
      return stream;
    }
    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const std::vector<SReading>& readings) {
      return PrintReadings(stream, readings);
    }
  };

  /** @return the readings, in the order in which the entities were created. */
  const std::vector<SReading>& GetReadings() const;

  const char* GetLabel() const override { return "tag_detector"; }
  /** [i] = { payload, center, corners = { 4 vectors } } */
  void WriteReadings(CLuaTable& table) const override;

 protected:
  std::vector<SReading> m_tReadings;
};

}  // namespace argos

#endif
