#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>

namespace argos {

namespace {

// as published with ARGoS 3
constexpr int kNumReadings = 24;
constexpr Real kStartAngle = 7.5;  // degrees
constexpr Real kAngleStep = 360.0 / kNumReadings;  // degrees

}  // namespace

CCI_FootBotProximitySensor::CCI_FootBotProximitySensor() {
  m_tReadings.reserve(kNumReadings);
  for (int i = 0; i < kNumReadings; ++i) {
    m_tReadings.emplace_back(0.0,
                             ToRadians(CDegrees(kStartAngle + kAngleStep * i)).SignedNormalize());
  }
}

const CCI_FootBotProximitySensor::TReadings& CCI_FootBotProximitySensor::GetReadings() const {
  return m_tReadings;
}

}  // namespace argos
