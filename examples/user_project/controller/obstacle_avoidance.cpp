#include "obstacle_avoidance.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

#include <algorithm>

using namespace argos;

void CObstacleAvoidance::Init(TConfigurationNode& node) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_proximity = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
  GetNodeAttributeOrDefault(node, "speed", m_speed, m_speed);
  GetNodeAttributeOrDefault(node, "caution", m_caution, m_caution);
}

void CObstacleAvoidance::ControlStep() {
  // vector towards the obstacles, in the robot's frame: x is forward, y is left
  const CVector2 obstacles = m_caution * SumOfReadings();
  const Real advance = std::clamp(1.0 - obstacles.GetX(), 0.0, 1.0);
  // turn away from the obstacles; to the right if they are straight ahead
  const Real side = obstacles.GetY() < 0.0 ? 1.0 : -1.0;
  const Real turn = side * std::min(obstacles.Length(), 1.0);
  m_wheels->SetLinearVelocity(m_speed * (advance - turn), m_speed * (advance + turn));
}

CVector2 CObstacleAvoidance::SumOfReadings() const {
  CVector2 sum;
  for (const auto& reading : m_proximity->GetReadings()) {
    const bool isAhead = Cos(reading.Angle) > 0.0;
    if (isAhead) {
      sum += CVector2(reading.Value, reading.Angle);
    }
  }
  return sum;
}

REGISTER_CONTROLLER(CObstacleAvoidance, "obstacle_avoidance")
