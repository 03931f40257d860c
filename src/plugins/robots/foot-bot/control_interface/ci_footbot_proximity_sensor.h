#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_PROXIMITY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_PROXIMITY_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/placed_readings.h>

namespace argos {

/**
 * The ring of 24 proximity sensors of the foot-bot.
 *
 * GetReadings() has 24 readings, counter-clockwise from 7.5 degrees in steps of 15: 0 means
 * that no object is in range, larger is nearer.
 */
class CCI_FootBotProximitySensor
    : public CPlacedSensors<CAngularReadings<CCI_FootBotProximitySensor>> {
 public:
  static const SSensorPlaces<CRadians> kPlaces;
};

}  // namespace argos

#endif
