#include "footbot_foraging.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

#include <algorithm>

using namespace argos;

namespace {

// grey of the nest on the ground, between black (food) and white
const CRange<Real> kNestGrey(0.25, 0.75);
// sum of the proximity readings above which a robot turns away from obstacles
constexpr Real kCrowded = 0.1;
// excludes 0, with which a robot would never leave, and values near 1
const CRange<Real> kProbabilities(0.001, 0.2);

}  // namespace

void CFootBotForaging::Init(TConfigurationNode& params) {
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
  m_mouth = GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing");
  m_ears = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
  m_proximity = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
  m_light = GetSensor<CCI_FootBotLightSensor>("footbot_light");
  m_ground = GetSensor<CCI_FootBotMotorGroundSensor>("footbot_motor_ground");
  Real maxSpeed = 10.0;
  GetNodeAttributeOrDefault(params, "max_speed", maxSpeed, maxSpeed);
  GetNodeAttributeOrDefault(params, "exploring_ticks", m_exploringTicks, m_exploringTicks);
  GetNodeAttributeOrDefault(params, "resting_ticks", m_restingTicks, m_restingTicks);
  GetNodeAttributeOrDefault(params, "leaving_probability", m_startProbability, m_startProbability);
  GetNodeAttributeOrDefault(params, "success_step", m_successStep, m_successStep);
  GetNodeAttributeOrDefault(params, "failure_step", m_failureStep, m_failureStep);
  m_steering = std::make_unique<CSteering>(
      *GetActuator<CCI_DifferentialSteeringActuator>("differential_steering"), maxSpeed);
  m_rng = CRandom::CreateRNG("argos");
  Reset();
}

void CFootBotForaging::Reset() {
  m_food = SFood();
  m_leavingProbability = m_startProbability;
  Enter(EState::Resting);
}

void CFootBotForaging::Enter(EState state) {
  m_state = state;
  m_ticksInState = 0;
  m_mouth->ClearData();
  m_leds->SetAllColors(state == EState::Resting     ? CColor::RED
                       : state == EState::Exploring ? CColor::GREEN
                                                    : CColor::BLUE);
}

void CFootBotForaging::ControlStep() {
  ++m_ticksInState;
  switch (m_state) {
    case EState::Resting:
      Rest();
      break;
    case EState::Exploring:
      Explore();
      break;
    case EState::Returning:
      Return();
      break;
  }
}

void CFootBotForaging::Rest() {
  m_steering->Stop();
  for (const CCI_RangeAndBearingSensor::SPacket& packet : m_ears->GetReadings()) {
    Learn(static_cast<ENews>(packet.Data[0]));
  }
  if (m_ticksInState > m_restingTicks && m_rng->Bernoulli(m_leavingProbability)) {
    Enter(EState::Exploring);
  }
}

void CFootBotForaging::Explore() {
  if (m_food.Has || m_ticksInState > m_exploringTicks) {
    m_foundFood = m_food.Has;
    Enter(EState::Returning);
    return;
  }
  CVector2 direction = CVector2::X + VectorOffObstacles();
  if (IsInNest()) {
    direction -= VectorToLight();
  }
  m_steering->Follow(direction.Normalize() * m_steering->GetMaxSpeed());
}

void CFootBotForaging::Return() {
  // robots deliver some way inside the nest, which keeps the entrance free
  if (IsInNest() && !m_food.Has) {
    const ENews news = m_foundFood ? ENews::Success : ENews::Failure;
    Learn(news);
    Enter(EState::Resting);
    m_mouth->SetData(0, static_cast<UInt8>(news));
    return;
  }
  CVector2 direction = VectorToLight() + VectorOffObstacles();
  m_steering->Follow(direction.Length() > 0.0 ? direction.Normalize() * m_steering->GetMaxSpeed()
                                              : CVector2(m_steering->GetMaxSpeed(), 0.0));
}

void CFootBotForaging::Learn(ENews news) {
  if (news == ENews::Success) {
    m_leavingProbability += m_successStep;
  } else if (news == ENews::Failure) {
    m_leavingProbability -= m_failureStep;
  }
  kProbabilities.TruncValue(m_leavingProbability);
}

bool CFootBotForaging::IsInNest() const {
  const auto& readings = m_ground->GetReadings();
  return std::all_of(readings.begin(), readings.end(), [](const auto& reading) {
    return kNestGrey.WithinMinBoundIncludedMaxBoundIncluded(reading.Value);
  });
}

CVector2 CFootBotForaging::VectorToLight() const {
  CVector2 sum;
  for (const CCI_FootBotLightSensor::SReading& reading : m_light->GetReadings()) {
    sum += CVector2(reading.Value, reading.Angle);
  }
  return sum.Length() > 0.0 ? sum.Normalize() : sum;
}

CVector2 CFootBotForaging::VectorOffObstacles() const {
  CVector2 sum;
  for (const CCI_FootBotProximitySensor::SReading& reading : m_proximity->GetReadings()) {
    sum += CVector2(reading.Value, reading.Angle);
  }
  return sum.Length() > kCrowded ? -sum.Normalize() * 2.0 : CVector2();
}

REGISTER_CONTROLLER(CFootBotForaging, "footbot_foraging_controller")
