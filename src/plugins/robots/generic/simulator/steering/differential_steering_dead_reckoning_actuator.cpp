#include <argos3/plugins/robots/generic/simulator/differential_steering_dead_reckoning_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

namespace argos {

namespace {

enum EWheel : size_t { LEFT, RIGHT };

}  // namespace

void CDifferentialSteeringDeadReckoningActuator::Init(TConfigurationNode& tree) {
  CDifferentialSteeringDefaultActuator::Init(tree);
  GetNodeAttributeOrDefault(tree, "sigma", m_sigma, m_sigma);
  RequireNotNegative(m_sigma, OwnerOf(tree), "attribute \"sigma\"");
  std::string backward = "faster";
  GetNodeAttributeOrDefault(tree, "backward", backward, backward);
  if (backward != "faster" && backward != "slower") {
    THROW_ARGOSEXCEPTION(tree.GetLocation()
                         << ": <" << tree.Value()
                         << ">: attribute \"backward\" must be \"faster\" or \"slower\", found \""
                         << backward << "\"");
  }
  m_backwardSign = backward == "faster" ? 1.0 : -1.0;
  GetWheels().EnableDrift();
  Restart();
}

void CDifferentialSteeringDeadReckoningActuator::Restart() {
  m_stream.emplace(GetRobot().GetSimulator().GetRandomSeed(), "argos",
                   GetRobot().GetRootEntity().GetId(), "differential steering dead reckoning");
  m_deviation = m_stream->Rayleigh(m_sigma);
  m_wasHolding = false;
}

bool CDifferentialSteeringDeadReckoningActuator::IsHolding() {
  const CEntity::TVector& components = GetRobot().GetParent().GetExistingComponents();
  const bool isCurrent = components.size() == m_numComponents &&
                         (m_gripper == nullptr || components[m_gripperPlace] == m_gripper);
  if (!isCurrent) {
    FindGripper(components);
  }
  return m_gripper != nullptr && m_gripper->IsGripping();
}

void CDifferentialSteeringDeadReckoningActuator::FindGripper(const CEntity::TVector& components) {
  m_numComponents = components.size();
  m_gripper = nullptr;
  for (size_t i = 0; i < components.size(); ++i) {
    if (const auto* gripper = dynamic_cast<const CGripperEquippedEntity*>(components[i])) {
      m_gripper = gripper;
      m_gripperPlace = i;
    }
  }
}

void CDifferentialSteeringDeadReckoningActuator::Update() {
  const bool isHolding = IsHolding();
  if (isHolding && !m_wasHolding) {
    m_deviation = m_stream->Rayleigh(m_sigma);
  }
  m_wasHolding = isHolding;
  const Real* const ordered = GetSpeeds();
  Real velocities[2] = {ordered[LEFT], ordered[RIGHT]};
  const Real drift = m_deviation * 0.5 * (velocities[LEFT] + velocities[RIGHT]);
  if (drift > 0.0) {
    velocities[RIGHT] += drift;
  } else {
    velocities[LEFT] += m_backwardSign * drift;
  }
  GetWheels().SetDriftingVelocities(ordered, velocities);
}

void CDifferentialSteeringDeadReckoningActuator::Reset() {
  CDifferentialSteeringDefaultActuator::Reset();
  Restart();
}

REGISTER_ACTUATOR(
    CDifferentialSteeringDeadReckoningActuator, "differential_steering", "dead_reckoning",
    "the authors of this project", "1.0",
    "Drives the two wheels of a robot, which drifts unnoticed by its encoders.",
    R"(Like differential_steering (default), with the same attributes, but the robot drifts, as robots do that navigate
by dead reckoning, and encoders read the commanded speeds. With v = the mean of the two commanded speeds, the right wheel
rolls mu |v| faster while v > 0, and the left wheel mu |v| faster backwards while v < 0. With equal speeds, a robot with
the distance d between its wheels follows a circle of radius d (2 + mu) / (2 mu): ahead around a point on its left, back
around one on its right, so that going back and forth draws an S. mu is drawn from a Rayleigh distribution at the start,
and again each time the gripper of the robot grips a body.
)" + RequiredActuatorXML(R"(<differential_steering implementation="dead_reckoning" />)") +
        OptionalXML(
            R"(<differential_steering implementation="dead_reckoning" sigma="0.00134" backward="faster" />)") +
        R"(
  sigma     real number >= 0, default 0.00134: of the Rayleigh distribution; the mean of mu is 1.2533 sigma.
  backward  "faster" (default) or "slower": what the drift makes of the left wheel while v < 0. If it is slower by
            mu |v|, the robot follows a circle of radius d (2 - mu) / (2 mu) around a point on its left, and retraces
            its way ahead.

The drift is applied after all attributes and <noise> children of differential_steering (default).
)",
    "Usable")

}  // namespace argos
