#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_ENCODER_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_ENCODER_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** The encoders of the wheels of the foot-bot: how far they really rolled. */
class CCI_FootBotEncoderSensor : public CCI_Sensor {
 public:
  struct SReading {
    Real CoveredDistanceLeftWheel = 0.0; /**< since the previous step, cm, positive ahead */
    Real CoveredDistanceRightWheel = 0.0; /**< since the previous step, cm, positive ahead */
    Real WheelAxisLength = 0.0; /**< distance between the wheels, cm */

    SReading() = default;
    SReading(Real distanceLeft, Real distanceRight, Real axisLength)
        : CoveredDistanceLeftWheel(distanceLeft),
          CoveredDistanceRightWheel(distanceRight),
          WheelAxisLength(axisLength) {}
  };

  const SReading& GetReading() const;

  /** robot.encoder.distance_left, .distance_right, .axis_length (cm) */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  SReading m_sReading;
};

}  // namespace argos

#endif
