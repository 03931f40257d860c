#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_LIGHT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_LIGHT_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/placed_readings.h>

namespace argos {

/**
 * The ring of 24 light sensors of the foot-bot.
 *
 * GetReadings() has 24 readings, counter-clockwise from 7.5 degrees in steps of 15: 0 is dark,
 * larger is brighter.
 */
class CCI_FootBotLightSensor : public CPlacedSensors<CAngularReadings<CCI_FootBotLightSensor>> {
 public:
  static const SSensorPlaces<CRadians> kPlaces;
};

}  // namespace argos

#endif
