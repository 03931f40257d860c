#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GROUND_GROUND_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GROUND_GROUND_ROTZONLY_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_ground_sensor.h>
#include <argos3/plugins/robots/generic/simulator/floor_reader.h>
#include <argos3/plugins/robots/generic/simulator/placed_readings_sensor.h>

namespace argos {

/** All ground sensors of any robot. */
class CGroundRotZOnlySensor : public CPlainReadingsSensor<CCI_GroundSensor, CFloorReader> {
 public:
  void Update() override;
};

}  // namespace argos

#endif
