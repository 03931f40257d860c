#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_COLORED_BLOB_OMNIDIRECTIONAL_CAMERA_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_COLORED_BLOB_OMNIDIRECTIONAL_CAMERA_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/math/angles.h>

#include <vector>

namespace argos {

/**
 * A camera that sees coloured lights all around the robot.
 *
 * Starts disabled: a controller calls Enable(), and has its first readings in the next step.
 */
class CCI_ColoredBlobOmnidirectionalCameraSensor : public CCI_Sensor {
 public:
  /** One coloured light. */
  struct SBlob {
    CColor Color;
    CRadians Angle; /**< in the robot's frame, [-PI,PI), 0 = ahead, counter-clockwise */
    Real Distance; /**< on the ground, from under the camera, cm */

    SBlob();
    SBlob(const CColor& color, const CRadians& angle, Real distance);
  };

  typedef std::vector<SBlob*> TBlobList;

  struct SReadings {
    TBlobList BlobList; /**< not owned; the blobs are valid until the next step */
    UInt64 Counter; /**< how many pictures were taken since the start */

    SReadings();
  };

  const SReadings& GetReadings() const;

  /** robot.colored_blob_omnidirectional_camera.enable(), disable(); [i] = { distance, angle, color
   * }
   */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  SReadings m_sReadings;
};

}  // namespace argos

#endif
