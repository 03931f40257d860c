// The encoders of the foot-bot: the actual rolling distance of the wheels.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_encoder_sensor.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/simulator/entities/odometer_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/testing/contract/sensors/scene.h>
#include <argos3/testing/support/closed_form/differential_drive.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace argos::encoder_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kTick = 0.1;  // s
constexpr Real kLag = 0.1;  // ticks: until an order acts, by default

SRobotExperiment WithEncoder(
    const std::string& arena,
    const std::string& sensor = "<footbot_encoder implementation=\"default\"/>") {
  SRobotExperiment experiment;
  experiment.Actuators = "<differential_steering implementation=\"default\"/>";
  experiment.Sensors = sensor;
  experiment.Engine = "<dynamics2d id=\"dyn2d\"/>";
  experiment.Arena = arena;
  return experiment;
}

const CCI_FootBotEncoderSensor::SReading& Reading(CRobotWorld& world) {
  return world.GetSensor<CCI_FootBotEncoderSensor>("r", "footbot_encoder").GetReading();
}

// speeds in cm/s
void Drive(CRobotWorld& world, Real left, Real right) {
  world.GetActuator<CCI_DifferentialSteeringActuator>("r", "differential_steering")
      .SetLinearVelocity(left, right);
}

// an odometer on a body that the test moves
struct SCart {
  CRobotWorld World{SRobotExperiment()};
  CComposableEntity Robot{nullptr, "robot"};
  CEmbodiedEntity& Body{*AddTo<CEmbodiedEntity>("body_0")};
  CWheeledEntity& Wheels{*AddTo<CWheeledEntity>("wheels_0", size_t(2))};
  COdometerEntity& Odometer{*AddTo<COdometerEntity>("odometer_0")};

  SCart() {
    Wheels.SetWheel(0, CVector3(0.0, 0.1, 0.0), 0.02);
    Wheels.SetWheel(1, CVector3(0.0, -0.1, 0.0), 0.02);
  }
  template <typename COMPONENT, typename... ARGUMENTS>
  COMPONENT* AddTo(ARGUMENTS&&... arguments) {
    auto component = std::make_unique<COMPONENT>(&Robot, std::forward<ARGUMENTS>(arguments)...);
    Robot.AddComponent(*component);
    return component.release();
  }
  // one tick of physics
  void Move(const CVector3& position, const CQuaternion& orientation) {
    World.GetSpace().IncreaseSimulationClock();
    Body.SetOriginPose(position, orientation);
    Odometer.Update();
  }
};

CQuaternion Yaw(Real yaw) {
  return CQuaternion(CRadians(yaw), CVector3::Z);
}

}  // namespace

TEST_CASE("encoder: on any arc each wheel reads its rolling distance in every tick",
          "[contract][sensors]") {
  using TSpeeds = std::pair<Real, Real>;  // cm/s
  const auto [left, right] =
      GENERATE(TSpeeds(10, 10), TSpeeds(10, 9), TSpeeds(3, 12), TSpeeds(-5, 7.5), TSpeeds(-8, -8),
               TSpeeds(4, -4), TSpeeds(0, 0), TSpeeds(200, -100));
  const Real yaw = GENERATE(0.0, 77.0, 179.0);  // degrees
  CAPTURE(left, right, yaw);
  CRobotWorld world(WithEncoder(Robot("foot-bot", "r", PoseText(CVector3(1.0, -2.0, 0.0), yaw))));
  CHECK_THAT(Reading(world).WheelAxisLength, WithinAbs(14.0, 1e-14));
  Drive(world, left, right);
  Real totalLeft = 0.0;
  for (int tick = 1; tick <= 50; ++tick) {
    world.Step();
    const Real time = tick == 1 ? kTick * (1.0 - kLag) : kTick;
    // tolerance of roundings of positions of some metres, in cm
    CHECK_THAT(Reading(world).CoveredDistanceLeftWheel, WithinAbs(left * time, 1e-11));
    CHECK_THAT(Reading(world).CoveredDistanceRightWheel, WithinAbs(right * time, 1e-11));
    totalLeft += Reading(world).CoveredDistanceLeftWheel;
  }
  CHECK_THAT(totalLeft, WithinAbs(left * kTick * (50 - kLag), 1e-9));
}

TEST_CASE("encoder: orders that change roll each wheel as far as it turned",
          "[contract][sensors]") {
  CRobotWorld world(WithEncoder(Robot("foot-bot", "r", PoseText(CVector3(1.0, -2.0, 0.0), 33.0))));
  const std::vector<std::pair<Real, Real>> orders = {{10, 10}, {-30, 30}, {30, -30}, {0, 0},
                                                     {20, 5},  {-8, 3},   {40, 40},  {-40, 10}};
  std::pair<Real, Real> last(0.0, 0.0);
  for (const auto& order : orders) {
    Drive(world, order.first, order.second);
    world.Step();
    const Real left = kLag * last.first + (1.0 - kLag) * order.first;
    const Real right = kLag * last.second + (1.0 - kLag) * order.second;
    CHECK_THAT(Reading(world).CoveredDistanceLeftWheel, WithinAbs(left * kTick, 1e-11));
    CHECK_THAT(Reading(world).CoveredDistanceRightWheel, WithinAbs(right * kTick, 1e-11));
    last = order;
  }
}

TEST_CASE("encoder: readings are zero before the first order", "[contract][sensors]") {
  CRobotWorld world(WithEncoder(Robot("foot-bot", "r", PoseText(CVector3(1.0, 0.0, 0.0), 30.0))));
  world.Step(2);
  CHECK(Reading(world).CoveredDistanceLeftWheel == 0.0);
  CHECK(Reading(world).CoveredDistanceRightWheel == 0.0);
}

TEST_CASE("encoder: the wheels of a robot that stalls at a wall do not roll",
          "[contract][sensors]") {
  CRobotWorld world(WithEncoder(Robot("foot-bot", "r", PoseText(CVector3())) +
                                BoxText("wall", CVector3(0.2, 4.0, 1.0), CVector3(0.3, 0.0, 0.0))));
  Drive(world, 10.0, 10.0);
  world.Step(100);
  // the robot is at the wall; the solver allows a small penetration
  CHECK_THAT(Reading(world).CoveredDistanceLeftWheel, WithinAbs(0.0, 1e-3));
  CHECK_THAT(Reading(world).CoveredDistanceRightWheel, WithinAbs(0.0, 1e-3));
}

TEST_CASE("encoder: wheels that drift turn as far as ordered, in proportion to their way",
          "[contract][sensors]") {
  SCart cart;
  cart.Odometer.Enable();
  cart.Wheels.EnableDrift();
  const Real ordered[2] = {0.1, 0.1};
  const Real ground[2] = {0.1, 0.14};
  cart.Wheels.SetDriftingVelocities(ordered, ground);
  // the pose after one tick of the drive: 12 mm of an arc, with a turn of 0.004 m / 0.2 m
  const Real turn = 0.02;
  const Real radius = 0.012 / turn;
  cart.Move(CVector3(radius * std::sin(turn), radius * (1.0 - std::cos(turn)), 0.0), Yaw(turn));
  CHECK_THAT(cart.Odometer.GetRolledDistance(0), WithinAbs(0.01, 1e-15));
  CHECK_THAT(cart.Odometer.GetRolledDistance(1), WithinAbs(0.01, 1e-15));
  // a robot that is held fast: the wheels neither roll nor turn
  cart.Move(cart.Body.GetOriginAnchor().Position, cart.Body.GetOriginAnchor().Orientation);
  // the odometer takes the chord of the commanded arc for its length: 12 mm times 0.02^2 / 24, and
  // the same for the deviation from it; the drift is 4 mm
  CHECK_THAT(cart.Odometer.GetRolledDistance(0), WithinAbs(0.0, 1e-6));
  CHECK_THAT(cart.Odometer.GetRolledDistance(1), WithinAbs(0.0, 1e-6));
}

TEST_CASE("encoder: moves by a program do not roll the wheels", "[contract][sensors]") {
  CRobotWorld world(WithEncoder(Robot("foot-bot", "r", PoseText(CVector3()))));
  Drive(world, 10.0, 10.0);
  world.Step(3);
  auto& body = world.Get<CFootBotEntity>("r").GetEmbodiedEntity();
  REQUIRE(body.MoveTo(CVector3(2.0, 1.0, 0.0), Yaw(1.0)));
  world.Step();
  // 1 cm but for the time in which the robot still stands, as when it was placed
  CHECK_THAT(Reading(world).CoveredDistanceLeftWheel, WithinAbs(1.0 - kLag, 1e-11));
  CHECK_THAT(Reading(world).CoveredDistanceRightWheel, WithinAbs(1.0 - kLag, 1e-11));
}

TEST_CASE("encoder: a reset restarts it, and the run repeats", "[contract][sensors]") {
  CRobotWorld world(WithEncoder(Robot("foot-bot", "r", PoseText(CVector3(1.0, 0.0, 0.0), 30.0)),
                                WithNoise("footbot_encoder implementation=\"default\"",
                                          "model=\"gaussian\" std_dev=\"0.1\"")));
  const auto run = [&world] {
    std::vector<Real> readings;
    Drive(world, 10.0, 5.0);
    for (int i = 0; i < 5; ++i) {
      world.Step();
      readings.push_back(Reading(world).CoveredDistanceLeftWheel);
      readings.push_back(Reading(world).CoveredDistanceRightWheel);
    }
    return readings;
  };
  const std::vector<Real> first = run();
  world.GetSimulator().Reset();
  CHECK(Reading(world).CoveredDistanceLeftWheel == 0.0);
  CHECK(run() == first);
}

TEST_CASE("odometer: arcs of less than half a turn are exact", "[contract][sensors]") {
  const Real turn = GENERATE(-3.1, -1.0, -1e-9, 0.0, 1e-5, 0.3, 2.0, 3.1);  // rad
  const Real way = GENERATE(-0.5, 0.0, 0.2);  // m, path of the origin
  const Real start = GENERATE(0.0, 2.0, -3.0);  // rad
  CAPTURE(turn, way, start);
  SCart cart;
  cart.Move(CVector3(0.3, 0.4, 0.0), Yaw(start));
  const Real right = way + 0.1 * turn;
  const Real left = way - 0.1 * turn;
  const testing::SPose end =
      testing::IntegrateDifferentialDrive({0.3, 0.4, start}, left, right, 0.2, 1.0);
  cart.Move(CVector3(end.X, end.Y, 0.0), Yaw(end.Yaw));
  // Near half a turn the chord is 24 times shorter than the path, so its roundings count as much
  // more. The closed form divides by the angle, and so the roundings of its sines.
  const Real tolerance = 1e-13 + (turn == 0.0 ? 0.0 : 4e-16 * std::abs(way / turn));
  CHECK_THAT(cart.Odometer.GetRolledDistance(0), WithinAbs(left, tolerance));
  CHECK_THAT(cart.Odometer.GetRolledDistance(1), WithinAbs(right, tolerance));
}

TEST_CASE("odometer: sideways motion does not roll the wheels", "[contract][sensors]") {
  SCart cart;
  cart.Move(CVector3(), Yaw(M_PI / 6.0));
  // 5 cm ahead and 7 cm to the left
  const CVector3 ahead(std::cos(M_PI / 6.0), std::sin(M_PI / 6.0), 0.0);
  const CVector3 left(-ahead.GetY(), ahead.GetX(), 0.0);
  cart.Move(ahead * 0.05 + left * 0.07, Yaw(M_PI / 6.0));
  CHECK_THAT(cart.Odometer.GetRolledDistance(0), WithinAbs(0.05, 1e-15));
  CHECK_THAT(cart.Odometer.GetRolledDistance(1), WithinAbs(0.05, 1e-15));
}

TEST_CASE("encoder noise: each wheel has the requested distribution",
          "[contract][sensors][noise]") {
  constexpr int kTicks = 4000;
  const bool isLeft = GENERATE(true, false);
  CRobotWorld world(
      WithEncoder(Robot("foot-bot", "r", PoseText(CVector3())),
                  WithNoise("footbot_encoder implementation=\"default\"",
                            std::string("on=\"distance_") + (isLeft ? "left" : "right") +
                                "\" model=\"gaussian\" std_dev=\"0.2\"")));
  // in place, so that the robot stays in the arena
  Drive(world, 10.0, -10.0);
  world.Step();  // the orders act late in it
  std::vector<Real> noisy;
  for (int i = 0; i < kTicks; ++i) {
    world.Step();
    const auto& reading = Reading(world);
    noisy.push_back(isLeft ? reading.CoveredDistanceLeftWheel - 1.0
                           : reading.CoveredDistanceRightWheel + 1.0);
    REQUIRE_THAT(
        isLeft ? reading.CoveredDistanceRightWheel + 1.0 : reading.CoveredDistanceLeftWheel - 1.0,
        WithinAbs(0.0, 1e-11));
  }
  CHECK(KolmogorovSmirnovExcess(noisy, [](Real x) { return NormalDistribution(x, 0.2); }) <= 1.0);
}

TEST_CASE("encoder: the sensor of another robot is refused", "[contract][sensors][errors]") {
  CHECK_THAT(LoadError(WithEncoder(Robot("e-puck", "ep0", PoseText(CVector3())))),
             Contains("\"ep0\"") && Contains("odometer"));
}

}  // namespace argos::encoder_test
