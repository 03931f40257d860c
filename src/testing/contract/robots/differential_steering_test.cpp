// Wheels of robots: orders of controllers, speeds of wheels, readings of encoders.

#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>
#include <argos3/plugins/robots/generic/simulator/differential_steering_default_actuator.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <vector>

namespace differential_steering_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

SRobotExperiment Wheels(const std::string& actuatorAttributes = "",
                        const std::string& sensorAttributes = "",
                        const std::string& tag = "foot-bot") {
  SRobotExperiment experiment;
  experiment.Actuators =
      "<differential_steering implementation=\"default\" " + actuatorAttributes + "/>";
  experiment.Sensors =
      "<differential_steering implementation=\"default\" " + sensorAttributes + "/>";
  experiment.Arena = Robot(tag, "r", "position=\"0,0,0\"");
  return experiment;
}

CCI_DifferentialSteeringActuator& Actuator(CRobotWorld& world) {
  return world.GetActuator<CCI_DifferentialSteeringActuator>("r", "differential_steering");
}

const CCI_DifferentialSteeringSensor::SReading& Reading(CRobotWorld& world) {
  return world.GetSensor<CCI_DifferentialSteeringSensor>("r", "differential_steering").GetReading();
}

CWheeledEntity& WheelsOf(CRobotWorld& world) {
  return world.Get<CComposableEntity>("r").GetComponent<CWheeledEntity>("wheels");
}

// gives the same order num times; returns the speed of one wheel after each order, m/s
std::vector<Real> Orders(CRobotWorld& world, Real speed, size_t wheel, int num) {
  std::vector<Real> results;
  for (int i = 0; i < num; ++i) {
    Actuator(world).SetLinearVelocity(speed, speed);
    world.GetRobot("r").Act();
    results.push_back(WheelsOf(world).GetWheelVelocity(wheel));
  }
  return results;
}

struct SMoments {
  Real Mean, Deviation;
};

SMoments MomentsOf(const std::vector<Real>& values) {
  Real sum = 0.0;
  for (const Real value : values) {
    sum += value;
  }
  const Real mean = sum / values.size();
  Real squares = 0.0;
  for (const Real value : values) {
    squares += (value - mean) * (value - mean);
  }
  return {mean, std::sqrt(squares / (values.size() - 1))};
}

}  // namespace

TEST_CASE("differential steering: orders in cm/s become wheel speeds in m/s in the next tick",
          "[contract][robots]") {
  const std::string tag = GENERATE("foot-bot", "e-puck");
  CAPTURE(tag);
  CRobotWorld world(Wheels("", "", tag));
  CHECK(WheelsOf(world).GetWheelVelocity(0) == 0.0);
  Actuator(world).SetLinearVelocity(12.5, -7.0);
  CHECK(WheelsOf(world).GetWheelVelocity(0) == 0.0);
  world.Step();
  // one rounding of the product
  CHECK_THAT(WheelsOf(world).GetWheelVelocity(0), WithinAbs(0.125, 1e-17));
  CHECK_THAT(WheelsOf(world).GetWheelVelocity(1), WithinAbs(-0.07, 1e-16));
  world.Step(3);
  CHECK_THAT(WheelsOf(world).GetWheelVelocity(0), WithinAbs(0.125, 1e-17));
  world.GetSimulator().Reset();
  CHECK(WheelsOf(world).GetWheelVelocity(0) == 0.0);
  world.Step();
  CHECK(WheelsOf(world).GetWheelVelocity(0) == 0.0);
}

TEST_CASE("differential steering: speeds that override those of the controller end with these",
          "[contract][robots]") {
  const std::string implementation = GENERATE("default", "dead_reckoning");
  const std::string noise = GENERATE("", " factor_stddev=\"0.2\"");
  CAPTURE(implementation, noise);
  SRobotExperiment experiment = Wheels();
  experiment.Actuators = "<differential_steering implementation=\"" + implementation + "\"" +
                         noise + (implementation == "default" ? "" : " sigma=\"0\"") + " />";
  CRobotWorld driven(experiment);
  CRobotWorld free(experiment);
  auto& actuator = dynamic_cast<CDifferentialSteeringDefaultActuator&>(Actuator(driven));
  for (CRobotWorld* world : {&driven, &free}) {
    Actuator(*world).SetLinearVelocity(10.0, 8.0);
    world->Step();
  }
  actuator.Override(-3.0, 2.0);
  driven.Step();
  CHECK_THAT(WheelsOf(driven).GetWheelVelocity(0), WithinAbs(-0.03, 1e-17));
  CHECK_THAT(WheelsOf(driven).GetWheelVelocity(1), WithinAbs(0.02, 1e-17));
  // what its controller sets, and the noise on it, is what it would be otherwise
  for (CRobotWorld* world : {&driven, &free}) {
    Actuator(*world).SetLinearVelocity(5.0, 4.0);
    world->Step();
  }
  CHECK_THAT(WheelsOf(driven).GetWheelVelocity(0), WithinAbs(-0.03, 1e-17));
  actuator.EndOverride();
  driven.Step();
  for (const size_t wheel : {0, 1}) {
    CHECK(WheelsOf(driven).GetWheelVelocity(wheel) == WheelsOf(free).GetWheelVelocity(wheel));
  }
  actuator.Override(1.0, 1.0);
  driven.GetSimulator().Reset();
  driven.Step();
  CHECK(WheelsOf(driven).GetWheelVelocity(0) == 0.0);
}

TEST_CASE("differential steering sensor: reads the orders", "[contract][robots]") {
  struct SCase {
    const char* Tag;
    Real Axis;  // cm
  };
  const SCase robot = GENERATE(SCase{"foot-bot", 14.0}, SCase{"e-puck", 5.3});
  CAPTURE(robot.Tag);
  CRobotWorld world(Wheels("", "", robot.Tag));
  Actuator(world).SetLinearVelocity(10.0, -4.0);
  world.Step();
  // a few roundings; ticks last 0.1 s
  CHECK_THAT(Reading(world).VelocityLeftWheel, WithinAbs(10.0, 1e-14));
  CHECK_THAT(Reading(world).VelocityRightWheel, WithinAbs(-4.0, 1e-14));
  CHECK_THAT(Reading(world).CoveredDistanceLeftWheel, WithinAbs(1.0, 1e-15));
  CHECK_THAT(Reading(world).CoveredDistanceRightWheel, WithinAbs(-0.4, 1e-15));
  CHECK_THAT(Reading(world).WheelAxisLength, WithinAbs(robot.Axis, 1e-14));
  world.GetSimulator().Reset();
  CHECK(Reading(world).VelocityLeftWheel == 0.0);
  CHECK_THAT(Reading(world).WheelAxisLength, WithinAbs(robot.Axis, 1e-14));
}

TEST_CASE("differential steering: the error on a speed that is not finite names the robot",
          "[contract][robots][errors]") {
  const Real bad =
      GENERATE(std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity());
  const bool isLeft = GENERATE(true, false);
  CRobotWorld world(Wheels());
  auto& controller = dynamic_cast<CRobotWorldController&>(world.GetRobot("r").GetController());
  controller.OnStep = [&] {
    Actuator(world).SetLinearVelocity(isLeft ? bad : 1.0, isLeft ? 1.0 : bad);
  };
  CHECK_THROWS_WITH(world.Step(), Contains("robot \"r\"") &&
                                      Contains("wheel speeds must be finite, got left=") &&
                                      Contains("tick 1"));
}

TEST_CASE("differential steering noise: the factor is drawn at each order", "[contract][robots]") {
  constexpr int kOrders = 20000;
  CRobotWorld world(Wheels("factor_avg=\"1.5\" factor_stddev=\"0.2\""));
  const SMoments left = MomentsOf(Orders(world, 10.0, 0, kOrders));
  // f (v + 0) with v = 0.1 m/s; five standard deviations of each estimate
  // are exceeded once in a million
  const Real deviation = 0.1 * 0.2;
  CHECK_THAT(left.Mean, WithinAbs(0.15, 5.0 * deviation / std::sqrt(kOrders)));
  CHECK_THAT(left.Deviation, WithinAbs(deviation, 5.0 * deviation / std::sqrt(2.0 * kOrders)));
}

TEST_CASE("differential steering noise: the bias is drawn once", "[contract][robots]") {
  CRobotWorld world(Wheels("bias_avg=\"0.01\" bias_stddev=\"0.002\""));
  const std::vector<Real> left = Orders(world, 10.0, 0, 20);
  const std::vector<Real> right = Orders(world, 10.0, 1, 20);
  CHECK(left == std::vector<Real>(20, left[0]));
  CHECK(right == std::vector<Real>(20, right[0]));
  CHECK(left[0] != right[0]);
  // tolerance of six deviations around the mean
  CHECK_THAT(left[0], WithinAbs(0.11, 0.012));
  CHECK(Orders(world, 0.0, 0, 1)[0] == 0.0);
  world.GetSimulator().Reset();
  CHECK(Orders(world, 10.0, 0, 20) == left);
}

TEST_CASE(
    "differential steering noise: biases of many robots have the requested mean and deviation",
    "[contract][robots]") {
  constexpr int kRobots = 500;
  SRobotExperiment experiment = Wheels("bias_avg=\"0.01\" bias_stddev=\"0.002\"");
  experiment.Arena.clear();
  for (int i = 0; i < kRobots; ++i) {
    experiment.Arena += Robot("e-puck", "r" + std::to_string(i), "position=\"0,0,0\"");
  }
  CRobotWorld world(experiment);
  std::vector<Real> biases;
  for (int i = 0; i < kRobots; ++i) {
    const std::string id = "r" + std::to_string(i);
    world.GetActuator<CCI_DifferentialSteeringActuator>(id, "differential_steering")
        .SetLinearVelocity(10.0, 10.0);
    world.GetRobot(id).Act();
    auto& wheels = world.Get<CComposableEntity>(id).GetComponent<CWheeledEntity>("wheels");
    biases.push_back(wheels.GetWheelVelocity(0) - 0.1);
    biases.push_back(wheels.GetWheelVelocity(1) - 0.1);
  }
  const SMoments moments = MomentsOf(biases);
  // tolerance of five standard deviations of each estimate: one failure in a million
  CHECK_THAT(moments.Mean, WithinAbs(0.01, 5.0 * 0.002 / std::sqrt(2.0 * kRobots)));
  CHECK_THAT(moments.Deviation, WithinAbs(0.002, 5.0 * 0.002 / std::sqrt(4.0 * kRobots)));
}

TEST_CASE("differential steering noise: the attribute of a single wheel has precedence",
          "[contract][robots]") {
  CRobotWorld world(Wheels("bias_avg=\"0.01\" bias_avg_right=\"0.03\" factor_avg_left=\"2\""));
  CHECK_THAT(Orders(world, 10.0, 0, 1)[0], WithinAbs(2.0 * 0.11, 1e-15));
  CHECK_THAT(Orders(world, 10.0, 1, 1)[0], WithinAbs(0.13, 1e-15));
}

TEST_CASE("differential steering sensor noise: readings stay in their ranges and fill them",
          "[contract][robots]") {
  CRobotWorld world(Wheels("", "vel_noise_range=\"-1:2\" dist_noise_range=\"0.5:0.7\""));
  Actuator(world).SetLinearVelocity(10.0, 10.0);
  Real least = 1e9;
  Real most = -1e9;
  for (int i = 0; i < 1000; ++i) {
    world.Step();
    least = std::min(least, Reading(world).VelocityLeftWheel);
    most = std::max(most, Reading(world).VelocityLeftWheel);
    REQUIRE(Reading(world).CoveredDistanceRightWheel >= 1.5 - 1e-12);
    REQUIRE(Reading(world).CoveredDistanceRightWheel <= 1.7 + 1e-12);
  }
  CHECK(least >= 9.0 - 1e-12);
  CHECK(most <= 12.0 + 1e-12);
  // of 1000 uniform draws none is in the last 5 % with a probability of 5e-23
  CHECK(least < 9.15);
  CHECK(most > 11.85);
}

TEST_CASE("differential steering: invalid experiments are refused with the reason",
          "[contract][robots][errors]") {
  CHECK_THAT(LoadError(Wheels("bias_stddev=\"-1\"")),
             Contains("bias_stddev") && Contains(">= 0") && Contains("-1"));
  CHECK_THAT(LoadError(Wheels("factor_stddev_left=\"-2\"")), Contains("factor_stddev"));
  CHECK_THAT(LoadError(Wheels("factor_avg=\"fast\"")), Contains("fast"));
  CHECK_THAT(LoadError(Wheels("", "vel_noise_range=\"2:1\"")), Contains("vel_noise_range"));
}

}  // namespace differential_steering_test
