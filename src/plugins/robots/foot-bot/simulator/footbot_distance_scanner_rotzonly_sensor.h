#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_DISTANCE_SCANNER_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_DISTANCE_SCANNER_ROTZONLY_SENSOR_H

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noisy_sensor.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>

namespace argos {

class CFootBotDistanceScannerEquippedEntity;

/** The heads of the foot-bot's distance scanner. */
class CFootBotDistanceScannerRotZOnlySensor
    : public CNoisySensor<CCI_FootBotDistanceScannerSensor> {
 public:
  void Update() override;

  bool IsShowRays() const { return m_showRays; }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_showRays = show; }

 private:
  void FindParts(CComposableEntity& robot) override;
  /** Also reads `show_rays`, `noise_range` (cm). */
  void Configure(TConfigurationNode& tree) override;
  void ResetReading() override;
  void AddBeams(const CRadians& scanner);
  void Cast();
  // converts a fraction of a range that ends at maximum (m) to cm
  Real ToReading(Real fraction, Real minimum, Real maximum);

  CFootBotDistanceScannerEquippedEntity* m_scanner = nullptr;
  CRayCaster m_caster;
  bool m_showRays = false;
  // readings of one tick; members to keep their memory allocated
  TReadings m_shortReadings;
  TReadings m_longReadings;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/robots/foot-bot/simulator/footbot_distance_scanner_equipped_entity.h>
#endif

#endif
