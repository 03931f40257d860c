#include <argos3/plugins/robots/foot-bot/simulator/footbot_turret_encoder_default_sensor.h>

#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>

namespace argos {

void CFootBotTurretEncoderDefaultSensor::FindParts(CComposableEntity& robot) {
  m_turret = &robot.GetComponent<CTurretEntity>("turret");
}

void CFootBotTurretEncoderDefaultSensor::Configure(TConfigurationNode& tree) {
  m_noise.Init(tree, *m_robot, {"rotation"});
}

void CFootBotTurretEncoderDefaultSensor::Update() {
  m_cRotation = CRadians(m_noise.Apply(0, m_turret->GetRotation().GetValue()));
  if (m_noise.IsOn()) {
    m_cRotation.SignedNormalize();
  }
}

void CFootBotTurretEncoderDefaultSensor::ResetReading() {
  m_cRotation = CRadians::ZERO;
}

REGISTER_SENSOR(
    CFootBotTurretEncoderDefaultSensor, "footbot_turret_encoder", "default",
    "the authors of this project", "1.0", "The rotation of the foot-bot's turret.",
    R"(Reads the rotation of the turret on the base, in rad, in (-pi,pi], counter-clockwise from straight ahead, in
every mode of the turret, and exactly without noise.
)" + RequiredSensorXML(R"(<footbot_turret_encoder implementation="default" />)") +
        OptionalNoiseXML("footbot_turret_encoder",
                         R"(on="rotation" model="gaussian" std_dev="0.01")") +
        NoiseManual("rotation",
                    "the rotation (rad) in each tick; the reading is normalized to (-pi,pi]."),
    "Usable")

}  // namespace argos
