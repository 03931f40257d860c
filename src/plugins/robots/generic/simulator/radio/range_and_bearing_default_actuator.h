#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_RANGE_AND_BEARING_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_RANGE_AND_BEARING_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>

namespace argos {

class CControllableEntity;
class CRABEquippedEntity;

/** Passes the message to the robot's range-and-bearing device, and adds the device to a medium. */
class CRangeAndBearingDefaultActuator : public CSimulatedActuator,
                                        public CCI_RangeAndBearingActuator {
 public:
  /** @throws CARGoSException if the robot has no "rab". */
  void SetRobot(CComposableEntity& robot) override;
  /**
   * Selects the medium: the optional `medium`, else that of the robot's sensor, else the only one.
   * @throws CARGoSException if there are several, or the id is unknown.
   */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Sets all bytes to 0. */
  void Reset() override;

 private:
  void SelectMedium(TConfigurationNode& tree);

  CControllableEntity* m_robot = nullptr;
  CRABEquippedEntity* m_rab = nullptr;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#endif

#endif
