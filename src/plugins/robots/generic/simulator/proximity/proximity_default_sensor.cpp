#include <argos3/plugins/robots/generic/simulator/proximity_default_sensor.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>

#include <cmath>
#include <typeinfo>

namespace argos {

CProximityDefaultSensor::CProximityDefaultSensor()
    : m_pcEmbodiedEntity(m_reader.GetCaster().AccessBody()),
      m_pcProximityEntity(m_reader.AccessSensors()),
      m_pcControllableEntity(m_reader.GetCaster().AccessRobot()),
      m_bShowRays(m_reader.AccessShowRays()),
      m_cSpace(CurrentSpace()) {
  m_reader.GetCaster().SetSpace(m_cSpace);
}

void CProximityDefaultSensor::Init(TConfigurationNode& tree) {
  if (typeid(*this) != typeid(CProximityDefaultSensor)) {
    m_reader.LeaveNoiseLevel();
    InitNoise(tree);
  }
  CPlainReadingsSensor::Init(tree);
}

void CProximityDefaultSensor::Update() {
  m_tReadings.resize(m_reader.GetNumSensors());
  const auto calculate = [this](Real distance) { return CalculateReading(distance); };
  const auto store = [this](size_t ray, Real reading) { m_tReadings[ray] = reading; };
  if (m_bAddNoise) {
    m_reader.Read(
        calculate, [this](Real reading) { return reading + DrawNoise(); }, store);
  } else {
    m_reader.Read(calculate, store);
  }
}

Real CProximityDefaultSensor::CalculateReading(Real distance) {
  return std::exp(-distance);
}

REGISTER_SENSOR(
    CProximityDefaultSensor, "proximity", "default", "the authors of this project", "1.0",
    "The proximity sensors of any robot.",
    R"(Every proximity sensor of the robot casts a ray from its position on the body. If the ray hits a
body other than the robot's own at the distance D (m) from its start, the sensor reads exp(-D), and 1 if it starts
inside one. If the ray hits nothing, the sensor reads 0.
)" + RayReadingsManual("proximity", "default", "the rays"),
    "Usable")

}  // namespace argos
