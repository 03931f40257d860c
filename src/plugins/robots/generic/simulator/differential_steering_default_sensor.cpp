#include <argos3/plugins/robots/generic/simulator/differential_steering_default_sensor.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

namespace argos {

namespace {

constexpr Real kCentimetersPerMeter = 100.0;

}  // namespace

void CDifferentialSteeringDefaultSensor::SetRobot(CComposableEntity& robot) {
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  m_wheels = &robot.GetComponent<CWheeledEntity>("wheels");
  if (m_wheels->GetNumWheels() != 2) {
    THROW_ARGOSEXCEPTION("sensor \"differential_steering\" needs a robot with two wheels; robot \""
                         << robot.GetId() << "\" has " << m_wheels->GetNumWheels());
  }
  m_sReading.WheelAxisLength =
      kCentimetersPerMeter * Distance(m_wheels->GetWheelPosition(0), m_wheels->GetWheelPosition(1));
}

void CDifferentialSteeringDefaultSensor::Init(TConfigurationNode& tree) {
  CCI_DifferentialSteeringSensor::Init(tree);
  CRange<Real> velocity(0.0, 0.0);
  CRange<Real> distance(0.0, 0.0);
  GetNodeAttributeOrDefault(tree, "vel_noise_range", velocity, velocity);
  GetNodeAttributeOrDefault(tree, "dist_noise_range", distance, distance);
  if (velocity.GetSpan() > 0.0 || distance.GetSpan() > 0.0) {
    m_noise = std::make_unique<SNoise>(SNoise{velocity, distance, MakeStream()});
  }
  Enable();
}

CRandomStream CDifferentialSteeringDefaultSensor::MakeStream() const {
  return CRandomStream(m_robot->GetSimulator().GetRandomSeed(), "argos",
                       m_robot->GetRootEntity().GetId(), "differential steering sensor noise");
}

void CDifferentialSteeringDefaultSensor::Update() {
  const Real tick = m_robot->GetSimulator().GetTickLength();
  const Real* const velocities = m_wheels->GetWheelVelocities();
  m_sReading.VelocityLeftWheel = kCentimetersPerMeter * velocities[0];
  m_sReading.VelocityRightWheel = kCentimetersPerMeter * velocities[1];
  m_sReading.CoveredDistanceLeftWheel = m_sReading.VelocityLeftWheel * tick;
  m_sReading.CoveredDistanceRightWheel = m_sReading.VelocityRightWheel * tick;
  if (m_noise != nullptr) {
    AddNoise();
  }
}

void CDifferentialSteeringDefaultSensor::AddNoise() {
  const auto draw = [this](const CRange<Real>& range) {
    return m_noise->Stream.Uniform(range.GetMin(), range.GetMax());
  };
  m_sReading.VelocityLeftWheel += draw(m_noise->Velocity);
  m_sReading.VelocityRightWheel += draw(m_noise->Velocity);
  m_sReading.CoveredDistanceLeftWheel += draw(m_noise->Distance);
  m_sReading.CoveredDistanceRightWheel += draw(m_noise->Distance);
}

void CDifferentialSteeringDefaultSensor::Reset() {
  m_sReading = SReading(0.0, 0.0, 0.0, 0.0, m_sReading.WheelAxisLength);
  if (m_noise != nullptr) {
    m_noise->Stream = MakeStream();
  }
}

REGISTER_SENSOR(
    CDifferentialSteeringDefaultSensor, "differential_steering", "default",
    "the authors of this project", "1.0", "The encoders of the two wheels of a robot.",
    R"(Reads the speed of each wheel, in cm/s, and how far it rolled in the last tick, in cm: as ordered
by the actuator, its noise included, whether or not the robot moved so far. Also the distance between the wheels, in cm.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <differential_steering implementation="default" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

  <differential_steering implementation="default" vel_noise_range="-0.1:0.2" dist_noise_range="-10.5:13.7" />

  vel_noise_range   "min:max", cm/s, default "0:0": a number drawn evenly from it is added to each
                    speed in each tick.
  dist_noise_range  "min:max", cm, default "0:0": the same for the distances.
)",
    "Usable")

}  // namespace argos
