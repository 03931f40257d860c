#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LEDS_DIRECTIONAL_LEDS_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LEDS_DIRECTIONAL_LEDS_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_directional_leds_actuator.h>

namespace argos {

class CDirectionalLEDEquippedEntity;

/** Sets the colours of a robot's directional LEDs. */
class CDirectionalLEDsDefaultActuator : public CSimulatedActuator,
                                        public CCI_DirectionalLEDsActuator {
 public:
  /** @throws CARGoSException if the robot has no "directional_leds". */
  void SetRobot(CComposableEntity& robot) override;
  void Update() override;
  /** Restores the initial colours. */
  void Reset() override;

 private:
  CDirectionalLEDEquippedEntity* m_leds = nullptr;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>
#endif

#endif
