#include "eyebot_circle.h"

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/vector2.h>

#include <algorithm>

using namespace argos;

namespace {

constexpr Real kCorrection = 2.0;  // gain of the radius and height errors, 1/s
constexpr Real kTurnShare = 0.3;  // share of the bearing of the other robot turned per step
// below this share of its height the robot only climbs
constexpr Real kLow = 0.5;

void ReadPositive(TConfigurationNode& params, const std::string& name, Real& value) {
  GetNodeAttributeOrDefault(params, name, value, value);
  if (!(value > 0.0)) {
    THROW_ARGOSEXCEPTION(name << " is " << value << "; it must be > 0");
  }
}

}  // namespace

void CEyeBotCircle::Init(TConfigurationNode& params) {
  m_propellers = GetActuator<CCI_QuadRotorPositionActuator>("quadrotor_position");
  m_ears = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
  if (HasActuator("leds")) {
    m_leds = GetActuator<CCI_LEDsActuator>("leds");
  }
  ReadPositive(params, "height", m_height);
  ReadPositive(params, "radius", m_radius);
  ReadPositive(params, "speed", m_speed);
  m_flying = std::make_unique<CFlying>(*m_propellers, 2.0 * m_speed);
  Reset();
}

void CEyeBotCircle::Reset() {
  if (m_leds != nullptr) {
    m_leds->SetAllColors(CColor::BLUE);
  }
}

void CEyeBotCircle::ControlStep() {
  const CCI_RangeAndBearingSensor::TReadings& packets = m_ears->GetReadings();
  if (packets.empty()) {
    m_flying->Follow(CVector3());
    return;
  }
  const auto& nearest =
      *std::min_element(packets.begin(), packets.end(),
                        [](const auto& a, const auto& b) { return a.Range < b.Range; });
  m_flying->Follow(ComputeVelocity(PlaceOf(nearest)));
  // turn towards the other robot
  m_propellers->SetRelativeYaw(nearest.HorizontalBearing * kTurnShare);
}

CVector3 CEyeBotCircle::ComputeVelocity(const CVector3& other) const {
  const Real climb = kCorrection * (m_height + other.GetZ());
  if (-other.GetZ() < kLow * m_height) {
    return CVector3(0.0, 0.0, climb);
  }
  CVector2 outward(-other.GetX(), -other.GetY());
  const Real distance = outward.Length();
  // directly above the other robot any direction is outward
  outward = distance > 0.0 ? outward / distance : CVector2(1.0, 0.0);
  const CVector2 along(-outward.GetY(), outward.GetX());
  const CVector2 velocity = along * m_speed + outward * (kCorrection * (m_radius - distance));
  return CVector3(velocity.GetX(), velocity.GetY(), climb);
}

REGISTER_CONTROLLER(CEyeBotCircle, "eyebot_circle_controller")
