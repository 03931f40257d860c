#include "user_controller.h"

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/logging/argos_log.h>

CUserController::CUserController()
    : m_pcWheels(NULL),
      m_pcEncoder(NULL),
      m_pcLEDs(NULL),
      m_pcGenericProximity(NULL),
      m_pcFootBotProximity(NULL),
      m_pcEPuckProximity(NULL),
      m_pcRNG(NULL),
      m_cAlpha(10.0f),
      m_fDelta(0.5f),
      m_fWheelVelocity(2.5f),
      m_cGoStraightAngleRange(-ToRadians(m_cAlpha), ToRadians(m_cAlpha)),
      m_unSteps(0) {}

void CUserController::Init(TConfigurationNode& t_node) {
  try {
    m_pcWheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    m_pcEncoder = GetSensor<CCI_DifferentialSteeringSensor>("differential_steering");
    m_pcGenericProximity = GetSensor<CCI_ProximitySensor>("proximity");
    if (HasActuator("leds"))
      m_pcLEDs = GetActuator<CCI_LEDsActuator>("leds");
    if (HasSensor("footbot_proximity"))
      m_pcFootBotProximity = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
    if (HasSensor("epuck_proximity"))
      m_pcEPuckProximity = GetSensor<CCI_EPuckProximitySensor>("epuck_proximity");
    m_pcRNG = CRandom::CreateRNG("argos");
    GetNodeAttributeOrDefault(t_node, "alpha", m_cAlpha, m_cAlpha);
    m_cGoStraightAngleRange.Set(-ToRadians(m_cAlpha), ToRadians(m_cAlpha));
    GetNodeAttributeOrDefault(t_node, "delta", m_fDelta, m_fDelta);
    GetNodeAttributeOrDefault(t_node, "velocity", m_fWheelVelocity, m_fWheelVelocity);
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(
        "Error initializing the user controller for robot \"" << GetId() << "\"", ex);
  }
}

void CUserController::ControlStep() {
  ++m_unSteps;
  m_cCrowd = CVector2();
  if (m_pcFootBotProximity != NULL) {
    const CCI_FootBotProximitySensor::TReadings& tProxReads = m_pcFootBotProximity->GetReadings();
    for (size_t i = 0; i < tProxReads.size(); ++i) {
      m_cCrowd += CVector2(tProxReads[i].Value, tProxReads[i].Angle);
    }
    m_cCrowd /= tProxReads.size();
  }
  CRadians cAngle = m_cCrowd.Angle();
  if (m_cGoStraightAngleRange.WithinMinBoundIncludedMaxBoundIncluded(cAngle) &&
      m_cCrowd.Length() < m_fDelta) {
    m_pcWheels->SetLinearVelocity(m_fWheelVelocity, m_fWheelVelocity);
  } else {
    if (cAngle.GetValue() > 0.0f)
      m_pcWheels->SetLinearVelocity(m_fWheelVelocity, 0.0f);
    else
      m_pcWheels->SetLinearVelocity(0.0f, m_fWheelVelocity);
  }
  if (m_pcLEDs != NULL) {
    m_pcLEDs->SetAllColors(m_pcRNG->Bernoulli() ? CColor::RED : CColor::BLUE);
  }
}

void CUserController::Reset() {
  m_unSteps = 0;
}

REGISTER_CONTROLLER(CUserController, "user_controller")
