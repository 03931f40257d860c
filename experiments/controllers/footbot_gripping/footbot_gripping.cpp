#include "footbot_gripping.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

using namespace argos;

void CFootBotGripping::Init(TConfigurationNode& params) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_gripper = GetActuator<CCI_FootBotGripperActuator>("footbot_gripper");
  GetNodeAttributeOrDefault(params, "velocity", m_velocity, m_velocity);
  GetNodeAttributeOrDefault(params, "phase_ticks", m_phaseTicks, m_phaseTicks);
  if (m_phaseTicks == 0) {
    THROW_ARGOSEXCEPTION("phase_ticks is 0; it must be > 0");
  }
  Reset();
}

void CFootBotGripping::Reset() {
  m_tick = 0;
}

void CFootBotGripping::ControlStep() {
  switch (m_tick++ / m_phaseTicks) {
    case 0:  // drive into the object with the gripper unlocked
      m_gripper->LockPositive();
      m_wheels->SetLinearVelocity(m_velocity, m_velocity);
      break;
    case 1:  // grip it and drag it back
      m_wheels->SetLinearVelocity(-m_velocity, -m_velocity);
      break;
    case 2:  // turn with it
      m_wheels->SetLinearVelocity(-m_velocity, m_velocity);
      break;
    default:  // release it and drive away
      m_gripper->Unlock();
      m_wheels->SetLinearVelocity(-m_velocity, -m_velocity);
      break;
  }
}

REGISTER_CONTROLLER(CFootBotGripping, "footbot_gripping_controller")
