// Sensors for pose and time: positioning, altitude, clock.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_altitude_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_clock_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>
#include <argos3/testing/contract/sensors/scene.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace pose_sensors_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

SRobotExperiment WithSensor(const std::string& sensor, const std::string& arena) {
  SRobotExperiment experiment;
  experiment.Sensors = sensor;
  experiment.Arena = arena;
  return experiment;
}

const CCI_PositioningSensor::SReading& Pose(CRobotWorld& world) {
  return world.GetSensor<CCI_PositioningSensor>("r", "positioning").GetReading();
}

constexpr int kTicks = 3000;  // of samples of noise

// A function of the orientation that the sensor reads, in each tick.
template <typename FUNCTION>
std::vector<Real> Sample(CRobotWorld& world, const FUNCTION& function) {
  std::vector<Real> values;
  for (int i = 0; i < kTicks; ++i) {
    world.Step();
    values.push_back(function(Pose(world).Orientation));
  }
  return values;
}

Real Altitude(CRobotWorld& world) {
  return world.GetSensor<CCI_AltitudeSensor>("r", "altitude").GetReading();
}

const CCI_ClockSensor::SReading& Clock(CRobotWorld& world) {
  return world.GetSensor<CCI_ClockSensor>("r", "clock").GetReading();
}

}  // namespace

TEST_CASE("positioning: reads the exact pose", "[contract][sensors]") {
  const std::string tag = GENERATE("foot-bot", "e-puck", "eye-bot");
  CRobotWorld world(
      WithSensor("<positioning implementation=\"default\"/>",
                 Robot(tag, "r", "position=\"1.25,-2.5,0.75\" orientation=\"30,20,10\"")));
  world.Step();
  const SAnchor& origin =
      world.Get<CComposableEntity>("r").GetComponent<CEmbodiedEntity>("body").GetOriginAnchor();
  CHECK(Pose(world).Position == CVector3(1.25, -2.5, 0.75));
  CHECK(Pose(world).Orientation == origin.Orientation);
  CRadians z, y, x;
  Pose(world).Orientation.ToEulerAngles(z, y, x);
  CHECK_THAT(ToDegrees(z).GetValue(), WithinAbs(30.0, 1e-12));
  CHECK_THAT(ToDegrees(y).GetValue(), WithinAbs(20.0, 1e-12));
  CHECK_THAT(ToDegrees(x).GetValue(), WithinAbs(10.0, 1e-12));
}

TEST_CASE("positioning: follows a moved robot", "[contract][sensors]") {
  CRobotWorld world(WithSensor("<positioning implementation=\"default\"/>",
                               Robot("foot-bot", "r", PoseText(CVector3()))));
  world.Step();
  const CQuaternion turn(CRadians(0.5), CVector3::Z);
  world.Get<CFootBotEntity>("r").GetEmbodiedEntity().MoveTo(CVector3(1.0, 2.0, 0.0), turn);
  world.Step();
  CHECK(Pose(world).Position == CVector3(1.0, 2.0, 0.0));
  CHECK(Pose(world).Orientation == turn);
  world.GetSimulator().Reset();
  CHECK(Pose(world).Position == CVector3());
}

TEST_CASE("positioning noise: each coordinate has the requested distribution",
          "[contract][sensors][noise]") {
  const bool even = GENERATE(true, false);
  const std::string device = "positioning implementation=\"default\"";
  CRobotWorld world(
      WithSensor(even ? "<" + device + " pos_noise_range=\"-0.1:0.2\"/>"
                      : WithNoise(device, "on=\"position\" model=\"gaussian\" std_dev=\"0.05\""),
                 Robot("foot-bot", "r", "position=\"1,2,3\" orientation=\"45,0,0\"")));
  std::vector<Real> deviations[3];
  for (int i = 0; i < kTicks; ++i) {
    world.Step();
    for (UInt32 axis = 0; axis < 3; ++axis) {
      deviations[axis].push_back(Pose(world).Position[axis] - (1.0 + axis));
    }
  }
  for (const std::vector<Real>& sample : deviations) {
    CHECK(KolmogorovSmirnovExcess(sample, [even](Real x) {
            return even ? UniformDistribution(x, -0.1, 0.2) : NormalDistribution(x, 0.05);
          }) <= 1.0);
  }
  // the orientation has no noise
  CHECK(Pose(world).Orientation ==
        world.Get<CFootBotEntity>("r").GetEmbodiedEntity().GetOriginAnchor().Orientation);
}

TEST_CASE("positioning noise: the angle's range is in radians", "[contract][sensors][noise]") {
  CRobotWorld world(
      WithSensor("<positioning implementation=\"default\" angle_noise_range=\"-0.2:0.1\"/>",
                 Robot("foot-bot", "r", "position=\"1,2,3\" orientation=\"60,0,0\"")));
  const std::vector<Real> deviations = Sample(world, [](const CQuaternion& orientation) {
    CRadians z, y, x;
    orientation.ToEulerAngles(z, y, x);
    REQUIRE_THAT(y.GetValue(), WithinAbs(0.0, 1e-14));
    REQUIRE_THAT(x.GetValue(), WithinAbs(0.0, 1e-14));
    return z.GetValue() - M_PI / 3.0;
  });
  CHECK(KolmogorovSmirnovExcess(deviations,
                                [](Real x) { return UniformDistribution(x, -0.2, 0.1); }) <= 1.0);
  CHECK(Pose(world).Position == CVector3(1.0, 2.0, 3.0));
}

TEST_CASE("positioning noise: the axis tilts, and orientations remain rotations",
          "[contract][sensors][noise]") {
  // a rotation about z by 90 degrees; noise is drawn for all three components of the axis
  CRobotWorld world(
      WithSensor("<positioning implementation=\"default\" axis_noise_range=\"-0.3:0.4\"/>",
                 Robot("foot-bot", "r", "position=\"1,2,3\" orientation=\"90,0,0\"")));
  const std::vector<Real> slopes = Sample(world, [](const CQuaternion& q) {
    REQUIRE_THAT(q.Length(), WithinAbs(1.0, 1e-14));
    // the angle has no noise
    REQUIRE_THAT(q.GetW(), WithinAbs(std::cos(M_PI / 4.0), 1e-14));
    return q.GetX() / q.GetZ();
  });
  // Distribution of the ratio of n1 and 1 + n2, both uniform in [-0.3, 0.4]: P(n1 / (1 + n2) <= s)
  // is the mean over n2 of P(n1 <= s (1 + n2)), by Simpson's rule on 1000 intervals.
  const auto distribution = [](Real slope) {
    constexpr int kPieces = 1000;
    Real sum = 0.0;
    for (int i = 0; i <= kPieces; ++i) {
      const Real n2 = -0.3 + 0.7 * i / kPieces;
      const Real weight = i == 0 || i == kPieces ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
      sum += weight * UniformDistribution(slope * (1.0 + n2), -0.3, 0.4);
    }
    return sum / (3.0 * kPieces);
  };
  CHECK(KolmogorovSmirnovExcess(slopes, distribution) <= 1.0);
}

TEST_CASE("altitude: is the height above the highest body below the robot, or the ground",
          "[contract][sensors]") {
  struct SCase {
    Real X, Z, Expected;  // m
  };
  const SCase c = GENERATE(SCase{0.0, 0.0, 0.0}, SCase{0.0, 2.0, 2.0},
                           // above the stool and beside it
                           SCase{1.0, 2.0, 1.5}, SCase{1.19, 2.0, 1.5}, SCase{1.21, 2.0, 2.0},
                           // above the shelf over the stool
                           SCase{3.0, 2.0, 0.8}, SCase{3.0, 1.0, 0.5},
                           // above an e-puck
                           SCase{-1.0, 1.0, 1.0 - 0.086},
                           // with its base inside a body, and below the ground
                           SCase{1.0, 0.3, 0.0}, SCase{0.0, -0.5, -0.5});
  CAPTURE(c.X, c.Z);
  const std::string shelf = BoxText("stool", CVector3(0.4, 0.4, 0.5), CVector3(1.0, 0.0, 0.0)) +
                            BoxText("stool2", CVector3(0.4, 0.4, 0.5), CVector3(3.0, 0.0, 0.0)) +
                            BoxText("shelf", CVector3(0.4, 0.4, 0.1), CVector3(3.0, 0.0, 1.1));
  CRobotWorld world(WithSensor("<altitude implementation=\"default\"/>",
                               shelf + Robot("foot-bot", "r", PoseText(CVector3(c.X, 0.0, c.Z))) +
                                   Robot("e-puck", "ep", PoseText(CVector3(-1.0, 0.0, 0.0)))));
  world.Step();
  CHECK_THAT(Altitude(world), WithinAbs(c.Expected, 1e-15));
}

TEST_CASE("altitude: a tilted robot measures vertically downwards and ignores its own body",
          "[contract][sensors]") {
  CRobotWorld world(
      WithSensor("<altitude implementation=\"default\" show_rays=\"true\"/>",
                 Robot("foot-bot", "r", "position=\"0,0,1\" orientation=\"0,90,0\"")));
  world.Step();
  CHECK(Altitude(world) == 1.0);
  CHECK(world.GetRobot("r").GetCheckedRays().size() == 1);
}

TEST_CASE("altitude noise: has the requested distribution", "[contract][sensors][noise]") {
  CRobotWorld world(WithSensor(WithNoise("altitude implementation=\"default\"",
                                         "on=\"height\" model=\"gaussian\" std_dev=\"0.1\""),
                               Robot("foot-bot", "r", PoseText(CVector3(0.0, 0.0, 1.0)))));
  std::vector<Real> deviations;
  for (int i = 0; i < 4000; ++i) {
    world.Step();
    deviations.push_back(Altitude(world) - 1.0);
  }
  CHECK(KolmogorovSmirnovExcess(deviations, [](Real x) { return NormalDistribution(x, 0.1); }) <=
        1.0);
}

TEST_CASE("clock: counts ticks from 1, and seconds", "[contract][sensors]") {
  const UInt32 ticksPerSecond = GENERATE(1U, 10U, 32U);
  SExperiment experiment =
      WithSensor("<clock implementation=\"default\"/>", Robot("e-puck", "r", PoseText(CVector3())))
          .ToExperiment();
  experiment.TicksPerSecond = ticksPerSecond;
  CTestWorld world(experiment);
  const auto& sensor = *world.Get<CComposableEntity>("r")
                            .GetComponent<CControllableEntity>("controller")
                            .GetController()
                            .GetSensor<CCI_ClockSensor>("clock");
  for (UInt32 tick = 1; tick <= 100; ++tick) {
    world.Step();
    CHECK(sensor.GetReading().Tick == tick);
    // one rounding of numbers up to 100
    CHECK_THAT(sensor.GetReading().Time,
               WithinAbs(static_cast<Real>(tick) / ticksPerSecond, 2e-14));
  }
  world.GetSimulator().Reset();
  CHECK(sensor.GetReading().Tick == 0);
  world.Step();
  CHECK(sensor.GetReading().Tick == 1);
}

TEST_CASE("clock noise: a clock may run fast", "[contract][sensors][noise]") {
  CRobotWorld world(WithSensor(
      WithNoise("clock implementation=\"default\"",
                "on=\"time\" model=\"gaussian\" std_dev=\"0\" bias=\"0.01\" relative=\"true\""),
      Robot("e-puck", "r", PoseText(CVector3()))));
  world.Step(200);
  CHECK(Clock(world).Tick == 200);
  CHECK_THAT(Clock(world).Time, WithinAbs(20.0 * 1.01, 1e-13));
}

TEST_CASE("pose sensors: invalid experiments are refused with the reason",
          "[contract][sensors][errors]") {
  const std::string robot = Robot("e-puck", "ep0", PoseText(CVector3()));
  CHECK_THAT(LoadError(WithSensor(
                 "<positioning implementation=\"default\" pos_noise_range=\"2:1\"/>", robot)),
             Contains("pos_noise_range") && Contains("2:1"));
  CHECK_THAT(LoadError(WithSensor(WithNoise("altitude implementation=\"default\"",
                                            "on=\"hight\" model=\"uniform\" level=\"1\""),
                                  robot)),
             Contains("\"hight\"") && Contains("height"));
  CHECK_THAT(
      LoadError(WithSensor(
          WithNoise("clock implementation=\"default\"", "model=\"uniform\" level=\"-1\""), robot)),
      Contains("level") && Contains(">= 0"));
}

}  // namespace pose_sensors_test
