#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_DISTANCE_SCANNER_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_DISTANCE_SCANNER_ROTZONLY_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>

namespace argos {

class CFootBotDistanceScannerEquippedEntity;

/** The heads of the foot-bot's distance scanner. */
class CFootBotDistanceScannerRotZOnlySensor : public CSimulatedSensor,
                                              public CCI_FootBotDistanceScannerSensor {
 public:
  /** @throws CARGoSException if the robot has no "distance_scanner", "body" or "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `show_rays`, `noise_range` (cm), and `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

 private:
  void AddBeams(const CRadians& scanner);
  void Cast();
  // converts a fraction of a range that ends at maximum (m) to cm
  Real ToReading(Real fraction, Real minimum, Real maximum);

  CFootBotDistanceScannerEquippedEntity* m_scanner = nullptr;  // of the robot
  CRayCaster m_caster;
  CDeviceNoise m_noise;
  bool m_showRays = false;
  // readings of one tick; members to keep their memory allocated
  TReadings m_shortReadings;
  TReadings m_longReadings;
};

}  // namespace argos

#endif
