// Where rigid bodies touch: Coulomb's cone, many contacts at once, rest, thin and heavy bodies.

#include <argos3/testing/contract/physics_engines/rigid_scene.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/physics_engines/planar/separation.h>
#include <argos3/testing/support/robot_sizes.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <vector>

namespace argos::rigid_touch_test {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr Real kDegree = ARGOS_PI / 180.0;

// a scene that is turned about the vertical through the origin
struct STurn {
  Real Degrees;

  CVector3 operator()(Real x, Real y, Real z = 0.0) const {
    const Real angle = Degrees * kDegree;
    return CVector3(x * std::cos(angle) - y * std::sin(angle),
                    x * std::sin(angle) + y * std::cos(angle), z);
  }
  std::string Robot(const std::string& id, Real x, Real y, Real yaw, Real speed) const {
    const CVector3 place = (*this)(x, y);
    return DriverXml("foot-bot", id, place.GetX(), place.GetY(), Degrees + yaw, speed, speed);
  }
  std::string Box(const std::string& id, const CVector3& size, const CVector3& place,
                  Real mass) const {
    return SBoxXml{id, size, (*this)(place.GetX(), place.GetY(), place.GetZ()),
                   CVector3(Degrees, 0, 0), mass}
        .ToXml();
  }
  // a coordinate of the scene before it was turned
  Real Along(const CVector3& place) const { return place.DotProduct((*this)(1.0, 0.0)); }
};

std::string CylinderXml(const std::string& id, Real radius, const CVector3& place, Real mass) {
  std::ostringstream xml;
  xml << "<cylinder id='" << id << "' radius='" << radius << "' height='0.1' mass='" << mass
      << "' movable='" << (mass > 0.0 ? "true" : "false") << "'><body position='" << place
      << "'/></cylinder>";
  return xml.str();
}

// what the body covers of the floor, which has one upright solid
SFootprint CoveredBy(CRigidScene& world, const std::string& id) {
  const CVector3 place = world.Position(id);
  SPlanarPose pose;
  pose.X = place.GetX();
  pose.Y = place.GetY();
  pose.HalfCos = std::cos(0.5 * world.Yaw(id));
  pose.HalfSin = std::sin(0.5 * world.Yaw(id));
  std::vector<SFootprint> footprints;
  AppendFootprints(*world.Body(id).GetBodyDescription(), pose, footprints);
  return footprints.front();
}

std::string Name(int i) {
  return "b" + std::to_string(i);
}

}  // namespace

TEST_CASE(
    "rigid touch: a robot that presses on a wall at 45 degrees slides along it at most at "
    "the rate of Coulomb's law",
    "[contract][engine][rigid][touch]") {
  const STurn turn{GENERATE(0.0, 30.0, 77.0)};
  const std::string stepper = GENERATE("mixed", "iterative");
  CAPTURE(turn.Degrees, stepper);
  // without friction at the wall it slides at v cos 45 degrees, so that the wheels slip across it
  CRigidScene world(GroundedEngine("", "<solver stepper='" + stepper + "'/>"),
                    turn.Box("wall", CVector3(20, 0.1, 0.3), CVector3(0, 0.05, 0), 0.0) +
                        turn.Robot("r", 0.0, -kFootBotRadius - 0.002, 45.0, 10.0));
  Real fastest = 0.0;
  for (int second = 0; second < 6; ++second) {
    const Real before = turn.Along(world.Position("r"));
    world.Step(10);
    fastest = std::max(fastest, turn.Along(world.Position("r")) - before);
  }
  CHECK(fastest < 0.075);
}

TEST_CASE("rigid touch: a box that is pushed beside its centre turns in every direction alike",
          "[contract][engine][rigid][touch]") {
  const auto push = [](Real degrees, const std::string& attributes) {
    const STurn turn{degrees};
    CRigidScene world(GroundedEngine(attributes),
                      turn.Box("box", CVector3(0.3, 0.3, 0.15), CVector3(), 1.0) +
                          turn.Robot("r", -0.15 - kFootBotRadius - 0.002, 0.05, 0.0, 10.0));
    world.Step(30);
    return std::remainder(world.Yaw("box") - degrees * kDegree, 2.0 * ARGOS_PI) / kDegree;
  };
  const Real exact = push(0.0, "iterations='200'");
  const Real ahead = push(0.0, "");
  CAPTURE(exact, ahead);
  CHECK(std::abs(exact) > 15.0);
  // the weight on four corners is distributed in more than one way, which differs by substeps
  CHECK_THAT(ahead, WithinRel(exact, 0.2));
  for (const Real degrees : {20.0, 45.0, 90.0, 131.0}) {
    CAPTURE(degrees);
    CHECK_THAT(push(degrees, ""), WithinAbs(ahead, 1.0));
  }
}

TEST_CASE("rigid touch: robots that push one box below their limit move it at their speed",
          "[contract][engine][rigid][touch]") {
  const int count = GENERATE(1, 2, 5, 10);
  CAPTURE(count);
  // wheels bear 80 % of 1.6 kg, and push with at most that
  const Real limit = 0.8 * 1.6 * kSceneGravity;
  const Real mass = 0.6 * count * limit / kSceneGravity;
  const STurn turn{0.0};
  std::string arena = turn.Box("box", CVector3(0.2, 0.2 * count, 0.1), CVector3(), mass);
  for (int i = 0; i < count; ++i) {
    arena += turn.Robot("r" + std::to_string(i), -0.1 - kFootBotRadius - 0.002,
                        0.2 * i - 0.1 * (count - 1), 0.0, 10.0);
  }
  CRigidScene world(GroundedEngine(), arena);
  world.Step(30);
  const Real before = world.Position("box").GetX();
  world.Step(20);
  CHECK_THAT(world.Position("box").GetX() - before, WithinRel(0.2, 0.03));
}

TEST_CASE("rigid touch: many idle boxes that touch each other fall asleep",
          "[contract][engine][rigid][touch]") {
  constexpr int kSide = 12;
  const std::string stepper = GENERATE("mixed", "iterative");
  std::string arena;
  for (int i = 0; i < kSide * kSide; ++i) {
    const CVector3 place(0.1 * (i % kSide), 0.1 * (i / kSide), 0.0);
    arena += SBoxXml{Name(i), CVector3(0.1, 0.1, 0.1), place, CVector3(), 0.5}.ToXml();
  }
  CRigidScene world(GroundedEngine("", "<solver stepper='" + stepper + "'/>"), arena);
  world.Step(15);
  std::vector<CVector3> places;
  for (int i = 0; i < kSide * kSide; ++i) {
    places.push_back(world.Position(Name(i)));
  }
  world.Step(5);
  // what sleeps does not move by a bit
  int moved = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    moved += world.Position(Name(i)) == places[i] ? 0 : 1;
  }
  CHECK(moved == 0);
}

TEST_CASE("rigid touch: an upright cylinder that leans slightly comes to rest on the floor",
          "[contract][engine][rigid][touch]") {
  const Real yaw = GENERATE(0.0, 10.0, 30.0, 45.0, 90.0, 200.0);
  const Real lean = GENERATE(0.05, 0.5);
  const Real height = GENERATE(0.05, 0.3);
  const Real table = GENERATE(0.0, 0.1);
  CAPTURE(yaw, lean, height, table);
  std::ostringstream arena;
  arena << "<cylinder id='c' radius='0.1' height='" << height
        << "' movable='true' mass='1'><body position='0,0," << table + 0.001 << "' orientation='"
        << yaw << "," << lean << ",0'/></cylinder>";
  if (table > 0.0) {
    arena << SBoxXml{"table", CVector3(1, 1, table), CVector3(), CVector3(), 0.0}.ToXml();
  }
  CRigidScene world(GroundedEngine(), arena.str());
  world.Step(30);
  CHECK_THAT(world.Position("c").GetZ(), WithinAbs(table, 1e-4));
  CHECK(world.Tilt("c") < 1e-3);
  const CVector3 place = world.Position("c");
  world.Step(5);
  CHECK(world.Position("c") == place);
}

TEST_CASE("rigid touch: a robot on a thin plate stands on it", "[contract][engine][rigid][touch]") {
  const Real thickness = GENERATE(1e-3, 2e-3, 4e-3, 8e-3);
  const std::string tag = GENERATE("foot-bot", "e-puck");
  const Real speed = GENERATE(0.0, 5.0);
  CAPTURE(thickness, tag, speed);
  std::ostringstream robot;
  robot << "<" << tag << " id='r'><body position='-0.2,0.03," << thickness
        << "' orientation='20,0,0'/><controller config='driver'><params left='" << speed
        << "' right='" << speed << "'/></controller></" << tag << ">";
  CRigidScene world(
      GroundedEngine(),
      SBoxXml{"plate", CVector3(1.5, 1.5, thickness), CVector3(), CVector3(), 0.0}.ToXml() +
          robot.str());
  Real highest = 0.0;
  Real lean = 0.0;
  for (int tick = 0; tick < 40; ++tick) {
    world.Step();
    highest = std::max(highest, std::abs(world.Position("r").GetZ() - thickness));
    lean = std::max(lean, world.Tilt("r"));
  }
  CHECK(highest < 2e-4);
  CHECK(lean < 0.01);
}

TEST_CASE("rigid touch: bodies of any mass rest on the floor", "[contract][engine][rigid][touch]") {
  const Real mass = GENERATE(1e-3, 1.0, 1e3, 1e5);
  const std::string stepper = GENERATE("mixed", "direct", "iterative");
  CAPTURE(mass, stepper);
  CRigidScene world(GroundedEngine("", "<solver stepper='" + stepper + "'/>"),
                    SBoxXml{"b", CVector3(1, 1, 1), CVector3(), CVector3(), mass}.ToXml());
  world.Step(30);
  CHECK_THAT(world.Position("b").GetZ(), WithinAbs(0.0, 2e-5));
  CHECK(world.Tilt("b") < 1e-4);
}

TEST_CASE("rigid touch: a fast robot does not pass through a thin wall",
          "[contract][engine][rigid][touch]") {
  const Real speed = GENERATE(50.0, 200.0, 400.0);
  const Real thickness = GENERATE(1e-3, 2e-3, 0.01);
  const Real yaw = GENERATE(0.0, 20.0);
  CAPTURE(speed, thickness, yaw);
  CRigidScene world(
      GroundedEngine(),
      SBoxXml{"wall", CVector3(thickness, 6, 0.2), CVector3(0.5, 0, 0), CVector3(), 0.0}.ToXml() +
          DriverXml("e-puck", "r", -0.3, 0.0, yaw, speed, speed));
  world.Step();
  world.Launch("r", CVector3(0.01 * speed, 0.0, 0.0).RotateZ(CRadians(yaw * kDegree)));
  Real farthest = -1.0;
  for (int tick = 0; tick < 30; ++tick) {
    world.Step();
    farthest = std::max(farthest, world.Position("r").GetX());
  }
  // 10 % of the radius
  CHECK(farthest < 0.5 - 0.5 * thickness - 0.9 * kEPuckRadius);
}

// at the end of each substep, of which there is one in a tick
TEST_CASE("rigid touch: what strikes an object or a wall does not enter it",
          "[contract][engine][rigid][touch]") {
  const std::string mover = GENERATE("box", "turned box", "cylinder", "foot-bot");
  const std::string target = GENERATE("box", "turned box", "cylinder", "wall");
  const Real gap = GENERATE(2e-3, 2.7e-3, 3.4e-3, 4.1e-3);  // m
  CAPTURE(mover, target, gap);
  const auto solid = [](const std::string& kind, const std::string& id, const CVector3& place,
                        Real mass) {
    if (kind == "cylinder") {
      return CylinderXml(id, 0.06, place, mass);
    }
    return SBoxXml{id, CVector3(0.12, 0.15, 0.1), place,
                   CVector3(kind == "turned box" ? 30.0 : 0.0, 0.0, 0.0), mass}
        .ToXml();
  };
  const CVector3 start(-0.5, 0.02, 0.0);
  SExperiment experiment = CDriveWorld::Describe(
      GroundedEngine("upright='false' free_robots='false'"),
      (mover == "foot-bot" ? DriverXml(mover, "a", start.GetX(), start.GetY(), 0.0, 30.0, 30.0)
                           : solid(mover, "a", start, 0.01)) +
          solid(target, "b", CVector3(), target == "wall" ? 0.0 : 0.3));
  experiment.TicksPerSecond = 100;
  CRigidScene world(experiment);
  world.Step(mover == "foot-bot" ? 10 : 1);
  const auto measureGap = [&] { return ComputeGap(CoveredBy(world, "a"), CoveredBy(world, "b")); };
  // beside the target, at a distance that its way in a substep decides whether it is reached in one
  CVector3 place = start;
  for (int i = 0; i < 50; ++i) {
    const Real now = measureGap();
    place.SetX(world.Position("a").GetX() + now - gap);
    world.Body("a").MoveTo(place, world.Body("a").GetOriginAnchor().Orientation);
  }
  world.Launch("a", CVector3(0.38, 0.0, 0.0));
  Real deepest = -1.0;
  for (int tick = 0; tick < 20; ++tick) {
    world.Step();
    deepest = std::max(deepest, -measureGap());
  }
  // it has struck
  CHECK(deepest > -2e-4);
  // 0.2 % of the size
  CHECK(deepest < 0.002 * 0.12);
}

TEST_CASE("rigid touch: a tower of ten boxes stands for a minute",
          "[contract][engine][rigid][touch]") {
  const std::string sleep = GENERATE("sleep='true'", "sleep='false'");
  const Real twist = GENERATE(0.0, 10.0);
  CAPTURE(sleep, twist);
  std::string boxes;
  for (int i = 0; i < 10; ++i) {
    boxes += SBoxXml{Name(i), CVector3(0.2, 0.2, 0.1), CVector3(0, 0, 0.1 * i),
                     CVector3(twist * i, 0, 0), 0.5}
                 .ToXml();
  }
  CRigidScene world(GroundedEngine(sleep), boxes);
  world.Step(600);
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i);
    CHECK(Distance(world.Position(Name(i)), CVector3(0, 0, 0.1 * i)) < 2e-3);
  }
}

}  // namespace argos::rigid_touch_test
