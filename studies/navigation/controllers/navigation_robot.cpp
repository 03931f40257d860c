#include "navigation_robot.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace argos;

namespace {

constexpr Real kTick = 0.1;  // s
// shorter sums of proximity readings, divided by their number, are no obstacle
constexpr Real kClear = 0.02;
// direction in which an obstacle is passed, from that of the obstacle on
const CRadians kDetour(100.0 / 180.0 * CRadians::PI.GetValue());
// robots that are farther away are not avoided, cm
constexpr Real kForesight = 80.0;
// a goal at this distance is reached, cm
constexpr Real kReached = 10.0;

}  // namespace

void CNavigationRobot::Init(TConfigurationNode& params) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
  m_sender = GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing");
  m_receiver = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
  m_proximity = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
  m_encoder = GetSensor<CCI_FootBotEncoderSensor>("footbot_encoder");
  GetNodeAttributeOrDefault(params, "speed", m_speed, m_speed);
  GetNodeAttributeOrDefault(params, "arrival", m_arrival, m_arrival);
  GetNodeAttributeOrDefault(params, "turn_time", m_turnTime, m_turnTime);
  std::string avoidance = "right";
  GetNodeAttributeOrDefault(params, "avoidance", avoidance, avoidance);
  if (avoidance == "away") {
    m_avoidance = EAvoidance::Away;
  } else if (avoidance == "habit") {
    m_avoidance = EAvoidance::Habit;
  } else if (avoidance == "right") {
    m_avoidance = EAvoidance::Right;
  } else {
    THROW_ARGOSEXCEPTION("avoidance is \"" << avoidance << "\"; it must be away, habit or right");
  }
  GetNodeAttributeOrDefault(params, "clearance", m_clearance, m_clearance);
  GetNodeAttributeOrDefault(params, "patience", m_patience, m_patience);
  m_rng = CRandom::CreateRNG("argos");
  Reset();
}

void CNavigationRobot::Reset() {
  m_table = CTargetTable();
  m_navigates = false;
  m_numArrivals = 0;
  m_followed = STargetEntry();
  m_hasGoal = false;
  m_turn = CRadians::ZERO;
  m_prefersRight = m_avoidance != EAvoidance::Habit || m_rng->Bernoulli(0.5);
}

void CNavigationRobot::Navigate(std::size_t firstTarget) {
  m_navigates = true;
  m_target = firstTarget;
}

void CNavigationRobot::ControlStep() {
  FollowMovement();
  Listen();
  m_sender->SetData(m_table.ToMessage());
  Drive(ChooseDirection());
  const CColor color = m_target == 0 ? CColor::RED : CColor::BLUE;
  m_leds->SetAllColors(m_navigates ? color : CColor::BLACK);
  RecordValue("target", m_navigates ? static_cast<Real>(m_target) : -1.0);
}

// Odometry: distances grow by what was driven, and the goal moves in the robot's frame.
void CNavigationRobot::FollowMovement() {
  const auto& reading = m_encoder->GetReading();
  const Real left = reading.CoveredDistanceLeftWheel;
  const Real right = reading.CoveredDistanceRightWheel;
  const Real driven = (left + right) / 2.0;
  const CRadians turned((right - left) / reading.WheelAxisLength);
  for (std::size_t target = 0; target < kNumTargets; ++target) {
    m_table[target].Distance += std::abs(driven);
  }
  m_goal -= CVector2(driven, turned / 2.0);
  m_goal.Rotate(-turned);
}

void CNavigationRobot::Listen() {
  for (const auto& packet : m_receiver->GetReadings()) {
    Hear(CTargetTable(packet.Data), packet);
  }
  if (m_hasGoal && m_goal.Length() < kReached) {
    m_hasGoal = false;
  }
}

void CNavigationRobot::Hear(const CTargetTable& heard,
                            const CCI_RangeAndBearingSensor::SPacket& packet) {
  for (std::size_t target = 0; target < kNumTargets; ++target) {
    if (!heard[target].IsKnown()) {
      continue;
    }
    const STargetEntry entry{heard[target].Sequence, heard[target].Distance + packet.Range};
    if (entry.IsBetterThan(m_table[target])) {
      m_table[target] = entry;
    }
    if (!m_navigates || target != m_target) {
      continue;
    }
    if (heard[target].Distance == 0.0 && packet.Range < m_arrival) {
      Arrive();
      return;
    }
    if (entry.IsBetterThan(m_followed)) {
      m_followed = entry;
      m_goal = CVector2(packet.Range, packet.HorizontalBearing);
      m_hasGoal = true;
    }
  }
}

void CNavigationRobot::Arrive() {
  ++m_numArrivals;
  m_target = 1 - m_target;
  m_followed = STargetEntry();
  m_hasGoal = false;
}

CVector2 CNavigationRobot::Obstacles() const {
  const auto& readings = m_proximity->GetReadings();
  CVector2 sum;
  for (const auto& reading : readings) {
    sum += CVector2(reading.Value, reading.Angle);
  }
  return sum / static_cast<Real>(readings.size());
}

CVector2 CNavigationRobot::ChooseDirection() {
  const CVector2 obstacles = Obstacles();
  const bool isNear = obstacles.Length() > kClear;
  if (!m_hasGoal) {
    return RandomWalk(isNear && obstacles.GetX() > 0.0, obstacles.Angle());
  }
  m_turn = CRadians::ZERO;
  // the angle at which the obstacle is, seen in the direction of the goal
  const CRadians angle = (obstacles.Angle() - m_goal.Angle()).SignedNormalize();
  if (!isNear || Abs(angle) >= CRadians::PI_OVER_TWO) {
    return CVector2(1.0, m_goal.Angle() + ComputeDetour());
  }
  const CRadians side = IsPassedOnTheRight(angle) ? -kDetour : kDetour;
  return CVector2(1.0, obstacles.Angle() + side);
}

// Angle from the direction of the goal at which the nearest robot on the way is passed with the
// clearance.
CRadians CNavigationRobot::ComputeDetour() const {
  Real nearest = kForesight;
  CRadians detour;
  for (const auto& packet : m_receiver->GetReadings()) {
    const CRadians angle = (packet.HorizontalBearing - m_goal.Angle()).SignedNormalize();
    if (packet.Range >= nearest || packet.Range > m_goal.Length() ||
        Abs(angle) > CRadians::PI_OVER_TWO) {
      continue;
    }
    nearest = packet.Range;
    const CRadians needed = ASin(std::min(m_clearance / packet.Range, 1.0));
    const CRadians missing = needed - Abs(angle);
    detour = missing < CRadians::ZERO                    ? CRadians::ZERO
             : packet.HorizontalBearing > CRadians::ZERO ? -missing
                                                         : missing;
  }
  return detour;
}

bool CNavigationRobot::IsPassedOnTheRight(CRadians angle) {
  const bool isOnTheWay = Abs(angle) < CRadians::PI_OVER_FOUR;
  if (m_avoidance == EAvoidance::Away || !isOnTheWay) {
    return angle > CRadians::ZERO;
  }
  // a habit that often fails is given up
  if (m_avoidance == EAvoidance::Habit && m_rng->Bernoulli(kTick / m_patience)) {
    m_prefersRight = !m_prefersRight;
  }
  return m_prefersRight;
}

// Straight on, with turns to random directions after random times, and away from obstacles.
CVector2 CNavigationRobot::RandomWalk(bool isBlocked, CRadians obstacle) {
  if (m_turn == CRadians::ZERO) {
    if (isBlocked) {
      const CRange<CRadians> range(-CRadians::PI_OVER_TWO, CRadians::PI_OVER_TWO);
      m_turn = (obstacle + CRadians::PI + m_rng->Uniform(range)).SignedNormalize();
    } else if (m_rng->Bernoulli(kTick / m_turnTime)) {
      m_turn = m_rng->Uniform(CRange<CRadians>(-CRadians::PI, CRadians::PI));
    }
  }
  const CRadians maxTurn(2.0 * m_speed / m_encoder->GetReading().WheelAxisLength * kTick);
  if (Abs(m_turn) <= maxTurn) {
    m_turn = CRadians::ZERO;
    return CVector2(1.0, CRadians::ZERO);
  }
  const bool isLeft = m_turn > CRadians::ZERO;
  m_turn += isLeft ? -maxTurn : maxTurn;
  return CVector2(1.0, isLeft ? CRadians::PI_OVER_TWO : -CRadians::PI_OVER_TWO);
}

// The outer wheel has the full speed; the inner one is the slower, the larger the angle is.
void CNavigationRobot::Drive(const CVector2& direction) {
  const Real angle = direction.Angle().GetValue();
  const Real turn = std::min(std::abs(angle) / CRadians::PI_OVER_TWO.GetValue(), 1.0);
  const Real inner = m_speed * (1.0 - 2.0 * turn);
  if (angle > 0.0) {
    m_wheels->SetLinearVelocity(inner, m_speed);
  } else {
    m_wheels->SetLinearVelocity(m_speed, inner);
  }
}

REGISTER_CONTROLLER(CNavigationRobot, "navigation_robot")
