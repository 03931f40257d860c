#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

#include <numbers>

/** Turns on the spot: 5.3 cm between the wheels, so pi * 5.3 / 20 cm/s on each is half a turn in 10
 * s. */
class CSpin : public argos::CCI_Controller {
 public:
  void Init(argos::TConfigurationNode& /*tree*/) override {
    m_wheels = GetActuator<argos::CCI_DifferentialSteeringActuator>("differential_steering");
  }
  void ControlStep() override {
    m_wheels->SetLinearVelocity(-std::numbers::pi * 5.3 / 20, std::numbers::pi * 5.3 / 20);
  }

 private:
  argos::CCI_DifferentialSteeringActuator* m_wheels = nullptr;
};

REGISTER_CONTROLLER(CSpin, "spin")
