#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_FRONT_CAMERA_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_FRONT_CAMERA_SENSOR_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <array>
#include <tuple>
#include <vector>

namespace argos {

/**
 * The front camera of the Pi-Puck, which finds tags, and LEDs at places that the controller names.
 * Starts disabled.
 *
 * In the frame of the camera z is the direction of the view. With the rotation 0 x points down, and
 * y to the left of the robot.
 */
class CCI_PiPuckFrontCameraSensor : public CTableSensor {
 public:
  /** Colours of an LED: off or unknown, magenta, orange, green, blue. */
  enum class ELedState : UInt8 { OFF = 0, Q1 = 1, Q2 = 2, Q3 = 3, Q4 = 4 };

  /** A tag in the image. */
  struct STag {
    UInt32 Id; /**< the number with which its payload begins; 0 without one */
    CVector3 Position; /**< of its centre in the frame of the camera, m */
    CQuaternion Orientation; /**< in the frame of the camera */
    CVector2 Center; /**< pixels */
    /** Pixels: the corners at (-,-), (+,-), (+,+) and (-,+) of the tag's frame. */
    std::array<CVector2, 4> Corners;

    using TVector = std::vector<STag>;

    STag(UInt32 id, const CVector3& position, const CQuaternion& orientation,
         const CVector2& center, const std::array<CVector2, 4>& corners);
  };

  /** Anchor; position (m) and orientation of the camera in its frame. */
  using TConfiguration = std::tuple<const char*, CVector3, CQuaternion>;

  /**
   * Reads `rotation` (degrees), `resolution`, `principal_point` and `focal_length` (pixels).
   * @throws CARGoSException if a resolution or a focal length is not > 0.
   */
  void Init(TConfigurationNode& tree) override;

  /**
   * The state of the LED that is nearest to a place, within 1 cm.
   * @param position  in the frame of the camera, m.
   */
  virtual ELedState DetectLed(const CVector3& position) const = 0;
  /** Time of the last image, s. */
  virtual Real GetTimestamp() const = 0;
  virtual const STag::TVector& GetTags() const = 0;

 protected:
  static const CVector3 POSITION_OFFSET;  // frame: anchor "origin", m
  static const Real DEFAULT_ROTATION;  // degrees
  static const CVector2 DEFAULT_RESOLUTION;  // pixels
  static const CVector2 DEFAULT_FOCAL_LENGTH;  // pixels

  CQuaternion m_cOrientationOffset;  // frame: anchor "origin"
  CVector2 m_cResolution;  // pixels
  CVector2 m_cPrincipalPoint;  // pixels
  CVector2 m_cFocalLength;  // pixels

 private:
  const char* GetLuaName() const override { return "front_camera"; }
  /** enable(), disable(), detect_led(vector3) = 0 to 4, resolution, transform */
  void WriteConstants(CLuaTable& table) override;
  /** timestamp, tags[i] = { id, position, orientation, center, corners[1...4] } */
  void WriteReadings(CLuaTable& table) const override;
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#endif
