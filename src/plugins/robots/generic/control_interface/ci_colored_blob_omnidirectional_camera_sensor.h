#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_COLORED_BLOB_OMNIDIRECTIONAL_CAMERA_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_COLORED_BLOB_OMNIDIRECTIONAL_CAMERA_SENSOR_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/generic/control_interface/colored_blobs.h>

#include <ostream>
#include <vector>

namespace argos {

/** A light in an image of an omnidirectional camera. */
struct SOmnidirectionalBlob {
  CColor Color;
  CRadians Angle; /**< in the robot's frame, [-PI,PI), 0 = ahead, counter-clockwise */
  Real Distance; /**< along the ground, from the point below the camera, cm */

  SOmnidirectionalBlob() : SOmnidirectionalBlob(CColor(), CRadians(), 0.0) {}
  SOmnidirectionalBlob(const CColor& color, const CRadians& angle, Real distance)
      : Color(color), Angle(angle), Distance(distance) {}

  template <int = 0>
  friend std::ostream& operator<<(std::ostream& stream, const SOmnidirectionalBlob& blob) {
    return PrintReading(stream, "Color", blob.Color, "Angle", blob.Angle, "Distance",
                        blob.Distance);
  }
  friend std::ostream& operator<<(std::ostream& stream,
                                  const std::vector<SOmnidirectionalBlob*>& blobs) {
    return PrintReadings(stream, blobs);
  }
};

/** An omnidirectional camera that detects coloured lights. */
class CCI_ColoredBlobOmnidirectionalCameraSensor : public CColoredBlobs<SOmnidirectionalBlob> {
 private:
  const char* GetLuaName() const override { return "colored_blob_omnidirectional_camera"; }
  /** [i] = { distance, angle, color } */
  void WriteReadings(CLuaTable& table) const override;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/logging/argos_log.h>
#endif

#endif
