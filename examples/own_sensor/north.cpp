#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

#include "ci_compass_sensor.h"

using namespace argos;

/** Turns a robot to the north and drives on. */
class CNorth : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override {
    m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    m_compass = GetSensor<CCI_CompassSensor>("compass");
  }
  void ControlStep() override {
    const Real turn = 5.0 * m_compass->GetNorth().GetValue();
    m_wheels->SetLinearVelocity(10.0 - turn, 10.0 + turn);
  }

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_CompassSensor* m_compass = nullptr;
};

REGISTER_CONTROLLER(CNorth, "north")
