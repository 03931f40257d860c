#include <argos3/plugins/robots/generic/simulator/proximity_default_sensor.h>

#include <cmath>

namespace argos {

void CProximityDefaultSensor::SetRobot(CComposableEntity& robot) {
  m_rays.SetRobot(robot);
}

void CProximityDefaultSensor::Init(TConfigurationNode& tree) {
  CCI_ProximitySensor::Init(tree);
  m_rays.Init(tree);
  m_tReadings.assign(m_rays.GetNumRays(), 0.0);
  Enable();
}

void CProximityDefaultSensor::Update() {
  m_tReadings.resize(m_rays.GetNumRays());
  m_rays.Read([this](Real distance) { return CalculateReading(distance); },
              [this](size_t ray, Real reading) { m_tReadings[ray] = reading; });
}

void CProximityDefaultSensor::Reset() {
  m_tReadings.assign(m_rays.GetNumRays(), 0.0);
  m_rays.Reset();
}

Real CProximityDefaultSensor::CalculateReading(Real distance) {
  return std::exp(-distance);
}

REGISTER_SENSOR(
    CProximityDefaultSensor, "proximity", "default", "the authors of this project", "1.0",
    "The proximity sensors of any robot.",
    R"(Every proximity sensor of the robot casts a ray from its place on the body. If the ray meets a
body other than the robot's own at the distance D (m) from its start, the sensor reads exp(-D), and 1 if it starts
inside one. A ray that meets nothing reads 0.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <proximity implementation="default" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

  <proximity implementation="default" show_rays="true" noise_level="0.1" />

  show_rays    "true" or "false", default "false": rays are shown by visualizations that can.
  noise_level  real number n >= 0, default 0: a number drawn evenly from [-n,n] is added to each
               reading in each tick, and the sum is clamped to [0,1].

Children <noise on="reading" model="uniform|gaussian|rayleigh" level|std_dev|sigma="..." bias="0" relative="false" />
add noise to every reading, before it is clamped.
)",
    "Usable")

}  // namespace argos
