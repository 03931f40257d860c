#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_COLORED_BLOB_PERSPECTIVE_CAMERA_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_COLORED_BLOB_PERSPECTIVE_CAMERA_SENSOR_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/plugins/robots/generic/control_interface/colored_blobs.h>

#include <ostream>
#include <vector>

namespace argos {

/** A light in an image of a perspective camera. */
struct SPerspectiveBlob {
  CColor Color;
  SInt32 X, Y; /**< pixels; (0,0) is the upper left one of the image */

  SPerspectiveBlob() : SPerspectiveBlob(CColor(), 0, 0) {}
  SPerspectiveBlob(const CColor& color, SInt32 x, SInt32 y) : Color(color), X(x), Y(y) {}

  template <int = 0>
  friend std::ostream& operator<<(std::ostream& stream, const SPerspectiveBlob& blob) {
    return PrintReading(stream, "Color", blob.Color, "X", blob.X, "Y", blob.Y);
  }
  friend std::ostream& operator<<(std::ostream& stream,
                                  const std::vector<SPerspectiveBlob*>& blobs) {
    return PrintReadings(stream, blobs);
  }
};

/** A perspective camera that detects coloured lights. */
class CCI_ColoredBlobPerspectiveCameraSensor : public CColoredBlobs<SPerspectiveBlob> {
 private:
  const char* GetLuaName() const override { return "colored_blob_perspective_camera"; }
  /** [i] = { x, y, color } */
  void WriteReadings(CLuaTable& table) const override;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/angles.h>
#endif

#endif
