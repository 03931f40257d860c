// Gripper and turret of the foot-bot as seen by controllers.

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_encoder_sensor.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_turret_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_gripper_actuator.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/testing/contract/sensors/scene.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripper_turret_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

using TTurret = CCI_FootBotTurretActuator;

constexpr Real kRadius = kFootBotRadius;
constexpr Real kHalf = 0.1;  // m, of an object to be gripped
constexpr Real kReach = 0.01;  // m, around the gripper's point
constexpr Real kNaN = std::numeric_limits<Real>::quiet_NaN();

SRobotExperiment With(const std::string& actuators, const std::string& sensors = "") {
  SRobotExperiment experiment;
  experiment.Actuators = actuators;
  experiment.Sensors = sensors;
  experiment.Engine = "<dynamics2d id=\"dyn2d\" velocity_lag=\"0\"/>";
  experiment.Arena = Robot("foot-bot", "r", "");
  return experiment;
}

// a movable object near a foot-bot at the origin that faces along x; (x, y) is its nearest point
std::string Thing(const std::string& kind, Real x, Real y) {
  if (kind == "foot-bot") {
    return Robot("foot-bot", "thing", "position=\"" + ToText(CVector3(x + kRadius, y, 0)) + "\"");
  }
  const bool isBox = kind == "box";
  return "<" + kind + " id=\"thing\" " +
         (isBox ? "size=\"0.2,0.2,0.1\"" : "radius=\"0.1\" height=\"0.1\"") +
         " movable=\"true\" mass=\"1\"><body position=\"" +
         ToText(CVector3(x + kHalf, isBox && y != 0.0 ? y + kHalf : y, 0)) + "\"/></" + kind + ">";
}

bool Grips(CRobotWorld& world) {
  world.GetActuator<CCI_FootBotGripperActuator>("r", "footbot_gripper").LockPositive();
  // orders act in the next tick
  world.Step();
  return world.Get<CFootBotEntity>("r").GetGripperEquippedEntity().IsGripping();
}

CVector3 PositionOf(CRobotWorld& world, const std::string& id) {
  return world.Get<CComposableEntity>(id)
      .GetComponent<CEmbodiedEntity>("body")
      .GetOriginAnchor()
      .Position;
}

SRobotExperiment WithTurret(const std::string& engine = "dynamics2d") {
  SRobotExperiment experiment = With("<footbot_turret implementation=\"default\"/>",
                                     "<footbot_turret_encoder implementation=\"default\"/>");
  experiment.Engine = "<" + engine + " id=\"e\"/>";
  return experiment;
}

}  // namespace

TEST_CASE("gripper actuator: it is locked above one half, from the next tick on",
          "[contract][robots]") {
  CRobotWorld world(With("<gripper implementation=\"default\"/>"));
  auto& actuator = world.GetActuator<CCI_GripperActuator>("r", "gripper");
  CGripperEquippedEntity& gripper = world.Get<CFootBotEntity>("r").GetGripperEquippedEntity();
  const auto lockStateFor = [&](auto&& order) {
    order();
    world.Step();
    return gripper.GetLockState();
  };
  CHECK(gripper.GetLockState() == 0.0);
  CHECK(lockStateFor([&] { actuator.Lock(); }) == 1.0);
  CHECK(gripper.IsLocked());
  CHECK(lockStateFor([&] { actuator.SetLockState(0.5); }) == 0.5);
  CHECK_FALSE(gripper.IsLocked());
  CHECK(lockStateFor([&] { actuator.SetLockState(7.0); }) == 1.0);
  CHECK(lockStateFor([&] { actuator.SetLockState(-7.0); }) == 0.0);
  CHECK(lockStateFor([&] { actuator.Lock(); }) == 1.0);
  CHECK(lockStateFor([&] { actuator.Unlock(); }) == 0.0);
  actuator.Lock();
  world.Step();
  world.GetSimulator().Reset();
  CHECK(gripper.GetLockState() == 0.0);
  world.Step();
  CHECK(gripper.GetLockState() == 0.0);
}

TEST_CASE("footbot_gripper: it is locked beyond 45 degrees to either side", "[contract][robots]") {
  CRobotWorld world(With("<footbot_gripper implementation=\"default\"/>"));
  auto& actuator = world.GetActuator<CCI_FootBotGripperActuator>("r", "footbot_gripper");
  CGripperEquippedEntity& gripper = world.Get<CFootBotEntity>("r").GetGripperEquippedEntity();
  const auto lockStateAt = [&](Real degrees) {
    actuator.SetAperture(ToRadians(CDegrees(degrees)));
    world.Step();
    return gripper.GetLockState();
  };
  CHECK_THAT(lockStateAt(30.0), WithinAbs(1.0 / 3.0, 1e-12));
  CHECK_FALSE(gripper.IsLocked());
  CHECK_THAT(lockStateAt(-60.0), WithinAbs(2.0 / 3.0, 1e-12));
  CHECK(gripper.IsLocked());
  // clamped to 90 degrees after removing full turns
  CHECK(lockStateAt(170.0) == 1.0);
  CHECK_THAT(lockStateAt(360.0 + 9.0), WithinAbs(0.1, 1e-12));
  actuator.LockPositive();
  world.Step();
  CHECK(gripper.IsLocked());
  actuator.Unlock();
  world.Step();
  CHECK(gripper.GetLockState() == 0.0);
  actuator.LockNegative();
  world.Step();
  CHECK(gripper.IsLocked());
  CHECK_THROWS_WITH(actuator.SetAperture(CRadians(kNaN)), Contains("must be a finite angle"));
  actuator.EnableCheckForObjectGrippedRoutine();
  actuator.DisableCheckForObjectGrippedRoutine();
  world.Step();
  CHECK(gripper.IsLocked());
  world.GetSimulator().Reset();
  world.Step();
  CHECK_FALSE(gripper.IsLocked());
}

TEST_CASE("gripper: its position follows the foot-bot's measures", "[contract][robots]") {
  CRobotWorld world(With("<gripper implementation=\"default\"/>"));
  CGripperEquippedEntity& gripper = world.Get<CFootBotEntity>("r").GetGripperEquippedEntity();
  CHECK(gripper.GetOffset() == CVector3(kFootBotRadius, 0.0, 0.085));
  CHECK(gripper.GetDirection() == CVector3::X);
  gripper.SetOffset(CVector3(0.1, 0.0, 0.1));
  world.GetSimulator().Reset();
  CHECK(gripper.GetOffset() == CVector3(kFootBotRadius, 0.0, 0.085));
}

TEST_CASE("footbot_gripper: its reach is a disc of 1 cm around its point", "[contract][robots]") {
  const std::string kind = GENERATE(as<std::string>(), "box", "cylinder", "foot-bot");
  CAPTURE(kind);
  const auto isHeld = [&kind](Real gap, Real side) {
    SRobotExperiment experiment = With("<footbot_gripper implementation=\"default\"/>");
    experiment.Arena += Thing(kind, kRadius + gap, side);
    CRobotWorld world(experiment);
    return Grips(world);
  };
  // tolerance for the single precision of the engine
  CHECK(isHeld(0.001, 0.0));
  CHECK(isHeld(kReach - 1e-5, 0.0));
  CHECK_FALSE(isHeld(kReach + 1e-5, 0.0));
  if (kind == "box") {
    // the corner of the box, along a diagonal
    const Real diagonal = kReach * std::sqrt(0.5);
    CHECK(isHeld(diagonal - 1e-5, diagonal - 1e-5));
    CHECK_FALSE(isHeld(diagonal + 1e-5, diagonal + 1e-5));
  }
}

TEST_CASE("footbot_gripper: the disc turns with the robot and with its turret",
          "[contract][robots]") {
  // an object beside the robot is gripped if the robot or its turret faces it
  SRobotExperiment experiment = With(
      "<footbot_gripper implementation=\"default\"/><footbot_turret implementation=\"default\"/>");
  experiment.Arena +=
      "<cylinder id=\"thing\" radius=\"0.1\" height=\"0.1\" movable=\"true\" mass=\"1\"><body "
      "position=\"0,0.19,0\"/></cylinder>";
  CRobotWorld ahead(experiment);
  CHECK_FALSE(Grips(ahead));
  ahead.GetActuator<TTurret>("r", "footbot_turret").SetActiveWithRotation(CRadians::PI_OVER_TWO);
  ahead.Step(150);
  CHECK(ahead.Get<CFootBotEntity>("r").GetGripperEquippedEntity().IsGripping());
  const size_t robot = experiment.Arena.find("<body ");
  experiment.Arena.insert(robot + 6, "orientation=\"90,0,0\" ");
  CRobotWorld turned(experiment);
  CHECK(Grips(turned));
}

TEST_CASE("footbot_gripper: a gripped object follows the robot until it is released",
          "[contract][robots]") {
  const std::string kind = GENERATE(as<std::string>(), "box", "cylinder", "foot-bot");
  CAPTURE(kind);
  SRobotExperiment experiment = With(
      "<footbot_gripper implementation=\"default\"/>"
      "<differential_steering implementation=\"default\"/>");
  experiment.Arena += Thing(kind, kRadius + 0.005, 0.0);
  CRobotWorld world(experiment);
  REQUIRE(Grips(world));
  const CVector3 arm = PositionOf(world, "thing") - PositionOf(world, "r");
  auto& wheels = world.GetActuator<CCI_DifferentialSteeringActuator>("r", "differential_steering");
  // the wheels of a gripped foot-bot roll along: otherwise its drive would brake with 15 N
  if (kind == "foot-bot") {
    world.GetActuator<CCI_DifferentialSteeringActuator>("thing", "differential_steering")
        .SetLinearVelocity(-5.0, -5.0);
  }
  wheels.SetLinearVelocity(-5.0, -5.0);
  world.Step(40);
  CHECK_THAT(PositionOf(world, "r").GetX(), WithinAbs(-0.2, 1e-3));
  // 1.49 N of friction stretch the grip by 0.15 mm
  CHECK_THAT(Distance(PositionOf(world, "thing") - PositionOf(world, "r"), arm),
             WithinAbs(0.0, 5e-4));
  world.GetActuator<CCI_FootBotGripperActuator>("r", "footbot_gripper").Unlock();
  if (kind == "foot-bot") {
    world.GetActuator<CCI_DifferentialSteeringActuator>("thing", "differential_steering")
        .SetLinearVelocity(0.0, 0.0);
  }
  // friction stops 5 cm/s after 0.034 s at 1.49 m/s^2
  world.Step(3);
  const CVector3 left = PositionOf(world, "thing");
  world.Step(20);
  CHECK_THAT(Distance(PositionOf(world, "thing"), left), WithinAbs(0.0, 1e-6));
  CHECK_THAT(PositionOf(world, "r").GetX(), WithinAbs(-0.2 - 0.05 * 2.3, 1e-3));
}

TEST_CASE("footbot_gripper: closing without an object in reach is no error and has no effect",
          "[contract][robots]") {
  SRobotExperiment experiment = With(
      "<footbot_gripper implementation=\"default\"/>"
      "<differential_steering implementation=\"default\"/>");
  CRobotWorld world(experiment);
  CHECK_FALSE(Grips(world));
  world.GetActuator<CCI_DifferentialSteeringActuator>("r", "differential_steering")
      .SetLinearVelocity(10.0, 10.0);
  world.Step(11);
  CHECK_THAT(PositionOf(world, "r").GetX(), WithinAbs(0.11, 1e-9));
  CHECK_FALSE(world.Get<CFootBotEntity>("r").GetGripperEquippedEntity().IsGripping());
}

TEST_CASE(
    "gripper entity: values must be finite, and access to a missing gripped entity is an error",
    "[contract][robots]") {
  CGripperEquippedEntity gripper(nullptr, "g", CVector3(1, 0, 0), CVector3::Y, 0.3);
  CHECK(gripper.GetTypeDescription() == "gripper");
  CHECK(gripper.GetDirection() == CVector3::Y);
  gripper.SetLockState(0.4);
  CHECK(gripper.IsLocked());
  gripper.SetLockThreshold(0.4);
  CHECK_FALSE(gripper.IsLocked());
  CHECK_THROWS_WITH(gripper.SetLockState(kNaN), Contains("\"g\"") && Contains("lock state"));
  CHECK_THROWS_WITH(gripper.SetLockThreshold(kNaN), Contains("lock threshold"));
  CHECK_FALSE(gripper.IsGripping());
  CHECK_THROWS_WITH(gripper.GetGrippedEntity(), Contains("holds nothing"));
}

TEST_CASE("footbot_turret: the encoder reads the rotation that orders have caused",
          "[contract][robots]") {
  // in an engine that supports turrets with loads, and in one that only turns them
  const std::string engine = GENERATE(as<std::string>(), "dynamics2d", "pointmass3d");
  CAPTURE(engine);
  CRobotWorld world(WithTurret(engine));
  auto& actuator = world.GetActuator<TTurret>("r", "footbot_turret");
  auto& encoder = world.GetSensor<CCI_FootBotTurretEncoderSensor>("r", "footbot_turret_encoder");
  // targets are stored in every mode
  actuator.SetRotation(CRadians(1.0));
  actuator.SetRotationSpeed(-3);
  world.Step(5);
  CHECK(encoder.GetRotation() == CRadians::ZERO);
  actuator.SetSpeedControlMode();
  world.Step(20);
  // -3 turns a minute for 2 s are 36 degrees
  CHECK_THAT(encoder.GetRotation().GetValue(), WithinAbs(-0.2 * ARGOS_PI, 1e-12));
  actuator.SetPassiveMode();
  world.Step(20);
  CHECK_THAT(encoder.GetRotation().GetValue(), WithinAbs(-0.2 * ARGOS_PI, 1e-12));
  actuator.SetPositionControlMode();
  world.Step(400);
  CHECK_THAT(encoder.GetRotation().GetValue(), WithinAbs(1.0, 1e-4));
  actuator.SetActiveWithRotation(CRadians(-2.0));
  world.Step(400);
  CHECK_THAT(encoder.GetRotation().GetValue(), WithinAbs(-2.0, 1e-4));
  // several turns, within (-pi,pi]
  actuator.SetMode(TTurret::MODE_SPEED_CONTROL);
  actuator.SetRotationSpeed(60);
  for (int tick = 0; tick < 50; ++tick) {
    world.Step();
    REQUIRE(TTurret::NORMALIZED_SPEED_RANGE.WithinMinBoundIncludedMaxBoundIncluded(1.0));
    REQUIRE(CCI_FootBotTurretEncoderSensor::ANGULAR_RANGE.WithinMinBoundIncludedMaxBoundIncluded(
        encoder.GetRotation()));
  }
  world.GetSimulator().Reset();
  CHECK(encoder.GetRotation() == CRadians::ZERO);
  world.Step(10);
  CHECK(encoder.GetRotation() == CRadians::ZERO);
}

TEST_CASE("footbot_turret: constants are those of ARGoS 3, and invalid orders are errors",
          "[contract][robots]") {
  CHECK(TTurret::SPEED_RANGE.GetMin() == -4);
  CHECK(TTurret::SPEED_RANGE.GetMax() == 4);
  CHECK(CCI_FootBotGripperActuator::UNLOCKED == CRadians::ZERO);
  CHECK(CCI_FootBotGripperActuator::LOCKED_POSITIVE == CRadians::PI_OVER_TWO);
  CHECK(CCI_FootBotGripperActuator::LOCKED_NEGATIVE == -CRadians::PI_OVER_TWO);
  CRobotWorld world(WithTurret());
  auto& actuator = world.GetActuator<TTurret>("r", "footbot_turret");
  CHECK_THROWS_WITH(actuator.SetRotation(CRadians(kNaN)), Contains("must be a finite angle"));
  auto& turret = world.Get<CFootBotEntity>("r").GetTurretEntity();
  CHECK_THROWS_WITH(turret.SetDesiredRotation(CRadians(kNaN)), Contains("desired rotation"));
  CHECK_THROWS_WITH(turret.SetDesiredRotationSpeed(kNaN), Contains("desired speed"));
}

TEST_CASE("gripper and turret: the devices are refused for robots without the components",
          "[contract][robots][errors]") {
  const std::string device = GENERATE(as<std::string>(), "gripper", "footbot_turret");
  CAPTURE(device);
  SRobotExperiment experiment = With("<" + device + " implementation=\"default\"/>");
  experiment.Arena = Robot("e-puck", "e", "");
  CHECK_THAT(
      LoadError(experiment),
      Contains("robot \"e\"") && Contains(device == "gripper" ? "has no component \"gripper\""
                                                              : "has no component \"turret\""));
}

namespace {

constexpr int kDraws = 4000;
const std::string kNoise = "model=\"gaussian\" std_dev=\"0.1\" bias=\"0.05\"";

// distribution of the noise of kNoise
Real NoiseDistribution(Real deviation) {
  return NormalDistribution(deviation - 0.05, 0.1);
}

}  // namespace

TEST_CASE("gripper noise: is on the aperture or the lock state of each new order",
          "[contract][robots][noise]") {
  const bool isFootBots = GENERATE(true, false);
  const std::string tag = isFootBots ? "footbot_gripper" : "gripper";
  CAPTURE(tag);
  SRobotExperiment experiment =
      With(WithNoise(tag + " implementation=\"default\"",
                     (isFootBots ? "on=\"aperture\" " : "on=\"lock_state\" ") + kNoise));
  experiment.Engine = "<toy_engine id=\"toy\"/>";
  CRobotWorld world(experiment);
  const auto& gripper = world.Get<CFootBotEntity>("r").GetGripperEquippedEntity();
  const auto order = [&](Real value) {
    if (isFootBots) {
      world.GetActuator<CCI_FootBotGripperActuator>("r", tag).SetAperture(CRadians(value));
    } else {
      world.GetActuator<CCI_GripperActuator>("r", tag).SetLockState(value);
    }
    world.GetRobot("r").Act();
    return gripper.GetLockState() * (isFootBots ? 0.5 * ARGOS_PI : 1.0);
  };
  // without a new order nothing is drawn
  CHECK(order(0.0) == 0.0);
  // Far enough from the limits that the noise is not clamped: 4.5 standard deviations are
  // exceeded 7 times in a million.
  const Real middle = isFootBots ? 0.7 : 0.45;
  std::vector<Real> deviations;
  for (int i = 0; i < kDraws; ++i) {
    // two alternating orders
    const Real value = i % 2 == 0 ? middle : middle + 0.01;
    const Real followed = order(value);
    deviations.push_back(followed - value);
    // repeating an order draws nothing
    CHECK(order(value) == followed);
  }
  CHECK(KolmogorovSmirnovExcess(deviations, &NoiseDistribution) <= 1.0);
  // values beyond the limits are clamped
  const Real end = isFootBots ? 0.5 * ARGOS_PI : 1.0;
  bool isCut = false;
  for (int i = 0; i < 20; ++i) {
    const Real followed = order(i % 2 == 0 ? end : end - 0.01);
    REQUIRE(followed <= end + 1e-15);
    isCut = isCut || followed == end;
  }
  CHECK(isCut);
  const Real first = [&] {
    world.GetSimulator().Reset();
    return order(middle);
  }();
  world.GetSimulator().Reset();
  CHECK(order(middle) == first);
}

TEST_CASE("footbot_turret noise: is on each order", "[contract][robots][noise]") {
  const bool isRotation = GENERATE(true, false);
  CAPTURE(isRotation);
  SRobotExperiment experiment =
      With(WithNoise("footbot_turret implementation=\"default\"",
                     (isRotation ? "on=\"rotation\" " : "on=\"rotation_speed\" ") + kNoise));
  experiment.Engine = "<toy_engine id=\"toy\"/>";
  CRobotWorld world(experiment);
  auto& actuator = world.GetActuator<TTurret>("r", "footbot_turret");
  const auto& turret = world.Get<CFootBotEntity>("r").GetTurretEntity();
  std::vector<Real> deviations;
  for (int i = 0; i < kDraws; ++i) {
    actuator.SetRotation(CRadians(1.0));
    actuator.SetRotationSpeed(3);
    world.GetRobot("r").Act();
    const Real rotation = turret.GetDesiredRotation().GetValue() - 1.0;
    const Real speed = turret.GetDesiredRotationSpeed() * 30.0 / ARGOS_PI - 3.0;
    deviations.push_back(isRotation ? rotation : speed);
    // the quantity without noise is exact, except for roundings of 3
    REQUIRE_THAT(isRotation ? speed : rotation, WithinAbs(0.0, 1e-15));
  }
  CHECK(KolmogorovSmirnovExcess(deviations, &NoiseDistribution) <= 1.0);
  // an unchanged order is not drawn again
  const CRadians rotation = turret.GetDesiredRotation();
  world.GetRobot("r").Act();
  CHECK(turret.GetDesiredRotation() == rotation);
}

TEST_CASE("footbot_turret_encoder noise: is on each reading, which stays in its range",
          "[contract][robots][noise]") {
  const Real rotation = GENERATE(0.5, -3.1);
  CAPTURE(rotation);
  SRobotExperiment experiment =
      With("", WithNoise("footbot_turret_encoder implementation=\"default\"", kNoise));
  experiment.Engine = "<toy_engine id=\"toy\"/>";
  CRobotWorld world(experiment);
  const auto& encoder =
      world.GetSensor<CCI_FootBotTurretEncoderSensor>("r", "footbot_turret_encoder");
  world.Get<CFootBotEntity>("r").GetTurretEntity().SetRotation(CRadians(rotation));
  std::vector<Real> deviations;
  Real greatest = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    world.Step();
    const Real reading = encoder.GetRotation().GetValue();
    greatest = std::max(greatest, std::abs(reading));
    deviations.push_back(std::remainder(reading - rotation, 2.0 * ARGOS_PI));
  }
  CHECK(KolmogorovSmirnovExcess(deviations, &NoiseDistribution) <= 1.0);
  CHECK(greatest <= ARGOS_PI);
}

TEST_CASE("gripper and turret noise: invalid noise is refused with the accepted names",
          "[contract][robots][errors]") {
  const auto [tag, known] =
      GENERATE(table<std::string, std::string>({{"gripper", "lock_state"},
                                                {"footbot_gripper", "aperture"},
                                                {"footbot_turret", "rotation"}}));
  CAPTURE(tag);
  CHECK_THAT(LoadError(With(WithNoise(tag + " implementation=\"default\"", "on=\"x\" " + kNoise))),
             Contains("test.argos:4: <noise>: <" + tag + "> has no \"x\"") && Contains(known));
}

}  // namespace gripper_turret_test
