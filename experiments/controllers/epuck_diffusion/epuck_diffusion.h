#ifndef EPUCK_DIFFUSION_H
#define EPUCK_DIFFUSION_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

/**
 * A random walk with obstacle avoidance for e-pucks; the controller of the benchmark.
 *
 * The robot drives straight on for a random time and then turns by a random angle. Obstacles in
 * front, detected by its eight proximity sensors, make it turn away at once. A step does not
 * allocate, and the robot's own random generator takes 40 bytes.
 */
class CEPuckDiffusion : public argos::CCI_Controller {
 public:
  CEPuckDiffusion();
  /** Reads the optional attributes velocity (cm/s) and mean_free_ticks (ticks, at least 1). */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

 private:
  void PlanStretch();
  void Drive();

  argos::CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  argos::CCI_EPuckProximitySensor* m_proximity = nullptr;
  argos::CRandomStream m_random;
  argos::Real m_velocity = 10.0;  // cm/s
  argos::UInt32 m_meanFreeTicks = 50;
  argos::UInt32 m_ticksLeft = 0;  // of the current straight run or turn
  argos::SInt32 m_turnDirection = 0;  // 1 left, -1 right, 0 straight
};

#endif
