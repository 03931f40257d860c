// Compares proximity sensors with distances computed by hand, in worlds without motion.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>
#include <argos3/testing/contract/sensors/sensor_ring.h>
#include <argos3/testing/support/polygons.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace proximity_geometry_test {

using namespace argos;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kNoHit = -1.0;
// tolerance of about ten roundings of numbers up to 10 m
constexpr Real kRounding = 1e-13;

SSensorRing EPuckRing() {
  SSensorRing ring{"e-puck", kEPuckRadius, 0.06, {}, 0.1};
  for (const Real divisor : {10.5884, 3.5999, 2.0, 1.2, 0.8571, 0.6667, 0.5806, 0.5247}) {
    ring.Angles.push_back(M_PI / divisor);
  }
  return ring;
}

std::string Pose(Real x, Real y, Real z, Real yawDegrees) {
  return "position=\"" + ToText(CVector3(x, y, z)) + "\" orientation=\"" + ToText(yawDegrees) +
         ",0,0\"";
}

std::string Cylinder(const std::string& id, Real x, Real y, Real radius, bool movable = false) {
  return "<cylinder id=\"" + id + "\" radius=\"" + ToText(radius) +
         "\" height=\"0.5\" mass=\"1\" movable=\"" + (movable ? "true" : "false") + "\"><body " +
         Pose(x, y, 0.0, 0.0) + "/></cylinder>";
}

std::string Box(const std::string& id, const CVector3& size, const std::string& pose) {
  return "<box id=\"" + id + "\" size=\"" + ToText(size) + "\" movable=\"false\"><body " + pose +
         "/></box>";
}

// distances of the generic sensor, whose reading is exp(-D)
std::vector<Real> Distances(CRobotWorld& world, const std::string& robot) {
  std::vector<Real> distances;
  for (const Real reading :
       world.GetSensor<CCI_ProximitySensor>(robot, "proximity").GetReadings()) {
    distances.push_back(reading > 0.0 ? -std::log(reading) : kNoHit);
  }
  return distances;
}

SRobotExperiment WithGenericSensor(const std::string& arena) {
  SRobotExperiment experiment;
  experiment.Sensors = "<proximity implementation=\"default\"/>";
  experiment.Arena = arena;
  return experiment;
}

// distance from a point on the ring, outward, to a disc, by the law of cosines
Real DistanceToDisc(const SSensorRing& ring, Real rayAngle, Real centerDistance, Real centerAngle,
                    Real radius) {
  const Real along = centerDistance * std::cos(centerAngle - rayAngle);
  const Real aside = centerDistance * std::sin(centerAngle - rayAngle);
  if (std::abs(aside) > radius) {
    return kNoHit;
  }
  const Real half = std::sqrt(radius * radius - aside * aside);
  if (along + half < ring.Radius) {
    return kNoHit;
  }
  const Real distance = std::max(0.0, along - half - ring.Radius);
  return distance <= ring.Range ? distance : kNoHit;
}

void CheckDistances(const std::vector<Real>& seen, const std::vector<Real>& expected) {
  REQUIRE(seen.size() == expected.size());
  for (size_t i = 0; i < seen.size(); ++i) {
    CAPTURE(i);
    CHECK_THAT(seen[i], WithinAbs(expected[i], kRounding));
  }
}

}  // namespace

TEST_CASE("proximity: a robot alone reads zeros and does not detect itself",
          "[contract][sensors]") {
  const SSensorRing ring = GENERATE(FootBotRing(), EPuckRing(), EyeBotRing());
  CAPTURE(ring.Tag);
  CRobotWorld world(WithGenericSensor(Robot(ring.Tag, "r", Pose(0.3, -0.2, 0.0, 30.0))));
  world.Step();
  CHECK(Distances(world, "r") == std::vector<Real>(ring.Angles.size(), kNoHit));
}

TEST_CASE("proximity: distances to a disc satisfy the law of cosines", "[contract][sensors]") {
  const SSensorRing ring = GENERATE(FootBotRing(), EPuckRing(), EyeBotRing());
  const bool movable = GENERATE(false, true);
  CRandomStream random(1, "test", ring.Tag, "poses");
  for (int trial = 0; trial < 25; ++trial) {
    const Real x = random.Uniform(-4.0, 4.0);
    const Real y = random.Uniform(-4.0, 4.0);
    const Real yaw = random.Uniform(-M_PI, M_PI);
    const Real radius = random.Uniform(0.02, 0.4);
    const Real distance = ring.Radius + radius + random.Uniform(0.0, ring.Range);
    const Real bearing = random.Uniform(-M_PI, M_PI);  // in the world frame
    CAPTURE(ring.Tag, movable, trial, x, y, yaw, radius, distance, bearing);
    CRobotWorld world(
        WithGenericSensor(Robot(ring.Tag, "r", Pose(x, y, 0.0, yaw * 180.0 / M_PI)) +
                          Cylinder("c", x + distance * std::cos(bearing),
                                   y + distance * std::sin(bearing), radius, movable)));
    world.Step();
    std::vector<Real> expected;
    for (const Real angle : ring.Angles) {
      expected.push_back(DistanceToDisc(ring, angle, distance, bearing - yaw, radius));
    }
    CheckDistances(Distances(world, "r"), expected);
  }
}

TEST_CASE("proximity: distances to a wall are its distance over the cosine of the angle",
          "[contract][sensors]") {
  const SSensorRing ring = GENERATE(FootBotRing(), EPuckRing(), EyeBotRing());
  const Real facing = GENERATE(0.0, 20.0, 45.0, 137.0, -90.0);  // degrees, towards the wall
  const Real yaw = GENERATE(0.0, 33.0, 180.0);  // degrees, of the robot
  const Real gap = 0.03;  // m, from the body to the wall
  const bool isPrism = GENERATE(false, true);
  CAPTURE(ring.Tag, facing, yaw, isPrism);
  // a wall one metre thick and eight metres long that faces the robot
  const Real center = ring.Radius + gap + 0.5;
  const Real towards = facing * M_PI / 180.0;
  CRobotWorld world(WithGenericSensor(
      Robot(ring.Tag, "r", Pose(1.0, -2.0, 0.0, yaw)) +
      Box("wall", CVector3(1.0, 8.0, 1.0),
          Pose(1.0 + center * std::cos(towards), -2.0 + center * std::sin(towards), 0.0, facing))));
  if (isPrism) {
    auto description = std::make_shared<SBodyDescription>();
    description->Shapes = {SShapeDescription::Prism(RectanglePolygon(1.0, 8.0), 1.0)};
    dynamic_cast<CComposableEntity&>(world.GetSpace().GetEntity("wall"))
        .GetComponent<CEmbodiedEntity>("body")
        .SetBodyDescription(std::move(description));
  }
  world.Step();
  std::vector<Real> expected;
  for (const Real angle : ring.Angles) {
    const Real cosine = std::cos(angle + yaw * M_PI / 180.0 - towards);
    const Real distance = (ring.Radius + gap) / cosine - ring.Radius;
    expected.push_back(cosine > 0.0 && distance <= ring.Range ? distance : kNoHit);
  }
  CheckDistances(Distances(world, "r"), expected);
}

TEST_CASE("proximity: readings are equal in every engine", "[contract][sensors]") {
  const std::string engine = GENERATE("toy_engine", "dynamics2d", "pointmass3d");
  const SSensorRing ring = GENERATE(FootBotRing(), EPuckRing(), EyeBotRing());
  CAPTURE(engine, ring.Tag);
  if (engine == "dynamics2d" && ring.Tag == "eye-bot") {
    WARN("skipped: robots do not fly in dynamics2d");
    return;
  }
  const Real gap = 0.03;
  const Real distance = ring.Radius + gap + 0.2;
  // direction of ray 1 of a robot turned by half a radian
  const Real bearing = ring.Angles[1] + 0.5;
  SRobotExperiment experiment =
      WithGenericSensor(Robot(ring.Tag, "r", Pose(2.0, 1.0, 0.0, 0.5 * 180.0 / M_PI)) +
                        Cylinder("c", 2.0 + distance * std::cos(bearing),
                                 1.0 + distance * std::sin(bearing), 0.2, true));
  experiment.Engine = "<" + engine + " id=\"engine\"/>";
  CRobotWorld world(experiment);
  world.Step(10);
  // tolerance for engines with poses in single precision: 2 m to 1e-7
  CHECK_THAT(Distances(world, "r")[1], WithinAbs(gap, 1e-6));
}

TEST_CASE("proximity: robots detect each other", "[contract][sensors]") {
  // an e-puck straight ahead of ray 0 of a foot-bot, 5 cm from body to body;
  // ray 3 of the e-puck points back
  const SSensorRing ring = FootBotRing();
  const Real distance = ring.Radius + 0.05 + 0.035;
  const Real yaw = 7.5 + 180.0 - EPuckRing().Angles[3] * 180.0 / M_PI;
  CRobotWorld world(WithGenericSensor(Robot("foot-bot", "fb", Pose(0.0, 0.0, 0.0, 0.0)) +
                                      Robot("e-puck", "ep",
                                            Pose(distance * std::cos(ring.Angles[0]),
                                                 distance * std::sin(ring.Angles[0]), 0.0, yaw))));
  world.Step();
  CHECK_THAT(Distances(world, "fb")[0], WithinAbs(0.05, kRounding));
  const std::vector<Real> seen = Distances(world, "ep");
  CHECK_THAT(seen[3], WithinAbs(0.05, kRounding));
  CHECK(seen[0] == kNoHit);
}

TEST_CASE("proximity: rays end at their range", "[contract][sensors]") {
  const SSensorRing ring = GENERATE(FootBotRing(), EPuckRing(), EyeBotRing());
  const Real excess = GENERATE(-1e-6, 1e-6);  // m, beyond the range
  CAPTURE(ring.Tag, excess);
  const Real distance = ring.Radius + ring.Range + excess + 0.2;
  CRobotWorld world(WithGenericSensor(Robot(ring.Tag, "r", Pose(0.0, 0.0, 0.0, 0.0)) +
                                      Cylinder("c", distance * std::cos(ring.Angles[1]),
                                               distance * std::sin(ring.Angles[1]), 0.2)));
  world.Step();
  const std::vector<Real> seen = Distances(world, "r");
  for (size_t i = 0; i < seen.size(); ++i) {
    CAPTURE(i);
    CHECK((seen[i] == kNoHit) == (i != 1 || excess > 0.0));
  }
}

TEST_CASE("proximity: of two bodies in line the nearer one is detected, in any order of addition",
          "[contract][sensors]") {
  const bool nearFirst = GENERATE(true, false);
  const SSensorRing ring = FootBotRing();
  const auto at = [&](const std::string& id, Real gap, Real radius) {
    const Real distance = ring.Radius + gap + radius;
    return Cylinder(id, distance * std::cos(ring.Angles[5]), distance * std::sin(ring.Angles[5]),
                    radius);
  };
  const std::string nearer = at("near", 0.03, 0.01);
  const std::string farther = at("far", 0.06, 0.3);
  CRobotWorld world(WithGenericSensor(Robot("foot-bot", "r", Pose(0.0, 0.0, 0.0, 0.0)) +
                                      (nearFirst ? nearer + farther : farther + nearer)));
  world.Step();
  CHECK_THAT(Distances(world, "r")[5], WithinAbs(0.03, kRounding));
}

TEST_CASE("proximity: a ray that starts inside a body reads distance 0", "[contract][sensors]") {
  // the disc contains the start of ray 0, which is 4 cm from its centre
  CRobotWorld world(WithGenericSensor(Robot("e-puck", "r", Pose(0.0, 0.0, 0.0, 0.0)) +
                                      Cylinder("c", 0.075 * std::cos(EPuckRing().Angles[0]),
                                               0.075 * std::sin(EPuckRing().Angles[0]), 0.05)));
  world.Step();
  const CCI_ProximitySensor& sensor = world.GetSensor<CCI_ProximitySensor>("r", "proximity");
  CHECK(sensor.GetReadings()[0] == 1.0);
  CHECK(sensor.GetReadings()[4] == 0.0);
}

TEST_CASE("proximity: bodies below and above the rays are not detected", "[contract][sensors]") {
  // the rays are at a height of 6 cm above the robot's base
  struct SCase {
    Real Bottom, Height, RobotZ;  // m
    bool Seen;
  };
  const SCase c = GENERATE(SCase{0.0, 0.059, 0.0, false}, SCase{0.0, 0.061, 0.0, true},
                           SCase{0.061, 0.5, 0.0, false}, SCase{0.059, 0.5, 0.0, true},
                           SCase{0.0, 0.1, 0.05, false}, SCase{0.05, 0.1, 0.05, true});
  CAPTURE(c.Bottom, c.Height, c.RobotZ);
  CRobotWorld world(
      WithGenericSensor(Robot("foot-bot", "r", Pose(0.0, 0.0, c.RobotZ, 0.0)) +
                        Box("b", CVector3(0.2, 0.2, c.Height), Pose(0.2, 0.0, c.Bottom, 0.0))));
  world.Step();
  CHECK((Distances(world, "r")[0] != kNoHit) == c.Seen);
}

TEST_CASE("proximity: a mirrored world gives mirrored readings", "[contract][sensors]") {
  CRobotWorld world(
      WithGenericSensor(Robot("foot-bot", "r", Pose(0.0, 0.0, 0.0, 0.0)) +
                        Cylinder("c1", 0.11, 0.08, 0.04) + Cylinder("c2", 0.11, -0.08, 0.04) +
                        Box("b1", CVector3(0.05, 0.05, 0.3), Pose(-0.1, 0.09, 0.0, 20.0)) +
                        Box("b2", CVector3(0.05, 0.05, 0.3), Pose(-0.1, -0.09, 0.0, -20.0))));
  world.Step();
  const std::vector<Real> seen = Distances(world, "r");
  int hits = 0;
  for (size_t i = 0; i < 12; ++i) {
    CAPTURE(i);
    hits += seen[i] != kNoHit ? 1 : 0;
    CHECK_THAT(seen[i], WithinAbs(seen[23 - i], kRounding));
  }
  CHECK(hits >= 4);
}

TEST_CASE("proximity: the rays of a tilted robot tilt with it", "[contract][sensors]") {
  // on its side, facing up: rays of the rear half point down to the top of a slab at z = 0
  const Real height = 0.1;  // m, of the origin above the slab
  CRobotWorld world(WithGenericSensor(
      "<foot-bot id=\"r\"><body position=\"" + ToText(CVector3(0.0, 0.0, height)) +
      "\" orientation=\"0,-90,0\"/><controller config=\"c\"/></foot-bot>" +
      Box("slab", CVector3(2.0, 2.0, 1.0), Pose(0.0, 0.0, -1.0, 0.0))));
  world.Step();
  const SSensorRing ring = FootBotRing();
  std::vector<Real> expected;
  for (const Real angle : ring.Angles) {
    // the robot's x axis points up: a ray at this angle descends by -cos(angle) per metre
    const Real distance = -height / std::cos(angle) - ring.Radius;
    const bool hit = std::cos(angle) < 0.0 && distance <= ring.Range;
    expected.push_back(hit ? std::max(distance, 0.0) : kNoHit);
  }
  CheckDistances(Distances(world, "r"), expected);
}

TEST_CASE("proximity: rays hit tilted boxes on their faces", "[contract][sensors]") {
  // A long bar turned by 45 degrees about its length, the y axis. Its cross-section is a square of
  // side s standing on a corner at z = 0; at z = 0.06 its front face is at x0 - 0.06.
  const Real side = 0.2;
  const Real corner = 0.2;  // x of the lowest edge, m
  CRobotWorld world(WithGenericSensor(
      Robot("foot-bot", "r", Pose(0.0, 0.0, 0.0, 0.0)) + "<box id=\"b\" size=\"" +
      ToText(CVector3(side, 4.0, side)) + "\" movable=\"false\"><body position=\"" +
      // the centre of the base is half a side up the slope from the lowest edge
      ToText(CVector3(corner + side / 2.0 * std::sqrt(0.5), 0.0, side / 2.0 * std::sqrt(0.5))) +
      "\" orientation=\"0,-45,0\"/></box>"));
  world.Step();
  const SSensorRing ring = FootBotRing();
  const Real face = corner - ring.Height;
  std::vector<Real> expected;
  for (const Real angle : ring.Angles) {
    const Real distance = face / std::cos(angle) - ring.Radius;
    expected.push_back(std::cos(angle) > 0.0 && distance <= ring.Range ? distance : kNoHit);
  }
  CheckDistances(Distances(world, "r"), expected);
}

TEST_CASE("proximity: each robot has its own response curve", "[contract][sensors]") {
  // a disc ahead of one ray of each robot, at distances on every segment of the curves
  const Real distance = GENERATE(0.0, 0.005, 0.012, 0.03, 0.0499, 0.0501, 0.09);
  CAPTURE(distance);
  const auto expectedFootBot = distance < 0.009889556 ? 1.0 : 0.0100527 / (distance + 0.000163144);
  const Real parabola = 298.701 * distance * distance - 36.8961 * distance + 1.08212;
  const auto expectedEPuck = distance <= 0.05 ? std::min(1.0, std::max(0.0, parabola)) : 0.0;

  const auto experiment = [distance](const SSensorRing& ring, const std::string& sensor) {
    SRobotExperiment result;
    result.Sensors = "<" + sensor + " implementation=\"default\"/>";
    const Real center = ring.Radius + distance + 0.05;
    result.Arena =
        Robot(ring.Tag, "r", Pose(0.0, 0.0, 0.0, 0.0)) +
        Cylinder("c", center * std::cos(ring.Angles[2]), center * std::sin(ring.Angles[2]), 0.05);
    return result;
  };
  // a slope of at most 100 per metre magnifies roundings of the distance
  constexpr Real kTolerance = 1e-11;
  CRobotWorld footBot(experiment(FootBotRing(), "footbot_proximity"));
  footBot.Step();
  CHECK_THAT(footBot.GetSensor<CCI_FootBotProximitySensor>("r", "footbot_proximity")
                 .GetReadings()[2]
                 .Value,
             WithinAbs(expectedFootBot, kTolerance));
  CRobotWorld eyeBot(experiment(EyeBotRing(), "eyebot_proximity"));
  eyeBot.Step();
  CHECK_THAT(
      eyeBot.GetSensor<CCI_EyeBotProximitySensor>("r", "eyebot_proximity").GetReadings()[2].Value,
      WithinAbs(expectedFootBot, kTolerance));
  CRobotWorld ePuck(experiment(EPuckRing(), "epuck_proximity"));
  ePuck.Step();
  CHECK_THAT(
      ePuck.GetSensor<CCI_EPuckProximitySensor>("r", "epuck_proximity").GetReadings()[2].Value,
      WithinAbs(expectedEPuck, kTolerance));
}

TEST_CASE("proximity: after a move by a program readings are those of the new place at once",
          "[contract][sensors]") {
  const SSensorRing ring = EPuckRing();
  CRobotWorld world(WithGenericSensor(Robot("e-puck", "r", Pose(0.0, 0.0, 0.0, 0.0)) +
                                      Cylinder("c", 2.0, 0.0, 0.1)));
  world.Step();
  CHECK(Distances(world, "r") == std::vector<Real>(8, kNoHit));
  auto& body = world.Get<CComposableEntity>("r").GetComponent<CEmbodiedEntity>("body");
  // ray 2 points along the robot's y axis: turned right by 90 degrees it points along x
  REQUIRE(body.MoveTo(CVector3(1.82, 0.0, 0.0), CQuaternion(-CRadians::PI_OVER_TWO, CVector3::Z)));
  world.GetRobot("r").Sense();
  CHECK_THAT(Distances(world, "r")[2], WithinAbs(2.0 - 0.1 - 1.82 - ring.Radius, kRounding));
}

}  // namespace proximity_geometry_test
