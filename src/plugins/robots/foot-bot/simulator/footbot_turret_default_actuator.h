#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_TURRET_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_TURRET_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_actuator.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CControllableEntity;
class CTurretEntity;

/** Rotates the turret of a foot-bot; see the manual in the source. */
class CFootBotTurretDefaultActuator : public CSimulatedActuator, public CCI_FootBotTurretActuator {
 public:
  /** @throws CARGoSException if the robot has no "turret" or "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  /** @throws CARGoSException if it is not finite. */
  void SetRotation(const CRadians& angle) override;
  void SetRotationSpeed(SInt32 pulses) override;
  void SetMode(ETurretModes mode) override;
  void Update() override;
  /** Switches the motor off and sets all targets to 0. */
  void Reset() override;

 private:
  CTurretEntity* m_turret = nullptr;
  const CControllableEntity* m_robot = nullptr;
  ETurretModes m_mode = MODE_OFF;
  CRadians m_rotation;  // applied rotation, with noise
  Real m_speed = 0.0;  // rad/s
  CDeviceNoise m_noise;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_turret_entity.h>
#endif

#endif
