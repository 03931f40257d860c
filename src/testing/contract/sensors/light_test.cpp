// Compares light sensors with geometry computed by hand, in worlds without motion.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_light_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_light_sensor.h>
#include <argos3/plugins/robots/generic/simulator/light_default_sensor.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/testing/contract/sensors/scene.h>
#include <argos3/testing/contract/sensors/sensor_ring.h>
#include <argos3/testing/support/robot_sizes.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace argos::light_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

// tolerance of about ten roundings of numbers of the order of 1
constexpr Real kRounding = 1e-13;

constexpr Real kHeight = 0.06;  // m, of the light sensors of wheeled robots

SSensorRing EPuckRing() {
  SSensorRing ring{"e-puck", kEPuckRadius, kHeight, {}};
  for (int i = 0; i < 8; ++i) {
    ring.Angles.push_back((22.5 + 45.0 * i) * M_PI / 180.0);
  }
  return ring;
}

CVector3 SensorAt(const SSensorRing& ring, size_t i, const CVector3& robot, Real yaw) {
  const Real angle = ring.Angles[i] + yaw;
  return robot +
         CVector3(ring.Radius * std::cos(angle), ring.Radius * std::sin(angle), ring.Height);
}

bool IsInFront(const SSensorRing& ring, size_t i, const CVector3& robot, Real yaw,
               const CVector3& light) {
  const Real angle = ring.Angles[i] + yaw;
  const CVector3 towards = light - SensorAt(ring, i, robot, yaw);
  return towards.GetX() * std::cos(angle) + towards.GetY() * std::sin(angle) >= 0.0;
}

SRobotExperiment WithSensor(const std::string& device, const std::string& arena) {
  SRobotExperiment experiment;
  experiment.Sensors = "<" + device + "/>";
  experiment.Arena = arena;
  return experiment;
}

SRobotExperiment WithGenericSensor(const std::string& arena) {
  return WithSensor("light implementation=\"default\"", arena);
}

SRobotExperiment WithFootBotSensor(const std::string& arena) {
  return WithSensor("footbot_light implementation=\"rot_z_only\"", arena);
}

const std::vector<Real>& Readings(CRobotWorld& world, const std::string& robot = "r") {
  return world.GetSensor<CCI_LightSensor>(robot, "light").GetReadings();
}

const CCI_FootBotLightSensor::TReadings& FootBotReadings(CRobotWorld& world,
                                                         const std::string& robot = "r") {
  return world.GetSensor<CCI_FootBotLightSensor>(robot, "footbot_light").GetReadings();
}

}  // namespace

TEST_CASE("light: sensors in front read the squared ratio of intensity and distance",
          "[contract][sensors]") {
  const SSensorRing ring = GENERATE(FootBotRing(), EPuckRing(), EyeBotRing());
  CRandomStream random(1, "test", ring.Tag, "light");
  int lit = 0;
  int dark = 0;
  for (int trial = 0; trial < 25; ++trial) {
    const CVector3 robot(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0), 0.0);
    const Real yaw = random.Uniform(-M_PI, M_PI);
    const CVector3 light = robot + CVector3(random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0),
                                            random.Uniform(0.0, 1.0));
    const Real intensity = random.Uniform(0.05, 0.3);
    CAPTURE(ring.Tag, trial, robot, yaw, light, intensity);
    CRobotWorld world(WithGenericSensor(Robot(ring.Tag, "r", PoseText(robot, yaw * 180.0 / M_PI)) +
                                        LampText("l", light, intensity)));
    world.Step();
    const std::vector<Real>& readings = Readings(world);
    REQUIRE(readings.size() == ring.Angles.size());
    for (size_t i = 0; i < readings.size(); ++i) {
      CAPTURE(i);
      const bool seen = IsInFront(ring, i, robot, yaw, light);
      const Real ratio = intensity / Distance(light, SensorAt(ring, i, robot, yaw));
      CHECK_THAT(readings[i], WithinAbs(seen ? std::min(1.0, ratio * ratio) : 0.0, kRounding));
      seen ? ++lit : ++dark;
    }
  }
  CHECK(lit > 50);
  CHECK(dark > 50);
}

TEST_CASE("light: a light on the tangent of a sensor is seen on both sides of the robot",
          "[contract][sensors]") {
  const Real yaw = GENERATE(0.0, 13.0, 90.0, 137.0, -60.0);  // degrees
  CAPTURE(yaw);
  const Real turn = yaw * M_PI / 180.0;
  const auto toWorld = [turn](Real x, Real y) {
    return CVector3(0.7 + x * std::cos(turn) - y * std::sin(turn),
                    -0.3 + x * std::sin(turn) + y * std::cos(turn), kHeight);
  };
  CRobotWorld world(WithGenericSensor(
      Robot("e-puck", "r", PoseText(CVector3(0.7, -0.3, 0.0), yaw)) +
      // along the tangents of the sensors at 90 and -90 degrees that are added below
      LampText("left", toWorld(1.0, 0.035), 0.2) + LampText("right", toWorld(1.0, -0.035), 0.3)));
  auto& robot = world.Get<CEPuckEntity>("r");
  SAnchor& origin = robot.GetEmbodiedEntity().GetOriginAnchor();
  CLightSensorEquippedEntity& sensors = robot.GetLightSensorEquippedEntity();
  sensors.AddSensor(CVector3(0.0, 0.035, kHeight), CVector3(0.0, 1.0, 0.0), 0.1, origin);
  sensors.AddSensor(CVector3(0.0, -0.035, kHeight), CVector3(0.0, -1.0, 0.0), 0.1, origin);
  world.Step();
  const std::vector<Real>& readings = Readings(world);
  REQUIRE(readings.size() == 10);
  // each sensor sees the light on its own tangent, at 1 m, and not the one on the other side
  CHECK_THAT(readings[8], WithinAbs(0.04, kRounding));
  CHECK_THAT(readings[9], WithinAbs(0.09, kRounding));
}

TEST_CASE("light: lights add up, lights without intensity are ignored, and the maximum is 1",
          "[contract][sensors]") {
  const SSensorRing ring = FootBotRing();
  const CVector3 a(1.5, 0.3, 0.2);
  const CVector3 b(0.4, 2.0, 0.1);
  CRobotWorld world(
      WithGenericSensor(Robot("foot-bot", "r", PoseText(CVector3())) + LampText("a", a, 0.2) +
                        LampText("off", CVector3(0.2, 0.0, 0.0), 0.0) + LampText("b", b, 0.3) +
                        LampText("negative", CVector3(0.0, 0.2, 0.0), -1.0)));
  world.Step();
  const auto contribution = [&](size_t i, const CVector3& light, Real intensity) {
    const Real ratio = intensity / Distance(light, SensorAt(ring, i, CVector3(), 0.0));
    return IsInFront(ring, i, CVector3(), 0.0, light) ? ratio * ratio : 0.0;
  };
  for (size_t i = 0; i < 24; ++i) {
    CAPTURE(i);
    CHECK_THAT(Readings(world)[i],
               WithinAbs(contribution(i, a, 0.2) + contribution(i, b, 0.3), kRounding));
  }
  world.Get<CLightEntity>("a").SetIntensity(100.0);
  world.Step();
  CHECK(Readings(world)[0] == 1.0);
}

TEST_CASE("light: a sensor at the position of a light reads 1", "[contract][sensors]") {
  const SSensorRing ring = EPuckRing();
  CRobotWorld world(WithGenericSensor(Robot("e-puck", "r", PoseText(CVector3())) +
                                      LampText("l", SensorAt(ring, 2, CVector3(), 0.0), 1e-3)));
  world.Step();
  CHECK(Readings(world)[2] == 1.0);
}

TEST_CASE("light: a body occludes the light from the sensors behind it only",
          "[contract][sensors]") {
  const SSensorRing ring = GENERATE(FootBotRing(), EPuckRing());
  const Real radius = GENERATE(0.01, 0.03, 0.05);  // m, radius of the pole
  CAPTURE(ring.Tag, radius);
  const CVector3 light(1.5, 0.0, kHeight);
  const CVector3 pole(0.5, 0.01, 0.0);
  CRobotWorld world(WithGenericSensor(Robot(ring.Tag, "r", PoseText(CVector3())) +
                                      LampText("l", light, 0.3) +
                                      PillarText("pole", pole.GetX(), pole.GetY(), radius, 0.5)));
  world.Step();
  int hidden = 0;
  int seen = 0;
  for (size_t i = 0; i < ring.Angles.size(); ++i) {
    CAPTURE(i);
    // at equal heights: distance of the pole's axis from the line between sensor and light
    const CVector3 sensor = SensorAt(ring, i, CVector3(), 0.0);
    const CVector3 along = light - sensor;
    const CVector3 aside = pole - sensor;
    const Real apart =
        std::abs(along.GetX() * aside.GetY() - along.GetY() * aside.GetX()) / along.Length();
    if (!IsInFront(ring, i, CVector3(), 0.0, light)) {
      CHECK(Readings(world)[i] == 0.0);
    } else if (apart < radius) {
      CHECK(Readings(world)[i] == 0.0);
      ++hidden;
    } else {
      CHECK_THAT(Readings(world)[i], WithinAbs(0.09 / along.SquareLength(), kRounding));
      ++seen;
    }
  }
  CHECK(hidden > 0);
  CHECK((seen > 0 || radius == 0.05));
}

TEST_CASE("light: bodies below, beside, behind and beyond do not occlude", "[contract][sensors]") {
  const CVector3 light(1.0, 0.0, 0.46);
  // at x = 0.5 the lines from the sensors to the light are above 0.2
  const std::string harmless =
      BoxText("low", CVector3(0.2, 1.0, 0.19), CVector3(0.5, 0.0, 0.0)) +
      BoxText("beside", CVector3(2.0, 0.2, 1.0), CVector3(0.5, 0.4, 0.0)) +
      BoxText("behind", CVector3(0.2, 2.0, 1.0), CVector3(-0.4, 0.0, 0.0)) +
      BoxText("beyond", CVector3(0.2, 2.0, 1.0), CVector3(1.4, 0.0, 0.0));
  const std::string robot = Robot("foot-bot", "r", PoseText(CVector3()));
  CRobotWorld open(WithGenericSensor(robot + LampText("l", light, 0.5)));
  CRobotWorld furnished(WithGenericSensor(robot + harmless + LampText("l", light, 0.5)));
  open.Step();
  furnished.Step();
  CHECK(Readings(open)[0] > 0.0);
  CHECK(Readings(open) == Readings(furnished));
}

TEST_CASE("light: robots occlude lights for other robots", "[contract][sensors]") {
  // the foot-bot occludes the light for the e-puck; no robot does for the foot-bot
  CRobotWorld world(WithGenericSensor(Robot("foot-bot", "fb", PoseText(CVector3(0.5, 0.0, 0.0))) +
                                      Robot("e-puck", "ep", PoseText(CVector3(0.2, 0.0, 0.0))) +
                                      LampText("l", CVector3(2.0, 0.0, kHeight), 0.5)));
  world.Step();
  CHECK(Readings(world, "ep") == std::vector<Real>(8, 0.0));
  CHECK(Readings(world, "fb")[0] > 0.0);
}

TEST_CASE("light: a light inside a body is not seen", "[contract][sensors]") {
  CRobotWorld world(WithGenericSensor(Robot("e-puck", "r", PoseText(CVector3())) +
                                      PillarText("c", 0.5, 0.0, 0.1, 0.5) +
                                      LampText("l", CVector3(0.5, 0.0, 0.1), 0.5)));
  world.Step();
  CHECK(Readings(world) == std::vector<Real>(8, 0.0));
}

TEST_CASE("light: lights that are added, moved or removed are taken into account",
          "[contract][sensors]") {
  SRobotExperiment experiment = WithGenericSensor(Robot("e-puck", "r", PoseText(CVector3())));
  CRobotWorld world(experiment);
  world.Step();
  CHECK(Readings(world) == std::vector<Real>(8, 0.0));
  // 1 m ahead of sensor 0
  const Real angle = 22.5 * M_PI / 180.0;
  const auto ahead = [angle](Real distance) {
    return CVector3((0.035 + distance) * std::cos(angle), (0.035 + distance) * std::sin(angle),
                    kHeight);
  };
  auto& light = world.Add(std::make_unique<CLightEntity>("l", ahead(1.0), CColor::YELLOW, 0.5));
  world.Step();
  CHECK_THAT(Readings(world)[0], WithinAbs(0.25, kRounding));
  light.SetPosition(ahead(2.0));
  world.Step();
  CHECK_THAT(Readings(world)[0], WithinAbs(0.0625, kRounding));
  world.GetSimulator().GetLoopFunctions().RemoveEntity("l");
  world.Step();
  CHECK(Readings(world)[0] == 0.0);
}

TEST_CASE("light: worlds have separate lights", "[contract][sensors]") {
  const std::string robot = Robot("e-puck", "r", PoseText(CVector3()));
  CRobotWorld lit(WithGenericSensor(robot + LampText("l", CVector3(1.0, 0.0, kHeight), 0.5)));
  CRobotWorld dark(WithGenericSensor(robot));
  lit.Step();
  dark.Step();
  CHECK(Readings(lit)[0] > 0.0);
  CHECK(Readings(dark) == std::vector<Real>(8, 0.0));
}

TEST_CASE("light: the sensors of a tilted robot tilt with it", "[contract][sensors]") {
  // Nose up, 2 m above the ground: the x axis points up, and the height of a sensor is along -x.
  CRobotWorld world(WithGenericSensor(
      "<e-puck id=\"r\"><body position=\"0,0,2\" orientation=\"0,-90,0\"/><controller "
      "config=\"c\"/></e-puck>" +
      LampText("l", CVector3(0.0, 0.0, 3.5), 0.5)));
  world.Step();
  const SSensorRing ring = EPuckRing();
  for (size_t i = 0; i < 8; ++i) {
    CAPTURE(i);
    const Real up = ring.Radius * std::cos(ring.Angles[i]);
    const CVector3 sensor(-kHeight, ring.Radius * std::sin(ring.Angles[i]), 2.0 + up);
    const CVector3 towards = CVector3(0.0, 0.0, 3.5) - sensor;
    const Real front =
        towards.GetY() * std::sin(ring.Angles[i]) + towards.GetZ() * std::cos(ring.Angles[i]);
    const Real expected = front >= 0.0 ? 0.25 / towards.SquareLength() : 0.0;
    CHECK_THAT(Readings(world)[i], WithinAbs(expected, kRounding));
  }
}

TEST_CASE("footbot_light and eyebot_light: readings decrease with distance and angle as published",
          "[contract][sensors]") {
  const bool flies = GENERATE(false, true);
  CRandomStream random(2, "test", flies ? "eye-bot" : "foot-bot", "light");
  for (int trial = 0; trial < 25; ++trial) {
    const CVector3 robot(random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0),
                         flies ? random.Uniform(0.0, 2.0) : 0.0);
    const Real yaw = random.Uniform(-M_PI, M_PI);
    const CVector3 offset(random.Uniform(-2.0, 2.0), random.Uniform(-2.0, 2.0),
                          random.Uniform(0.0, 1.0));
    const Real intensity = random.Uniform(0.3, 3.0);
    CAPTURE(trial, robot, yaw, offset, intensity);
    const std::string pose = PoseText(robot, yaw * 180.0 / M_PI);
    const std::string lamp = LampText("l", robot + offset, intensity);
    CRobotWorld world(flies ? WithSensor("eyebot_light implementation=\"rot_z_only\"",
                                         Robot("eye-bot", "r", pose) + lamp)
                            : WithFootBotSensor(Robot("foot-bot", "r", pose) + lamp));
    world.Step();
    std::vector<std::pair<CRadians, Real>> readings;
    if (flies) {
      for (const auto& reading :
           world.GetSensor<CCI_EyeBotLightSensor>("r", "eyebot_light").GetReadings()) {
        readings.emplace_back(reading.Angle, reading.Value);
      }
    } else {
      for (const auto& reading : FootBotReadings(world)) {
        readings.emplace_back(reading.Angle, reading.Value);
      }
    }
    const Real distance = offset.Length() / intensity;
    const Real strength = distance <= 2.5 ? std::exp(-2.0 * distance) : 0.0;
    REQUIRE(readings.size() == 24);
    for (size_t i = 0; i < 24; ++i) {
      CAPTURE(i);
      const Real angle = (7.5 + 15.0 * i) * M_PI / 180.0;
      const Real apart = std::abs(
          std::remainder(std::atan2(offset.GetY(), offset.GetX()) - yaw - angle, 2.0 * M_PI));
      const Real expected = strength * std::max(0.0, 1.0 - 2.0 * apart / M_PI);
      CHECK_THAT(readings[i].second, WithinAbs(std::min(1.0, expected), kRounding));
      CHECK_THAT(std::remainder(readings[i].first.GetValue() - angle, 2.0 * M_PI),
                 WithinAbs(0.0, kRounding));
    }
  }
}

TEST_CASE("eyebot_light: an arena without lights reads 0", "[contract][sensors]") {
  CRobotWorld world(WithSensor("eyebot_light implementation=\"rot_z_only\"",
                               Robot("eye-bot", "r", PoseText(CVector3(0.0, 0.0, 1.0)))));
  world.Step();
  for (const auto& reading :
       world.GetSensor<CCI_EyeBotLightSensor>("r", "eyebot_light").GetReadings()) {
    CHECK(reading.Value == 0.0);
  }
}

TEST_CASE("footbot_light: equals the published example", "[contract][sensors]") {
  CRobotWorld world(WithFootBotSensor(Robot("foot-bot", "r", PoseText(CVector3())) +
                                      LampText("l", CVector3(1.0, 0.0, 0.0), 1.0)));
  world.Step();
  // published with four digits
  CHECK_THAT(FootBotReadings(world)[0].Value, WithinAbs(0.1241, 5e-5));
}

TEST_CASE("footbot_light: the reach grows with the intensity up to 2.5", "[contract][sensors]") {
  const Real intensity = GENERATE(0.5, 1.0, 1.7);
  const Real excess = GENERATE(-1e-9, 1e-9);
  CRobotWorld world(
      WithFootBotSensor(Robot("foot-bot", "r", PoseText(CVector3())) +
                        LampText("l", CVector3(2.5 * intensity + excess, 0.0, 0.0), intensity)));
  world.Step();
  CHECK((FootBotReadings(world)[0].Value > 0.0) == (excess < 0.0));
}

TEST_CASE("footbot_light: a light directly above gives equal readings of all sensors",
          "[contract][sensors]") {
  CRobotWorld world(
      WithFootBotSensor(Robot("foot-bot", "r", PoseText(CVector3(0.3, 0.7, 0.0), 20.0)) +
                        LampText("l", CVector3(0.3, 0.7, 0.5), 1.0)));
  world.Step();
  for (const auto& reading : FootBotReadings(world)) {
    CHECK_THAT(reading.Value, WithinAbs(std::exp(-1.0) / 4.0, kRounding));
  }
}

TEST_CASE(
    "footbot_light: another body on the line to the light occludes it, the robot's own does not",
    "[contract][sensors]") {
  // the light is inside the robot's own body, 3 cm ahead of its centre
  CRobotWorld own(WithFootBotSensor(Robot("foot-bot", "r", PoseText(CVector3())) +
                                    LampText("l", CVector3(0.03, 0.0, 0.05), 1.0)));
  own.Step();
  CHECK(FootBotReadings(own)[0].Value > 0.0);
  const Real side = GENERATE(0.0, 0.0999, 0.1001);  // m, distance of the pole's axis from the line
  CRobotWorld world(WithFootBotSensor(Robot("foot-bot", "r", PoseText(CVector3())) +
                                      PillarText("c", 0.6, side, 0.1, 0.5) +
                                      LampText("l", CVector3(1.2, 0.0, 0.0), 1.0)));
  world.Step();
  CHECK((FootBotReadings(world)[0].Value > 0.0) == (side > 0.1));
}

TEST_CASE("light sensors: noise is uniform in [-n,n], or as the <noise> child requests",
          "[contract][sensors][noise]") {
  constexpr int kDraws = 4000;
  struct SCase {
    const char* Attributes;
    const char* Child;
    std::function<Real(Real)> Distribution;  // of the deviation
  };
  const SCase cases[] = {
      {"noise_level=\"0.05\"", "", [](Real x) { return UniformDistribution(x, -0.05, 0.05); }},
      {"", "<noise on=\"reading\" model=\"gaussian\" std_dev=\"0.02\" bias=\"0.01\"/>",
       [](Real x) { return NormalDistribution(x - 0.01, 0.02); }},
  };
  const size_t which = GENERATE(0U, 1U);
  const SCase& noise = cases[which];
  const std::string device =
      GENERATE("light implementation=\"default\"", "footbot_light implementation=\"rot_z_only\"");
  const std::string tag = device.substr(0, device.find(' '));
  CAPTURE(device, noise.Attributes, noise.Child);
  SRobotExperiment experiment;
  experiment.Sensors = "<" + device + " " + noise.Attributes + ">" + noise.Child + "</" + tag + ">";
  experiment.Arena = Robot("foot-bot", "r", PoseText(CVector3())) +
                     LampText("l", CVector3(1.0, 0.0, 0.0), tag == "light" ? 0.6 : 3.0);
  SRobotExperiment exact = experiment;
  exact.Sensors = "<" + device + "/>";
  const auto first = [&tag](CRobotWorld& world) {
    world.Step();
    return tag == "light" ? Readings(world)[0] : FootBotReadings(world)[0].Value;
  };
  CRobotWorld exactWorld(exact);
  const Real truth = first(exactWorld);
  // far enough from the limits of [0,1] that nothing is clamped
  REQUIRE((truth > 0.3 && truth < 0.7));
  CRobotWorld world(experiment);
  std::vector<Real> deviations;
  for (int i = 0; i < kDraws; ++i) {
    deviations.push_back(first(world) - truth);
  }
  CHECK(KolmogorovSmirnovExcess(deviations, noise.Distribution) <= 1.0);
}

TEST_CASE("light sensors: rays are recorded only on request", "[contract][sensors]") {
  const bool show = GENERATE(false, true);
  const std::string device =
      GENERATE("light implementation=\"default\"", "footbot_light implementation=\"rot_z_only\"");
  CAPTURE(show, device);
  SRobotExperiment experiment =
      WithSensor(device + " show_rays=\"" + (show ? "true" : "false") + "\"",
                 Robot("foot-bot", "r", PoseText(CVector3())) +
                     LampText("l", CVector3(2.0, 0.0, kHeight), 1.0));
  CRobotWorld world(experiment);
  world.Step(2);
  size_t expected = 1;
  if (device[0] == 'l') {
    // sensors within acos(R / 2) of the light: 12 of the 24 at 7.5 + 15 i degrees
    expected = 12;
  }
  CHECK(world.GetRobot("r").GetCheckedRays().size() == (show ? expected : 0));
}

namespace {

// the documented way to change the response
class CInverseLightSensor : public CLightDefaultSensor {
 public:
  Real CalculateReading(Real distance, Real intensity) override {
    return 0.1 * intensity / distance;
  }
};

}  // namespace

REGISTER_SENSOR(CInverseLightSensor, "light", "inverse_for_tests", "", "", "", "", "")

TEST_CASE("light: derived sensors can change the response", "[contract][sensors]") {
  const Real angle = 22.5 * M_PI / 180.0;
  CRobotWorld world(WithSensor(
      "light implementation=\"inverse_for_tests\"",
      Robot("e-puck", "r", PoseText(CVector3())) +
          LampText("l", CVector3(0.535 * std::cos(angle), 0.535 * std::sin(angle), kHeight), 2.0)));
  world.Step();
  CHECK_THAT(Readings(world)[0], WithinAbs(0.4, kRounding));
}

TEST_CASE("light sensors: invalid experiments are refused with the reason",
          "[contract][sensors][errors]") {
  SECTION("a robot without light sensors") {
    SRobotExperiment experiment = WithGenericSensor(Robot("toy-robot", "t0", PoseText(CVector3())));
    CHECK_THAT(LoadError(experiment), Contains("\"t0\"") && Contains("light_sensors"));
  }
  SECTION("the sensor of another robot") {
    CHECK_THAT(LoadError(WithFootBotSensor(Robot("e-puck", "ep0", PoseText(CVector3())))),
               Contains("footbot_light") && Contains("needs a robot with 24") &&
                   Contains("\"ep0\" has 8"));
  }
  SECTION("negative noise") {
    const std::string device =
        GENERATE("light implementation=\"default\"", "footbot_light implementation=\"rot_z_only\"");
    CHECK_THAT(LoadError(WithSensor(device + " noise_level=\"-0.1\"",
                                    Robot("foot-bot", "fb0", PoseText(CVector3())))),
               Contains("noise_level") && Contains(">= 0") && Contains("-0.1"));
  }
  SECTION("noise on an unknown quantity") {
    SRobotExperiment experiment = WithGenericSensor(Robot("foot-bot", "fb0", PoseText(CVector3())));
    experiment.Sensors =
        "<light implementation=\"default\"><noise on=\"readin\" model=\"uniform\" "
        "level=\"1\"/></light>";
    CHECK_THAT(LoadError(experiment), Contains("\"readin\"") && Contains("reading"));
  }
}

}  // namespace argos::light_test
