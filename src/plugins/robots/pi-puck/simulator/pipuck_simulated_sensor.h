#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_SIMULATED_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_SIMULATED_SENSOR_H

#include <argos3/core/simulator/sensor.h>

#include <functional>
#include <vector>

namespace argos {

struct SAnchor;

/** Base of the Pi-Puck's sensors that have several readings, each with a label. */
template <typename CONTROL_INTERFACE>
class CPiPuckSimulatedSensor : public CSimulatedSensor, public CONTROL_INTERFACE {
 public:
  using SInterface = typename CONTROL_INTERFACE::SInterface;

  CPiPuckSimulatedSensor() {
    m_interfaces.reserve(CONTROL_INTERFACE::MAP_SENSOR_CONFIG.size());
    for (const auto& sensor : CONTROL_INTERFACE::MAP_SENSOR_CONFIG) {
      m_interfaces.emplace_back(sensor.first);
    }
  }

  /** Reads `show_rays`. */
  void Init(TConfigurationNode& tree) override {
    CONTROL_INTERFACE::Init(tree);
    GetNodeAttributeOrDefault(tree, "show_rays", m_bShowRays, m_bShowRays);
    this->Enable();
  }
  void Visit(std::function<void(const SInterface&)> visit) override {
    for (const SInterface& interface : m_interfaces) {
      visit(interface);
    }
  }

  bool IsShowRays() const { return m_bShowRays; }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_bShowRays = show; }

 protected:
  const SAnchor* m_anchor = nullptr;  // holds all sensors
  std::vector<SInterface> m_interfaces;  // ordered by label
  bool m_bShowRays = false;
};

}  // namespace argos

#endif
