#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_ANGULAR_PROXIMITY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_ANGULAR_PROXIMITY_SENSOR_H

#include <argos3/core/utility/prefetch.h>
#include <argos3/plugins/robots/generic/simulator/placed_readings_sensor.h>
#include <argos3/plugins/robots/generic/simulator/proximity_rays.h>

#include <string>

namespace argos {

/**
 * The proximity sensors of one kind of robot, which say where they point, and have the response of
 * the real ones.
 *
 * @tparam INTERFACE  the control interface: has CAngularReadings.
 */
template <class INTERFACE>
class CAngularProximitySensor : public CPlacedReadingsSensor<INTERFACE, CProximityRays> {
 public:
  void Update() override {
    this->m_reader.Read(
        [this](Real distance) { return CalculateReading(distance); },
        [this](size_t ray, Real reading) { this->m_tReadings[ray].Value = reading; });
  }
  void PrefetchUpdate() const override {
    this->m_reader.PrefetchRead();
    PrefetchElements(this->m_tReadings);
  }

  /**
   * What a sensor reads, before noise; clamped to [0,1] afterwards.
   * @param distance  from the start of its ray to what it met, m, >= 0.
   */
  virtual Real CalculateReading(Real distance) = 0;

 protected:
  /**
   * What SetRobot() does.
   * @throws CARGoSException that names @p device unless the robot has a ray for each reading.
   */
  void TakeRays(CComposableEntity& robot, const std::string& device) {
    this->m_reader.SetRobot(robot);
    this->m_reader.RequireNumRays(this->m_tReadings.size(), device);
  }
};

}  // namespace argos

#endif
