#include "epuck_diffusion.h"

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/rng.h>

using namespace argos;

namespace {

// turning on the spot at 10 cm/s, an e-puck (wheelbase 5.3 cm) makes half a turn in 8 ticks of 0.1
// s
constexpr UInt32 kMaxTurnTicks = 8;
// a reading of 0.1 means an obstacle about 4 cm away
constexpr Real kThreshold = 0.1;

}  // namespace

CEPuckDiffusion::CEPuckDiffusion() : m_random(0, "controller", "", "walk") {}

void CEPuckDiffusion::Init(TConfigurationNode& params) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_proximity = GetSensor<CCI_EPuckProximitySensor>("epuck_proximity");
  GetNodeAttributeOrDefault(params, "velocity", m_velocity, m_velocity);
  GetNodeAttributeOrDefault(params, "mean_free_ticks", m_meanFreeTicks, m_meanFreeTicks);
  if (m_meanFreeTicks == 0) {
    THROW_ARGOSEXCEPTION("mean_free_ticks is 0; it must be at least 1");
  }
  Reset();
}

void CEPuckDiffusion::ControlStep() {
  // counter-clockwise from the heading: 0 to 2 are on the left, 5 to 7 on the right
  const CCI_EPuckProximitySensor::TReadings& readings = m_proximity->GetReadings();
  const Real left = readings[0].Value + readings[1].Value + 0.5 * readings[2].Value;
  const Real right = readings[7].Value + readings[6].Value + 0.5 * readings[5].Value;
  if (left > kThreshold || right > kThreshold) {
    if (m_turnDirection == 0) {
      m_turnDirection = left > right ? -1 : 1;
    }
    m_ticksLeft = 1 + static_cast<UInt32>(m_random.UniformInteger(UInt64(3)));
  } else if (m_ticksLeft > 0) {
    --m_ticksLeft;
  } else if (m_turnDirection != 0) {
    PlanStretch();
  } else {
    m_turnDirection = m_random.Bernoulli() ? 1 : -1;
    m_ticksLeft = static_cast<UInt32>(m_random.UniformInteger(UInt64(kMaxTurnTicks)));
  }
  Drive();
}

void CEPuckDiffusion::Reset() {
  m_random = CRandomStream(CRandom::GetSeedOf("argos"), "controller", GetId(), "walk");
  PlanStretch();
  Drive();
}

void CEPuckDiffusion::PlanStretch() {
  m_turnDirection = 0;
  m_ticksLeft = static_cast<UInt32>(m_random.UniformInteger(UInt64(2) * m_meanFreeTicks));
}

void CEPuckDiffusion::Drive() {
  if (m_turnDirection == 0) {
    m_wheels->SetLinearVelocity(m_velocity, m_velocity);
  } else {
    m_wheels->SetLinearVelocity(-m_turnDirection * m_velocity, m_turnDirection * m_velocity);
  }
}

REGISTER_CONTROLLER(CEPuckDiffusion, "epuck_diffusion_controller")
