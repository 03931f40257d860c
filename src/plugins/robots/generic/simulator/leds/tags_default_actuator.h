#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LEDS_TAGS_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LEDS_TAGS_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_tags_actuator.h>

namespace argos {

class CTagEquippedEntity;

/** Sets the payloads of a robot's tags. */
class CTagsDefaultActuator : public CSimulatedActuator, public CCI_TagsActuator {
 public:
  /** @throws CARGoSException if the robot has no "tags". */
  void SetRobot(CComposableEntity& robot) override;
  void Update() override;
  /** Restores the initial payloads. */
  void Reset() override;

 private:
  TSettings m_initSettings;
  CTagEquippedEntity* m_tags = nullptr;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/simulator/entities/tag_equipped_entity.h>
#endif

#endif
