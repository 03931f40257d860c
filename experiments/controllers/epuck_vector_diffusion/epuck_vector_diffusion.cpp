#include "epuck_vector_diffusion.h"

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/vector2.h>

using namespace argos;

void CEPuckVectorDiffusion::Init(TConfigurationNode& params) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_proximity = GetSensor<CCI_EPuckProximitySensor>("epuck_proximity");
  GetNodeAttributeOrDefault(params, "velocity", m_velocity, m_velocity);
  GetNodeAttributeOrDefault(params, "delta", m_delta, m_delta);
  GetNodeAttributeOrDefault(params, "alpha", m_alpha, m_alpha);
}

void CEPuckVectorDiffusion::ControlStep() {
  CVector2 mean;
  for (const CCI_EPuckProximitySensor::SReading& reading : m_proximity->GetReadings()) {
    // most sensors see nothing, and a sine and a cosine take longer than this test
    if (reading.Value > 0.0) {
      mean += CVector2(reading.Value, reading.Angle);
    }
  }
  mean /= static_cast<Real>(m_proximity->GetReadings().size());
  const CRadians angle = mean.Angle();
  const CRadians ahead = ToRadians(m_alpha);
  if (angle >= -ahead && angle <= ahead && mean.Length() < m_delta) {
    m_wheels->SetLinearVelocity(m_velocity, m_velocity);
  } else if (angle > CRadians::ZERO) {
    m_wheels->SetLinearVelocity(m_velocity, 0.0);
  } else {
    m_wheels->SetLinearVelocity(0.0, m_velocity);
  }
}

REGISTER_CONTROLLER(CEPuckVectorDiffusion, "epuck_vector_diffusion_controller")
