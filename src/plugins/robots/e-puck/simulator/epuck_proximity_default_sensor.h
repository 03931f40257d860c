#ifndef ARGOS3_PLUGINS_ROBOTS_E_PUCK_SIMULATOR_EPUCK_PROXIMITY_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_E_PUCK_SIMULATOR_EPUCK_PROXIMITY_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/generic/simulator/angular_proximity_sensor.h>

namespace argos {

/** The e-puck's proximity sensors, with the response of the real ones. */
class CEPuckProximityDefaultSensor : public CAngularProximitySensor<CCI_EPuckProximitySensor> {
 public:
  /** @throws CARGoSException unless the robot has eight proximity sensors. */
  void SetRobot(CComposableEntity& robot) override;
  /**
   * What a sensor reads, before noise: a parabola up to 5 cm, then 0; clamped to [0,1] afterwards.
   * @param distance  from the start of its ray to what it met, m, >= 0.
   */
  Real CalculateReading(Real distance) override;
};

}  // namespace argos

#endif
