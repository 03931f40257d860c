// The distance scanner of the foot-bot: motor and heads.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/ray_queries.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_sensor.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_distance_scanner_equipped_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/testing/contract/sensors/scene.h>
#include <argos3/testing/support/robot_sizes.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace distance_scanner_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kRadius = kFootBotRadius;
constexpr Real kHeight = 0.123199866;  // m, of the beams
constexpr Real kTick = 0.1;  // s
constexpr Real kGrazing = 1e-6;  // cm; grazing rays lose half of the digits in a square root

typedef CCI_FootBotDistanceScannerSensor::TReadingsMap TMap;

SRobotExperiment WithScanner(const std::string& arena, const std::string& sensorAttributes = "") {
  SRobotExperiment experiment;
  experiment.Actuators = "<footbot_distance_scanner implementation=\"default\"/>";
  experiment.Sensors =
      "<footbot_distance_scanner implementation=\"rot_z_only\" " + sensorAttributes + "/>";
  experiment.Arena = arena;
  return experiment;
}

std::string FootBot(const CVector3& position = CVector3(), Real yaw = 0.0) {
  return Robot("foot-bot", "r", PoseText(position, yaw));
}

CCI_FootBotDistanceScannerSensor& Sensor(CRobotWorld& world) {
  return world.GetSensor<CCI_FootBotDistanceScannerSensor>("r", "footbot_distance_scanner");
}

CCI_FootBotDistanceScannerActuator& Motor(CRobotWorld& world) {
  return world.GetActuator<CCI_FootBotDistanceScannerActuator>("r", "footbot_distance_scanner");
}

Real Wrap(Real angle) {
  return std::remainder(angle, 2.0 * M_PI);
}

// the reading of the beam at that angle, rad
Real At(const TMap& readings, Real angle) {
  for (const auto& [beam, distance] : readings) {
    if (std::abs(Wrap(beam.GetValue() - angle)) < 1e-9) {
      return distance;
    }
  }
  FAIL("no beam at " << angle);
  return 0.0;
}

// the expected reading of a beam of a robot in that pose, from a separate ray query
Real Expect(CRobotWorld& world, Real x, Real y, Real yaw, Real angle, Real range, Real minimum) {
  const Real direction = yaw + angle;
  const CVector3 outward(std::cos(direction), std::sin(direction), 0.0);
  const CVector3 start = CVector3(x, y, kHeight) + outward * kRadius;
  SEmbodiedEntityIntersectionItem hit;
  if (!GetClosestEmbodiedEntityIntersectedByRay(
          hit, CRay3(start, start + outward * range),
          world.Get<CFootBotEntity>("r").GetEmbodiedEntity())) {
    return -2.0;
  }
  const Real distance = hit.TOnRay * range;
  return distance <= minimum ? -1.0 : 100.0 * distance;
}

}  // namespace

TEST_CASE("distance scanner: it is off until it is switched on, then at angle 0",
          "[contract][sensors]") {
  CRobotWorld world(WithScanner(FootBot()));
  world.Step(2);
  CHECK(Sensor(world).GetReadingsMap().empty());
  CHECK(Sensor(world).GetShortReadingsMap().empty());
  CHECK(Sensor(world).GetLongReadingsMap().empty());
  Motor(world).Enable();
  world.Step();
  const TMap& shortRange = Sensor(world).GetShortReadingsMap();
  const TMap& longRange = Sensor(world).GetLongReadingsMap();
  REQUIRE(shortRange.size() == 2);
  REQUIRE(longRange.size() == 2);
  CHECK(Sensor(world).GetReadingsMap().size() == 4);
  CHECK(At(shortRange, 0.0) == -2.0);
  CHECK(At(shortRange, M_PI) == -2.0);
  CHECK(At(longRange, 0.5 * M_PI) == -2.0);
  CHECK(At(longRange, -0.5 * M_PI) == -2.0);
  Motor(world).Disable();
  world.Step();
  CHECK(Sensor(world).GetReadingsMap().empty());
}

TEST_CASE("distance scanner: on an eye-bot, beams begin at its arms, 16.35 cm above its base",
          "[contract][sensors]") {
  // the plate ahead is in the beam, the one to the left just below it
  const Real gap = 0.2;
  const Real center = 0.25 + gap + 0.5;
  SRobotExperiment experiment =
      WithScanner(Robot("eye-bot", "r", PoseText(CVector3())) +
                  BoxText("ahead", CVector3(1.0, 1.0, 0.02), CVector3(center, 0.0, 0.1535), 0.0) +
                  BoxText("left", CVector3(1.0, 1.0, 0.02), CVector3(0.0, center, 0.1434), 0.0));
  experiment.Engine = "<pointmass3d id=\"engine\"/>";
  CRobotWorld world(experiment);
  Motor(world).SetAngle(CRadians::ZERO);
  world.Step();
  CHECK_THAT(At(Sensor(world).GetShortReadingsMap(), 0.0), WithinAbs(100.0 * gap, 1e-9));
  CHECK(At(Sensor(world).GetShortReadingsMap(), M_PI) == -2.0);
  CHECK(At(Sensor(world).GetLongReadingsMap(), 0.5 * M_PI) == -2.0);
  Motor(world).SetAngle(CRadians::PI_OVER_TWO);
  world.Step();
  CHECK_THAT(At(Sensor(world).GetLongReadingsMap(), 0.0), WithinAbs(100.0 * gap, 1e-9));
}

TEST_CASE(
    "distance scanner: distances are measured from the surface of the body, within each range",
    "[contract][sensors]") {
  struct SCase {
    Real Gap;  // m, from the surface of the body to a wall
    Real Short, Long;  // cm
  };
  const SCase c = GENERATE(SCase{0.0, -1.0, -1.0}, SCase{1e-6, 1e-4, -1.0}, SCase{0.05, 5.0, -1.0},
                           SCase{0.12 - 1e-9, 12.0, -1.0}, SCase{0.12 + 1e-9, 12.0, 12.0},
                           SCase{0.26 - 1e-9, 26.0, 26.0}, SCase{0.26 + 1e-9, -2.0, 26.0},
                           SCase{1.0, -2.0, 100.0}, SCase{1.42 - 1e-9, -2.0, 142.0},
                           SCase{1.42 + 1e-9, -2.0, -2.0});
  const bool isLong = GENERATE(false, true);
  const Real yaw = GENERATE(0.0, 90.0, 180.0);  // degrees: walls stay along the axes
  CAPTURE(c.Gap, isLong, yaw);
  // a wall straight ahead of the robot
  const Real towards = yaw * M_PI / 180.0;
  const Real center = kRadius + c.Gap + 0.5;
  CRobotWorld world(WithScanner(
      FootBot(CVector3(), yaw) +
      BoxText("wall", CVector3(1.0, 3.0, 0.5),
              CVector3(center * std::cos(towards), center * std::sin(towards), 0.0), yaw)));
  // turns the head of that range ahead
  Motor(world).SetAngle(isLong ? -CRadians::PI_OVER_TWO : CRadians::ZERO);
  world.Step();
  const TMap& readings =
      isLong ? Sensor(world).GetLongReadingsMap() : Sensor(world).GetShortReadingsMap();
  // a nanometre is 1e-7 cm
  CHECK_THAT(At(readings, 0.0), WithinAbs(isLong ? c.Long : c.Short, 2e-7));
  CHECK(At(readings, M_PI) == -2.0);
}

TEST_CASE("distance scanner: in a cluttered world every beam equals a separate ray query",
          "[contract][sensors]") {
  CRandomStream random(3, "test", "scanner", "clutter");
  int near = 0;
  int far = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Real x = random.Uniform(-2.0, 2.0);
    const Real y = random.Uniform(-2.0, 2.0);
    const Real yaw = random.Uniform(-M_PI, M_PI);
    std::string arena = FootBot(CVector3(x, y, 0.0), yaw * 180.0 / M_PI);
    for (int i = 0; i < 12; ++i) {
      const Real bearing = random.Uniform(-M_PI, M_PI);
      const Real distance = random.Uniform(0.2, 1.6);
      const Real radius = random.Uniform(0.02, 0.1);
      arena += PillarText("p" + std::to_string(i), x + distance * std::cos(bearing),
                          y + distance * std::sin(bearing), radius, random.Uniform(0.05, 0.3));
    }
    CRobotWorld world(WithScanner(arena));
    for (const Real rpm : {0.0, 20.0, 95.0, -40.0}) {
      CAPTURE(trial, rpm);
      rpm == 0.0 ? Motor(world).SetAngle(CRadians(random.Uniform(-10.0, 10.0)))
                 : Motor(world).SetRPM(rpm);
      world.Step();
      for (const auto& [angle, reading] : Sensor(world).GetShortReadingsMap()) {
        CHECK_THAT(reading,
                   WithinAbs(Expect(world, x, y, yaw, angle.GetValue(), 0.26, 0.0), kGrazing));
        near += reading >= 0.0 ? 1 : 0;
      }
      for (const auto& [angle, reading] : Sensor(world).GetLongReadingsMap()) {
        CHECK_THAT(reading,
                   WithinAbs(Expect(world, x, y, yaw, angle.GetValue(), 1.42, 0.12), kGrazing));
        far += reading >= 0.0 ? 1 : 0;
      }
    }
  }
  CHECK(near > 50);
  CHECK(far > 50);
}

TEST_CASE("distance scanner: an ordered angle is reached in the next tick", "[contract][sensors]") {
  const Real angle = GENERATE(0.3, -2.0, 3.5, 100.0);  // rad
  CAPTURE(angle);
  CRobotWorld world(WithScanner(FootBot()));
  Motor(world).SetAngle(CRadians(angle));
  world.Step();
  for (const auto& [beam, reading] : Sensor(world).GetReadingsMap()) {
    CHECK(beam.GetValue() > -M_PI - 1e-15);
    CHECK(beam.GetValue() <= M_PI);
  }
  At(Sensor(world).GetShortReadingsMap(), angle);
  At(Sensor(world).GetShortReadingsMap(), angle + M_PI);
  At(Sensor(world).GetLongReadingsMap(), angle + 0.5 * M_PI);
  At(Sensor(world).GetLongReadingsMap(), angle - 0.5 * M_PI);
  const CRadians rotation =
      world.Get<CFootBotEntity>("r").GetDistanceScannerEquippedEntity().GetRotation();
  CHECK(rotation >= CRadians::ZERO);
  CHECK(rotation < CRadians::TWO_PI);
  CHECK_THAT(Wrap(rotation.GetValue() - angle), WithinAbs(0.0, 1e-13));
}

TEST_CASE("distance scanner: while it turns each head has six readings per tick",
          "[contract][sensors]") {
  const Real rpm = GENERATE(1.0, 30.0, 250.0, -30.0, -250.0);
  CAPTURE(rpm);
  const Real step = rpm * M_PI / 30.0 * kTick;  // rad in a tick
  CRobotWorld world(WithScanner(FootBot()));
  Motor(world).SetAngle(CRadians(1.0));
  world.Step();
  Motor(world).SetRPM(rpm);
  for (int tick = 0; tick < 40; ++tick) {
    CAPTURE(tick);
    world.Step();
    REQUIRE(Sensor(world).GetShortReadingsMap().size() == 12);
    REQUIRE(Sensor(world).GetLongReadingsMap().size() == 12);
    for (int sample = 0; sample < 6; ++sample) {
      const Real angle = 1.0 + step * (tick + sample / 6.0);
      At(Sensor(world).GetShortReadingsMap(), angle);
      At(Sensor(world).GetShortReadingsMap(), angle + M_PI);
      At(Sensor(world).GetLongReadingsMap(), angle + 0.5 * M_PI);
      At(Sensor(world).GetLongReadingsMap(), angle + 1.5 * M_PI);
    }
  }
}

TEST_CASE("distance scanner: switched on again it continues at its angle", "[contract][sensors]") {
  CRobotWorld world(WithScanner(FootBot()));
  Motor(world).SetRPM(60.0);
  world.Step(3);
  Motor(world).Disable();
  world.Step(5);
  Motor(world).Enable();
  world.Step(2);
  // the angle after three ticks at 2 PI rad/s
  REQUIRE(Sensor(world).GetShortReadingsMap().size() == 2);
  At(Sensor(world).GetShortReadingsMap(), 2.0 * M_PI * 3 * kTick);
}

TEST_CASE("distance scanner: of two beams at the same angle the one with a distance counts",
          "[contract][sensors]") {
  // 300 rpm at 10 ticks per second are half a turn per tick: the short-range heads reach the angles
  // of the long-range heads at another time of the tick
  CRobotWorld world(
      WithScanner(FootBot() + BoxText("left", CVector3(3.0, 0.2, 0.5), CVector3(0.0, 0.6, 0.0))));
  Motor(world).SetRPM(300.0);
  world.Step(3);
  const Real distance = 100.0 * (0.5 - kRadius);
  CHECK(At(Sensor(world).GetShortReadingsMap(), 0.5 * M_PI) == -2.0);
  CHECK_THAT(At(Sensor(world).GetLongReadingsMap(), 0.5 * M_PI), WithinAbs(distance, 1e-9));
  CHECK_THAT(At(Sensor(world).GetReadingsMap(), 0.5 * M_PI), WithinAbs(distance, 1e-9));
}

TEST_CASE("distance scanner: low bodies and its own robot are not seen", "[contract][sensors]") {
  const Real top = GENERATE(0.12, 0.13);  // m
  CRobotWorld world(
      WithScanner(FootBot() + BoxText("b", CVector3(0.1, 3.0, top), CVector3(0.25, 0.0, 0.0))));
  Motor(world).Enable();
  world.Step();
  CHECK((At(Sensor(world).GetShortReadingsMap(), 0.0) > 0.0) == (top > kHeight));
}

TEST_CASE("distance scanner: a reset switches it off, and the run repeats", "[contract][sensors]") {
  CRobotWorld world(
      WithScanner(FootBot() + BoxText("b", CVector3(0.1, 3.0, 1.0), CVector3(0.3, 0.0, 0.0)),
                  "noise_range=\"-1:1\""));
  const auto run = [&world] {
    std::vector<std::pair<Real, Real>> all;
    Motor(world).SetRPM(40.0);
    for (int i = 0; i < 5; ++i) {
      world.Step();
      for (const auto& [angle, reading] : Sensor(world).GetReadingsMap()) {
        all.emplace_back(angle.GetValue(), reading);
      }
    }
    return all;
  };
  const auto first = run();
  world.GetSimulator().Reset();
  CHECK(Sensor(world).GetReadingsMap().empty());
  world.Step();
  CHECK(Sensor(world).GetReadingsMap().empty());
  world.GetSimulator().Reset();
  CHECK(run() == first);
}

TEST_CASE("distance scanner noise: is on valid distances only, with the requested distribution",
          "[contract][sensors][noise]") {
  constexpr int kTicks = 4000;
  const bool even = GENERATE(true, false);
  SRobotExperiment experiment =
      WithScanner(FootBot() + BoxText("b", CVector3(0.1, 3.0, 1.0), CVector3(0.3, 0.0, 0.0)),
                  even ? "noise_range=\"-0.5:1.5\"" : "");
  if (!even) {
    experiment.Sensors = WithNoise("footbot_distance_scanner implementation=\"rot_z_only\"",
                                   "on=\"distance\" model=\"gaussian\" std_dev=\"0.7\"");
  }
  CRobotWorld world(experiment);
  Motor(world).Enable();
  std::vector<Real> deviations;
  for (int i = 0; i < kTicks; ++i) {
    world.Step();
    deviations.push_back(At(Sensor(world).GetShortReadingsMap(), 0.0) - 100.0 * (0.25 - kRadius));
    REQUIRE(At(Sensor(world).GetShortReadingsMap(), M_PI) == -2.0);
  }
  CHECK(KolmogorovSmirnovExcess(deviations, [even](Real x) {
          return even ? UniformDistribution(x, -0.5, 1.5) : NormalDistribution(x, 0.7);
        }) <= 1.0);
}

TEST_CASE("distance scanner noise: distances never become the codes for missing distances",
          "[contract][sensors][noise]") {
  CRobotWorld world(
      WithScanner(FootBot() + BoxText("b", CVector3(0.1, 3.0, 1.0), CVector3(0.15, 0.0, 0.0)),
                  "noise_range=\"-10:0\""));
  Motor(world).Enable();
  for (int i = 0; i < 50; ++i) {
    world.Step();
    REQUIRE(At(Sensor(world).GetShortReadingsMap(), 0.0) >= 0.0);
  }
}

TEST_CASE("distance scanner noise: the motor's angle has the requested distribution",
          "[contract][sensors][noise]") {
  SRobotExperiment experiment = WithScanner(FootBot());
  experiment.Actuators = WithNoise("footbot_distance_scanner implementation=\"default\"",
                                   "on=\"angle\" model=\"gaussian\" std_dev=\"0.05\"");
  CRobotWorld world(experiment);
  const auto& scanner = world.Get<CFootBotEntity>("r").GetDistanceScannerEquippedEntity();
  std::vector<Real> deviations;
  for (int i = 0; i < 3000; ++i) {
    Motor(world).SetAngle(CRadians(2.0));
    world.Step();
    deviations.push_back(scanner.GetRotation().GetValue() - 2.0);
  }
  CHECK(KolmogorovSmirnovExcess(deviations, [](Real x) { return NormalDistribution(x, 0.05); }) <=
        1.0);
}

TEST_CASE("distance scanner: rays are recorded only on request", "[contract][sensors]") {
  const bool show = GENERATE(false, true);
  CRobotWorld world(
      WithScanner(FootBot() + BoxText("b", CVector3(0.1, 3.0, 1.0), CVector3(0.3, 0.0, 0.0)),
                  std::string("show_rays=\"") + (show ? "true" : "false") + "\""));
  Motor(world).Enable();
  world.Step();
  CHECK(world.GetRobot("r").GetCheckedRays().size() == (show ? 4 : 0));
  CHECK(world.GetRobot("r").GetIntersectionPoints().size() == (show ? 1 : 0));
}

TEST_CASE("distance scanner: invalid values are refused with the reason",
          "[contract][sensors][errors]") {
  const std::string ePuck = Robot("e-puck", "ep0", PoseText(CVector3()));
  CHECK_THAT(LoadError(WithScanner(ePuck)), Contains("\"ep0\"") && Contains("distance_scanner"));
  CHECK_THAT(LoadError(WithScanner(FootBot(), "noise_range=\"1:-1\"")),
             Contains("noise_range") && Contains("1:-1"));
  CRobotWorld world(WithScanner(FootBot()));
  const Real bad =
      GENERATE(std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity());
  CHECK_THROWS_WITH(Motor(world).SetAngle(CRadians(bad)),
                    Contains("robot \"r\"") && Contains("angle (rad) must be finite"));
  CHECK_THROWS_WITH(Motor(world).SetRPM(bad),
                    Contains("robot \"r\"") && Contains("speed (rpm) must be finite"));
  auto& scanner = world.Get<CFootBotEntity>("r").GetDistanceScannerEquippedEntity();
  CHECK_THROWS_WITH(scanner.SetRotation(CRadians(bad)), Contains("must be finite"));
  CHECK_THROWS_WITH(scanner.SetRotationSpeed(bad), Contains("must be finite"));
}

}  // namespace distance_scanner_test
