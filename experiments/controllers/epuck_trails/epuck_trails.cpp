#include "epuck_trails.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

#include <algorithm>

using namespace argos;

namespace {

// greys on the ground: food is darker than kFoodGrey, the nest between kFoodGrey and kNestGrey
constexpr Real kFoodGrey = 0.25;
constexpr Real kNestGrey = 0.6;
// sum of the proximity readings above which a robot turns away from obstacles
constexpr Real kCrowded = 0.1;
// angle from the obstacles to the evasion direction: two robots that meet on a trail both pass on
// the right
const CRadians kEvasion = ToRadians(CDegrees(-140.0));
constexpr Real kEvasionWeight = 1.5;  // weight of the evasion relative to the target direction
// gains of the turn by the difference between the antennae, and of the direction away from the nest
constexpr Real kTurnGain = 3.0;
constexpr Real kOutwards = 0.6;
// share of the drift that a wandering robot keeps per tick: it decays within some ten ticks
constexpr Real kDriftKept = 0.9;

}  // namespace

void CEPuckTrails::Init(TConfigurationNode& params) {
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
  m_gland = GetActuator<CCI_PheromoneActuator>("pheromone");
  m_antennae = &GetSensor<CCI_PheromoneSensor>("pheromone")->GetReadings("trail");
  m_proximity = GetSensor<CCI_EPuckProximitySensor>("epuck_proximity");
  m_ground = GetSensor<CCI_GroundSensor>("ground");
  m_position = GetSensor<CCI_PositioningSensor>("positioning");
  if (m_antennae->size() != 2) {
    THROW_ARGOSEXCEPTION(
        "this controller needs two antennae, <point> of the sensor \"pheromone\": "
        "left and right; there are "
        << m_antennae->size());
  }
  Real maxSpeed = 8.0;
  GetNodeAttributeOrDefault(params, "max_speed", maxSpeed, maxSpeed);
  GetNodeAttributeOrDefault(params, "rate", m_rate, m_rate);
  GetNodeAttributeOrDefault(params, "threshold", m_threshold, m_threshold);
  GetNodeAttributeOrDefault(params, "wandering", m_wandering, m_wandering);
  GetNodeAttributeOrDefault(params, "nest", m_nest, m_nest);
  m_steering = std::make_unique<CSteering>(
      *GetActuator<CCI_DifferentialSteeringActuator>("differential_steering"), maxSpeed);
  m_rng = CRandom::CreateRNG("argos");
  Reset();
}

void CEPuckTrails::Reset() {
  m_hasFood = false;
  m_delivered = 0;
  m_drift = 0.0;
  m_leds->SetAllColors(CColor::BLACK);
}

void CEPuckTrails::ControlStep() {
  TakeOrDeliver();
  const CVector2 way = (m_hasFood ? VectorHome() : Search()) + VectorOffObstacles();
  m_steering->Follow(CVector2(m_steering->GetMaxSpeed(), way.Angle()));
}

void CEPuckTrails::TakeOrDeliver() {
  const std::vector<Real>& greys = m_ground->GetReadings();
  const Real grey = *std::max_element(greys.begin(), greys.end());
  if (!m_hasFood && grey < kFoodGrey) {
    m_hasFood = true;
    m_leds->SetAllColors(CColor::GREEN);
    m_gland->SetRate("trail", m_rate);
  } else if (m_hasFood && grey > kFoodGrey && grey < kNestGrey) {
    m_hasFood = false;
    ++m_delivered;
    m_leds->SetAllColors(CColor::BLACK);
    m_gland->SetRate("trail", 0.0);
  }
}

CVector2 CEPuckTrails::Search() {
  const Real left = (*m_antennae)[0].Value;
  const Real right = (*m_antennae)[1].Value;
  if (left + right >= m_threshold) {
    m_drift = 0.0;
    const Real difference = (left - right) / (left + right);
    return CVector2(1.0, kTurnGain * difference) - VectorHome() * kOutwards;
  }
  m_drift = kDriftKept * m_drift + m_rng->Gaussian(m_wandering);
  return {1.0, CRadians(m_drift)};
}

CVector2 CEPuckTrails::VectorHome() const {
  const CCI_PositioningSensor::SReading& reading = m_position->GetReading();
  CVector2 way(m_nest.GetX() - reading.Position.GetX(), m_nest.GetY() - reading.Position.GetY());
  CRadians heading;
  CRadians pitch;
  CRadians roll;
  reading.Orientation.ToEulerAngles(heading, pitch, roll);
  return way.Length() > 0.0 ? way.Normalize().Rotate(-heading) : way;
}

CVector2 CEPuckTrails::VectorOffObstacles() const {
  CVector2 sum;
  for (const CCI_EPuckProximitySensor::SReading& reading : m_proximity->GetReadings()) {
    sum += CVector2(reading.Value, reading.Angle);
  }
  return sum.Length() > kCrowded ? CVector2(kEvasionWeight, sum.Angle() + kEvasion) : CVector2();
}

REGISTER_CONTROLLER(CEPuckTrails, "epuck_trails_controller")
