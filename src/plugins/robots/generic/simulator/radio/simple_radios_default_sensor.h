#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_SIMPLE_RADIOS_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_SIMPLE_RADIOS_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_sensor.h>

namespace argos {

class CControllableEntity;
class CSimpleRadioEquippedEntity;

/** Reads the messages that the robot's radios have received. */
class CSimpleRadiosDefaultSensor : public CSimulatedSensor, public CCI_SimpleRadiosSensor {
 public:
  /** @throws CARGoSException if the robot has no "simple_radios". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `show_rays`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Clears the messages. */
  void Reset() override;

  bool IsShowRays() const { return m_bShowRays; }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_bShowRays = show; }

 private:
  CControllableEntity* m_robot = nullptr;
  CSimpleRadioEquippedEntity* m_radios = nullptr;
  bool m_bShowRays = false;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>
#endif

#endif
