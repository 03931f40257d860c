// Wheels whose right one is slightly faster: the drift of robots that navigate by dead reckoning.

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
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

using namespace argos;
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

TEST_CASE("dead reckoning: the right wheel is faster, forwards and backwards",
          "[contract][robots]") {
  CRobotWorld world(Drifting("sigma=\"0.1\""));
  const Real mu = Actuator(world).GetDeviation();
  REQUIRE(mu > 0.0);
  const auto [left, right] = WheelsFor(world, 10.0, 10.0);
  CHECK(left == 0.1);
  CHECK_THAT(right, WithinAbs(0.1 * (1.0 + mu), 1e-16));
  const auto [leftBack, rightBack] = WheelsFor(world, -10.0, -10.0);
  CHECK_THAT(leftBack, WithinAbs(-0.1 * (1.0 - mu), 1e-16));
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
  const bool ahead = GENERATE(true, false);
  CAPTURE(type.Tag, ahead);
  CRobotWorld world(Drifting("sigma=\"0.02\"", type.Tag));
  const Real mu = Actuator(world).GetDeviation();
  CAPTURE(mu);
  const Real speed = ahead ? 10.0 : -10.0;  // cm/s
  Actuator(world).SetLinearVelocity(speed, speed);
  constexpr int kTicks = 100;
  world.Step(kTicks);
  const auto& origin =
      world.Get<CComposableEntity>("r").GetComponent<CEmbodiedEntity>("body").GetOriginAnchor();
  // the centre of the circle is to the left, at (0, radius)
  const Real radius = type.Axis * (ahead ? 2.0 + mu : 2.0 - mu) / (2.0 * mu);
  CHECK_THAT(std::hypot(origin.Position.GetX(), origin.Position.GetY() - radius),
             WithinAbs(radius, 1e-12 * radius));
  // the length of the arc follows from the mean speed of the wheels
  const Real way = 0.01 * speed * (ahead ? 1.0 + 0.5 * mu : 1.0 - 0.5 * mu) * kTicks * kTick;
  const auto arc = testing::IntegrateDifferentialDrive({}, ahead ? 0.1 : -0.1 * (1.0 - mu),
                                                       ahead ? 0.1 * (1.0 + mu) : -0.1, type.Axis,
                                                       kTicks * kTick);
  CHECK_THAT(origin.Position.GetX(), WithinAbs(radius * std::sin(way / radius), 1e-12));
  CHECK_THAT(origin.Position.GetX(), WithinAbs(arc.X, 1e-12));
  CHECK_THAT(origin.Position.GetY(), WithinAbs(arc.Y, 1e-12));
  CHECK((origin.Position.GetY() > 0.0));
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
