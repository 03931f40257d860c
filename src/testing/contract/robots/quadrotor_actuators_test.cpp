// Orders of controllers to flying robots, and the resulting targets of the propellers.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_position_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_speed_actuator.h>
#include <argos3/testing/contract/sensors/scene.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace argos::quadrotor_actuators_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kRounding = 1e-15;

const std::string kPosition = "<quadrotor_position implementation=\"default\"/>";
const std::string kSpeed = "<quadrotor_speed implementation=\"default\"/>";

// an experiment with an engine in which nothing moves
SRobotExperiment WithActuators(const std::string& actuators, const std::string& tag = "eye-bot") {
  SRobotExperiment experiment;
  experiment.Actuators = actuators;
  experiment.Arena = Robot(tag, "r", PoseText(CVector3(1, 2, 0.3), 90.0));
  return experiment;
}

CCI_QuadRotorPositionActuator& Places(CRobotWorld& world) {
  return world.GetActuator<CCI_QuadRotorPositionActuator>("r", "quadrotor_position");
}

CCI_QuadRotorSpeedActuator& Speeds(CRobotWorld& world) {
  return world.GetActuator<CCI_QuadRotorSpeedActuator>("r", "quadrotor_speed");
}

CQuadRotorEntity& Propellers(CRobotWorld& world) {
  return world.Get<CEyeBotEntity>("r").GetQuadRotorEntity();
}

}  // namespace

TEST_CASE(
    "quadrotor position: the initial target is the robot's pose, and orders act in the next tick",
    "[contract][robots]") {
  CRobotWorld world(WithActuators(kPosition));
  CHECK(Propellers(world).GetControlMethod() == CQuadRotorEntity::POSITION_CONTROL);
  world.Step();
  CHECK(Propellers(world).GetPositionControlData().Position == CVector3(1, 2, 0.3));
  CHECK_THAT(Propellers(world).GetPositionControlData().Yaw.GetValue(),
             WithinAbs(0.5 * M_PI, kRounding));
  Places(world).SetAbsolutePosition(CVector3(4, 5, 6));
  Places(world).SetAbsoluteYaw(CRadians(-1.5));
  CHECK(Propellers(world).GetPositionControlData().Position == CVector3(1, 2, 0.3));
  world.Step();
  CHECK(Propellers(world).GetPositionControlData().Position == CVector3(4, 5, 6));
  CHECK(Propellers(world).GetPositionControlData().Yaw == CRadians(-1.5));
  world.GetSimulator().Reset();
  world.Step();
  CHECK(Propellers(world).GetPositionControlData().Position == CVector3(1, 2, 0.3));
}

TEST_CASE("quadrotor position: relative orders refer to the robot's pose at the call",
          "[contract][robots]") {
  CRobotWorld world(WithActuators(kPosition));
  // the robot faces along y: ahead is y, left is -x
  Places(world).SetRelativePosition(CVector3(0.5, 0.25, -0.1));
  Places(world).SetRelativeYaw(CRadians(0.75));
  world.Get<CEyeBotEntity>("r").GetEmbodiedEntity().MoveTo(CVector3(3, 3, 0.3), CQuaternion());
  world.Step();
  const auto& data = Propellers(world).GetPositionControlData();
  CHECK_THAT(Distance(data.Position, CVector3(0.75, 2.5, 0.2)), WithinAbs(0.0, kRounding));
  CHECK_THAT(data.Yaw.GetValue(), WithinAbs(0.5 * M_PI + 0.75, kRounding));
  // a new order of the yaw keeps that of the position
  Places(world).SetRelativeYaw(CRadians(-0.25));
  world.Step();
  CHECK_THAT(Distance(data.Position, CVector3(0.75, 2.5, 0.2)), WithinAbs(0.0, kRounding));
  CHECK_THAT(data.Yaw.GetValue(), WithinAbs(-0.25, kRounding));
}

TEST_CASE("quadrotor speed: the initial target is zero, and orders act in the next tick",
          "[contract][robots]") {
  CRobotWorld world(WithActuators(kSpeed));
  CHECK(Propellers(world).GetControlMethod() == CQuadRotorEntity::SPEED_CONTROL);
  world.Step();
  CHECK(Propellers(world).GetSpeedControlData().Velocity == CVector3());
  Speeds(world).SetLinearVelocity(CVector3(1, -2, 3));
  CHECK(Propellers(world).GetSpeedControlData().Velocity == CVector3());
  world.Step();
  CHECK(Propellers(world).GetSpeedControlData().Velocity == CVector3(1, -2, 3));
  Speeds(world).SetRotationalSpeed(CRadians(10.0));
  world.Step();
  CHECK(Propellers(world).GetSpeedControlData().Velocity == CVector3(1, -2, 3));
  CHECK(Propellers(world).GetSpeedControlData().RotSpeed == CRadians(10.0));
  world.GetSimulator().Reset();
  world.Step();
  CHECK(Propellers(world).GetSpeedControlData().Velocity == CVector3());
  CHECK(Propellers(world).GetSpeedControlData().RotSpeed == CRadians());
}

TEST_CASE("quadrotor actuators: invalid orders are refused and change nothing",
          "[contract][robots][errors]") {
  const Real bad =
      GENERATE(std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity(), -2e9);
  CRobotWorld places(WithActuators(kPosition));
  CHECK_THROWS_WITH(Places(places).SetAbsolutePosition(CVector3(bad, 0, 0)),
                    Contains("\"r.quadrotor_0\"") && Contains("a target position (m)"));
  CHECK_THROWS_WITH(Places(places).SetRelativePosition(CVector3(0, 0, bad)),
                    Contains("\"r.quadrotor_0\""));
  CHECK_THROWS_WITH(Places(places).SetAbsoluteYaw(CRadians(bad)), Contains("\"r.quadrotor_0\""));
  CHECK_THROWS_WITH(Places(places).SetRelativeYaw(CRadians(bad)), Contains("\"r.quadrotor_0\""));
  places.Step();
  CHECK(Propellers(places).GetPositionControlData().Position == CVector3(1, 2, 0.3));
  CRobotWorld speeds(WithActuators(kSpeed));
  CHECK_THROWS_WITH(Speeds(speeds).SetLinearVelocity(CVector3(0, bad, 0)),
                    Contains("\"r.quadrotor_0\"") && Contains("a target velocity (m/s)"));
  CHECK_THROWS_WITH(Speeds(speeds).SetRotationalSpeed(CRadians(bad)),
                    Contains("\"r.quadrotor_0\""));
  speeds.Step();
  CHECK(Propellers(speeds).GetSpeedControlData().Velocity == CVector3());
}

TEST_CASE("quadrotor actuators: only one is accepted, and only on a robot with propellers",
          "[contract][robots][errors]") {
  CHECK_THAT(LoadError(WithActuators(kPosition + kSpeed)),
             Contains("actuator \"quadrotor_speed\": the propellers of robot \"r\" already have an "
                      "actuator") &&
                 Contains("not both"));
  CHECK_THAT(LoadError(WithActuators(kSpeed + kPosition)),
             Contains("actuator \"quadrotor_position\": the propellers of robot \"r\""));
  CHECK_THAT(LoadError(WithActuators(kPosition, "foot-bot")),
             Contains("\"r\"") && Contains("no component \"quadrotor\""));
  CHECK_THAT(LoadError(WithActuators("<differential_steering implementation=\"default\"/>")),
             Contains("\"r\"") && Contains("no component \"wheels\""));
}

TEST_CASE("quadrotor actuators: a new controller of a robot gets its actuators too",
          "[contract][robots]") {
  CRobotWorld world(WithActuators(kPosition));
  CControllableEntity& robot = world.GetRobot("r");
  robot.SetController("c");
  world.Step();
  CHECK(Propellers(world).GetControlMethod() == CQuadRotorEntity::POSITION_CONTROL);
  Places(world).SetAbsolutePosition(CVector3(4, 5, 6));
  world.Step();
  CHECK(Propellers(world).GetPositionControlData().Position == CVector3(4, 5, 6));
}

TEST_CASE("quadrotor actuators: noise has the requested distribution on the requested quantity",
          "[contract][robots][noise]") {
  constexpr int kOrders = 4000;
  {
    CRobotWorld world(
        WithActuators(WithNoise("quadrotor_position implementation=\"default\"",
                                "on=\"position\" model=\"gaussian\" std_dev=\"0.2\"")));
    std::vector<Real> errors;
    for (int i = 0; i < kOrders; ++i) {
      Places(world).SetAbsolutePosition(CVector3(3, -2, 1));
      Places(world).SetAbsoluteYaw(CRadians(0.5));
      world.GetRobot("r").Act();
      const auto& data = Propellers(world).GetPositionControlData();
      for (UInt32 axis = 0; axis < 3; ++axis) {
        errors.push_back(data.Position[axis] - CVector3(3, -2, 1)[axis]);
      }
      REQUIRE(data.Yaw == CRadians(0.5));
    }
    CHECK(KolmogorovSmirnovExcess(
              errors, [](Real value) { return NormalDistribution(value, 0.2); }) <= 1.0);
  }
  {
    CRobotWorld world(WithActuators(WithNoise("quadrotor_speed implementation=\"default\"",
                                              "on=\"rotational_speed\" model=\"uniform\" "
                                              "level=\"0.3\"")));
    std::vector<Real> errors;
    for (int i = 0; i < kOrders; ++i) {
      Speeds(world).SetLinearVelocity(CVector3(1, 2, 3));
      Speeds(world).SetRotationalSpeed(CRadians(2.0));
      world.GetRobot("r").Act();
      errors.push_back(Propellers(world).GetSpeedControlData().RotSpeed.GetValue() - 2.0);
      REQUIRE(Propellers(world).GetSpeedControlData().Velocity == CVector3(1, 2, 3));
    }
    CHECK(KolmogorovSmirnovExcess(
              errors, [](Real value) { return UniformDistribution(value, -0.3, 0.3); }) <= 1.0);
  }
}

TEST_CASE("quadrotor actuators: noise repeats after a reset and differs between robots",
          "[contract][robots][noise]") {
  SRobotExperiment experiment = WithActuators(WithNoise(
      "quadrotor_speed implementation=\"default\"", "model=\"gaussian\" std_dev=\"0.2\""));
  experiment.Arena += Robot("eye-bot", "s", PoseText(CVector3(-1, 2, 0.3)));
  CRobotWorld world(experiment);
  const auto draw = [&world](const std::string& robot) {
    world.GetActuator<CCI_QuadRotorSpeedActuator>(robot, "quadrotor_speed")
        .SetLinearVelocity(CVector3());
    world.GetRobot(robot).Act();
    return world.Get<CEyeBotEntity>(robot).GetQuadRotorEntity().GetSpeedControlData().Velocity;
  };
  const CVector3 first = draw("r");
  CHECK(draw("r") != first);
  CHECK(draw("s") != first);
  world.GetSimulator().Reset();
  CHECK(draw("r") == first);
  experiment.Actuators = WithNoise("quadrotor_speed implementation=\"default\"",
                                   "on=\"height\" model=\"gaussian\" std_dev=\"0.2\"");
  CHECK_THAT(LoadError(experiment), Contains("<quadrotor_speed> has no \"height\""));
}

}  // namespace argos::quadrotor_actuators_test
