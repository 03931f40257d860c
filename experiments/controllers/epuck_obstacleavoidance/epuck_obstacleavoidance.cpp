#include "epuck_obstacleavoidance.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

#include <vector>

using namespace argos;

namespace {

constexpr size_t kNumRays = 8;
// a low weight to the side: a wall beside the robot is ignored while the front is free
constexpr Real kWeights[3] = {1.0, 0.8, 0.2};  // of the rays at 17, 50 and 90 degrees
// exceeded by any detection of one front ray, because readings begin at 0.9
constexpr Real kThreshold = 0.5;

}  // namespace

void CEPuckObstacleAvoidance::Init(TConfigurationNode& params) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_proximity = GetSensor<CCI_ProximitySensor>("proximity");
  if (m_proximity->GetReadings().size() != kNumRays) {
    THROW_ARGOSEXCEPTION("this controller requires a robot with "
                         << kNumRays << " proximity rays; this one has "
                         << m_proximity->GetReadings().size());
  }
  GetNodeAttributeOrDefault(params, "velocity", m_velocity, m_velocity);
  Reset();
}

void CEPuckObstacleAvoidance::ControlStep() {
  const std::vector<Real>& readings = m_proximity->GetReadings();
  Real left = 0.0;
  Real right = 0.0;
  for (size_t i = 0; i < 3; ++i) {
    left += kWeights[i] * readings[i];
    right += kWeights[i] * readings[kNumRays - 1 - i];
  }
  if (left < kThreshold && right < kThreshold) {
    m_turnDirection = 0.0;
  } else if (m_turnDirection == 0.0) {
    // keep the direction until the way is free, to get out of corners
    m_turnDirection = left > right ? -1.0 : 1.0;
  }

  if (m_turnDirection == 0.0) {
    m_wheels->SetLinearVelocity(m_velocity, m_velocity);
  } else {
    m_wheels->SetLinearVelocity(-m_turnDirection * m_velocity, m_turnDirection * m_velocity);
  }
}

void CEPuckObstacleAvoidance::Reset() {
  m_turnDirection = 0.0;
}

REGISTER_CONTROLLER(CEPuckObstacleAvoidance, "epuck_obstacleavoidance_controller")
