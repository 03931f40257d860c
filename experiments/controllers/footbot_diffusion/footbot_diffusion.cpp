#include "footbot_diffusion.h"

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/general.h>

using namespace argos;

namespace {

// larger than a right angle: a robot leaves a wall instead of following it
const CRadians kBehind = ToRadians(CDegrees(120.0));

}  // namespace

void CFootBotDiffusion::Init(TConfigurationNode& params) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_proximity = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
  if (HasActuator("leds")) {
    m_leds = GetActuator<CCI_LEDsActuator>("leds");
  }

  CDegrees alpha = ToDegrees(m_alpha);
  GetNodeAttributeOrDefault(params, "alpha", alpha, alpha);
  GetNodeAttributeOrDefault(params, "delta", m_delta, m_delta);
  GetNodeAttributeOrDefault(params, "velocity", m_velocity, m_velocity);
  if (alpha < CDegrees(0.0) || alpha > CDegrees(180.0)) {
    THROW_ARGOSEXCEPTION("alpha is " << alpha.GetValue() << "; it must be from 0 to 180 degrees");
  }
  if (m_delta < 0.0 || m_delta > 1.0) {
    THROW_ARGOSEXCEPTION("delta is " << m_delta << "; it must be from 0 to 1");
  }
  m_alpha = ToRadians(alpha);
  Reset();
}

void CFootBotDiffusion::ControlStep() {
  const CVector2 crowd = SumUpProximity();
  const bool negligible = crowd.Length() < m_delta && Abs(crowd.Angle()) <= m_alpha;
  const bool behind = Abs(crowd.Angle()) > kBehind;
  if (negligible || behind) {
    EnterState(EState::Free);
  } else if (m_state == EState::Free) {
    // keep the direction until the way is free, to get out of corners
    EnterState(crowd.Angle() > CRadians::ZERO ? EState::TurningRight : EState::TurningLeft);
  }
}

void CFootBotDiffusion::Reset() {
  EnterState(EState::Free);
}

CFootBotDiffusion::TParameters CFootBotDiffusion::ListParameters() {
  return {{"velocity", m_velocity, 0.0, 30.0, "cm/s"}, {"delta", m_delta, 0.0, 1.0}};
}

CVector2 CFootBotDiffusion::SumUpProximity() const {
  const CCI_FootBotProximitySensor::TReadings& readings = m_proximity->GetReadings();
  CVector2 sum;
  for (const CCI_FootBotProximitySensor::SReading& reading : readings) {
    sum += CVector2(reading.Value, reading.Angle);
  }
  return sum / static_cast<Real>(readings.size());
}

void CFootBotDiffusion::EnterState(EState state) {
  m_state = state;
  const Real left = state == EState::TurningLeft ? -m_velocity : m_velocity;
  const Real right = state == EState::TurningRight ? -m_velocity : m_velocity;
  m_wheels->SetLinearVelocity(left, right);
  if (m_leds != nullptr) {
    m_leds->SetAllColors(state == EState::Free ? CColor::GREEN : CColor::ORANGE);
  }
}

REGISTER_CONTROLLER(CFootBotDiffusion, "footbot_diffusion_controller")
