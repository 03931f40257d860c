#include "shelter_robot.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

#include <algorithm>
#include <cmath>

using namespace argos;

namespace {

constexpr UInt32 kBeacon = 12;  // the LED in the centre of the robot: others see one light of it
constexpr Real kTicksPerSecond = 10.0;
constexpr Real kCentimeters = 100.0;  // in a metre
constexpr Real kObstacle = 0.1;  // sum of the proximity readings that makes a free robot turn
constexpr Real kTurnGain = 10.0;  // cm/s of a wheel for a right angle
const CRange<UInt32> kTurnTicks(2, 13);  // up to some 100 degrees

}  // namespace

void CShelterRobot::Init(TConfigurationNode& params) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
  m_proximity = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
  m_camera =
      GetSensor<CCI_ColoredBlobOmnidirectionalCameraSensor>("colored_blob_omnidirectional_camera");
  m_ears = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
  GetNodeAttributeOrDefault(params, "range", m_range, m_range);
  GetNodeAttributeOrDefault(params, "speed", m_speed, m_speed);
  GetNodeAttributeOrDefault(params, "pace", m_pace, m_pace);
  GetNodeAttributeOrDefault(params, "walk", m_walk, m_walk);
  GetNodeAttributeOrDefault(params, "pull", m_pull, m_pull);
  GetNodeAttributeOrDefault(params, "push", m_push, m_push);
  GetNodeAttributeOrDefault(params, "rest", m_rest, m_rest);
  GetNodeAttributeOrDefault(params, "distance", m_distance, m_distance);
  GetNodeAttributeOrDefault(params, "way", m_way, m_way);
  m_rng = CRandom::CreateRNG("argos");
  Reset();
}

void CShelterRobot::Reset() {
  m_wasInRange = false;
  m_turnTicks = 0;
  Enter(EState::Free);
}

void CShelterRobot::ControlStep() {
  const SShelter shelter = FindShelter();
  if (m_state == EState::Free) {
    Walk();
  } else {
    FollowForces(shelter);
  }
  ChangeState(shelter);
  m_wasInRange = shelter.IsInRange;
}

CShelterRobot::SShelter CShelterRobot::FindShelter() const {
  SShelter nearest;
  Real best = m_range * kCentimeters;
  for (const CCI_RangeAndBearingSensor::SPacket& packet : m_ears->GetReadings()) {
    const SShelterMessage message = SShelterMessage::Read(packet.Data);
    const Real distance = packet.Range * Cos(packet.VerticalBearing);
    if (message.IsActive && distance <= best) {
      best = distance;
      nearest.IsInRange = true;
      nearest.Center = CVector2(distance, packet.HorizontalBearing);
      nearest.Message = message;
    }
  }
  return nearest;
}

void CShelterRobot::ChangeState(const SShelter& shelter) {
  if (m_state == EState::Free) {
    const bool isJustInRange = shelter.IsInRange && !m_wasInRange;
    if (isJustInRange && Happens(shelter.Message.Join)) {
      Enter(EState::InGroup);
    }
  } else if (!shelter.IsInRange) {
    Enter(EState::Free);
  } else if (m_state == EState::InGroup && Happens(shelter.Message.Leave)) {
    Enter(EState::Leaving);
  }
}

void CShelterRobot::Enter(EState state) {
  m_state = state;
  m_leds->SetSingleColor(kBeacon, state == EState::Free      ? CColor::GREEN
                                  : state == EState::InGroup ? CColor::RED
                                                             : CColor::BLUE);
  // each state has the sensor that it needs
  if (state == EState::Free) {
    m_proximity->Enable();
    m_camera->Disable();
  } else {
    m_proximity->Disable();
    m_camera->Enable();
  }
}

void CShelterRobot::Walk() {
  CVector2 obstacles;
  for (const CCI_FootBotProximitySensor::SReading& reading : m_proximity->GetReadings()) {
    const bool isAhead = Cos(reading.Angle) > 0.0;
    if (isAhead) {
      obstacles += CVector2(reading.Value, reading.Angle);
    }
  }
  if (m_turnTicks == 0) {
    const bool isBlocked = obstacles.Length() > kObstacle;
    if (isBlocked) {
      m_turnSign = obstacles.GetY() > 0.0 ? -1.0 : 1.0;
    } else if (Happens(1.0 / (m_walk * kTicksPerSecond))) {
      m_turnSign = Happens(0.5) ? 1.0 : -1.0;
    } else {
      m_wheels->SetLinearVelocity(m_speed, m_speed);
      return;
    }
    m_turnTicks = m_rng->Uniform(kTurnTicks);
  }
  --m_turnTicks;
  m_wheels->SetLinearVelocity(-m_turnSign * m_speed, m_turnSign * m_speed);
}

void CShelterRobot::FollowForces(const SShelter& shelter) {
  CVector2 force;
  if (shelter.IsInRange && shelter.Center.Length() > 0.0) {
    force = shelter.Center;
    force.Normalize();
    force *= m_state == EState::InGroup ? m_pull : -m_pace;
  }
  for (const SOmnidirectionalBlob* blob : m_camera->GetReadings().BlobList) {
    force += ForceOf(*blob);
  }
  Drive(force);
}

CVector2 CShelterRobot::ForceOf(const SOmnidirectionalBlob& neighbor) const {
  // a robot that leaves has more room around it
  const bool isOneLeaving = m_state == EState::Leaving || neighbor.Color == CColor::BLUE;
  const bool isOneOfMine = m_state == EState::InGroup && neighbor.Color == CColor::RED;
  const Real rest = isOneLeaving ? m_way : m_distance;
  const Real distance = neighbor.Distance / kCentimeters;
  if (distance <= 0.0 || (distance > rest && !isOneOfMine)) {
    return CVector2();
  }
  const Real square = (rest / distance) * (rest / distance);
  return CVector2(-m_push / distance * (square * square - square), neighbor.Angle);
}

void CShelterRobot::Drive(const CVector2& velocity) {
  const Real speed = std::min(velocity.Length(), m_pace);
  if (speed < m_rest) {
    m_wheels->SetLinearVelocity(0.0, 0.0);
    return;
  }
  // ahead or back, whichever is nearer
  const bool isBack = velocity.GetX() < 0.0;
  const CRadians angle = (isBack ? -velocity : velocity).Angle();
  const Real ahead = speed * Cos(angle) * (isBack ? -1.0 : 1.0);
  const Real turn = kTurnGain * (angle / CRadians::PI_OVER_TWO);
  m_wheels->SetLinearVelocity(ahead - turn, ahead + turn);
}

bool CShelterRobot::Happens(Real probability) {
  return m_rng->Uniform(CRange<Real>(0.0, 1.0)) <= probability;
}

REGISTER_CONTROLLER(CShelterRobot, "shelter_robot")
