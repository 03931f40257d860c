#ifndef ARGOS3_TESTING_DETERMINISM_COMMS_SWARM_H
#define ARGOS3_TESTING_DETERMINISM_COMMS_SWARM_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_sensor.h>
#include <argos3/testing/support/experiment.h>

#include <string>

namespace argos {

/**
 * "chatter": sends, writes and deposits data that depend on all readings, and drives towards their
 * sources; so every bit of the readings affects the run.
 */
class CChatter : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;

 private:
  UInt32 Listen(CVector2& way) const;
  void Speak(UInt32 sum);

  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_RangeAndBearingActuator* m_rabActuator = nullptr;
  CCI_RangeAndBearingSensor* m_rabSensor = nullptr;
  CCI_SimpleRadiosActuator* m_radioActuator = nullptr;
  CCI_SimpleRadiosSensor* m_radioSensor = nullptr;
  CCI_RFIDActuator* m_tagActuator = nullptr;
  CCI_RFIDSensor* m_tagSensor = nullptr;
  CCI_PheromoneActuator* m_scentActuator = nullptr;
  const CCI_PheromoneSensor::TReadings* m_scents = nullptr;  // left, right
  bool m_withRadio = true;
  CByteArray m_message;
};

/**
 * Foot-bots and e-pucks, half each, that communicate and lay trails among walls and boxes. The size
 * of the arena is 0.16 m^2 per robot.
 * @param noisy           devices have noise and lose messages.
 * @param mediaAttributes  of all media except pheromones.
 * @param withRadio        robots also send by radio, for which controllers allocate memory.
 */
SExperiment CommsSwarm(UInt32 robots, bool noisy = true, const std::string& mediaAttributes = "",
                       bool withRadio = true);

}  // namespace argos

#endif
