#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_encoder_sensor.h>

namespace argos {

const CRange<CRadians> CCI_FootBotTurretEncoderSensor::ANGULAR_RANGE(-CRadians::PI, CRadians::PI);

void CCI_FootBotTurretEncoderSensor::ListNumbers(CNumberList& list) const {
  list.Add("rotation", "rad", m_cRotation.GetValue());
}

}  // namespace argos
