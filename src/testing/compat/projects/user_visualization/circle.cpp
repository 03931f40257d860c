#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

/* Drives in a circle. */
class CCircle : public argos::CCI_Controller {
 public:
  CCircle() : m_pcWheels(NULL), m_fLeft(0.0), m_fRight(0.0) {}
  virtual void Init(argos::TConfigurationNode& t_node) {
    m_pcWheels = GetActuator<argos::CCI_DifferentialSteeringActuator>("differential_steering");
    argos::GetNodeAttribute(t_node, "left", m_fLeft);
    argos::GetNodeAttribute(t_node, "right", m_fRight);
  }
  virtual void ControlStep() { m_pcWheels->SetLinearVelocity(m_fLeft, m_fRight); }

 private:
  argos::CCI_DifferentialSteeringActuator* m_pcWheels;
  argos::Real m_fLeft;
  argos::Real m_fRight;
};

REGISTER_CONTROLLER(CCircle, "circle")
