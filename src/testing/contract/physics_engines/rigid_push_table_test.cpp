// The table of doc/internals/accuracy.md on pushing in dynamics3d, by the number of substeps.

#include <argos3/testing/contract/physics_engines/rigid_scene.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>

namespace argos::rigid_push_table_test {

namespace {

constexpr Real kRadius = 0.085036758;  // m, of a foot-bot
constexpr Real kForce = 0.8 * 1.6 * kSceneGravity;  // N, the weight on its wheels
constexpr Real kBeside = 0.1 + 0.005 + kRadius;  // m, of a robot from the middle of a box

std::string Number(const std::string& id, int number) {
  return id + std::to_string(number);
}

std::string Robot(const std::string& id, Real x, Real y, Real yaw) {
  return DriverXml("foot-bot", id, x, y, yaw, 10.0, 10.0);
}

CRigidScene MakeScene(UInt32 iterations, const std::string& arena) {
  return CRigidScene(GroundedEngine("iterations='" + std::to_string(iterations) + "'"), arena);
}

// Robots side by side push a box whose weight is that share of their force. @return its way in
// 10 s, m.
Real PushBox(UInt32 iterations, int count, Real share) {
  std::string arena =
      SBoxXml{"b", CVector3(0.2, 0.2 * count, 0.1), {}, {}, share * count * kForce / kSceneGravity}
          .ToXml();
  for (int i = 0; i < count; ++i) {
    arena += Robot(Number("r", i), -kBeside, 0.2 * (i - 0.5 * (count - 1)), 0.0);
  }
  CRigidScene world = MakeScene(iterations, arena);
  world.Step(100);
  return world.Position("b").GetX();
}

// A robot pushes a row of boxes whose weight is that share of its force. @return the speed of the
// last one, m/s.
Real PushRow(UInt32 iterations, int count, Real share) {
  std::string arena = Robot("r", -kBeside, 0.0, 0.0);
  for (int i = 0; i < count; ++i) {
    arena += SBoxXml{Number("b", i),
                     CVector3(0.2, 0.2, 0.1),
                     CVector3(0.202 * i, 0.0, 0.0),
                     {},
                     share * kForce / kSceneGravity / count}
                 .ToXml();
  }
  CRigidScene world = MakeScene(iterations, arena);
  const std::string last = Number("b", count - 1);
  world.Step(60);
  const Real before = world.Position(last).GetX();
  world.Step(20);
  return 0.5 * (world.Position(last).GetX() - before);
}

// Two robots against two, or three. @return the speed of a box between them, m/s.
Real Balance(UInt32 iterations, int against, Real mass) {
  std::string arena = SBoxXml{"b", CVector3(0.2, 0.8, 0.1), {}, {}, mass}.ToXml();
  for (int i = 0; i < 2; ++i) {
    arena += Robot(Number("left", i), -kBeside, 0.3 * (i - 0.5), 0.0);
  }
  for (int i = 0; i < against; ++i) {
    arena += Robot(Number("right", i), kBeside, 0.2 * (i - 0.5 * (against - 1)), 180.0);
  }
  CRigidScene world = MakeScene(iterations, arena);
  world.Step(30);
  const Real before = world.Position("b").GetX();
  world.Step(20);
  return 0.5 * (before - world.Position("b").GetX());
}

// Two robots turn a bar, whose friction torque is 1/4 of its weight times its length. @return by
// how much in 6 s, rad.
Real TurnBar(UInt32 iterations) {
  const Real beside = 0.05 + 0.005 + kRadius;
  CRigidScene world = MakeScene(
      iterations, SBoxXml{"b", CVector3(1.0, 0.1, 0.1), {}, {}, 60.0 / kSceneGravity}.ToXml() +
                      Robot("r0", 0.4, -beside, 90.0) + Robot("r1", -0.4, beside, -90.0));
  world.Step(60);
  return std::abs(world.Yaw("b"));
}

// Ten robots press a box against a wall. @return how deep they or the wall are in it at most, mm.
Real Squeeze(UInt32 iterations, Real mass) {
  constexpr int kRobots = 10;
  std::string arena =
      SBoxXml{"wall", CVector3(0.2, 3.0, 0.1), CVector3(0.2, 0, 0), {}, 0.0}.ToXml() +
      SBoxXml{"b", CVector3(0.2, 2.0, 0.1), {}, {}, mass}.ToXml();
  for (int i = 0; i < kRobots; ++i) {
    arena += Robot(Number("r", i), -kBeside, 0.19 * (i - 0.5 * (kRobots - 1)), 0.0);
  }
  CRigidScene world = MakeScene(iterations, arena);
  Real deepest = 0.0;
  for (int tick = 0; tick < 50; ++tick) {
    world.Step();
    const Real middle = world.Position("b").GetX();
    deepest = std::max(deepest, middle);
    for (int i = 0; i < kRobots; ++i) {
      const Real front = world.Position(Number("r", i)).GetX() + kRadius;
      deepest = std::max(deepest, front - (middle - 0.1));
    }
  }
  return 1e3 * deepest;
}

void PrintRow(const std::string& scene, int digits, const std::function<Real(UInt32)>& measure) {
  std::ostringstream row;
  row << std::fixed << std::setprecision(digits) << "| " << scene;
  for (const UInt32 iterations : {1, 2, 5, 10, 50}) {
    row << " | " << measure(iterations);
  }
  WARN(row.str() << " |");
}

}  // namespace

TEST_CASE("rigid pushing: table", "[.table]") {
  for (const Real share : {0.6, 0.9, 1.1, 2.0}) {
    for (const int count : {1, 3, 10}) {
      std::ostringstream scene;
      scene << count << " foot-bots, a box of " << share << " of their force: way in 10 s, m";
      PrintRow(scene.str(), 4,
               [&](UInt32 iterations) { return PushBox(iterations, count, share); });
    }
  }
  for (const Real share : {0.9, 1.1}) {
    for (const int count : {2, 6, 9}) {
      std::ostringstream scene;
      scene << "a foot-bot, a row of " << count << " boxes of " << share << " of its force: m/s";
      PrintRow(scene.str(), 4,
               [&](UInt32 iterations) { return PushRow(iterations, count, share); });
    }
  }
  for (const int against : {2, 3}) {
    for (const Real mass : {0.05, 0.3, 1.0, 5.0}) {
      std::ostringstream scene;
      scene << against << " foot-bots against two over a box of " << mass << " kg: m/s";
      PrintRow(scene.str(), 4,
               [&](UInt32 iterations) { return Balance(iterations, against, mass); });
    }
  }
  PrintRow("two foot-bots, a couple of 10 N m on a bar with a friction torque of 15 N m: rad", 4,
           TurnBar);
  for (const Real mass : {0.01, 0.05, 0.5, 5.0}) {
    std::ostringstream scene;
    scene << "ten foot-bots squeeze a box of " << mass << " kg against a wall: depth, mm";
    PrintRow(scene.str(), 2, [&](UInt32 iterations) { return Squeeze(iterations, mass); });
  }
}

}  // namespace argos::rigid_push_table_test
