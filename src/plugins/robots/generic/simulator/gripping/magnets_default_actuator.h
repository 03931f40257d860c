#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GRIPPING_MAGNETS_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GRIPPING_MAGNETS_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_magnets_actuator.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CMagnetEquippedEntity;

/** Sets the currents of a robot's magnets; see the manual in the source. */
class CMagnetsDefaultActuator : public CSimulatedActuator, public CCI_MagnetsActuator {
 public:
  /** @throws CARGoSException if the robot has no "magnets". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `<noise>`. @throws CARGoSException if a value is out of range. */
  void Init(TConfigurationNode& tree) override;
  /** @throws CARGoSException if a current is not finite. */
  void Update() override;
  /** Sets all currents to 0. */
  void Reset() override;

 private:
  CMagnetEquippedEntity* m_magnets = nullptr;
  CComposableEntity* m_robot = nullptr;
  CDeviceNoise m_noise;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/simulator/entities/magnet_equipped_entity.h>
#endif

#endif
