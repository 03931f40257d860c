#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LEDS_LEDS_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LEDS_LEDS_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>

namespace argos {

class CLEDEquippedEntity;

/** Sets the colours of a robot's LEDs, and adds them to a medium so that cameras detect them. */
class CLEDsDefaultActuator : public CSimulatedActuator, public CCI_LEDsActuator {
 public:
  /** @throws CARGoSException if the robot has no "leds". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `medium`. @throws CARGoSException if the LED medium is unknown. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Switches all LEDs off. */
  void Reset() override;

 private:
  CComposableEntity* m_robot = nullptr;
  CLEDEquippedEntity* m_leds = nullptr;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#endif

#endif
