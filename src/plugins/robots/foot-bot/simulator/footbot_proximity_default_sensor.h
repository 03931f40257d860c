#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_PROXIMITY_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_PROXIMITY_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/simulator/angular_proximity_sensor.h>

namespace argos {

/** The foot-bot's proximity sensors, with the response of the real ones. */
class CFootBotProximityDefaultSensor : public CAngularProximitySensor<CCI_FootBotProximitySensor> {
 public:
  /** @throws CARGoSException unless the robot has 24 proximity sensors. */
  void SetRobot(CComposableEntity& robot) override;
  /**
   * What a sensor reads, before noise: 1 below 0.99 cm, then falling as 1/distance.
   * @param distance  from the start of its ray to what it met, m, >= 0.
   */
  Real CalculateReading(Real distance) override;
};

}  // namespace argos

#endif
