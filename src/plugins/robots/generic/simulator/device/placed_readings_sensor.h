#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_PLACED_READINGS_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_PLACED_READINGS_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

namespace argos {

/**
 * What the sensors whose readings say where they are have in common: all but taking them.
 *
 * @tparam INTERFACE  the control interface: has CAngularReadings or COffsetReadings.
 * @tparam READER     takes the readings: has Init(TConfigurationNode&) and Reset().
 */
template <class INTERFACE, class READER>
class CPlacedReadingsSensor : public CSimulatedSensor, public INTERFACE {
 public:
  /** See READER::Init(). */
  void Init(TConfigurationNode& tree) override {
    INTERFACE::Init(tree);
    m_reader.Init(tree);
    this->Enable();
  }
  void Reset() override {
    for (auto& reading : this->m_tReadings) {
      reading.Value = 0.0;
    }
    m_reader.Reset();
  }

 protected:
  READER m_reader;
};

}  // namespace argos

#endif
