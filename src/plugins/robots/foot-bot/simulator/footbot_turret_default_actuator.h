#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_TURRET_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_TURRET_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_actuator.h>

namespace argos {

class CTurretEntity;

/** Turns the turret of a foot-bot; see its long description. */
class CFootBotTurretDefaultActuator : public CSimulatedActuator, public CCI_FootBotTurretActuator {
 public:
  /** @throws CARGoSException unless the robot has a "turret". */
  void SetRobot(CComposableEntity& robot) override;
  /** @throws CARGoSException if it is not finite. */
  void SetRotation(const CRadians& angle) override;
  void SetRotationSpeed(SInt32 pulses) override;
  void SetMode(ETurretModes mode) override;
  void Update() override;
  /** Off; all targets are zero. */
  void Reset() override;

 private:
  CTurretEntity* m_turret = nullptr;  // of the robot
  ETurretModes m_mode = MODE_OFF;
  CRadians m_rotation;
  CRadians m_speed;  // per s
};

}  // namespace argos

#endif
