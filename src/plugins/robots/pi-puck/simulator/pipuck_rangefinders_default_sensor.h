#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_RANGEFINDERS_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_RANGEFINDERS_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/generic/simulator/ray_caster.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_rangefinders_sensor.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_simulated_sensor.h>

namespace argos {

/** Casts the rays of the range sensors of a Pi-Puck. */
class CPiPuckRangefindersDefaultSensor
    : public CPiPuckSimulatedSensor<CCI_PiPuckRangefindersSensor> {
 public:
  /** @throws CARGoSException if the robot is no Pi-Puck. */
  void SetRobot(CComposableEntity& robot) override;
  void Update() override;
  /** Sets all readings to the range. */
  void Reset() override;

 private:
  CRayCaster m_caster;
};

}  // namespace argos

#endif
