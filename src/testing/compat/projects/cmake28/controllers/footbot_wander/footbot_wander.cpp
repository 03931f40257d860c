#include "footbot_wander.h"

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/vector2.h>

CFootBotWander::CFootBotWander()
    : m_pcWheels(NULL),
      m_pcProximity(NULL),
      m_cAlpha(10.0f),
      m_fDelta(0.5f),
      m_fWheelVelocity(2.5f),
      m_cGoStraightAngleRange(-ToRadians(m_cAlpha), ToRadians(m_cAlpha)) {}

void CFootBotWander::Init(TConfigurationNode& t_node) {
  m_pcWheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_pcProximity = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
  GetNodeAttributeOrDefault(t_node, "alpha", m_cAlpha, m_cAlpha);
  m_cGoStraightAngleRange.Set(-ToRadians(m_cAlpha), ToRadians(m_cAlpha));
  GetNodeAttributeOrDefault(t_node, "delta", m_fDelta, m_fDelta);
  GetNodeAttributeOrDefault(t_node, "velocity", m_fWheelVelocity, m_fWheelVelocity);
}

void CFootBotWander::ControlStep() {
  const CCI_FootBotProximitySensor::TReadings& tReadings = m_pcProximity->GetReadings();
  CVector2 cObstacle;
  for (size_t i = 0; i < tReadings.size(); ++i) {
    cObstacle += CVector2(tReadings[i].Value, tReadings[i].Angle);
  }
  cObstacle /= tReadings.size();
  CRadians cAngle = cObstacle.Angle();
  if (m_cGoStraightAngleRange.WithinMinBoundIncludedMaxBoundIncluded(cAngle) &&
      cObstacle.Length() < m_fDelta) {
    m_pcWheels->SetLinearVelocity(m_fWheelVelocity, m_fWheelVelocity);
  } else if (cAngle.GetValue() > 0.0f) {
    m_pcWheels->SetLinearVelocity(m_fWheelVelocity, 0.0f);
  } else {
    m_pcWheels->SetLinearVelocity(0.0f, m_fWheelVelocity);
  }
}

REGISTER_CONTROLLER(CFootBotWander, "footbot_wander_controller")
