#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_MOTOR_GROUND_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_MOTOR_GROUND_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector2.h>

#include <vector>

namespace argos {

/** The four ground sensors between the wheels of the foot-bot, which see shades of grey. */
class CCI_FootBotMotorGroundSensor : public CCI_Sensor {
 public:
  static constexpr UInt32 kNumSensors = 4;

  struct SReading {
    Real Value = 0.0; /**< in [0,1]: 0 is black, 1 is white */
    CVector2 Offset; /**< of the sensor from the centre of the robot, in its frame, cm */

    SReading() = default;
    SReading(Real value, const CVector2& offset) : Value(value), Offset(offset) {}
  };

  typedef std::vector<SReading> TReadings;

  CCI_FootBotMotorGroundSensor();

  /** One reading for each sensor. */
  const TReadings& GetReadings() const;
  /** Where a sensor is, cm: x ahead, y left. @param index < kNumSensors. */
  static CVector2 GetOffset(UInt32 index);

  /** robot.motor_ground[i] = { offset, value } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  TReadings m_tReadings;
};

}  // namespace argos

#endif
