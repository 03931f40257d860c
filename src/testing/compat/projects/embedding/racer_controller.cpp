#include "racer_controller.h"

void CRacerController::Init(TConfigurationNode& t_node) {
  m_pcWheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
}

void CRacerController::ControlStep() {
  m_pcWheels->SetLinearVelocity(m_fLeft, m_fRight);
}

REGISTER_CONTROLLER(CRacerController, "racer_controller")
