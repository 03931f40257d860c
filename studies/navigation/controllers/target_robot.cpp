#include "target_robot.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

using namespace argos;

void CTargetRobot::Init(TConfigurationNode& params) {
  m_sender = GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing");
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
  GetNodeAttribute(params, "target", m_target);
  if (m_target >= kNumTargets) {
    THROW_ARGOSEXCEPTION("target is " << m_target << "; it must be 0 or 1");
  }
}

void CTargetRobot::ControlStep() {
  ++m_table[m_target].Sequence;
  m_sender->SetData(m_table.ToMessage());
  m_leds->SetAllColors(m_target == 0 ? CColor::RED : CColor::BLUE);
}

void CTargetRobot::Reset() {
  m_table = CTargetTable();
}

REGISTER_CONTROLLER(CTargetRobot, "target_robot")
