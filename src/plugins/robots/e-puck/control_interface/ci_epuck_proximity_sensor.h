#ifndef ARGOS3_PLUGINS_ROBOTS_E_PUCK_CONTROL_INTERFACE_CI_EPUCK_PROXIMITY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_E_PUCK_CONTROL_INTERFACE_CI_EPUCK_PROXIMITY_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/placed_readings.h>

namespace argos {

/**
 * The eight proximity sensors of the e-puck.
 *
 * GetReadings() has eight readings, at about 17, 50, 90, 150, -150, -90, -50 and -17 degrees: 0
 * means that no object is in range, larger is nearer.
 */
class CCI_EPuckProximitySensor : public CPlacedSensors<CAngularReadings<CCI_EPuckProximitySensor>> {
 public:
  static constexpr UInt32 kNumSensors = 8;
  static const SSensorPlaces<CRadians> kPlaces;

  /** Direction of sensor @p index (0 to 7), in (-PI,PI]; as published with ARGoS 3. */
  static CRadians GetAngle(UInt32 index);
};

}  // namespace argos

#endif
