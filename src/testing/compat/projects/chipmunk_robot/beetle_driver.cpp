#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>

using namespace argos;

/* Drives at constant speeds, and prints where the robot is. */
class CBeetleDriver : public CCI_Controller {
 public:
  virtual void Init(TConfigurationNode& t_node) {
    m_pcWheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    m_pcPosition = GetSensor<CCI_PositioningSensor>("positioning");
    GetNodeAttribute(t_node, "left", m_fLeft);
    GetNodeAttribute(t_node, "right", m_fRight);
  }

  virtual void ControlStep() {
    m_pcWheels->SetLinearVelocity(m_fLeft, m_fRight);
    const CVector3& cPosition = m_pcPosition->GetReading().Position;
    LOG << "position_of_" << GetId() << " " << cPosition.GetX() << " " << cPosition.GetY()
        << std::endl;
  }

 private:
  CCI_DifferentialSteeringActuator* m_pcWheels;
  CCI_PositioningSensor* m_pcPosition;
  Real m_fLeft, m_fRight;
};

REGISTER_CONTROLLER(CBeetleDriver, "beetle_driver");
