#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_RANGEFINDERS_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_RANGEFINDERS_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_rangefinders_sensor.h>

#include <vector>

namespace argos {

/** Casts the rays of the range sensors of a Pi-Puck. */
class CPiPuckRangefindersDefaultSensor : public CSimulatedSensor,
                                         public CCI_PiPuckRangefindersSensor {
 public:
  CPiPuckRangefindersDefaultSensor();

  /** @throws CARGoSException if the robot is no Pi-Puck. */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `show_rays`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Sets all readings to the range. */
  void Reset() override;
  void Visit(std::function<void(const SInterface&)> visit) override;

  bool IsShowRays() const { return m_bShowRays; }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_bShowRays = show; }

 private:
  CRayCaster m_caster;
  const SAnchor* m_anchor = nullptr;  // of all sensors
  std::vector<SInterface> m_interfaces;
  bool m_bShowRays = false;
};

}  // namespace argos

#endif
