#ifndef FOOTBOT_DIFFUSION_H
#define FOOTBOT_DIFFUSION_H

#include <argos3/core/control_interface/changeable_parameters.h>
#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>

/**
 * Drives a foot-bot straight on and turns it away from obstacles detected by its proximity sensors,
 * so that a swarm spreads over the arena.
 *
 * Each of the 24 readings is a vector with the direction of its sensor and the length of its value.
 * Their mean points towards obstacles. The way is free if the mean points backwards, or if it is
 * shorter than delta and within alpha of the heading; otherwise the robot turns away on the spot
 * until the way is free.
 *
 * If the robot has the actuator "leds", they are green while the way is free and orange while it
 * turns.
 */
class CFootBotDiffusion : public argos::CCI_Controller, public argos::CChangeableParameters {
 public:
  /** Reads the optional attributes alpha (degrees), delta (0 to 1) and velocity (cm/s). */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;
  /** In the live view, the speed and delta have sliders. */
  TParameters ListParameters() override;

 private:
  enum class EState { Free, TurningLeft, TurningRight };

  argos::CVector2 SumUpProximity() const;
  void EnterState(EState state);

  argos::CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  argos::CCI_FootBotProximitySensor* m_proximity = nullptr;
  argos::CCI_LEDsActuator* m_leds = nullptr;  // optional

  argos::CRadians m_alpha = argos::ToRadians(argos::CDegrees(7.5));
  argos::Real m_delta = 0.1;
  argos::Real m_velocity = 10.0;  // cm/s
  EState m_state = EState::Free;
};

#endif
