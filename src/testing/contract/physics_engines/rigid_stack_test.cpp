// Stacks of boxes and cylinders: stable and toppling ones.

#include <argos3/testing/contract/physics_engines/rigid_scene.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/digests.h>

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>
#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace argos::rigid_stack_test {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

std::string Stepper(const std::string& name) {
  return "<solver stepper='" + name + "'/>";
}

std::string Name(int i) {
  return "b" + std::to_string(i);
}

// each turned against the one below, degrees
std::string Stack(int count, Real twist = 10.0) {
  std::string boxes;
  for (int i = 0; i < count; ++i) {
    boxes += SBoxXml{Name(i), CVector3(0.2, 0.2, 0.1), CVector3(0, 0, 0.1 * i),
                     CVector3(twist * i, 0, 0), 0.5}
                 .ToXml();
  }
  return boxes;
}

}  // namespace

TEST_CASE("rigid stack: a cylinder on a box stays at rest", "[contract][engine][rigid]") {
  const std::string table = GENERATE("movable='false'", "movable='true' mass='5'");
  const Real x = GENERATE(0.0, 0.43);  // with the second value it extends over the edge
  CAPTURE(table, x);
  std::ostringstream arena;
  arena << "<box id='t' size='1,1,0.2' " << table << "><body position='0,0,0'/></box>"
        << "<cylinder id='c' radius='0.1' height='0.3' movable='true' mass='1'><body position='"
        << x << ",0.1,0.2' orientation='10,0,0'/></cylinder>";
  CRigidScene world(GroundedEngine("sleep='false'"), arena.str());
  Real most = 0.0;
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    most = std::max(most, world.Tilt("c"));
  }
  // a rocking cylinder would tilt by more than the limit that is reported as upright
  CHECK(most < 1e-6);
  CHECK(Distance(world.Position("c"), CVector3(x, 0.1, 0.2)) < 1e-3);
}

TEST_CASE("rigid stack: five stacked boxes rest for 10 s", "[contract][engine][rigid]") {
  const std::string stepper = GENERATE("mixed", "direct", "iterative");
  const std::string sleep = GENERATE("sleep='true'", "sleep='false'");
  CAPTURE(stepper, sleep);
  CRigidScene world(GroundedEngine(sleep, Stepper(stepper)), Stack(5));
  world.Step(100);
  // 2 % of a box's side for the iterative stepper, 1 % for the others
  const Real aside = stepper == "iterative" ? 4e-3 : 2e-3;
  for (int i = 0; i < 5; ++i) {
    CAPTURE(i);
    CHECK_THAT(world.Position(Name(i)).GetX(), WithinAbs(0.0, aside));
    CHECK_THAT(world.Position(Name(i)).GetY(), WithinAbs(0.0, aside));
    // tolerance for the compliance of contacts
    CHECK_THAT(world.Position(Name(i)).GetZ(), WithinAbs(0.1 * i, 1e-3));
    CHECK(world.Tilt(Name(i)) < 5e-3);
  }
}

TEST_CASE("rigid stack: the stepper direct reports contacts that it leaves unsolved",
          "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine("sleep='false'", Stepper("direct")), Stack(5, 15.0));
  world.Step(100);
  CHECK_THAT(TakeLogErr(), Catch::Matchers::Contains("has left contacts unsolved"));
}

TEST_CASE("rigid stack: a box falls when the box below is removed", "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine(), Stack(2));
  // long enough for both to fall asleep
  world.Step(20);
  world.GetSimulator().GetLoopFunctions().RemoveEntity("b0");
  world.Step(10);
  CHECK_THAT(world.Position("b1").GetZ(), WithinAbs(0.0, 1e-3));
}

TEST_CASE("rigid stack: a tall box stands on a slope until its weight acts beyond its edge",
          "[contract][engine][rigid]") {
  // 0.1 m wide, 0.4 m tall: it topples beyond atan(1 / 4) = 14.04 degrees; friction holds to 45
  const auto slope = [](Real degrees) {
    const Real angle = degrees * ARGOS_PI / 180.0;
    const CVector3 top(0.1 * std::sin(angle), 0.0, 0.1 * std::cos(angle));
    return SBoxXml{"slope", CVector3(4, 2, 0.1), CVector3(), CVector3(0, degrees, 0), 0.0}.ToXml() +
           SBoxXml{"tall", CVector3(0.1, 0.1, 0.4), top, CVector3(0, degrees, 0)}.ToXml();
  };
  CRigidScene stands(RigidEngine("", "<gravity g='9.81'/>"), slope(13.0));
  stands.Step(50);
  CHECK_THAT(stands.Tilt("tall"), WithinAbs(13.0 * ARGOS_PI / 180.0, 0.01));
  CRigidScene topples(RigidEngine("", "<gravity g='9.81'/>"), slope(15.5));
  topples.Step(50);
  // it is on its side on the slope
  CHECK_THAT(topples.Tilt("tall"), WithinAbs(0.5 * ARGOS_PI + 15.5 * ARGOS_PI / 180.0, 0.05));
}

TEST_CASE("rigid stack: an impulse at its middle topples a tall box beyond a certain speed",
          "[contract][engine][rigid]") {
  // About its edge the box has the moment of inertia I = m (w^2 + h^2) / 3. An impulse p at half
  // its height h gives it the rate p h / (2 I), and it topples if the energy lifts its centre of
  // mass from h / 2 to sqrt(w^2 + h^2) / 2.
  const Real width = 0.1;
  const Real height = 0.4;
  const Real diagonal = std::hypot(width, height);
  const Real inertia = diagonal * diagonal / 3.0;
  const Real rate = std::sqrt(2.0 * 9.81 * 0.5 * (diagonal - height) / inertia);
  const Real impulse = rate * 2.0 * inertia / height;
  const Real share = GENERATE(0.85, 1.15);
  CAPTURE(share, impulse);
  // friction high enough that the edge does not slip
  CRigidScene world(
      GroundedEngine("default_friction='3'", KickXml("tall", CVector3(share * impulse, 0, 0))),
      SBoxXml{"tall", CVector3(width, width, height), CVector3()}.ToXml());
  world.Step(30);
  CHECK_THAT(world.Tilt("tall"), WithinAbs(share > 1.0 ? 0.5 * ARGOS_PI : 0.0, 0.01));
}

TEST_CASE("rigid stack: cylinders stand on each other and beside each other",
          "[contract][engine][rigid]") {
  const std::string cylinder =
      "<cylinder id='low' radius='0.1' height='0.2' movable='true' mass='1'><body "
      "position='0,0,0'/></cylinder><cylinder id='high' radius='0.1' height='0.2' movable='true' "
      "mass='1'><body position='0.02,0,0.2'/></cylinder><cylinder id='beside' radius='0.1' "
      "height='0.2' movable='true' mass='1'><body position='-0.2,0,0'/></cylinder>";
  CRigidScene world(GroundedEngine(), cylinder);
  world.Step(50);
  CHECK_THAT(world.Position("low").GetX(), WithinAbs(0.0, 1e-3));
  CHECK_THAT(world.Position("high").GetX(), WithinAbs(0.02, 2e-3));
  CHECK_THAT(world.Position("high").GetZ(), WithinAbs(0.2, 1e-3));
  CHECK_THAT(world.Position("beside").GetX(), WithinAbs(-0.2, 1e-3));
  CHECK(world.Tilt("high") < 0.01);
}

TEST_CASE("rigid stack: a cylinder on its side rolls down a slope with 2/3 of g sin a",
          "[contract][engine][rigid]") {
  const Real angle = 0.1;
  const Real degrees = angle * 180.0 / ARGOS_PI;
  // its axis, the z axis of its body, is along y: turned by 90 degrees about x
  const Real radius = 0.2;
  const CVector3 top((0.1 + radius) * std::sin(angle), 0.0, (0.1 + radius) * std::cos(angle));
  std::ostringstream arena;
  arena << SBoxXml{"slope", CVector3(8, 2, 0.1), CVector3(), CVector3(0, degrees, 0), 0.0}.ToXml()
        << "<cylinder id='c' radius='" << radius
        << "' height='0.4' movable='true' mass='1'><body position='" << top.GetX() << ",0.2,"
        << top.GetZ() << "' orientation='0,0,90'/></cylinder>";
  CRigidScene world(RigidEngine("", "<gravity g='9.81'/>"), arena.str());
  world.Step(10);
  const Real n = 100.0;
  const Real path = 2.0 / 3.0 * 9.81 * std::sin(angle) * 1e-4 * n * (n + 1.0) / 2.0;
  CHECK_THAT((world.Position("c") - CVector3(top.GetX(), 0.2, top.GetZ())).Length(),
             Catch::Matchers::WithinRel(path, 0.02));
}

namespace {

// rows of boxes on each other, each of one box less than the one below, side by side
std::string PyramidXml(int rows) {
  std::string boxes;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) {
      boxes += SBoxXml{Name(100 * row + i), CVector3(0.2, 0.2, 0.1),
                       CVector3(0.21 * (i + 0.5 * row), 0, 0.1 * row), CVector3(), 0.5}
                   .ToXml();
    }
  }
  return boxes;
}

constexpr Real kBall = 0.05;  // m, radius
constexpr Real kBallMass = 0.5;  // kg

// balls above each other in a pen, 5 by 5 in a layer
std::string PileXml(int count) {
  constexpr Real kSide = 0.55;  // m, of the pen
  std::ostringstream arena;
  for (int i = 0; i < 4; ++i) {
    const Real x = i % 2 == 0 ? (i - 1) * 0.5 * (kSide + 0.1) : 0.0;
    const Real y = i % 2 == 0 ? 0.0 : (i - 2) * 0.5 * (kSide + 0.1);
    arena << SBoxXml{"wall" + std::to_string(i),
                     CVector3(i % 2 == 0 ? 0.1 : 0.75, i % 2 == 0 ? 0.75 : 0.1, 2.0),
                     CVector3(x, y, 0),
                     {},
                     0.0}
                 .ToXml();
  }
  for (int i = 0; i < count; ++i) {
    // a little aside of those below
    const Real x = 0.109 * (i % 5 - 2) + 1e-3 * (i * 7 % 5 - 2);
    const Real y = 0.109 * (i / 5 % 5 - 2) + 1e-3 * (i * 11 % 7 - 3);
    arena << "<prototype id='" << Name(i) << "' movable='true'><body position='" << x << "," << y
          << "," << 0.001 + 0.107 * (i / 25) << "'/><links ref='l'><link id='l' geometry='sphere' "
          << "radius='" << kBall << "' mass='" << kBallMass << "'/></links></prototype>";
  }
  return arena.str();
}

CDynamics3DModel& ModelOf(CRigidScene& world, const std::string& id) {
  return dynamic_cast<CDynamics3DModel&>(world.Body(id).GetPhysicsModel(size_t(0)));
}

// of balls, J
Real ComputeEnergy(CRigidScene& world, int count) {
  Real sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const CDynamics3DModel& model = ModelOf(world, Name(i));
    sum += kBallMass * (kSceneGravity * model.GetCentreOfMass().GetZ() +
                        0.5 * model.GetVelocity().SquareLength() +
                        0.2 * kBall * kBall * model.GetAngularVelocity().SquareLength());
  }
  return sum;
}

// how deep balls are in each other and in the floor, m
Real FindDeepest(CRigidScene& world, int count) {
  std::vector<CVector3> places;
  Real deepest = 0.0;
  for (int i = 0; i < count; ++i) {
    places.push_back(ModelOf(world, Name(i)).GetCentreOfMass());
    deepest = std::max(deepest, kBall - places[i].GetZ());
    for (int j = 0; j < i; ++j) {
      deepest = std::max(deepest, 2.0 * kBall - Distance(places[i], places[j]));
    }
  }
  return deepest;
}

}  // namespace

TEST_CASE("rigid stack: a tower stands for an hour, and does not move once it stands",
          "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine("sleep='false'"), Stack(10));
  world.Step(100);
  std::vector<CVector3> places;
  for (int i = 0; i < 10; ++i) {
    places.push_back(world.Position(Name(i)));
    CAPTURE(i);
    // 1 % of the height of a box
    CHECK(Distance(places[i], CVector3(0, 0, 0.1 * i)) < 1e-3);
  }
  world.Step(36000);
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i);
    CHECK(Distance(places[i], world.Position(Name(i))) < 1e-5);
  }
}

TEST_CASE("rigid stack: boxes on each other bear their weights from the first tick on",
          "[contract][engine][rigid]") {
  const bool isPyramid = GENERATE(false, true);
  CAPTURE(isPyramid);
  // forces are forgotten when this one is moved
  const std::string aside =
      SBoxXml{"aside", CVector3(0.1, 0.1, 0.1), CVector3(0, 5, 0), CVector3(), 0.5}.ToXml();
  CRigidScene world(GroundedEngine("sleep='false'"),
                    (isPyramid ? PyramidXml(10) : Stack(10)) + aside);
  const auto check = [&] {
    for (int row = 0; row < 10; ++row) {
      for (int i = 0; i < (isPyramid ? 10 - row : 1); ++i) {
        CAPTURE(row, i);
        const CVector3 place(isPyramid ? 0.21 * (i + 0.5 * row) : 0.0, 0, 0.1 * row);
        const std::string id = Name(isPyramid ? 100 * row + i : row);
        // they would sink by 10 um and more if each gave way in turn
        CHECK(Distance(world.Position(id), place) < 1e-8);
      }
    }
  };
  world.Step();
  check();
  CHECK(world.Body("aside").MoveTo(CVector3(0, 5.5, 0), CQuaternion()));
  world.Step();
  check();
}

TEST_CASE("rigid stack: a tower does not rise when what is on it is removed",
          "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine("sleep='false'"), Stack(5));
  world.Step(2);
  world.GetSimulator().GetLoopFunctions().RemoveEntity(Name(4));
  world.GetSimulator().GetLoopFunctions().RemoveEntity(Name(3));
  for (int tick = 0; tick < 50; ++tick) {
    world.Step();
    for (int i = 0; i < 3; ++i) {
      CAPTURE(tick, i);
      CHECK_THAT(world.Position(Name(i)).GetZ(), WithinAbs(0.1 * i, 1e-5));
    }
  }
}

TEST_CASE("rigid stack: a pyramid of boxes stands, and falls asleep", "[contract][engine][rigid]") {
  constexpr int kRows = 12;
  CRigidScene world(GroundedEngine(), PyramidXml(kRows));
  world.Step(40);
  std::vector<CVector3> places;
  for (const bool isFirst : {true, false}) {
    size_t number = 0;
    for (int row = 0; row < kRows; ++row) {
      for (int i = 0; i < kRows - row; ++i) {
        CAPTURE(row, i);
        const CVector3 place = world.Position(Name(100 * row + i));
        CHECK(Distance(place, CVector3(0.21 * (i + 0.5 * row), 0, 0.1 * row)) < 1e-3);
        if (isFirst) {
          places.push_back(place);
        } else {
          CHECK(places[number++] == place);
        }
      }
    }
    world.Step(10);
  }
}

TEST_CASE("rigid stack: a block of boxes that touch on all sides stands, and falls asleep",
          "[contract][engine][rigid]") {
  constexpr int kSide = 5;
  const auto placeOf = [](int i) {
    return CVector3(0.1 * (i % kSide), 0.1 * (i / kSide % kSide), 0.1 * (i / kSide / kSide));
  };
  std::string arena;
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    arena += SBoxXml{Name(i), CVector3(0.1, 0.1, 0.1), placeOf(i), CVector3(), 0.5}.ToXml();
  }
  CRigidScene world(GroundedEngine(), arena);
  world.Step(30);
  std::vector<CVector3> places;
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    places.push_back(world.Position(Name(i)));
    CAPTURE(i);
    CHECK(Distance(places[i], placeOf(i)) < 1e-3);
  }
  world.Step(5);
  int moved = 0;
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    moved += world.Position(Name(i)) == places[i] ? 0 : 1;
  }
  CHECK(moved == 0);
}

TEST_CASE("rigid stack: a ball that spins on the floor comes to rest",
          "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine("sleep='false'"), PileXml(1));
  world.Step();
  SBodyMotion motion;
  motion.Rotation.SetZ(20.0);
  world.Body(Name(0)).GetPhysicsModel(0).GetEngine().SetMotion(world.Body(Name(0)), motion);
  world.Step(10);
  // friction on a patch with a radius of 1 to 2 % of its own: 10 to 20 rad/s^2
  CHECK(world.Motion(Name(0)).Rotation.GetZ() > -1e-9);
  CHECK(world.Motion(Name(0)).Rotation.GetZ() < 11.0);
  world.Step(20);
  CHECK_THAT(world.Motion(Name(0)).Rotation.GetZ(), WithinAbs(0.0, 1e-9));
}

TEST_CASE("rigid stack: a ball that rolls on the floor is slowed down evenly, and stops",
          "[contract][engine][rigid]") {
  constexpr Real kSpeed = 0.05;  // m/s
  constexpr Real kSlowing = 5.0 / 7.0 * 0.004 * kSceneGravity;  // m/s^2, of rolling resistance
  CRigidScene world(GroundedEngine("sleep='false'"), PileXml(1));
  world.Step();
  const CDynamics3DModel& ball = ModelOf(world, Name(0));
  const CVector3 start = ball.GetCentreOfMass();
  SBodyMotion motion;
  motion.Velocity.Set(0.6 * kSpeed, 0.8 * kSpeed, 0.0);
  motion.Rotation.Set(-0.8 * kSpeed / kBall, 0.6 * kSpeed / kBall, 0.0);
  world.Body(Name(0)).GetPhysicsModel(0).GetEngine().SetMotion(world.Body(Name(0)), motion);
  world.Step(10);
  CHECK_THAT(ball.GetVelocity().Length(), WithinRel(kSpeed - kSlowing, 0.02));
  world.Step(20);
  CHECK(ball.GetVelocity().Length() < 1e-9);
  CHECK_THAT(Distance(start, ball.GetCentreOfMass()),
             WithinRel(0.5 * kSpeed * kSpeed / kSlowing, 0.02));
}

TEST_CASE("rigid stack: a pile of balls comes to rest and falls asleep",
          "[contract][engine][rigid]") {
  constexpr int kBalls = 150;
  CRigidScene world(GroundedEngine(), PileXml(kBalls));
  world.Step(100);
  CHECK(FindDeepest(world, kBalls) < 0.02 * kBall);
  std::vector<CVector3> places;
  for (int i = 0; i < kBalls; ++i) {
    places.push_back(world.Position(Name(i)));
  }
  world.Step(20);
  int moved = 0;
  for (int i = 0; i < kBalls; ++i) {
    moved += world.Position(Name(i)) == places[i] ? 0 : 1;
  }
  CHECK(moved == 0);
}

TEST_CASE("rigid stack: a pile of balls loses energy, and its balls stay beside each other",
          "[contract][engine][rigid]") {
  constexpr int kBalls = 150;
  CRigidScene world(GroundedEngine("sleep='false'"), PileXml(kBalls));
  world.Step();
  Real energy = ComputeEnergy(world, kBalls);
  for (int tick = 0; tick < 60; ++tick) {
    world.Step();
    const Real now = ComputeEnergy(world, kBalls);
    CAPTURE(tick, energy, now);
    // what the correction of overlaps lifts
    CHECK(now < energy + 1e-3 * kBalls * kBallMass * kSceneGravity * kBall);
    energy = std::min(energy, now);
  }
  // 1 % of their size
  CHECK(FindDeepest(world, kBalls) < 0.02 * kBall);
  int moving = 0;
  for (int i = 0; i < kBalls; ++i) {
    moving += ModelOf(world, Name(i)).GetVelocity().Length() > 0.02 ? 1 : 0;
  }
  // one may still roll about on the top
  CHECK(moving <= 1);
}

TEST_CASE("rigid stack: equal bit by bit for any number of threads", "[contract][engine][rigid]") {
  const auto run = [](UInt32 threads) {
    std::string arena;
    for (int i = 0; i < 120; ++i) {
      arena += SBoxXml{Name(i), CVector3(0.2, 0.2, 0.1),
                       CVector3(0.5 * (i % 20), 0.01 * (i % 3), 0.101 * (i / 20)),
                       CVector3(10.0 * i, 0, 0), 0.5}
                   .ToXml();
    }
    CRigidScene world(GroundedEngine("sleep='false'"), arena, threads);
    return RecordDigests(world, 15);
  };
  const std::vector<UInt64> expected = run(0);
  CHECK(run(1) == expected);
  CHECK(run(4) == expected);
}

}  // namespace argos::rigid_stack_test
