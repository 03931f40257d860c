#include "flying.h"

#include <argos3/core/utility/configuration/argos_exception.h>

using namespace argos;

namespace {

// s; an eye-bot whose target is d ahead in each step of 0.1 s flies at d / 0.55 s: then its
// controllers, with 20 N/m and 10 N s/m, exert no force on average
constexpr Real kLead = 0.55;
constexpr Real kMetersPerCentimeter = 0.01;

}  // namespace

CFlying::CFlying(CCI_QuadRotorPositionActuator& propellers, Real maxSpeed)
    : m_propellers(propellers), m_maxSpeed(maxSpeed) {
  if (!(maxSpeed > 0.0)) {
    THROW_ARGOSEXCEPTION("the maximum speed is " << maxSpeed << " m/s; it must be > 0");
  }
}

void CFlying::Follow(const CVector3& velocity) {
  const Real speed = velocity.Length();
  const Real share = speed > m_maxSpeed ? m_maxSpeed / speed : 1.0;
  m_propellers.SetRelativePosition(velocity * (share * kLead));
}

CVector3 PlaceOf(const CCI_RangeAndBearingSensor::SPacket& packet) {
  const Real range = packet.Range * kMetersPerCentimeter;
  const Real onPlane = range * Cos(packet.VerticalBearing);
  return CVector3(onPlane * Cos(packet.HorizontalBearing), onPlane * Sin(packet.HorizontalBearing),
                  range * Sin(packet.VerticalBearing));
}
