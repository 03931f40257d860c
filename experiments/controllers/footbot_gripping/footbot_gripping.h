#ifndef FOOTBOT_GRIPPING_H
#define FOOTBOT_GRIPPING_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

/**
 * A foot-bot that drives into the object ahead, grips it, drags it back, turns with it, releases
 * it, and drives away.
 */
class CFootBotGripping : public argos::CCI_Controller {
 public:
  /** Reads the optional attributes velocity (cm/s) and phase_ticks (length of each phase, > 0). */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

 private:
  argos::CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  argos::CCI_FootBotGripperActuator* m_gripper = nullptr;

  argos::Real m_velocity = 5.0;  // cm/s
  argos::UInt64 m_phaseTicks = 60;
  argos::UInt64 m_tick = 0;
};

#endif
