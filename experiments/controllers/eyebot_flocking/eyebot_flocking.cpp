#include "eyebot_flocking.h"

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/vector2.h>

#include <cmath>

using namespace argos;

namespace {

constexpr UInt32 kTakeOffSteps = 30;  // an eye-bot reaches a new height in 1.6 s
// radius of the neighbourhood, in target distances
constexpr Real kReach = 1.8;
constexpr Real kClimb = 0.2;  // gain of the height error, 1/s

void ReadPositive(TConfigurationNode& params, const std::string& name, Real& value) {
  GetNodeAttributeOrDefault(params, name, value, value);
  if (!(value > 0.0)) {
    THROW_ARGOSEXCEPTION(name << " is " << value << "; it must be > 0");
  }
}

}  // namespace

void CEyeBotFlocking::Init(TConfigurationNode& params) {
  m_propellers = GetActuator<CCI_QuadRotorPositionActuator>("quadrotor_position");
  m_ears = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
  m_light = GetSensor<CCI_EyeBotLightSensor>("eyebot_light");
  if (HasActuator("leds")) {
    m_leds = GetActuator<CCI_LEDsActuator>("leds");
  }
  Real maxSpeed = 0.3;
  ReadPositive(params, "height", m_height);
  ReadPositive(params, "max_speed", maxSpeed);
  ReadPositive(params, "target_distance", m_targetDistance);
  ReadPositive(params, "gain", m_gain);
  ReadPositive(params, "light_speed", m_lightSpeed);
  m_flying = std::make_unique<CFlying>(*m_propellers, maxSpeed);
  Reset();
}

void CEyeBotFlocking::Reset() {
  m_step = 0;
  if (m_leds != nullptr) {
    m_leds->SetAllColors(CColor::GREEN);
  }
}

void CEyeBotFlocking::ControlStep() {
  ++m_step;
  if (m_step == 1) {
    m_propellers->SetRelativePosition(CVector3(0.0, 0.0, m_height));
  } else if (m_step > kTakeOffSteps) {
    m_flying->Follow(VectorToLight() + FlockingVector());
  }
}

CVector3 CEyeBotFlocking::VectorToLight() const {
  CVector2 sum;
  for (const CCI_EyeBotLightSensor::SReading& reading : m_light->GetReadings()) {
    sum += CVector2(reading.Value, reading.Angle);
  }
  if (sum.Length() == 0.0) {
    return CVector3();
  }
  const CVector2 velocity(m_lightSpeed, sum.Angle());
  return CVector3(velocity.GetX(), velocity.GetY(), 0.0);
}

CVector3 CEyeBotFlocking::FlockingVector() const {
  CVector3 sum;
  Real numHeard = 0.0;
  Real climb = 0.0;
  for (const CCI_RangeAndBearingSensor::SPacket& packet : m_ears->GetReadings()) {
    const CVector3 other = PlaceOf(packet);
    const Real distance = std::hypot(other.GetX(), other.GetY());
    if (distance == 0.0 || distance > kReach * m_targetDistance) {
      continue;
    }
    const Real ratio = m_targetDistance / distance;
    const Real repulsion = m_gain / distance * (std::pow(ratio, 4) - std::pow(ratio, 2));
    sum -= CVector3(other.GetX(), other.GetY(), 0.0) * (repulsion / distance);
    climb += other.GetZ();
    numHeard += 1.0;
  }
  if (numHeard > 0.0) {
    sum.SetZ(kClimb * climb / numHeard);
  }
  return sum;
}

REGISTER_CONTROLLER(CEyeBotFlocking, "eyebot_flocking_controller")
