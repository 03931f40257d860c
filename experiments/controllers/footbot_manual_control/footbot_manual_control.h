#ifndef FOOTBOT_MANUAL_CONTROL_H
#define FOOTBOT_MANUAL_CONTROL_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>

/** A foot-bot that drives as it is told between ticks. Its LEDs are yellow while it is selected. */
class CFootBotManualControl : public argos::CCI_Controller {
 public:
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

  /** Speeds of the wheels from the next tick on, cm/s. */
  void SetSpeeds(argos::Real left, argos::Real right);
  /** A robot that is not selected stands. */
  void SetSelected(bool isSelected);

 private:
  argos::CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  argos::CCI_LEDsActuator* m_leds = nullptr;

  bool m_isSelected = false;
  argos::Real m_left = 0.0;  // cm/s
  argos::Real m_right = 0.0;
};

#endif
