#include <argos3/plugins/robots/foot-bot/simulator/footbot_turret_encoder_default_sensor.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>

namespace argos {

void CFootBotTurretEncoderDefaultSensor::SetRobot(CComposableEntity& robot) {
  m_turret = &robot.GetComponent<CTurretEntity>("turret");
}

void CFootBotTurretEncoderDefaultSensor::Init(TConfigurationNode& tree) {
  CCI_FootBotTurretEncoderSensor::Init(tree);
  Enable();
}

void CFootBotTurretEncoderDefaultSensor::Update() {
  m_cRotation = m_turret->GetRotation();
}

void CFootBotTurretEncoderDefaultSensor::Reset() {
  m_cRotation = CRadians::ZERO;
}

REGISTER_SENSOR(
    CFootBotTurretEncoderDefaultSensor, "footbot_turret_encoder", "default",
    "the authors of this project", "1.0", "Where the turret of the foot-bot points.",
    R"(Reads the rotation of the turret on the base, in rad, in (-pi,pi], counter-clockwise from straight ahead;
exactly, and in every mode of the turret.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <footbot_turret_encoder implementation="default" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

  None.
)",
    "Usable")

}  // namespace argos
