#ifndef ARGOS3_TESTING_DETERMINISM_COMMS_SWARM_H
#define ARGOS3_TESTING_DETERMINISM_COMMS_SWARM_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/testing/support/experiment.h>

#include <string>

namespace argos {

/** "chatter": says what it hears, and goes where that comes from; so every bit of it matters. */
class CChatter : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_RangeAndBearingActuator* m_rabActuator = nullptr;
  CCI_RangeAndBearingSensor* m_rabSensor = nullptr;
};

/**
 * Foot-bots and e-pucks, half each, that chatter among walls and boxes. The arena grows with their
 * number: one robot on 0.16 m^2.
 * @param noisy           devices have noise, and lose messages.
 * @param rabAttributes  of the medium for range and bearing.
 */
SExperiment CommsSwarm(UInt32 robots, bool noisy = true, const std::string& rabAttributes = "");

}  // namespace argos

#endif
