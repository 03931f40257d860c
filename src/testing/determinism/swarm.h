#ifndef ARGOS3_TESTING_DETERMINISM_SWARM_H
#define ARGOS3_TESTING_DETERMINISM_SWARM_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/testing/support/experiment.h>

namespace argos {

/**
 * "walker": a random walk with LEDs that show its state; every device
 * has noise if it supports noise.
 */
class CWalker : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

 private:
  Real SumUp(bool left) const;

  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_LEDsActuator* m_leds = nullptr;
  CCI_FootBotProximitySensor* m_footBotEyes = nullptr;
  CCI_EPuckProximitySensor* m_ePuckEyes = nullptr;
  CRandom::CRNG* m_random = nullptr;
  UInt32 m_turnTicks = 0;
  Real m_turn = 0.0;
};

/**
 * Foot-bots and e-pucks, half each, that walk among walls, boxes and cylinders, fixed and movable.
 * The size of the arena is 0.16 m^2 per robot.
 * @param enginesPerSide  1, or 2 for four engines side by side.
 * @param withLEDs        the robots light their LEDs.
 * @param engine          the type of the engines.
 */
SExperiment Swarm(UInt32 robots, UInt32 enginesPerSide = 1, bool withLEDs = true,
                  const std::string& engine = "dynamics2d");

}  // namespace argos

#endif
