#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LIGHT_ANGULAR_LIGHT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LIGHT_ANGULAR_LIGHT_SENSOR_H

#include <argos3/plugins/robots/generic/simulator/angular_light.h>
#include <argos3/plugins/robots/generic/simulator/placed_readings_sensor.h>

#include <string>

namespace argos {

/**
 * Light sensors of one type of robot, with directions in the readings; see CAngularLight for the
 * model.
 *
 * @tparam INTERFACE  the control interface: has CAngularReadings.
 */
template <class INTERFACE>
class CAngularLightSensor : public CPlacedReadingsSensor<INTERFACE, CAngularLight> {
 public:
  void Update() override { this->m_reader.Read(this->m_tReadings); }
};

/** Manual of a ring of 24 such sensors. @param tag  the XML element of the sensor. */
std::string AngularLightManual(const std::string& tag);

}  // namespace argos

#endif
