// Wheels whose right one is slightly faster: the drift of robots that navigate by dead reckoning.

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_encoder_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>
#include <argos3/plugins/robots/generic/simulator/differential_steering_dead_reckoning_actuator.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/testing/contract/sensors/scene.h>
#include <argos3/testing/support/closed_form/differential_drive.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace argos::dead_reckoning_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kTick = 0.1;  // s

SRobotExperiment Drifting(const std::string& attributes = "", const std::string& tag = "foot-bot") {
  SRobotExperiment experiment;
  experiment.Actuators =
      "<differential_steering implementation=\"dead_reckoning\" " + attributes + "/>";
  experiment.Engine = "<dynamics2d id=\"dyn2d\" velocity_lag=\"0\"/>";
  experiment.Arena = Robot(tag, "r", PoseText(CVector3()));
  return experiment;
}

CDifferentialSteeringDeadReckoningActuator& Actuator(CRobotWorld& world,
                                                     const std::string& robot = "r") {
  return world.GetActuator<CDifferentialSteeringDeadReckoningActuator>(robot,
                                                                       "differential_steering");
}

// speeds of the left and right wheel, m/s
std::pair<Real, Real> WheelsFor(CRobotWorld& world, Real left, Real right) {
  Actuator(world).SetLinearVelocity(left, right);
  world.GetRobot("r").Act();
  const auto& wheels = world.Get<CComposableEntity>("r").GetComponent<CWheeledEntity>("wheels");
  return {wheels.GetWheelVelocity(0), wheels.GetWheelVelocity(1)};
}

// the calls of engines when the gripper of "r" closes around the body of "s", and when it opens
void Grip(CRobotWorld& world, bool holds) {
  CGripperEquippedEntity& gripper = world.Get<CFootBotEntity>("r").GetGripperEquippedEntity();
  holds ? gripper.SetGrippedEntity(world.Get<CFootBotEntity>("s").GetEmbodiedEntity())
        : gripper.ClearGrippedEntity();
  world.GetRobot("r").Act();
}

SRobotExperiment DriftingPair(const std::string& attributes) {
  SRobotExperiment experiment = Drifting(attributes);
  experiment.Engine = "<toy_engine id=\"toy\"/>";
  experiment.Arena += Robot("foot-bot", "s", PoseText(CVector3(1.0, 0.0, 0.0)));
  return experiment;
}

}  // namespace

TEST_CASE("dead reckoning: mu has a Rayleigh distribution", "[contract][robots][noise]") {
  constexpr int kRobots = 2000;
  const bool isDefault = GENERATE(true, false);
  SRobotExperiment experiment = Drifting(isDefault ? "" : "sigma=\"0.05\"");
  experiment.Engine = "<toy_engine id=\"toy\"/>";
  experiment.Arena.clear();
  for (int i = 0; i < kRobots; ++i) {
    experiment.Arena += Robot("e-puck", "r" + std::to_string(i), PoseText(CVector3()));
  }
  CRobotWorld world(experiment);
  std::vector<Real> deviations;
  for (int i = 0; i < kRobots; ++i) {
    deviations.push_back(Actuator(world, "r" + std::to_string(i)).GetDeviation());
  }
  CHECK(KolmogorovSmirnovExcess(deviations, [isDefault](Real x) {
          return RayleighDistribution(x, isDefault ? 0.00134 : 0.05);
        }) <= 1.0);
}

TEST_CASE("dead reckoning: the drift adds to the outer wheel of each direction",
          "[contract][robots]") {
  const bool isFaster = GENERATE(true, false);
  CAPTURE(isFaster);
  CRobotWorld world(Drifting(isFaster ? "sigma=\"0.1\"" : "sigma=\"0.1\" backward=\"slower\""));
  const Real mu = Actuator(world).GetDeviation();
  REQUIRE(mu > 0.0);
  const auto [left, right] = WheelsFor(world, 10.0, 10.0);
  CHECK(left == 0.1);
  CHECK_THAT(right, WithinAbs(0.1 * (1.0 + mu), 1e-16));
  const auto [leftBack, rightBack] = WheelsFor(world, -10.0, -10.0);
  CHECK_THAT(leftBack, WithinAbs(-0.1 * (isFaster ? 1.0 + mu : 1.0 - mu), 1e-16));
  CHECK(rightBack == -0.1);
  // on a curve, the deviation is proportional to the mean speed
  const auto [leftTurn, rightTurn] = WheelsFor(world, 4.0, 12.0);
  CHECK(leftTurn == 0.04);
  CHECK_THAT(rightTurn, WithinAbs(0.12 + 0.08 * mu, 1e-16));
  // no deviation when turning in place or at rest
  CHECK(WheelsFor(world, 5.0, -5.0) == std::pair<Real, Real>(0.05, -0.05));
  CHECK(WheelsFor(world, 0.0, 0.0) == std::pair<Real, Real>(0.0, 0.0));
}

TEST_CASE("dead reckoning: a robot with equal orders for both wheels follows the circle of its mu",
          "[contract][robots]") {
  struct SType {
    const char* Tag;
    Real Axis;  // m
  };
  const SType type = GENERATE(SType{"foot-bot", 0.14}, SType{"e-puck", 0.053});
  // ahead, back, and back with the other sign of the drift
  const int direction = GENERATE(1, -1, -2);
  const bool ahead = direction > 0;
  CAPTURE(type.Tag, direction);
  CRobotWorld world(Drifting(
      direction == -2 ? "sigma=\"0.02\" backward=\"slower\"" : "sigma=\"0.02\"", type.Tag));
  const Real mu = Actuator(world).GetDeviation();
  CAPTURE(mu);
  // of the outer wheel's excess over the other one
  const Real excess = direction == -2 ? -mu : mu;
  const Real speed = ahead ? 10.0 : -10.0;  // cm/s
  Actuator(world).SetLinearVelocity(speed, speed);
  constexpr int kTicks = 100;
  world.Step(kTicks);
  const auto& origin =
      world.Get<CComposableEntity>("r").GetComponent<CEmbodiedEntity>("body").GetOriginAnchor();
  // the centre of the circle is at (0, radius): to the left, but for a robot that goes back on its
  // faster left wheel
  const Real radius = (direction == -1 ? -1.0 : 1.0) * type.Axis * (2.0 + excess) / (2.0 * mu);
  CHECK_THAT(std::hypot(origin.Position.GetX(), origin.Position.GetY() - radius),
             WithinAbs(std::abs(radius), 1e-12 * std::abs(radius)));
  // the length of the arc follows from the mean speed of the wheels
  const Real way = 0.01 * std::abs(speed) * (1.0 + 0.5 * excess) * kTicks * kTick;
  const auto arc = testing::IntegrateDifferentialDrive({}, ahead ? 0.1 : -0.1 * (1.0 + excess),
                                                       ahead ? 0.1 * (1.0 + mu) : -0.1, type.Axis,
                                                       kTicks * kTick);
  CHECK_THAT(std::abs(origin.Position.GetX()),
             WithinAbs(std::abs(radius) * std::sin(way / std::abs(radius)), 1e-12));
  CHECK_THAT(origin.Position.GetX(), WithinAbs(arc.X, 1e-12));
  CHECK_THAT(origin.Position.GetY(), WithinAbs(arc.Y, 1e-12));
  CHECK((origin.Position.GetY() > 0.0) == (radius > 0.0));
}

TEST_CASE("dead reckoning: back and forth draws an S, or retraces its way", "[contract][robots]") {
  const bool isFaster = GENERATE(true, false);
  CAPTURE(isFaster);
  CRobotWorld world(Drifting(isFaster ? "sigma=\"0.02\"" : "sigma=\"0.02\" backward=\"slower\""));
  const Real mu = Actuator(world).GetDeviation();
  constexpr Real kAxis = 0.14;  // m
  constexpr int kTicks = 100;
  constexpr Real kDuration = kTicks * kTick;
  const auto& origin = world.Get<CFootBotEntity>("r").GetEmbodiedEntity().GetOriginAnchor();
  Actuator(world).SetLinearVelocity(10.0, 10.0);
  world.Step(kTicks);
  Actuator(world).SetLinearVelocity(-10.0, -10.0);
  world.Step(kTicks);
  // out and back turn by mu v t / d each, and back turns the same way or returns
  const Real turn = mu * 0.1 * kDuration / kAxis;
  CRadians yaw, pitch, roll;
  origin.Orientation.ToEulerAngles(yaw, pitch, roll);
  CHECK_THAT(yaw.GetValue(), WithinAbs(isFaster ? 2.0 * turn : 0.0, 1e-12));
  // Ahead the arc around (0,R), R = d (2 + mu) / (2 mu), through the angle a leads to
  // (R sin a, R (1 - cos a)). Back on the same radius around a point on the right of the robot,
  // through a: x = 2 R sin a - R sin 2a, y = R (1 - 2 cos a + cos 2a). Back on the radius R - d
  // around a point on the left: x = d sin a, y = d (1 - cos a).
  const Real radius = kAxis * (2.0 + mu) / (2.0 * mu);
  const Real x =
      isFaster ? radius * (2.0 * std::sin(turn) - std::sin(2.0 * turn)) : kAxis * std::sin(turn);
  const Real y = isFaster ? radius * (1.0 - 2.0 * std::cos(turn) + std::cos(2.0 * turn))
                          : kAxis * (1.0 - std::cos(turn));
  CHECK_THAT(origin.Position.GetX(), WithinAbs(x, 1e-12));
  CHECK_THAT(origin.Position.GetY(), WithinAbs(y, 1e-12));
}

TEST_CASE("dead reckoning: mu is drawn again when the robot grips something",
          "[contract][robots]") {
  constexpr int kGrips = 2000;
  const bool isDefault = GENERATE(true, false);
  CRobotWorld world(DriftingPair(isDefault ? "" : "sigma=\"0.01\""));
  world.Step(3);
  const Real first = Actuator(world).GetDeviation();
  Grip(world, true);
  const Real second = Actuator(world).GetDeviation();
  CHECK(second != first);
  // mu is kept while the robot holds something, and when it releases it
  world.GetRobot("r").Act();
  CHECK(Actuator(world).GetDeviation() == second);
  Grip(world, false);
  CHECK(Actuator(world).GetDeviation() == second);
  std::vector<Real> drawn;
  for (int i = 0; i < kGrips; ++i) {
    Grip(world, true);
    drawn.push_back(Actuator(world).GetDeviation());
    Grip(world, false);
  }
  CHECK(KolmogorovSmirnovExcess(drawn, [isDefault](Real x) {
          return RayleighDistribution(x, isDefault ? 0.00134 : 0.01);
        }) <= 1.0);
  world.GetSimulator().Reset();
  CHECK(Actuator(world).GetDeviation() == first);
}

TEST_CASE("dead reckoning: a constant order is affected by the new mu at once",
          "[contract][robots]") {
  CRobotWorld world(DriftingPair("sigma=\"0.1\""));
  Actuator(world).SetLinearVelocity(10.0, 10.0);
  Grip(world, true);
  const auto& wheels = world.Get<CComposableEntity>("r").GetComponent<CWheeledEntity>("wheels");
  CHECK_THAT(wheels.GetWheelVelocity(1),
             WithinAbs(0.1 * (1.0 + Actuator(world).GetDeviation()), 1e-16));
}

TEST_CASE("dead reckoning: a grip by the engine changes mu", "[contract][robots]") {
  SRobotExperiment experiment = Drifting("sigma=\"0.01\"");
  experiment.Actuators += "<footbot_gripper implementation=\"default\"/>";
  // a box that the robot drives into
  experiment.Arena +=
      "<box id=\"load\" size=\"0.2,0.2,0.2\" movable=\"true\" mass=\"1\"><body "
      "position=\"0.25,0,0\"/></box>";
  CRobotWorld world(experiment);
  const Real first = Actuator(world).GetDeviation();
  const CGripperEquippedEntity& gripper = world.Get<CFootBotEntity>("r").GetGripperEquippedEntity();
  world.GetActuator<CCI_FootBotGripperActuator>("r", "footbot_gripper").LockPositive();
  Actuator(world).SetLinearVelocity(5.0, 5.0);
  for (int tick = 0; tick < 50 && !gripper.IsGripping(); ++tick) {
    CHECK(Actuator(world).GetDeviation() == first);
    world.Step();
  }
  REQUIRE(gripper.IsGripping());
  world.Step();
  CHECK(Actuator(world).GetDeviation() != first);
}

TEST_CASE("dead reckoning: creates no gripper or turret for robots", "[contract][robots]") {
  CRobotWorld world(Drifting());
  world.Step(2);
  for (const CEntity* component : world.Get<CFootBotEntity>("r").GetExistingComponents()) {
    CHECK(component->GetTypeDescription() != "gripper");
    CHECK(component->GetTypeDescription() != "turret");
  }
}

TEST_CASE("dead reckoning: mu differs between robots and seeds, and repeats after a reset",
          "[contract][robots]") {
  SRobotExperiment experiment = Drifting();
  experiment.Arena += Robot("foot-bot", "s", PoseText(CVector3(1.0, 0.0, 0.0)));
  CRobotWorld world(experiment);
  const Real mu = Actuator(world).GetDeviation();
  CHECK(Actuator(world, "s").GetDeviation() != mu);
  world.GetSimulator().Reset();
  CHECK(Actuator(world).GetDeviation() == mu);
  world.GetSimulator().Reset(2);
  CHECK(Actuator(world).GetDeviation() != mu);
}

TEST_CASE("dead reckoning: sigma 0 means no drift, and negative values are refused",
          "[contract][robots][errors]") {
  CRobotWorld world(Drifting("sigma=\"0\""));
  CHECK(WheelsFor(world, 10.0, 10.0) == std::pair<Real, Real>(0.1, 0.1));
  CHECK_THAT(LoadError(Drifting("sigma=\"-0.1\"")),
             Contains("sigma") && Contains(">= 0") && Contains("-0.1"));
  CHECK_THAT(LoadError(Drifting("", "toy-robot")), Contains("wheels"));
}

TEST_CASE("dead reckoning: encoders read the ordered rotation, and odometry errs by the drift",
          "[contract][robots][sensors]") {
  const Real lag = GENERATE(0.0, 0.1);
  CAPTURE(lag);
  SRobotExperiment experiment = Drifting("sigma=\"0.05\"");
  experiment.Engine = "<dynamics2d id=\"dyn2d\" velocity_lag=\"" + ToString(lag) + "\"/>";
  experiment.Sensors =
      "<differential_steering implementation=\"default\"/>"
      "<footbot_encoder implementation=\"default\"/>";
  CRobotWorld world(experiment);
  const auto& steering =
      world.GetSensor<CCI_DifferentialSteeringSensor>("r", "differential_steering").GetReading();
  const auto& encoder =
      world.GetSensor<CCI_FootBotEncoderSensor>("r", "footbot_encoder").GetReading();
  const auto& origin = world.Get<CFootBotEntity>("r").GetEmbodiedEntity().GetOriginAnchor();
  // orders in cm/s; each is the order of the tick that follows it
  const std::vector<std::pair<Real, Real>> orders = {{10.0, 10.0}, {10.0, 10.0}, {-10.0, -10.0},
                                                     {0.0, 8.0},   {3.0, -3.0},  {-6.0, -2.0},
                                                     {0.0, 0.0}};
  std::pair<Real, Real> last;
  testing::SPose estimated;
  for (int round = 0; round < 3; ++round) {
    for (const auto& order : orders) {
      Actuator(world).SetLinearVelocity(order.first, order.second);
      world.Step();
      CAPTURE(round, order.first, order.second);
      CHECK(steering.VelocityLeftWheel == 100.0 * (0.01 * order.first));
      CHECK(steering.VelocityRightWheel == 100.0 * (0.01 * order.second));
      const auto turned = [lag](Real speed, Real before) {
        return (speed + lag * (before - speed)) * kTick;
      };
      // several roundings of some cm
      CHECK_THAT(encoder.CoveredDistanceLeftWheel,
                 WithinAbs(turned(order.first, last.first), 1e-12));
      CHECK_THAT(encoder.CoveredDistanceRightWheel,
                 WithinAbs(turned(order.second, last.second), 1e-12));
      last = order;
    }
  }
  world.GetSimulator().Reset();
  Actuator(world).SetLinearVelocity(10.0, 10.0);
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    estimated = testing::IntegrateDifferentialDrive(
        estimated, 0.01 * encoder.CoveredDistanceLeftWheel / kTick,
        0.01 * encoder.CoveredDistanceRightWheel / kTick, 0.14, kTick);
  }
  // the robot believes that it went straight, and is mu s^2 / (2 d) beside its line (leading term)
  CHECK_THAT(estimated.Y, WithinAbs(0.0, 1e-12));
  const Real way = origin.Position.GetX();
  const Real offset = Actuator(world).GetDeviation() * way * way / (2.0 * 0.14);
  CHECK_THAT(origin.Position.GetY(), WithinAbs(offset, 0.1 * offset));
}

TEST_CASE("dead reckoning: another actuator of the same wheels ends the drift",
          "[contract][robots]") {
  CRobotWorld world(Drifting("sigma=\"0.1\""));
  WheelsFor(world, 10.0, 10.0);
  auto& wheels = world.Get<CComposableEntity>("r").GetComponent<CWheeledEntity>("wheels");
  CHECK(wheels.GetOrderedVelocities()[1] == 0.1);
  CHECK(wheels.GetWheelVelocities()[1] > 0.1);
  const Real speeds[2] = {0.2, 0.3};
  wheels.SetVelocities(speeds);
  CHECK(wheels.GetOrderedVelocities()[1] == 0.3);
  CHECK(wheels.GetWheelVelocities()[1] == 0.3);
  wheels.Reset();
  CHECK(wheels.GetOrderedVelocities()[1] == 0.0);
}

TEST_CASE("dead reckoning: the direction of the drift backwards is one of two words",
          "[contract][robots][errors]") {
  CHECK_THAT(LoadError(Drifting("backward=\"left\"")),
             Contains("backward") && Contains("\"faster\" or \"slower\"") && Contains("left"));
}

}  // namespace argos::dead_reckoning_test
