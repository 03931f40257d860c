#include "steering.h"

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/math/general.h>

using namespace argos;

CSteering::CSteering(CCI_DifferentialSteeringActuator& wheels, Real maxSpeed)
    : m_wheels(wheels), m_maxSpeed(maxSpeed) {
  if (!(maxSpeed > 0.0)) {
    THROW_ARGOSEXCEPTION("the maximum speed is " << maxSpeed << " cm/s; it must be > 0");
  }
}

void CSteering::Follow(const CVector2& velocity) {
  const Real speed = Min(velocity.Length(), m_maxSpeed);
  const CRadians angle = velocity.Angle().SignedNormalize();
  // 0 for straight ahead, 1 for a right angle or more
  const Real turn = Min<Real>(1.0, Abs(angle) / CRadians::PI_OVER_TWO);
  const Real inner = speed * (1.0 - 2.0 * turn);
  if (angle > CRadians::ZERO) {
    m_wheels.SetLinearVelocity(inner, speed);
  } else {
    m_wheels.SetLinearVelocity(speed, inner);
  }
}

void CSteering::Stop() {
  m_wheels.SetLinearVelocity(0.0, 0.0);
}
