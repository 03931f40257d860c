#include "flocking_robot.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace argos;

namespace {

constexpr Real kAxis = 14.0;  // distance between the wheels, cm

CVector2 Normalized(const CVector2& vector) {
  return vector.Length() > 0.0 ? vector / vector.Length() : CVector2();
}

CVector2 Turned(const CVector2& vector, CRadians angle) {
  CVector2 turned = vector;
  turned.Rotate(angle);
  return turned;
}

// Angles are sent as 16 bits, 0 to 65535 for a full turn.
CRadians Decode(const CByteArray& data) {
  return CRadians((data[0] * 256 + data[1]) / 65536.0 * CRadians::TWO_PI.GetValue());
}

}  // namespace

void CFlockingRobot::Init(TConfigurationNode& params) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
  m_sender = GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing");
  m_receiver = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
  m_lights = GetSensor<CCI_FootBotLightSensor>("footbot_light");
  std::string algorithm;
  GetNodeAttribute(params, "algorithm", algorithm);
  if (algorithm == "hcs") {
    m_algorithm = EAlgorithm::Hcs;
  } else if (algorithm == "ics") {
    m_algorithm = EAlgorithm::Ics;
  } else if (algorithm == "scs") {
    m_algorithm = EAlgorithm::Scs;
  } else {
    THROW_ARGOSEXCEPTION("algorithm is \"" << algorithm << "\"; it must be hcs, ics or scs");
  }
  GetNodeAttributeOrDefault(params, "alpha", m_alpha, m_alpha);
  GetNodeAttributeOrDefault(params, "beta", m_beta, m_beta);
  GetNodeAttributeOrDefault(params, "gamma", m_gamma, m_gamma);
  GetNodeAttributeOrDefault(params, "epsilon", m_epsilon, m_epsilon);
  GetNodeAttributeOrDefault(params, "distance", m_distance, m_distance);
  GetNodeAttributeOrDefault(params, "reach", m_reach, m_reach);
  GetNodeAttributeOrDefault(params, "forward_gain", m_forwardGain, m_forwardGain);
  GetNodeAttributeOrDefault(params, "turn_gain", m_turnGain, m_turnGain);
  GetNodeAttributeOrDefault(params, "max_speed", m_maxSpeed, m_maxSpeed);
  GetNodeAttributeOrDefault(params, "max_turn_rate", m_maxTurnRate, m_maxTurnRate);
  GetNodeAttributeOrDefault(params, "agreement", m_agreement, m_agreement);
  GetNodeAttributeOrDefault(params, "confidence_step", m_confidenceStep, m_confidenceStep);
  Reset();
}

void CFlockingRobot::Reset() {
  m_goal.reset();
  m_average = CVector2();
  m_sent = CVector2();
  m_confidence = 0.0;
}

void CFlockingRobot::ControlStep() {
  const CRadians light = MeasureLight();
  const CVector2 received = SumOfMessages();
  const auto count = static_cast<Real>(m_receiver->GetReadings().size());
  AdaptConfidence(count > 0.0 ? received.Length() / count : 1.0);

  const CVector2 toGoal = m_goal ? CVector2(1.0, m_goal->Angle + light) : CVector2();
  const CVector2 alignment = Normalized(Turned(received + m_sent, light));
  Drive(m_alpha * Proximal() + m_beta * toGoal + m_gamma * alignment);

  m_sent = Turned(ChooseMessage(light), -light);
  Send(m_sent.Angle());
  m_average = Normalized(Turned(received, light));
  ShowState();
}

CRadians CFlockingRobot::MeasureLight() const {
  CVector2 sum;
  for (const auto& reading : m_lights->GetReadings()) {
    sum += CVector2(reading.Value, reading.Angle);
  }
  return sum.Angle();
}

CVector2 CFlockingRobot::Proximal() const {
  // a potential like that between molecules, whose minimum is at the distance sqrt(2) s
  const Real s = m_distance / std::sqrt(2.0);
  CVector2 sum;
  for (const auto& packet : m_receiver->GetReadings()) {
    const Real d = packet.Range / 100.0;
    if (d < m_reach) {
      const Real attraction =
          -8.0 * m_epsilon * (2.0 * std::pow(s, 4) / std::pow(d, 5) - s * s / (d * d * d));
      sum += CVector2(attraction, packet.HorizontalBearing);
    }
  }
  return sum;
}

CVector2 CFlockingRobot::SumOfMessages() const {
  CVector2 sum;
  for (const auto& packet : m_receiver->GetReadings()) {
    sum += CVector2(1.0, Decode(packet.Data));
  }
  return sum;
}

void CFlockingRobot::AdaptConfidence(Real agreement) {
  if (!m_goal) {
    m_confidence = 0.0;
  } else if (m_algorithm == EAlgorithm::Ics || m_goal->HasPriority) {
    m_confidence = 1.0;
  } else {
    const Real step = agreement >= m_agreement ? m_confidenceStep : -m_confidenceStep;
    m_confidence = std::clamp(m_confidence + step, 0.0, 1.0);
  }
}

CVector2 CFlockingRobot::ChooseMessage(CRadians light) const {
  const CVector2 heading(1.0, CRadians::ZERO);
  if (m_algorithm == EAlgorithm::Hcs) {
    return heading;
  }
  const CVector2 toGoal = m_goal ? CVector2(1.0, m_goal->Angle + light) : CVector2();
  const CVector2 average = m_average.Length() > 0.0 ? m_average : heading;
  const CVector2 sum = m_confidence * toGoal + (1.0 - m_confidence) * average;
  return sum.Length() > 0.0 ? Normalized(sum) : average;
}

void CFlockingRobot::Send(CRadians angle) {
  const Real turns = angle.UnsignedNormalize().GetValue() / CRadians::TWO_PI.GetValue();
  const UInt32 code = static_cast<UInt32>(turns * 65536.0) % 65536;
  m_sender->SetData(0, static_cast<UInt8>(code / 256));
  m_sender->SetData(1, static_cast<UInt8>(code % 256));
}

void CFlockingRobot::Drive(const CVector2& force) {
  const Real forward = std::clamp(m_forwardGain * force.GetX(), 0.0, m_maxSpeed);
  const Real turn = std::clamp(m_turnGain * force.GetY(), -m_maxTurnRate, m_maxTurnRate);
  m_wheels->SetLinearVelocity(forward - turn * kAxis / 2.0, forward + turn * kAxis / 2.0);
}

void CFlockingRobot::ShowState() {
  m_leds->SetAllColors(m_goal ? CColor::YELLOW : CColor::BLACK);
  RecordValue("confidence", m_confidence);
}

REGISTER_CONTROLLER(CFlockingRobot, "flocking_robot")
