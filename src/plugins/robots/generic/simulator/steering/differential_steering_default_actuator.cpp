#include <argos3/plugins/robots/generic/simulator/differential_steering_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

#include <cmath>

namespace argos {

namespace {

constexpr Real kMetersPerCentimeter = 0.01;

// attributes for both wheels, the left and the right one
struct SWheelAttributes {
  std::string Both;
  std::string Left = Both + "_left";
  std::string Right = Both + "_right";
};
const SWheelAttributes kBiasAverage = {"bias_avg"};
const SWheelAttributes kBiasDeviation = {"bias_stddev"};
const SWheelAttributes kFactorAverage = {"factor_avg"};
const SWheelAttributes kFactorDeviation = {"factor_stddev"};

// the attribute of a wheel has precedence for it
bool ReadForWheels(TConfigurationNode& tree, const SWheelAttributes& attributes, Real& left,
                   Real& right) {
  bool present = false;
  const auto read = [&tree, &present](const std::string& attribute, Real& value) {
    if (NodeAttributeExists(tree, attribute)) {
      GetNodeAttribute(tree, attribute, value);
      present = true;
    }
  };
  read(attributes.Both, left);
  read(attributes.Left, left);
  read(attributes.Both, right);
  read(attributes.Right, right);
  return present;
}

}  // namespace

void CDifferentialSteeringDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  m_wheels = &robot.GetComponent<CWheeledEntity>("wheels");
  if (m_wheels->GetNumWheels() != 2) {
    THROW_ARGOSEXCEPTION(
        "actuator \"differential_steering\" needs a robot with two wheels; robot \""
        << robot.GetId() << "\" has " << m_wheels->GetNumWheels());
  }
}

void CDifferentialSteeringDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_DifferentialSteeringActuator::Init(tree);
  m_noise.Init(tree, *m_robot, {"left", "right"});
  SWheelNoise left;
  SWheelNoise right;
  bool noisy = ReadForWheels(tree, kBiasAverage, left.BiasAverage, right.BiasAverage);
  noisy = ReadForWheels(tree, kBiasDeviation, left.BiasDeviation, right.BiasDeviation) || noisy;
  noisy = ReadForWheels(tree, kFactorAverage, left.FactorAverage, right.FactorAverage) || noisy;
  noisy =
      ReadForWheels(tree, kFactorDeviation, left.FactorDeviation, right.FactorDeviation) || noisy;
  if (!noisy) {
    return;
  }
  for (const SWheelNoise& wheel : {left, right}) {
    RequireNotNegative(wheel.BiasDeviation, OwnerOf(tree), "attribute \"bias_stddev\" (m/s)");
    RequireNotNegative(wheel.FactorDeviation, OwnerOf(tree), "attribute \"factor_stddev\"");
  }
  m_wheelNoise = std::make_unique<SNoise>(SNoise{{left, right}, MakeStream()});
  DrawBiases();
}

CRandomStream CDifferentialSteeringDefaultActuator::MakeStream() const {
  return CRandomStream(m_robot->GetSimulator().GetRandomSeed(), "argos",
                       m_robot->GetRootEntity().GetId(), "differential steering actuator noise");
}

void CDifferentialSteeringDefaultActuator::DrawBiases() {
  for (SWheelNoise& wheel : m_wheelNoise->Wheels) {
    wheel.Bias = m_wheelNoise->Stream.Gaussian(wheel.BiasDeviation, wheel.BiasAverage);
  }
}

void CDifferentialSteeringDefaultActuator::SetLinearVelocity(Real left, Real right) {
  if (!std::isfinite(left) || !std::isfinite(right)) {
    THROW_ARGOSEXCEPTION("robot \"" << m_robot->GetRootEntity().GetId()
                                    << "\": wheel speeds must be finite, got left=" << left
                                    << ", right=" << right << " (cm/s)");
  }
  m_fCurrentVelocity[0] = left * kMetersPerCentimeter;
  m_fCurrentVelocity[1] = right * kMetersPerCentimeter;
  if (left == 0.0 && right == 0.0) {
    return;
  }
  for (size_t i = 0; i < 2; ++i) {
    if (m_wheelNoise != nullptr) {
      const SWheelNoise& wheel = m_wheelNoise->Wheels[i];
      const Real factor = m_wheelNoise->Stream.Gaussian(wheel.FactorDeviation, wheel.FactorAverage);
      m_fCurrentVelocity[i] = factor * (m_fCurrentVelocity[i] + wheel.Bias);
    }
    m_fCurrentVelocity[i] = m_noise.Apply(i, m_fCurrentVelocity[i]);
  }
}

void CDifferentialSteeringDefaultActuator::Override(Real left, Real right) {
  m_override = std::make_unique<std::array<Real, 2>>(
      std::array<Real, 2>{left * kMetersPerCentimeter, right * kMetersPerCentimeter});
}

void CDifferentialSteeringDefaultActuator::Update() {
  m_wheels->SetVelocities(GetSpeeds());
}

void CDifferentialSteeringDefaultActuator::Reset() {
  m_fCurrentVelocity[0] = 0.0;
  m_fCurrentVelocity[1] = 0.0;
  EndOverride();
  if (m_wheelNoise != nullptr) {
    m_wheelNoise->Stream = MakeStream();
    DrawBiases();
  }
  m_noise.Reset();
}

REGISTER_ACTUATOR(
    CDifferentialSteeringDefaultActuator, "differential_steering", "default",
    "the authors of this project", "1.0", "Drives the two wheels of a robot.",
    R"(The controller sets the ground speed of each wheel, in cm/s. A speed holds from the next tick on until it is
changed; at the start and after a reset the speeds are 0. There is no speed limit.
)" + RequiredActuatorXML(R"(<differential_steering implementation="default" />)") +
        R"(
OPTIONAL XML

Noise: a wheel whose speed is set to v rolls at f (v + b), unless both speeds are set to 0. The factor f is drawn from a
Gaussian each time the controller sets speeds, the bias b once at the start of the experiment.

  <differential_steering implementation="default"
                         bias_avg="0" bias_stddev="0.002"
                         factor_avg="1" factor_stddev="0.05" />

  bias_avg       m/s, default 0: mean of b.
  bias_stddev    m/s, >= 0, default 0: standard deviation of b.
  factor_avg     real number, default 1: mean of f.
  factor_stddev  real number >= 0, default 0: standard deviation of f.

Each of the four also exists for one wheel, for which it has precedence:

  <differential_steering implementation="default"
                         bias_avg_left="0.003" bias_avg_right="0" bias_stddev_left="0" bias_stddev_right="0.002"
                         factor_avg_left="1" factor_avg_right="1.1" factor_stddev_left="0" factor_stddev_right="0.1" />

  bias_avg_left, bias_avg_right            m/s, default that of bias_avg.
  bias_stddev_left, bias_stddev_right      m/s, >= 0, default that of bias_stddev.
  factor_avg_left, factor_avg_right        real number, default that of factor_avg.
  factor_stddev_left, factor_stddev_right  real number >= 0, default that of factor_stddev.
)" +
        NoiseManual("left|right",
                    "the speed of a wheel (m/s) each time the controller sets speeds, unless both "
                    "are set to 0."),
    "Usable")

}  // namespace argos
