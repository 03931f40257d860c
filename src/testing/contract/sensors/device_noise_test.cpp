// The <noise> children of devices that also have noise attributes: proximity sensors and wheels.

#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/testing/contract/sensors/scene.h>
#include <argos3/testing/support/robot_sizes.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace device_noise_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

constexpr int kDraws = 4000;

// a distribution that <noise> offers
struct SNoise {
  std::string Xml;  // attributes
  std::function<Real(Real)> Distribution;  // of the deviation
};

std::vector<SNoise> Noises() {
  return {
      {"model=\"uniform\" level=\"0.03\"",
       [](Real x) { return UniformDistribution(x, -0.03, 0.03); }},
      {"model=\"gaussian\" std_dev=\"0.01\" bias=\"0.02\"",
       [](Real x) { return NormalDistribution(x - 0.02, 0.01); }},
      {"model=\"rayleigh\" sigma=\"0.01\"", [](Real x) { return RayleighDistribution(x, 0.01); }}};
}

// one reading of a proximity sensor
Real ReadProximity(CRobotWorld& world, const std::string& tag, size_t ray) {
  CCI_Controller& controller = world.GetRobot("r").GetController();
  if (tag == "proximity") {
    return controller.GetSensor<CCI_ProximitySensor>(tag)->GetReadings()[ray];
  }
  if (tag == "epuck_proximity") {
    return controller.GetSensor<CCI_EPuckProximitySensor>(tag)->GetReadings()[ray].Value;
  }
  if (tag == "eyebot_proximity") {
    return controller.GetSensor<CCI_EyeBotProximitySensor>(tag)->GetReadings()[ray].Value;
  }
  return controller.GetSensor<CCI_FootBotProximitySensor>(tag)->GetReadings()[ray].Value;
}

SRobotExperiment Wheels(const std::string& actuator, const std::string& sensor) {
  SRobotExperiment experiment;
  experiment.Actuators = actuator;
  experiment.Sensors = sensor;
  experiment.Arena = Robot("foot-bot", "r", PoseText(CVector3()));
  return experiment;
}

const std::string kWheels = "differential_steering implementation=\"default\"";

}  // namespace

TEST_CASE("proximity noise: <noise> children have the requested distribution",
          "[contract][sensors][noise]") {
  struct SRobot {
    const char* Tag;
    const char* Sensor;
    Real Gap;  // m, from the sensors to a pillar: the reading is far from 0 and 1
  };
  // generic readings are above 0.9 within range: the eye-bot's range is longer
  const SRobot robot = GENERATE(
      SRobot{"foot-bot", "footbot_proximity", 0.02}, SRobot{"e-puck", "epuck_proximity", 0.02},
      SRobot{"eye-bot", "eyebot_proximity", 0.02}, SRobot{"eye-bot", "proximity", 0.5});
  const size_t which = GENERATE(0U, 1U, 2U);
  const SNoise noise = Noises()[which];
  CAPTURE(robot.Sensor, noise.Xml);
  SRobotExperiment experiment;
  // four walls around the robot, so that every ray hits one
  const Real inner = 1.0;
  experiment.Arena = Robot(robot.Tag, "r", PoseText(CVector3())) +
                     PillarText("p", inner, 0.0,
                                inner - robot.Gap -
                                    (robot.Tag[0] == 'f'   ? kFootBotRadius
                                     : robot.Tag[1] == '-' ? kEPuckRadius
                                                           : 0.255),
                                1.0);
  SRobotExperiment exact = experiment;
  exact.Sensors = std::string("<") + robot.Sensor + " implementation=\"default\"/>";
  experiment.Sensors = WithNoise(std::string(robot.Sensor) + " implementation=\"default\"",
                                 "on=\"reading\" " + noise.Xml);
  CRobotWorld exactWorld(exact);
  exactWorld.Step();
  const Real truth = ReadProximity(exactWorld, robot.Sensor, 0);
  REQUIRE((truth > 0.1 && truth < 0.9));
  CRobotWorld world(experiment);
  std::vector<Real> deviations;
  for (int i = 0; i < kDraws; ++i) {
    world.Step();
    deviations.push_back(ReadProximity(world, robot.Sensor, 0) - truth);
  }
  CHECK(KolmogorovSmirnovExcess(deviations, noise.Distribution) <= 1.0);
}

TEST_CASE("proximity noise: the noise of the attribute and that of the children add up",
          "[contract][sensors][noise]") {
  // the sum of two independent draws of U[-0.1, 0.1] has a triangular distribution
  SRobotExperiment experiment;
  experiment.Sensors = WithNoise("footbot_proximity implementation=\"default\" noise_level=\"0.1\"",
                                 "model=\"uniform\" level=\"0.1\"");
  experiment.Arena = Robot("foot-bot", "r", PoseText(CVector3())) +
                     PillarText("p", 1.0, 0.0, 1.0 - 0.02 - kFootBotRadius, 1.0);
  SRobotExperiment exact = experiment;
  exact.Sensors = "<footbot_proximity implementation=\"default\"/>";
  CRobotWorld exactWorld(exact);
  exactWorld.Step();
  const Real truth = ReadProximity(exactWorld, "footbot_proximity", 0);
  CRobotWorld world(experiment);
  std::vector<Real> deviations;
  for (int i = 0; i < kDraws; ++i) {
    world.Step();
    deviations.push_back(ReadProximity(world, "footbot_proximity", 0) - truth);
  }
  CHECK(KolmogorovSmirnovExcess(deviations, [](Real x) {
          const Real t = std::min(1.0, std::max(-1.0, x / 0.2));
          return t < 0.0 ? 0.5 * (1.0 + t) * (1.0 + t) : 1.0 - 0.5 * (1.0 - t) * (1.0 - t);
        }) <= 1.0);
}

TEST_CASE("differential steering noise: <noise> on a wheel is drawn at each order",
          "[contract][robots][noise]") {
  const bool isLeft = GENERATE(true, false);
  const size_t which = GENERATE(0U, 1U, 2U);
  const SNoise noise = Noises()[which];
  CAPTURE(isLeft, noise.Xml);
  CRobotWorld world(Wheels(
      WithNoise(kWheels, std::string("on=\"") + (isLeft ? "left" : "right") + "\" " + noise.Xml),
      ""));
  auto& actuator =
      world.GetActuator<CCI_DifferentialSteeringActuator>("r", "differential_steering");
  const auto& wheels = world.Get<CComposableEntity>("r").GetComponent<CWheeledEntity>("wheels");
  std::vector<Real> deviations;
  for (int i = 0; i < kDraws; ++i) {
    actuator.SetLinearVelocity(10.0, 10.0);
    world.GetRobot("r").Act();
    deviations.push_back(wheels.GetWheelVelocity(isLeft ? 0 : 1) - 0.1);
    REQUIRE(wheels.GetWheelVelocity(isLeft ? 1 : 0) == 0.1);
  }
  CHECK(KolmogorovSmirnovExcess(deviations, noise.Distribution) <= 1.0);
  actuator.SetLinearVelocity(0.0, 0.0);
  world.GetRobot("r").Act();
  CHECK(wheels.GetWheelVelocity(0) == 0.0);
  CHECK(wheels.GetWheelVelocity(1) == 0.0);
}

TEST_CASE(
    "differential steering sensor noise: <noise> has the requested distribution on each quantity",
    "[contract][robots][noise]") {
  const size_t quantity = GENERATE(0U, 1U, 2U, 3U);
  const size_t which = GENERATE(0U, 1U, 2U);
  const SNoise noise = Noises()[which];
  const char* const names[] = {"velocity_left", "velocity_right", "distance_left",
                               "distance_right"};
  CAPTURE(names[quantity], noise.Xml);
  CRobotWorld world(
      Wheels("<" + kWheels + "/>",
             WithNoise(kWheels, std::string("on=\"") + names[quantity] + "\" " + noise.Xml)));
  world.GetActuator<CCI_DifferentialSteeringActuator>("r", "differential_steering")
      .SetLinearVelocity(5.0, 7.0);
  const auto& sensor =
      world.GetSensor<CCI_DifferentialSteeringSensor>("r", "differential_steering");
  std::vector<Real> deviations[4];
  for (int i = 0; i < kDraws; ++i) {
    world.Step();
    const auto& reading = sensor.GetReading();
    deviations[0].push_back(reading.VelocityLeftWheel - 5.0);
    deviations[1].push_back(reading.VelocityRightWheel - 7.0);
    deviations[2].push_back(reading.CoveredDistanceLeftWheel - 0.5);
    deviations[3].push_back(reading.CoveredDistanceRightWheel - 0.7);
  }
  CHECK(KolmogorovSmirnovExcess(deviations[quantity], noise.Distribution) <= 1.0);
  for (size_t other = 0; other < 4; ++other) {
    if (other != quantity) {
      // tolerance of roundings of 7 cm
      CHECK(*std::max_element(deviations[other].begin(), deviations[other].end()) < 1e-14);
      CHECK(*std::min_element(deviations[other].begin(), deviations[other].end()) > -1e-14);
    }
  }
}

TEST_CASE("differential steering noise: actuator and sensor draw from independent streams",
          "[contract][robots][noise]") {
  CRobotWorld world(
      Wheels(WithNoise(kWheels, "on=\"left\" model=\"gaussian\" std_dev=\"0.01\""),
             WithNoise(kWheels, "on=\"velocity_left\" model=\"gaussian\" std_dev=\"1\"")));
  auto& actuator =
      world.GetActuator<CCI_DifferentialSteeringActuator>("r", "differential_steering");
  const auto& wheels = world.Get<CComposableEntity>("r").GetComponent<CWheeledEntity>("wheels");
  const auto& sensor =
      world.GetSensor<CCI_DifferentialSteeringSensor>("r", "differential_steering");
  Real product = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    actuator.SetLinearVelocity(10.0, 10.0);
    world.Step();
    // both in units of their standard deviations
    const Real ordered = (wheels.GetWheelVelocity(0) - 0.1) / 0.01;
    const Real read = sensor.GetReading().VelocityLeftWheel - 100.0 * wheels.GetWheelVelocity(0);
    product += ordered * read;
  }
  // The mean of the products of independent normal numbers: five standard deviations
  // are exceeded once in a million.
  CHECK(std::abs(product / kDraws) < 5.0 / std::sqrt(kDraws));
}

TEST_CASE("device noise: invalid noise is refused with the accepted names",
          "[contract][sensors][errors]") {
  CHECK_THAT(
      LoadError(Wheels(WithNoise(kWheels, "on=\"lefft\" model=\"uniform\" level=\"1\""), "")),
      Contains("\"lefft\"") && Contains("left") && Contains("test.argos:"));
  CHECK_THAT(LoadError(Wheels("", WithNoise(kWheels, "model=\"even\" level=\"1\""))),
             Contains("\"even\"") && Contains("uniform"));
  CHECK_THAT(LoadError(Wheels("", WithNoise(kWheels, "model=\"gaussian\" level=\"1\""))),
             Contains("std_dev"));
}

}  // namespace device_noise_test
