#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_GROUND_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_GROUND_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_ground_sensor.h>

#include <vector>

namespace argos {

class CControllableEntity;
struct SAnchor;

/** Reads the floor below the front of a Pi-Puck. */
class CPiPuckGroundDefaultSensor : public CSimulatedSensor, public CCI_PiPuckGroundSensor {
 public:
  CPiPuckGroundDefaultSensor();

  /** @throws CARGoSException if the robot is no Pi-Puck. */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `show_rays`. @throws CARGoSException after loading, if there is no floor. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Sets all readings to 0. */
  void Reset() override;
  void Visit(std::function<void(const SInterface&)> visit) override;

  bool IsShowRays() const { return m_bShowRays; }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_bShowRays = show; }

 private:
  const SAnchor* m_anchor = nullptr;  // of all sensors
  CControllableEntity* m_robot = nullptr;
  std::vector<SInterface> m_interfaces;
  bool m_bShowRays = false;
};

}  // namespace argos

#endif
