#ifndef ARGOS3_PLUGINS_ROBOTS_E_PUCK_SIMULATOR_EPUCK_PROXIMITY_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_E_PUCK_SIMULATOR_EPUCK_PROXIMITY_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/generic/simulator/angular_proximity_sensor.h>

namespace argos {

/** The proximity sensors of the e-puck. */
class CEPuckProximityDefaultSensor : public CAngularProximitySensor<CCI_EPuckProximitySensor> {
 public:
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Response of the real sensors: a parabola up to 5 cm, then 0. */
  Real CalculateReading(Real distance) override;

 private:
  bool m_isDerived = true;  // a derived class may have another response
};

}  // namespace argos

#endif
