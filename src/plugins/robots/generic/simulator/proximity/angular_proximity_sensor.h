#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_ANGULAR_PROXIMITY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_ANGULAR_PROXIMITY_SENSOR_H

#include <argos3/plugins/robots/generic/simulator/placed_readings_sensor.h>
#include <argos3/plugins/robots/generic/simulator/proximity_rays.h>

#include <string>

namespace argos {

/**
 * Proximity sensors of one type of robot, with directions in the readings. The derived class
 * defines the response to distance.
 *
 * @tparam INTERFACE  the control interface: has CAngularReadings.
 */
template <class INTERFACE>
class CAngularProximitySensor : public CPlacedReadingsSensor<INTERFACE, CProximityRays> {
 public:
  void Update() override {
    Read([this](Real distance) { return CalculateReading(distance); });
  }

  /**
   * Response of a sensor, before noise; clamped to [0,1] afterwards.
   * @param distance  from the start of the ray to the body that it hits, m, >= 0.
   */
  virtual Real CalculateReading(Real distance) = 0;

 protected:
  /** Sets all readings. @param calculate  Real(Real distance), as CalculateReading(). */
  template <typename CALCULATE>
  void Read(CALCULATE&& calculate) {
    auto* const readings = this->m_tReadings.data();
    this->m_reader.Read(calculate,
                        [readings](size_t ray, Real reading) { readings[ray].Value = reading; });
  }
};

}  // namespace argos

#endif
