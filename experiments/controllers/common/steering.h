#ifndef STEERING_H
#define STEERING_H

#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

/**
 * Drives a robot with two wheels along a vector.
 *
 * The outer wheel has the requested speed. The inner one slows down with the angle between the
 * vector and the heading; at a right angle or more the robot turns on the spot.
 */
class CSteering {
 public:
  /** @param maxSpeed  of a wheel, cm/s, > 0. @throws CARGoSException if it is out of range. */
  CSteering(argos::CCI_DifferentialSteeringActuator& wheels, argos::Real maxSpeed);

  argos::Real GetMaxSpeed() const { return m_maxSpeed; }
  /** @param velocity  in the robot's frame, cm/s; its length is limited. */
  void Follow(const argos::CVector2& velocity);
  void Stop();

 private:
  argos::CCI_DifferentialSteeringActuator& m_wheels;
  argos::Real m_maxSpeed;  // cm/s
};

#endif
