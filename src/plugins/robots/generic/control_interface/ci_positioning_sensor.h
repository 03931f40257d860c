#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_POSITIONING_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_POSITIONING_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/** Tells a robot where it is, and which way it looks. */
class CCI_PositioningSensor : public CCI_Sensor {
 public:
  struct SReading {
    CVector3 Position; /**< of the centre of the base, world frame, m */
    CQuaternion Orientation; /**< of the body in the world frame */

    SReading() = default;
    SReading(const CVector3& position, const CQuaternion& orientation)
        : Position(position), Orientation(orientation) {}
  };

  const SReading& GetReading() const;

  /** robot.positioning.position (m), .orientation */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  SReading m_sReading;
  CRadians m_cAngle;  // the orientation as a turn by this angle, with noise
  CVector3 m_cAxis;  // about this axis
};

}  // namespace argos

#endif
