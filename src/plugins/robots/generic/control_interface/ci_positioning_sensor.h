#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_POSITIONING_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_POSITIONING_SENSOR_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <ostream>

namespace argos {

/** Position and orientation of a robot. */
class CCI_PositioningSensor : public CTableSensor {
 public:
  struct SReading {
    CVector3 Position; /**< of the centre of the base, world frame, m */
    CQuaternion Orientation; /**< of the body in the world frame */

    SReading() = default;
    SReading(const CVector3& position, const CQuaternion& orientation)
        : Position(position), Orientation(orientation) {}

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReading& reading) {
      return PrintReading(stream, "Position", reading.Position, "Orientation", reading.Orientation);
    }
  };

  const SReading& GetReading() const { return m_sReading; }

 protected:
  SReading m_sReading;
  CRadians m_cAngle;  // the orientation is a rotation by this angle, with noise
  CVector3 m_cAxis;  // axis of the rotation by m_cAngle

 private:
  const char* GetLuaName() const override { return "positioning"; }
  /** robot.positioning.position (m), .orientation */
  void WriteReadings(CLuaTable& table) const override;
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#endif
