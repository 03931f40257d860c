#include <argos3/plugins/robots/e-puck/simulator/epuck_proximity_default_sensor.h>

#include <argos3/plugins/robots/generic/simulator/device_manual.h>

#include <algorithm>
#include <typeinfo>

namespace argos {

namespace {

// response curve as published with ARGoS 3: kA D^2 + kB D + kC up to kReach
constexpr Real kReach = 0.05;  // m
constexpr Real kA = 298.701;  // 1/m^2
constexpr Real kB = -36.8961;  // 1/m
constexpr Real kC = 1.08212;

inline Real ComputeResponse(Real distance) {
  const Real response = std::clamp((kA * distance + kB) * distance + kC, 0.0, 1.0);
  return distance > kReach ? 0.0 : response;
}

}  // namespace

void CEPuckProximityDefaultSensor::Init(TConfigurationNode& tree) {
  CAngularProximitySensor::Init(tree);
  m_isDerived = typeid(*this) != typeid(CEPuckProximityDefaultSensor);
  if (!m_isDerived) {
    m_reader.SetRange(kReach);
  }
}

void CEPuckProximityDefaultSensor::Update() {
  if (m_isDerived) {
    CAngularProximitySensor::Update();
  } else {
    // inline, not a virtual call for each ray
    Read([](Real distance) { return ComputeResponse(distance); });
  }
}

Real CEPuckProximityDefaultSensor::CalculateReading(Real distance) {
  return ComputeResponse(distance);
}

REGISTER_SENSOR(
    CEPuckProximityDefaultSensor, "epuck_proximity", "default", "the authors of this project",
    "1.0", "The proximity sensors of the e-puck.",
    R"(Eight sensors at a height of 6 cm, at about 17, 50, 90, 150, -150, -90, -50 and -17 degrees, each with a
ray of 10 cm from the surface of the body. If the ray hits a body other than the robot's own at the distance D (m)
from its start, the sensor reads 298.701 D^2 - 36.8961 D + 1.08212, clamped to [0,1], for D <= 0.05; otherwise 0. If
the ray hits nothing, the sensor reads 0.
)" + RayReadingsManual("epuck_proximity", "default", "the rays"),
    "Usable")

}  // namespace argos
