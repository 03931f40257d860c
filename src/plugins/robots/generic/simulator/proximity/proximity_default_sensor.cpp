#include <argos3/plugins/robots/generic/simulator/proximity_default_sensor.h>

#include <argos3/plugins/robots/generic/simulator/device_manual.h>

#include <cmath>

namespace argos {

void CProximityDefaultSensor::Update() {
  m_tReadings.resize(m_reader.GetNumSensors());
  m_reader.Read([this](Real distance) { return CalculateReading(distance); },
                [this](size_t ray, Real reading) { m_tReadings[ray] = reading; });
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
