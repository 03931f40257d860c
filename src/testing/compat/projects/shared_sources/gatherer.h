#ifndef GATHERER_H
#define GATHERER_H

#include <argos3/core/control_interface/ci_controller.h>

#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

class CField;

class CGatherer : public argos::CCI_Controller {
 public:
  void Init(argos::TConfigurationNode& tree) override;
  void ControlStep() override;
  void SetField(CField& cField) { m_pcField = &cField; }

 private:
  argos::CCI_DifferentialSteeringActuator* m_pcWheels = nullptr;
  CField* m_pcField = nullptr;
};

#endif
