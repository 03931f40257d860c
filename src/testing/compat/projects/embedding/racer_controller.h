#ifndef RACER_CONTROLLER_H
#define RACER_CONTROLLER_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

using namespace argos;

/* Sets the wheels to the two values of its genome, in cm/s. */
class CRacerController : public CCI_Controller {
 public:
  CRacerController() : m_pcWheels(NULL), m_fLeft(0.0), m_fRight(0.0) {}
  virtual ~CRacerController() {}
  virtual void Init(TConfigurationNode& t_node);
  virtual void ControlStep();
  void SetGenome(const Real* pf_genome) {
    m_fLeft = pf_genome[0];
    m_fRight = pf_genome[1];
  }

 private:
  CCI_DifferentialSteeringActuator* m_pcWheels;
  Real m_fLeft;
  Real m_fRight;
};

#endif
