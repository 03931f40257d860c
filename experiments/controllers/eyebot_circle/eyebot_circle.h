#ifndef EYEBOT_CIRCLE_H
#define EYEBOT_CIRCLE_H

#include "../common/flying.h"

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>

#include <memory>

/**
 * An eye-bot that takes off and circles above the nearest robot that it receives messages from,
 * also if that robot moves.
 *
 * It uses only range and bearing of these messages. Without messages it hovers.
 */
class CEyeBotCircle : public argos::CCI_Controller {
 public:
  /** Reads the optional attributes height, radius (m), and speed (m/s), all > 0. */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

 private:
  /** @param other  vector from this robot to the other one, in this robot's frame, m. */
  argos::CVector3 ComputeVelocity(const argos::CVector3& other) const;

  argos::CCI_QuadRotorPositionActuator* m_propellers = nullptr;
  argos::CCI_RangeAndBearingSensor* m_ears = nullptr;
  argos::CCI_LEDsActuator* m_leds = nullptr;  // null without such an actuator
  std::unique_ptr<CFlying> m_flying;

  argos::Real m_height = 1.5;  // above the other's antenna, m
  argos::Real m_radius = 0.75;  // of the circle, m
  argos::Real m_speed = 0.4;  // along the circle, m/s
};

#endif
