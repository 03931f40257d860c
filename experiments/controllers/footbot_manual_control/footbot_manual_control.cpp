#include "footbot_manual_control.h"

using namespace argos;

void CFootBotManualControl::Init(TConfigurationNode&) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
}

void CFootBotManualControl::Reset() {
  m_left = m_right = 0.0;
}

void CFootBotManualControl::ControlStep() {
  m_wheels->SetLinearVelocity(m_left, m_right);
  m_leds->SetAllColors(m_isSelected ? CColor::YELLOW : CColor::BLACK);
}

void CFootBotManualControl::SetSpeeds(Real left, Real right) {
  m_left = left;
  m_right = right;
}

void CFootBotManualControl::SetSelected(bool isSelected) {
  m_isSelected = isSelected;
  SetSpeeds(0.0, 0.0);
}

REGISTER_CONTROLLER(CFootBotManualControl, "footbot_manual_control_controller")
