#include <argos3/plugins/robots/generic/simulator/differential_steering_default_sensor.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/units.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

namespace argos {

namespace {

enum : size_t { VELOCITY_LEFT, VELOCITY_RIGHT, DISTANCE_LEFT, DISTANCE_RIGHT };

}  // namespace

void CDifferentialSteeringDefaultSensor::FindParts(CComposableEntity& robot) {
  m_wheels = &robot.GetComponent<CWheeledEntity>("wheels");
  if (m_wheels->GetNumWheels() != 2) {
    THROW_ARGOSEXCEPTION("sensor \"differential_steering\" needs a robot with two wheels; robot \""
                         << robot.GetId() << "\" has " << m_wheels->GetNumWheels());
  }
  m_sReading.WheelAxisLength =
      kCentimetersPerMeter * Distance(m_wheels->GetWheelPosition(0), m_wheels->GetWheelPosition(1));
}

void CDifferentialSteeringDefaultSensor::Configure(TConfigurationNode& tree) {
  const CRange<Real> velocity = ReadNoiseRange(tree, "vel_noise_range");
  const CRange<Real> distance = ReadNoiseRange(tree, "dist_noise_range");
  m_noise.Init(tree, *m_robot,
               {"velocity_left", "velocity_right", "distance_left", "distance_right"},
               {velocity, velocity, distance, distance});
}

void CDifferentialSteeringDefaultSensor::Update() {
  const Real tick = m_robot->GetSimulator().GetTickLength();
  const Real* const velocities = m_wheels->GetOrderedVelocities();
  const Real left = kCentimetersPerMeter * velocities[0];
  const Real right = kCentimetersPerMeter * velocities[1];
  m_sReading.VelocityLeftWheel = m_noise.Apply(VELOCITY_LEFT, left);
  m_sReading.VelocityRightWheel = m_noise.Apply(VELOCITY_RIGHT, right);
  m_sReading.CoveredDistanceLeftWheel = m_noise.Apply(DISTANCE_LEFT, left * tick);
  m_sReading.CoveredDistanceRightWheel = m_noise.Apply(DISTANCE_RIGHT, right * tick);
}

void CDifferentialSteeringDefaultSensor::ResetReading() {
  m_sReading = SReading(0.0, 0.0, 0.0, 0.0, m_sReading.WheelAxisLength);
}

REGISTER_SENSOR(
    CDifferentialSteeringDefaultSensor, "differential_steering", "default",
    "the authors of this project", "1.0", "The encoders of the two wheels of a robot.",
    R"(Reads the speed of each wheel, in cm/s, and the distance that it rolled in the last tick, in cm, as set by the
actuator including its noise, even if the robot moved differently. The drift of differential_steering (dead_reckoning)
is not part of it: no sensor of the wheels shows that. Also reads the distance between the wheels, in cm.
)" + RequiredSensorXML(R"(<differential_steering implementation="default" />)") +
        OptionalXML(
            R"(<differential_steering implementation="default" vel_noise_range="-0.1:0.2" dist_noise_range="-10.5:13.7" />)") +
        R"(
  vel_noise_range   "min:max", cm/s, default "0:0": a number drawn evenly from it is added to each
                    speed in each tick.
  dist_noise_range  "min:max", cm, default "0:0": the same for the distances.
)" +
        NoiseManual("velocity_left|velocity_right|distance_left|distance_right",
                    "a speed (cm/s) or a distance (cm) in each tick."),
    "Usable")

}  // namespace argos
