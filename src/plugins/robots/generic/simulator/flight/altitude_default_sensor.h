#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_ALTITUDE_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_ALTITUDE_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_altitude_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>

namespace argos {

/**
 * How high a robot is: a range finder that looks straight down from the centre of its base, at the
 * highest body below, or the ground at height 0.
 */
class CAltitudeDefaultSensor : public CSimulatedSensor, public CCI_AltitudeSensor {
 public:
  /** @throws CARGoSException if the robot has no "body" or "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `show_rays` and `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

 private:
  CRayCaster m_caster;
  bool m_showRays = false;
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
