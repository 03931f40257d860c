#include "transporter.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

#include <algorithm>

using namespace argos;

namespace {

constexpr UInt32 kBeacon = 12;
constexpr Real kTicksPerSecond = 10.0;
constexpr Real kCentimeters = 100.0;  // in a metre
constexpr Real kBody = 8.5;  // cm, radius of a robot
constexpr Real kContact = 19.8;  // cm, between the centres of a robot and the object that it grips
constexpr Real kNearGrip = 23.0;  // cm, from there on the gripper is locked
constexpr Real kHeld = 26.0;  // cm, an object that is farther is not held
constexpr Real kReach = 28.0;  // cm, from the centre of another robot to an object that it holds
constexpr Real kTolerance = 2.0;  // cm, of the contact of another robot
const CRadians kStraight(0.15);
constexpr UInt32 kGripTicks = 100;  // at most, to grip an object
constexpr UInt32 kSecureTicks = 5;  // in contact
constexpr UInt32 kHandOverTicks = 30;  // while the other robot releases the object
constexpr UInt32 kLeaveTicks = 20;  // to drive away from an object that was released
constexpr UInt32 kInsideTicks = 30;  // to drive on in the nest before the object is released
constexpr Real kObstacle = 0.1;
constexpr Real kArrived = 5.0;  // cm
const CRange<UInt32> kTurnTicks(2, 13);
const CRange<Real> kNestGrey(0.25, 0.75);
const CRadians kLoadWidth(0.8);  // readings within this of the load's direction are of the load

}  // namespace

void CTransporter::Init(TConfigurationNode& params) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_gripper = GetActuator<CCI_FootBotGripperActuator>("footbot_gripper");
  m_turret = GetActuator<CCI_FootBotTurretActuator>("footbot_turret");
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
  m_encoder = GetSensor<CCI_FootBotEncoderSensor>("footbot_encoder");
  m_light = GetSensor<CCI_FootBotLightSensor>("footbot_light");
  m_ground = GetSensor<CCI_FootBotMotorGroundSensor>("footbot_motor_ground");
  m_proximity = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
  m_camera =
      GetSensor<CCI_ColoredBlobOmnidirectionalCameraSensor>("colored_blob_omnidirectional_camera");
  GetNodeAttributeOrDefault(params, "speed", m_speed, m_speed);
  GetNodeAttributeOrDefault(params, "way", m_way, m_way);
  GetNodeAttributeOrDefault(params, "patience", m_patience, m_patience);
  GetNodeAttributeOrDefault(params, "search", m_search, m_search);
  GetNodeAttributeOrDefault(params, "near", m_near, m_near);
  GetNodeAttributeOrDefault(params, "sight", m_sight, m_sight);
  m_rng = CRandom::CreateRNG("argos");
  Reset();
}

void CTransporter::Reset() {
  m_odometry.Restart();
  m_knowsSource = false;
  m_hasWaited = false;
  m_hasArrived = false;
  m_turnTicks = 0;
  m_numGrips = 0;
  m_numArrivals = 0;
  m_numLost = 0;
  m_camera->Enable();
  Enter(EState::Exploring);
}

void CTransporter::Enter(EState state) {
  m_state = state;
  m_ticks = 0;
  const bool holds = state == EState::Carrying || state == EState::Waiting;
  if (holds) {
    m_turret->SetPassiveMode();
  } else {
    m_turret->SetActiveWithRotation(CRadians::ZERO);
  }
  if (!holds && state != EState::Gripping) {
    m_gripper->Unlock();
  }
  m_leds->SetSingleColor(kBeacon, state == EState::Carrying   ? CColor::RED
                                  : state == EState::Waiting  ? CColor::BLUE
                                  : state == EState::Gripping ? CColor::YELLOW
                                                              : CColor::BLACK);
}

void CTransporter::ControlStep() {
  m_odometry.Update(m_encoder->GetReading());
  Look();
  ++m_ticks;
  switch (m_state) {
    case EState::Exploring:
      Explore();
      break;
    case EState::Approaching:
      Approach();
      break;
    case EState::Gripping:
      Grip();
      break;
    case EState::Carrying:
      Carry();
      break;
    case EState::Waiting:
      Wait();
      break;
    case EState::Leaving:
      Leave();
      break;
    case EState::Returning:
      Return();
      break;
    case EState::Searching:
      Search();
      break;
  }
}

void CTransporter::Look() {
  m_view.Objects.clear();
  m_view.Carriers.clear();
  m_view.Busy.clear();
  m_view.Waiters.clear();
  for (const SOmnidirectionalBlob* blob : m_camera->GetReadings().BlobList) {
    const CVector2 place(blob->Distance, blob->Angle);
    if (blob->Color == CColor::GREEN) {
      m_view.Objects.push_back(place);
    } else if (blob->Color == CColor::BLUE) {
      m_view.Waiters.push_back(place);
    } else {
      m_view.Busy.push_back(place);
      if (blob->Color == CColor::RED) {
        m_view.Carriers.push_back(place);
      }
    }
  }
}

void CTransporter::Explore() {
  if (FindObject()) {
    Enter(EState::Approaching);
    return;
  }
  Walk();
}

void CTransporter::Approach() {
  const std::optional<CVector2> object = FindObject();
  if (!object) {
    Enter(m_knowsSource ? EState::Searching : EState::Exploring);
    return;
  }
  if (object->Length() < kNearGrip + 7.0) {
    Enter(EState::Gripping);
    return;
  }
  CVector2 direction = *object;
  direction.Normalize();
  // around a robot that stands in the way
  for (const std::vector<CVector2>* robots : {&m_view.Waiters, &m_view.Busy}) {
    for (const CVector2& robot : *robots) {
      if (robot.Length() < 35.0) {
        CVector2 off = robot;
        off.Normalize();
        const Real side = off.CrossProduct(direction) >= 0.0 ? 1.0 : -1.0;
        direction += CVector2(-off.GetY(), off.GetX()) * side - off * 0.5;
      }
    }
  }
  Follow(direction, m_speed / 2.0);
}

void CTransporter::Grip() {
  const std::optional<CVector2> object = FindObject();
  if (!object || m_ticks > kGripTicks) {
    // back off, and look again
    Enter(EState::Leaving);
    return;
  }
  const CRadians angle = object->Angle().SignedNormalize();
  const bool isStraight = Abs(angle) < kStraight;
  if (object->Length() < kNearGrip && isStraight) {
    m_gripper->LockPositive();
  } else {
    m_gripper->Unlock();
  }
  if (object->Length() > kContact || !isStraight) {
    m_turnTicks = 0;
    Follow(*object, isStraight ? 3.0 : 1.5);
    return;
  }
  m_wheels->SetLinearVelocity(1.0, 1.0);
  if (++m_turnTicks < kSecureTicks) {
    return;
  }
  m_turnTicks = 0;
  ++m_numGrips;
  m_odometry.Restart();
  m_knowsSource = true;
  m_hasWaited = false;
  m_hasArrived = false;
  Enter(EState::Carrying);
}

void CTransporter::Carry() {
  const std::optional<CVector2> load = FindLoad();
  if (!load) {
    Enter(EState::Leaving);
    return;
  }
  const bool isHandedOver = SeesWithin(m_view.Waiters, *load, kReach);
  if (isHandedOver && m_ticks < kHandOverTicks) {
    m_wheels->SetLinearVelocity(0.0, 0.0);
    return;
  }
  if (IsInNest()) {
    m_turnTicks += 1;
    if (m_turnTicks > kInsideTicks) {
      m_turnTicks = 0;
      Enter(EState::Leaving);
      return;
    }
  }
  const Real way = m_odometry.GetPosition().Length() / kCentimeters;
  if (m_way > 0.0 && way >= m_way && !m_hasWaited && !IsInNest()) {
    m_hasWaited = true;
    Enter(EState::Waiting);
    return;
  }
  Follow(VectorToLight() + VectorOffObstacles(), m_speed);
}

void CTransporter::Wait() {
  m_wheels->SetLinearVelocity(0.0, 0.0);
  const std::optional<CVector2> load = FindLoad();
  const Real touching = kContact + kTolerance;
  if (!load || SeesWithin(m_view.Carriers, *load, touching)) {
    Enter(EState::Leaving);
  } else if (!SeesWithin(m_view.Busy, *load, touching) && m_ticks > m_patience * kTicksPerSecond) {
    m_turnTicks = 0;
    Enter(EState::Carrying);
  }
}

void CTransporter::Leave() {
  // away from the object that it has released
  if (m_ticks <= kLeaveTicks) {
    CVector2 off;
    for (const CVector2& object : m_view.Objects) {
      if (object.Length() < 35.0) {
        off -= object / object.SquareLength();
      }
    }
    if (off.Length() > 0.0) {
      const bool isAhead = off.GetX() < 0.0;
      const Real speed = isAhead ? -m_speed / 2.0 : m_speed / 2.0;
      m_wheels->SetLinearVelocity(speed, speed);
    }
    return;
  }
  Enter(m_knowsSource ? EState::Returning : EState::Exploring);
}

void CTransporter::Return() {
  const CVector2 target = m_odometry.To(CVector2());
  const bool isNear = target.Length() <= m_near * kCentimeters;
  const bool seesObject = isNear && FindObject();
  if (seesObject || target.Length() <= kArrived) {
    m_numArrivals += m_hasArrived ? 0 : 1;
    m_hasArrived = true;
    Enter(seesObject ? EState::Approaching : EState::Searching);
    return;
  }
  CVector2 direction = target;
  direction.Normalize();
  Follow(direction + VectorOffObstacles(), m_speed);
}

void CTransporter::Search() {
  if (FindObject()) {
    Enter(EState::Approaching);
    return;
  }
  if (m_ticks > m_search * kTicksPerSecond) {
    ++m_numLost;
    m_knowsSource = false;
    Enter(EState::Exploring);
    return;
  }
  const CVector2 target = m_odometry.To(CVector2());
  if (target.Length() > m_near * kCentimeters) {
    CVector2 direction = target;
    Follow(direction.Normalize() + VectorOffObstacles(), m_speed);
  } else {
    Walk();
  }
}

std::optional<CVector2> CTransporter::FindObject() const {
  const bool isOnIt = m_state == EState::Approaching || m_state == EState::Gripping;
  std::optional<CVector2> nearest;
  for (const CVector2& object : m_view.Objects) {
    const bool isTaken = SeesWithin(m_view.Busy, object, kReach) ||
                         (!isOnIt && object.Length() > kBody + m_sight * kCentimeters);
    if (!isTaken && (!nearest || object.Length() < nearest->Length())) {
      nearest = object;
    }
  }
  return nearest;
}

std::optional<CVector2> CTransporter::FindLoad() const {
  std::optional<CVector2> nearest;
  for (const CVector2& object : m_view.Objects) {
    if (object.Length() < kHeld && (!nearest || object.Length() < nearest->Length())) {
      nearest = object;
    }
  }
  return nearest;
}

bool CTransporter::SeesWithin(const std::vector<CVector2>& places, const CVector2& center,
                              Real distance) const {
  return std::any_of(places.begin(), places.end(),
                     [&](const CVector2& place) { return Distance(place, center) < distance; });
}

bool CTransporter::IsInNest() const {
  const auto& readings = m_ground->GetReadings();
  return std::all_of(readings.begin(), readings.end(), [](const auto& reading) {
    return kNestGrey.WithinMinBoundIncludedMaxBoundIncluded(reading.Value);
  });
}

CVector2 CTransporter::VectorToLight() const {
  CVector2 sum;
  for (const CCI_FootBotLightSensor::SReading& reading : m_light->GetReadings()) {
    sum += CVector2(reading.Value, reading.Angle);
  }
  return sum.Length() > 0.0 ? sum.Normalize() : CVector2::X;
}

CVector2 CTransporter::VectorOffObstacles() const {
  const std::optional<CVector2> load =
      m_state == EState::Carrying ? FindLoad() : std::optional<CVector2>();
  CVector2 sum;
  for (const CCI_FootBotProximitySensor::SReading& reading : m_proximity->GetReadings()) {
    const bool isLoad = load && Abs((reading.Angle - load->Angle()).SignedNormalize()) < kLoadWidth;
    if (!isLoad) {
      sum += CVector2(reading.Value, reading.Angle);
    }
  }
  if (sum.Length() <= kObstacle) {
    return CVector2();
  }
  sum.Normalize();
  // away, and past it on the left
  return -sum * 1.2 + CVector2(sum.GetY(), -sum.GetX()) * 0.8;
}

void CTransporter::Walk() {
  CVector2 obstacles;
  for (const CCI_FootBotProximitySensor::SReading& reading : m_proximity->GetReadings()) {
    if (Cos(reading.Angle) > 0.0) {
      obstacles += CVector2(reading.Value, reading.Angle);
    }
  }
  if (m_turnTicks == 0) {
    if (obstacles.Length() > kObstacle) {
      m_turnSign = obstacles.GetY() > 0.0 ? -1.0 : 1.0;
    } else if (m_rng->Uniform(CRange<Real>(0.0, 1.0)) < 0.01) {
      m_turnSign = m_rng->Bernoulli(0.5) ? 1.0 : -1.0;
    } else {
      m_wheels->SetLinearVelocity(m_speed, m_speed);
      return;
    }
    m_turnTicks = m_rng->Uniform(kTurnTicks);
  }
  --m_turnTicks;
  m_wheels->SetLinearVelocity(-m_turnSign * m_speed, m_turnSign * m_speed);
}

void CTransporter::Follow(const CVector2& direction, Real speed) {
  const CRadians angle = direction.Angle().SignedNormalize();
  // 0 for straight ahead, 1 for a right angle or more
  const Real turn = std::min<Real>(1.0, Abs(angle) / CRadians::PI_OVER_TWO);
  const Real inner = speed * (1.0 - 2.0 * turn);
  if (angle > CRadians::ZERO) {
    m_wheels->SetLinearVelocity(inner, speed);
  } else {
    m_wheels->SetLinearVelocity(speed, inner);
  }
}

REGISTER_CONTROLLER(CTransporter, "transporter")
