#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_SIMPLE_RADIOS_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_SIMPLE_RADIOS_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_actuator.h>

namespace argos {

class CSimpleRadioEquippedEntity;

/** Passes messages to the robot's radios, which send them. */
class CSimpleRadiosDefaultActuator : public CSimulatedActuator, public CCI_SimpleRadiosActuator {
 public:
  /** @throws CARGoSException if the robot has no "simple_radios". */
  void SetRobot(CComposableEntity& robot) override;
  void Update() override;
  /** Discards messages that are not sent yet. */
  void Reset() override;

 private:
  CSimpleRadioEquippedEntity* m_radios = nullptr;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>
#include <argos3/plugins/simulator/media/simple_radio_medium.h>
#endif

#endif
