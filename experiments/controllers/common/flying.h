#ifndef FLYING_H
#define FLYING_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_position_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

/** Flies a robot along a velocity vector, by means of an actuator for positions. */
class CFlying {
 public:
  /** @param maxSpeed  m/s, > 0. @throws CARGoSException if it is out of range. */
  CFlying(argos::CCI_QuadRotorPositionActuator& propellers, argos::Real maxSpeed);

  /** Call it once per step. @param velocity  in the robot's frame, m/s; its length is limited. */
  void Follow(const argos::CVector3& velocity);

 private:
  argos::CCI_QuadRotorPositionActuator& m_propellers;
  argos::Real m_maxSpeed;  // m/s
};

/** Vector from the robot to the sender of a message, in the robot's frame, m. */
argos::CVector3 PlaceOf(const argos::CCI_RangeAndBearingSensor::SPacket& packet);

#endif
