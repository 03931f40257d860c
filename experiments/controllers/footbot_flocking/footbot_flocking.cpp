#include "footbot_flocking.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

using namespace argos;

namespace {

constexpr UInt32 kBeacon = 12;  // index of the LED on top
// radius of the neighbourhood, in target distances
constexpr Real kReach = 1.8;

void ReadPositive(TConfigurationNode& params, const std::string& name, Real& value) {
  GetNodeAttributeOrDefault(params, name, value, value);
  if (!(value > 0.0)) {
    THROW_ARGOSEXCEPTION(name << " is " << value << "; it must be > 0");
  }
}

}  // namespace

void CFootBotFlocking::Init(TConfigurationNode& params) {
  m_leds = GetActuator<CCI_LEDsActuator>("leds");
  m_light = GetSensor<CCI_FootBotLightSensor>("footbot_light");
  m_camera =
      GetSensor<CCI_ColoredBlobOmnidirectionalCameraSensor>("colored_blob_omnidirectional_camera");
  Real maxSpeed = 10.0;
  ReadPositive(params, "max_speed", maxSpeed);
  ReadPositive(params, "target_distance", m_targetDistance);
  ReadPositive(params, "gain", m_gain);
  ReadPositive(params, "light_speed", m_lightSpeed);
  m_steering = std::make_unique<CSteering>(
      *GetActuator<CCI_DifferentialSteeringActuator>("differential_steering"), maxSpeed);
  Reset();
}

void CFootBotFlocking::Reset() {
  m_camera->Enable();
  m_leds->SetSingleColor(kBeacon, CColor::RED);
}

void CFootBotFlocking::ControlStep() {
  // a reset switches the actuator's LEDs off
  m_leds->SetSingleColor(kBeacon, CColor::RED);
  m_steering->Follow(VectorToLight() + FlockingVector());
}

CVector2 CFootBotFlocking::VectorToLight() const {
  CVector2 sum;
  for (const CCI_FootBotLightSensor::SReading& reading : m_light->GetReadings()) {
    sum += CVector2(reading.Value, reading.Angle);
  }
  return sum.Length() > 0.0 ? CVector2(m_lightSpeed, sum.Angle()) : CVector2();
}

CVector2 CFootBotFlocking::FlockingVector() const {
  CVector2 sum;
  for (const auto* blob : m_camera->GetReadings().BlobList) {
    if (blob->Color != CColor::RED || blob->Distance > kReach * m_targetDistance) {
      continue;
    }
    const Real ratio = m_targetDistance / blob->Distance;
    const Real repulsion = m_gain / blob->Distance * (::pow(ratio, 4) - ::pow(ratio, 2));
    sum += CVector2(-repulsion, blob->Angle);
  }
  return sum;
}

REGISTER_CONTROLLER(CFootBotFlocking, "footbot_flocking_controller")
