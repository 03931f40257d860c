#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_MOTOR_GROUND_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_MOTOR_GROUND_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/placed_readings.h>

namespace argos {

/**
 * The four ground sensors between the wheels of the foot-bot, which read shades of grey.
 *
 * GetReadings() has one reading for each sensor, in the order of GetOffset(): 0 is black, 1 is
 * white.
 */
class CCI_FootBotMotorGroundSensor
    : public CPlacedSensors<COffsetReadings<CCI_FootBotMotorGroundSensor>> {
 public:
  static constexpr UInt32 kNumSensors = 4;
  static const SSensorPlaces<CVector2> kPlaces;

  /** Position of a sensor, cm: x ahead, y left. @param index < kNumSensors. */
  static CVector2 GetOffset(UInt32 index);
};

}  // namespace argos

#endif
