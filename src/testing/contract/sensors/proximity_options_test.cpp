// Noise, recorded rays and errors of the proximity sensors.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>
#include <argos3/plugins/robots/generic/simulator/proximity_default_sensor.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace proximity_options_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr int kDraws = 20000;

// readings, tick by tick, of ray 2 of an e-puck at a disc 12 mm away
std::vector<Real> DrawReadings(CRobotWorld& world, const std::string& robot, int num) {
  const auto& sensor = world.GetSensor<CCI_EPuckProximitySensor>(robot, "epuck_proximity");
  std::vector<Real> readings;
  for (int i = 0; i < num; ++i) {
    world.Step();
    readings.push_back(sensor.GetReadings()[2].Value);
  }
  return readings;
}

SRobotExperiment WithSensor(const std::string& tag, const std::string& sensor) {
  SRobotExperiment experiment;
  experiment.Sensors = "<" + sensor + " implementation=\"default\"/>";
  experiment.Arena = Robot(tag, "r", "position=\"0,0,0\"");
  return experiment;
}

// The box begins at y = 0.06, in the range of sensor 2.
SRobotExperiment EPuckBesideBox(const std::string& implementation = "default") {
  SRobotExperiment experiment;
  experiment.Sensors = "<proximity implementation=\"" + implementation + "\"/>";
  experiment.Arena =
      Robot("e-puck", "r", "position=\"0,0,0\"") +
      "<box id=\"b\" size=\"0.1,0.1,0.1\" movable=\"false\"><body position=\"0,0.11,0\"/></box>";
  return experiment;
}

SRobotExperiment NoisyEPucks(const std::string& noise) {
  SRobotExperiment experiment;
  experiment.Sensors =
      "<epuck_proximity implementation=\"default\" noise_level=\"" + noise + "\"/>";
  experiment.Arena = Robot("e-puck", "a", "position=\"0,0,0\"") +
                     Robot("e-puck", "b", "position=\"1,0,0\"") +
                     "<cylinder id=\"ca\" radius=\"0.1\" height=\"0.5\" movable=\"false\"><body "
                     "position=\"0,0.147,0\"/></cylinder>"
                     "<cylinder id=\"cb\" radius=\"0.1\" height=\"0.5\" movable=\"false\"><body "
                     "position=\"1,0.147,0\"/></cylinder>";
  return experiment;
}

}  // namespace

TEST_CASE("proximity noise: is uniform in [-n,n] around the true reading", "[contract][sensors]") {
  const Real n = 0.2;
  CRobotWorld world(NoisyEPucks("0.2"));
  const std::vector<Real> readings = DrawReadings(world, "a", kDraws);
  const Real truth = 298.701 * 0.012 * 0.012 - 36.8961 * 0.012 + 1.08212;
  REQUIRE((truth > n && truth < 1.0 - n));
  Real sum = 0.0;
  Real squares = 0.0;
  for (const Real reading : readings) {
    REQUIRE(std::abs(reading - truth) <= n + 1e-12);
    sum += reading - truth;
    squares += (reading - truth) * (reading - truth);
  }
  // The variance of U[-n,n] is n^2/3, and the standard deviation of the square is sqrt(4/45) n^2.
  // Five standard deviations of each estimate: one failure in a million.
  const Real deviation = n / std::sqrt(3.0);
  CHECK_THAT(sum / kDraws, WithinAbs(0.0, 5.0 * deviation / std::sqrt(kDraws)));
  CHECK_THAT(squares / kDraws,
             WithinAbs(n * n / 3.0, 5.0 * std::sqrt(4.0 / 45.0) * n * n / std::sqrt(kDraws)));
}

TEST_CASE("proximity noise: readings stay in [0,1]", "[contract][sensors]") {
  CRobotWorld world(NoisyEPucks("3"));
  const std::vector<Real> readings = DrawReadings(world, "a", 200);
  CHECK(*std::min_element(readings.begin(), readings.end()) == 0.0);
  CHECK(*std::max_element(readings.begin(), readings.end()) == 1.0);
}

TEST_CASE("proximity noise: differs between robots and repeats after a reset",
          "[contract][sensors]") {
  CRobotWorld world(NoisyEPucks("0.1"));
  const std::vector<Real> a = DrawReadings(world, "a", 10);
  world.GetSimulator().Reset();
  const std::vector<Real> b = DrawReadings(world, "b", 10);
  CHECK(a != b);
  world.GetSimulator().Reset();
  CHECK(DrawReadings(world, "a", 10) == a);
  world.GetSimulator().Reset(2);
  CHECK(DrawReadings(world, "a", 10) != a);
}

TEST_CASE("proximity: rays are recorded only on request", "[contract][sensors]") {
  const bool show = GENERATE(false, true);
  SRobotExperiment experiment;
  experiment.Sensors = std::string("<footbot_proximity implementation=\"default\" show_rays=\"") +
                       (show ? "true" : "false") + "\"/>";
  // the disc is ahead of ray 0 alone, 5 cm away
  const CRadians angle = ToRadians(CDegrees(7.5));
  const Real distance = kFootBotRadius + 0.05 + 0.01;
  experiment.Arena =
      Robot("foot-bot", "r", "position=\"0,0,0\"") +
      "<cylinder id=\"c\" radius=\"0.01\" height=\"0.5\" movable=\"false\"><body position=\"" +
      ToText(CVector3(distance * Cos(angle), distance * Sin(angle), 0.0)) + "\"/></cylinder>";
  CRobotWorld world(experiment);
  world.Step(2);
  CControllableEntity& robot = world.GetRobot("r");
  REQUIRE(robot.GetCheckedRays().size() == (show ? 24 : 0));
  REQUIRE(robot.GetIntersectionPoints().size() == (show ? 1 : 0));
  if (!show) {
    return;
  }
  for (size_t i = 0; i < 24; ++i) {
    CHECK(robot.GetCheckedRays()[i].first == (i == 0));
    CHECK_THAT(robot.GetCheckedRays()[i].second.GetLength(), WithinAbs(0.1, 1e-15));
  }
  const CVector3 expected((distance - 0.01) * Cos(angle), (distance - 0.01) * Sin(angle), 0.06);
  CHECK_THAT(Distance(robot.GetIntersectionPoints()[0], expected), WithinAbs(0.0, 1e-14));
}

TEST_CASE("proximity: readings contain the directions of the sensors", "[contract][sensors]") {
  CRobotWorld footBots(WithSensor("foot-bot", "footbot_proximity"));
  const auto& footBot =
      footBots.GetSensor<CCI_FootBotProximitySensor>("r", "footbot_proximity").GetReadings();
  REQUIRE(footBot.size() == 24);
  for (int i = 0; i < 24; ++i) {
    const Real degrees = 7.5 + 15.0 * i;
    CHECK_THAT(ToDegrees(footBot[i].Angle).GetValue(),
               WithinAbs(degrees > 180.0 ? degrees - 360.0 : degrees, 1e-12));
  }
  CRobotWorld ePucks(WithSensor("e-puck", "epuck_proximity"));
  const auto& ePuck =
      ePucks.GetSensor<CCI_EPuckProximitySensor>("r", "epuck_proximity").GetReadings();
  REQUIRE(ePuck.size() == 8);
  const int expected[8] = {17, 50, 90, 150, -150, -90, -50, -17};
  for (int i = 0; i < 8; ++i) {
    // the angles are published in whole degrees and as fractions of PI, which agree to 0.1 degrees
    CHECK_THAT(ToDegrees(ePuck[i].Angle).GetValue(), WithinAbs(expected[i], 0.1));
  }
}

TEST_CASE("proximity: a disabled sensor keeps its readings", "[contract][sensors]") {
  CRobotWorld world(EPuckBesideBox());
  auto& sensor = world.GetSensor<CCI_ProximitySensor>("r", "proximity");
  world.Step();
  const std::vector<Real> seen = sensor.GetReadings();
  CHECK(seen[2] > 0.0);
  sensor.Disable();
  world.GetSpace().GetEntity("r");
  world.Get<CEPuckEntity>("r").GetEmbodiedEntity().MoveTo(CVector3(1.0, 1.0, 0.0), CQuaternion());
  world.Step();
  CHECK(sensor.GetReadings() == seen);
  sensor.Enable();
  world.Step();
  CHECK(sensor.GetReadings() == std::vector<Real>(8, 0.0));
}

namespace {

// the documented way to change the response
class CLinearProximitySensor : public CProximityDefaultSensor {
 public:
  Real CalculateReading(Real distance) override { return 1.0 - 10.0 * distance; }
};

}  // namespace

REGISTER_SENSOR(CLinearProximitySensor, "proximity", "linear_for_tests", "", "", "", "", "")

TEST_CASE("proximity: derived sensors can change the response", "[contract][sensors]") {
  CRobotWorld world(EPuckBesideBox("linear_for_tests"));
  world.Step();
  // the box begins at y = 0.06, the ray at 0.035
  CHECK_THAT(world.GetSensor<CCI_ProximitySensor>("r", "proximity").GetReadings()[2],
             WithinAbs(0.75, 1e-13));
}

TEST_CASE("proximity: sensors added or changed by a program are read", "[contract][sensors]") {
  CRobotWorld world(EPuckBesideBox());
  auto& robot = world.Get<CEPuckEntity>("r");
  CProximitySensorEquippedEntity& component = robot.GetProximitySensorEquippedEntity();
  component.GetSensor(0).Offset = CVector3(0.0, 0.05, 0.06);
  component.GetSensor(0).Direction = CVector3(0.0, 0.02, 0.0);
  component.AddSensor(CVector3(0.0, 0.04, 0.06), CVector3(0.0, 5.0, 0.0), 0.5,
                      robot.GetEmbodiedEntity().GetOriginAnchor());
  world.Step();
  const auto& readings = world.GetSensor<CCI_ProximitySensor>("r", "proximity").GetReadings();
  REQUIRE(readings.size() == 9);
  CHECK_THAT(readings[0], WithinAbs(std::exp(-0.01), 1e-13));
  CHECK_THAT(readings[8], WithinAbs(std::exp(-0.02), 1e-13));
}

TEST_CASE("proximity: invalid experiments are refused with the reason",
          "[contract][sensors][errors]") {
  SRobotExperiment experiment;
  experiment.Arena = Robot("foot-bot", "fb0", "position=\"0,0,0\"");
  SECTION("negative noise") {
    experiment.Sensors = "<footbot_proximity implementation=\"default\" noise_level=\"-0.1\"/>";
    CHECK_THAT(LoadError(experiment),
               Contains("noise_level") && Contains(">= 0") && Contains("-0.1") && Contains("fb0"));
  }
  SECTION("noise that is not a number") {
    experiment.Sensors = "<proximity implementation=\"default\" noise_level=\"much\"/>";
    CHECK_THAT(LoadError(experiment), Contains("noise_level") && Contains("much"));
  }
  SECTION("the sensor of another robot") {
    experiment.Sensors = "<epuck_proximity implementation=\"default\"/>";
    CHECK_THAT(LoadError(experiment), Contains("epuck_proximity") &&
                                          Contains("needs a robot with 8") &&
                                          Contains("\"fb0\" has 24"));
  }
}

}  // namespace proximity_options_test
