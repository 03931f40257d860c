#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GROUND_OFFSET_GROUND_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GROUND_OFFSET_GROUND_SENSOR_H

#include <argos3/plugins/robots/generic/simulator/floor_reader.h>
#include <argos3/plugins/robots/generic/simulator/placed_readings_sensor.h>

#include <string>

namespace argos {

/**
 * Some of the ground sensors of one type of robot, with offsets in the readings.
 *
 * @tparam INTERFACE  the control interface: has COffsetReadings.
 * @tparam FIRST      number of the first of these sensors among all ground sensors of the robot.
 * @tparam NUM_ALL    number of all ground sensors of the robot.
 */
template <class INTERFACE, size_t FIRST, size_t NUM_ALL>
class COffsetGroundSensor : public CPlacedReadingsSensor<INTERFACE, CFloorReader> {
 public:
  void Update() override { this->m_reader.Read(this->m_tReadings, FIRST); }

 protected:
  size_t GetNumNeeded() const override { return NUM_ALL; }
};

/**
 * Required and optional XML of a ground sensor.
 * @param tag   the XML element of the sensor.
 * @param next  the step after noise is added, such as "it is clamped to [0,1]".
 */
std::string GroundSensorManual(const std::string& tag, const std::string& next);

}  // namespace argos

#endif
