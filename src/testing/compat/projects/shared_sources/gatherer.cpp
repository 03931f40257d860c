#include "gatherer.h"

#include "field.h"
#include "parameters.h"

#include <argos3/core/simulator/simulator.h>

using namespace argos;

void CGatherer::Init(TConfigurationNode&) {
  m_pcWheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
}

void CGatherer::ControlStep() {
  m_pcWheels->SetLinearVelocity(kSpeed, kSpeed);
  // the loop functions that the simulator has are those that were told to this controller
  CField& cField = dynamic_cast<CField&>(CSimulator::GetInstance().GetLoopFunctions());
  if (&cField == m_pcField) {
    cField.Report();
  }
}

REGISTER_CONTROLLER(CGatherer, "gatherer")
