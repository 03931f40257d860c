#ifndef ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_PROXIMITY_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_PROXIMITY_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/simulator/angular_proximity_sensor.h>

namespace argos {

/** The eye-bot's proximity sensors, with the response of the real ones. */
class CEyeBotProximityDefaultSensor : public CAngularProximitySensor<CCI_EyeBotProximitySensor> {
 public:
  /** @throws CARGoSException unless the robot has 24 proximity sensors. */
  void SetRobot(CComposableEntity& robot) override;
  /**
   * What a sensor reads, before noise; see ComputeSwarmanoidProximity().
   * @param distance  from the start of its ray to what it met, m, >= 0.
   */
  Real CalculateReading(Real distance) override;
};

}  // namespace argos

#endif
