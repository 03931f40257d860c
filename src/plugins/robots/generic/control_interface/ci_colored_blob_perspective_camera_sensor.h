#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_COLORED_BLOB_PERSPECTIVE_CAMERA_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_COLORED_BLOB_PERSPECTIVE_CAMERA_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <vector>

namespace argos {

/**
 * A camera that sees coloured lights in one direction.
 *
 * Starts disabled: a controller calls Enable(), and has its first readings in the next step.
 */
class CCI_ColoredBlobPerspectiveCameraSensor : public CCI_Sensor {
 public:
  /** One coloured light. */
  struct SBlob {
    CColor Color;
    SInt32 X, Y; /**< pixels; (0,0) is the upper left one of the image */

    SBlob();
    SBlob(const CColor& color, SInt32 x, SInt32 y);
  };

  typedef std::vector<SBlob*> TBlobList;

  struct SReadings {
    TBlobList BlobList; /**< not owned; the blobs are valid until the next step */
    UInt64 Counter; /**< how many pictures were taken since the start */

    SReadings();
  };

  const SReadings& GetReadings() const;

  /** robot.colored_blob_perspective_camera.enable(), disable(); [i] = { x, y, color } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  SReadings m_sReadings;
};

}  // namespace argos

#endif
