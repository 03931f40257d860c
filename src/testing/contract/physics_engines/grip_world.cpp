#include <argos3/testing/contract/physics_engines/grip_world.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>

#include <argos3/core/simulator/geometry/body_description.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace argos {

namespace {

// interval of random commands, ticks
constexpr UInt32 kTicksPerCommand = 7;

SExperiment MakeExperiment(const std::string& arena, const CGripWorld::SOptions& options) {
  SExperiment experiment;
  experiment.Controllers =
      "<contract_gripper id='gripper'><actuators>"
      "<differential_steering implementation='default'/>"
      "<footbot_gripper implementation='default'/><footbot_turret implementation='default'/>"
      "</actuators><sensors/></contract_gripper>";
  experiment.Engines = options.Engine;
  experiment.TicksPerSecond = options.TicksPerSecond;
  experiment.Threads = options.Threads;
  experiment.ArenaSize = "80,80,2";
  experiment.Arena = arena;
  return experiment;
}

}  // namespace

void CContractGripper::Init(TConfigurationNode& params) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_gripper = GetActuator<CCI_FootBotGripperActuator>("footbot_gripper");
  m_turret = GetActuator<CCI_FootBotTurretActuator>("footbot_turret");
  GetNodeAttributeOrDefault(params, "left", m_left, m_left);
  GetNodeAttributeOrDefault(params, "right", m_right, m_right);
  GetNodeAttributeOrDefault(params, "lock", m_lock, m_lock);
  GetNodeAttributeOrDefault(params, "turret", m_turretIsOn, m_turretIsOn);
  GetNodeAttributeOrDefault(params, "grip", m_grips, m_grips);
  bool random = false;
  GetNodeAttributeOrDefault(params, "random", random, random);
  if (random) {
    m_random.emplace(1, "test", GetId(), "commands");
  }
  Reset();
}

void CContractGripper::Reset() {
  Left = m_left;
  Right = m_right;
  Lock = m_lock;
  Mode = CCI_FootBotTurretActuator::MODE_OFF;
  TurretSpeed = 0;
  TurretRotation = CRadians::ZERO;
  m_tick = 0;
  if (m_random) {
    m_random->Reset();
  }
}

void CContractGripper::ControlStep() {
  if (m_random && m_tick++ % kTicksPerCommand == 0) {
    DrawCommands();
  }
  m_wheels->SetLinearVelocity(Left, Right);
  Lock ? m_gripper->LockPositive() : m_gripper->Unlock();
  m_turret->SetMode(Mode);
  m_turret->SetRotationSpeed(TurretSpeed);
  m_turret->SetRotation(TurretRotation);
}

void CContractGripper::DrawCommands() {
  Left = m_random->Uniform(-15.0, 15.0);
  Right = m_random->Uniform(-15.0, 15.0);
  // locked most of the time
  Lock = m_random->Bernoulli(0.95) && m_grips;
  Mode = static_cast<CCI_FootBotTurretActuator::ETurretModes>(
      m_random->UniformInteger(m_turretIsOn ? UInt64(4) : UInt64(2)));
  TurretSpeed = static_cast<SInt32>(m_random->UniformInteger(SInt64(-4), SInt64(4)));
  TurretRotation = CRadians(m_random->Uniform(-ARGOS_PI, ARGOS_PI));
}

std::string GripperXml(const std::string& id, Real x, Real y, Real yaw, const std::string& params,
                       Real force, Real torque) {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<foot-bot id='" << id << "'><body position='" << x << "," << y
      << ",0' orientation='" << yaw << ",0,0'/><controller config='gripper'><params " << params
      << "/></controller><dynamics2d><differential_steering max_force='" << force
      << "' max_torque='" << torque << "'/></dynamics2d></foot-bot>\n";
  return xml.str();
}

std::string LoadXml(const std::string& id, Real x, Real y, Real mass, Real yaw) {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<box id='" << id << "' size='0.2,0.2,0.1' movable='true' mass='"
      << mass << "'><body position='" << x << "," << y << ",0' orientation='" << yaw
      << ",0,0'/></box>\n";
  return xml.str();
}

std::string RollXml(const std::string& id, Real x, Real y, Real mass) {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<cylinder id='" << id
      << "' radius='0.1' height='0.1' movable='true' mass='" << mass << "'><body position='" << x
      << "," << y << ",0'/></cylinder>\n";
  return xml.str();
}

CGripWorld::CGripWorld(const std::string& arena, const SOptions& options)
    : CTestWorld(MakeExperiment(arena, options)), m_scope(GetSimulator()) {}

CEmbodiedEntity& CGripWorld::Body(const std::string& id) {
  return Get<CComposableEntity>(id).GetComponent<CEmbodiedEntity>("body");
}

Real CGripWorld::Yaw(const std::string& id) {
  CRadians z;
  CRadians y;
  CRadians x;
  Body(id).GetOriginAnchor().Orientation.ToEulerAngles(z, y, x);
  return z.GetValue();
}

CContractGripper& CGripWorld::Driver(const std::string& id) {
  auto& controllable = Get<CComposableEntity>(id).GetComponent<CControllableEntity>("controller");
  return dynamic_cast<CContractGripper&>(controllable.GetController());
}

CGripperEquippedEntity& CGripWorld::Gripper(const std::string& id) {
  return Get<CComposableEntity>(id).GetComponent<CGripperEquippedEntity>("gripper");
}

CTurretEntity& CGripWorld::Turret(const std::string& id) {
  return Get<CComposableEntity>(id).GetComponent<CTurretEntity>("turret");
}

std::string CGripWorld::HeldBy(const std::string& id) {
  CGripperEquippedEntity& gripper = Gripper(id);
  return gripper.IsGripping() ? gripper.GetGrippedEntity().GetRootEntity().GetId() : "";
}

void CGripWorld::Drive(const std::string& id, Real left, Real right) {
  Driver(id).Left = left;
  Driver(id).Right = right;
}

CGripWorld::TPoses CGripWorld::GetPoses() {
  TPoses poses;
  for (CEntity* root : GetSpace().GetRootEntityVector()) {
    auto& composable = dynamic_cast<CComposableEntity&>(*root);
    const SAnchor& origin = composable.GetComponent<CEmbodiedEntity>("body").GetOriginAnchor();
    const bool isRobot = composable.HasComponent("turret");
    poses[root->GetId()] = {
        origin.Position, origin.Orientation,
        isRobot ? Turret(root->GetId()).GetAnchor().OffsetOrientation : CQuaternion()};
  }
  return poses;
}

namespace {

CVector3 Rotated(CVector3 vector, const CQuaternion& rotation) {
  return vector.Rotate(rotation);
}

// the point of a solid, in its body's frame, that is nearest to a point at its height
CVector3 ComputeNearest(const SShapeDescription& shape, const CVector3& point) {
  CVector3 nearest = point;
  if (shape.Kind == SShapeDescription::EKind::Box) {
    for (const UInt32 axis : {0U, 1U}) {
      const Real half = 0.5 * shape.Size[axis];
      nearest[axis] = std::clamp(point[axis], -half, half);
    }
  } else if (point.Length() > shape.Radius) {
    nearest *= shape.Radius / point.Length();
  }
  return nearest;
}

}  // namespace

CGripGauge::CGripGauge(CGripWorld& world, const std::string& robot,
                       const CGripWorld::TPoses& before)
    : m_world(world), m_robot(robot), m_held(world.Gripper(robot).GetGrippedEntity()) {
  const CGripWorld::SPose& own = before.at(robot);
  const CGripWorld::SPose& held = before.at(m_held.GetRootEntity().GetId());
  CVector3 gripper = m_world.Gripper(m_robot).GetOffset();
  gripper.SetZ(0.0);
  const CVector3 centre = own.Position + Rotated(gripper, own.Orientation * own.Turret);
  m_point = ComputeNearest(m_held.GetBodyDescription()->Shapes.front(),
                           Rotated(centre - held.Position, held.Orientation.Inverse()));
  m_arm = ComputePoint(before);
}

// in the frame of the turret
CGripGauge CGripGauge::Grip(CGripWorld& world, const std::string& robot, const std::string& body) {
  const CGripWorld::TPoses start = world.GetPoses();
  world.Step(2);
  REQUIRE(world.HeldBy(robot) == body);
  return CGripGauge(world, robot, start);
}

CVector3 CGripGauge::ComputePoint(const CGripWorld::TPoses& poses) const {
  const CGripWorld::SPose& own = poses.at(m_robot);
  const CGripWorld::SPose& held = poses.at(m_held.GetRootEntity().GetId());
  const CVector3 point = held.Position + Rotated(m_point, held.Orientation);
  return Rotated(point - own.Position, (own.Orientation * own.Turret).Inverse());
}

CVector3 CGripGauge::ComputeError() const {
  return ComputePoint(m_world.GetPoses()) - m_arm;
}

Real CGripGauge::Stretch() const {
  return ComputeError().DotProduct(m_arm) / m_arm.Length();
}

Real CGripGauge::Sideways() const {
  return CVector3(m_arm).CrossProduct(ComputeError()).GetZ() / m_arm.Length();
}

REGISTER_CONTROLLER(CContractGripper, "contract_gripper")

}  // namespace argos
