// The tables of doc/internals/accuracy.md on pushing in the engines of the plane, by the number of
// substeps.

#include <argos3/testing/contract/physics_engines/push_scene.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>

namespace argos::planar_push_table_test {

namespace {

constexpr SFriction kDefault{1.49, 1.49};
constexpr Real kGap = 0.005;  // m, before robots that have none in their row

/** An engine with a number of substeps. */
struct SSetting {
  const SEngineType& Engine;
  UInt32 Iterations;

  CDriveWorld MakeWorld(const CPushScene& scene, const SFriction& friction) const {
    return CDriveWorld(MakePushEngine(Engine, Iterations, friction), scene.GetArena());
  }
};

std::string Number(const std::string& id, int number) {
  return id + std::to_string(number);
}

// An e-puck pushes a cylinder. @return its way in 10 s, m.
Real PushCylinder(const SSetting& setting, Real mass, Real gap) {
  CPushScene scene(0.0, false);
  scene.AddRobot(kEPuck, "r", -0.1 - gap - kEPuck.Radius, 0.0, 0.0);
  scene.AddCylinder("o", 0.0, 0.0, 0.1, mass);
  CDriveWorld world = setting.MakeWorld(scene, kDefault);
  world.Step(100);
  return world.Position("o").GetX();
}

// Three foot-bots push a box of 1 kg. @return its way in 10 s, m.
Real PushBox(const SSetting& setting, Real friction) {
  CPushScene scene(0.0, false);
  for (int i = 0; i < 3; ++i) {
    scene.AddRobot(kFootBot, Number("r", i), -0.1 - kGap - kFootBot.Radius, 0.2 * (i - 1), 0.0);
  }
  scene.AddBox("o", 0.0, 0.0, 0.2, 0.6, 1.0);
  CDriveWorld world = setting.MakeWorld(scene, {friction, friction});
  world.Step(100);
  return world.Position("o").GetX();
}

// An e-puck pushes two cylinders in a row. @return the way of the last one in 10 s, m.
Real PushTwo(const SSetting& setting) {
  CPushScene scene(0.0, false);
  scene.AddRobot(kEPuck, "r", -0.1 - kGap - kEPuck.Radius, 0.0, 0.0);
  scene.AddCylinder("a", 0.0, 0.0, 0.1, 0.1);
  scene.AddCylinder("o", 0.201, 0.0, 0.1, 0.1);
  CDriveWorld world = setting.MakeWorld(scene, kDefault);
  world.Step(100);
  return world.Position("o").GetX() - 0.201;
}

// A foot-bot pushes a row of nine boxes. @return the speed of the last one, m/s.
Real PushRow(const SSetting& setting, Real friction) {
  CPushScene scene(0.0, false);
  scene.AddRobot(kFootBot, "r", -0.1 - kGap - kFootBot.Radius, 0.0, 0.0);
  for (int i = 0; i < 9; ++i) {
    scene.AddBox(Number("o", i), 0.202 * i, 0.0, 0.2, 0.2, 0.5);
  }
  CDriveWorld world = setting.MakeWorld(scene, {friction, friction});
  world.Step(60);
  const Real before = world.Position("o8").GetX();
  world.Step(20);
  return 0.5 * (world.Position("o8").GetX() - before);
}

// Two foot-bots turn a bar of 1 m. @return by how much in 6 s, rad.
Real TurnBar(const SSetting& setting) {
  const Real beside = 0.05 + kGap + kFootBot.Radius;
  CPushScene scene(0.0, false);
  scene.AddBox("o", 0.0, 0.0, 1.0, 0.1, 1.0);
  scene.AddRobot(kFootBot, "r0", 0.4, -beside, 90.0);
  scene.AddRobot(kFootBot, "r1", -0.4, beside, -90.0);
  CDriveWorld world = setting.MakeWorld(scene, {1.49, 1e6});
  world.Step(60);
  return std::abs(scene.TurnOf(world, "o"));
}

// Four e-pucks turn a box of 1 kg with 0.6 N m. @return by how much in 10 s, rad.
Real TurnBox(const SSetting& setting) {
  const Real beside = 0.1 + kGap + kEPuck.Radius;
  CPushScene scene(0.0, false);
  scene.AddBox("o", 0.0, 0.0, 0.4, 0.2, 1.0);
  for (int i = 0; i < 2; ++i) {
    const Real along = i == 0 ? 0.06 : 0.14;
    scene.AddRobot(kEPuck, Number("a", i), along, -beside, 90.0);
    scene.AddRobot(kEPuck, Number("b", i), -along, beside, -90.0);
  }
  CDriveWorld world = setting.MakeWorld(scene, kDefault);
  world.Step(100);
  return std::abs(scene.TurnOf(world, "o"));
}

// Ten foot-bots press a box against a wall. @return how deep they or the wall are in it, mm.
Real Squeeze(const SSetting& setting, Real mass) {
  constexpr int kRobots = 10;
  CPushScene scene(0.0, false);
  scene.AddBox("wall", 0.2, 0.0, 0.2, 3.0, 0.0);
  scene.AddBox("o", 0.0, 0.0, 0.2, 2.0, mass);
  for (int i = 0; i < kRobots; ++i) {
    scene.AddRobot(kFootBot, Number("r", i), -0.11 - kFootBot.Radius,
                   0.19 * (i - 0.5 * (kRobots - 1)), 0.0);
  }
  CDriveWorld world = setting.MakeWorld(scene, kDefault);
  Real deepest = 0.0;
  for (int tick = 0; tick < 50; ++tick) {
    world.Step();
    const Real middle = world.Position("o").GetX();
    deepest = std::max(deepest, middle);
    for (int i = 0; i < kRobots; ++i) {
      const Real front = world.Position(Number("r", i)).GetX() + kFootBot.Radius;
      deepest = std::max(deepest, front - (middle - 0.1));
    }
  }
  return 1e3 * deepest;
}

// Two foot-bots face to face over a cylinder. @return its speed, m/s.
Real Face(const SSetting& setting, Real mass) {
  const Real beside = 0.1 + kGap + kFootBot.Radius;
  CPushScene scene(0.0, false);
  scene.AddCylinder("o", 0.0, 0.0, 0.1, mass);
  scene.AddRobot(kFootBot, "r0", -beside, 0.0, 0.0);
  scene.AddRobot(kFootBot, "r1", beside, 0.0, 180.0);
  CDriveWorld world = setting.MakeWorld(scene, kDefault);
  world.Step(30);
  const Real before = world.Position("o").GetX();
  world.Step(20);
  return 0.5 * std::abs(world.Position("o").GetX() - before);
}

// Three foot-bots against two over a box. @return its speed, m/s.
Real Balance(const SSetting& setting, Real mass) {
  const Real beside = 0.1 + kGap + kFootBot.Radius;
  CPushScene scene(0.0, false);
  scene.AddBox("o", 0.0, 0.0, 0.2, 0.8, mass);
  for (int i = 0; i < 2; ++i) {
    scene.AddRobot(kFootBot, Number("left", i), -beside, 0.3 * (i - 0.5), 0.0);
  }
  for (int i = 0; i < 3; ++i) {
    scene.AddRobot(kFootBot, Number("right", i), beside, 0.2 * (i - 1), 180.0);
  }
  CDriveWorld world = setting.MakeWorld(scene, kDefault);
  world.Step(30);
  const Real before = world.Position("o").GetX();
  world.Step(20);
  return 0.5 * (before - world.Position("o").GetX());
}

// A foot-bot pushes a box beside its middle for 3.5 s. @return how far it is from its place with 50
// substeps, mm.
Real PushAskew(const SSetting& setting) {
  const auto place = [&](UInt32 iterations) {
    CPushScene scene(0.0, false);
    scene.AddBox("o", 0.0, 0.0, 0.2, 0.5, 1.0);
    scene.AddRobot(kFootBot, "r", -0.2, 0.12, 0.0);
    CDriveWorld world = SSetting{setting.Engine, iterations}.MakeWorld(scene, {4.0, 0.3});
    world.Step(35);
    return world.Position("o");
  };
  return 1e3 * Distance(place(setting.Iterations), place(50));
}

void PrintRow(const SEngineType& engine, const std::string& scene,
              const std::function<Real(const SSetting&)>& measure) {
  std::printf("%s | %s", engine.Tag.c_str(), scene.c_str());
  for (const UInt32 iterations : {1U, 2U, 5U, 10U, 50U}) {
    std::printf(" | %.4f", measure({engine, iterations}));
  }
  std::printf("\n");
}

}  // namespace

TEST_CASE("planar pushing: table", "[.][table]") {
  for (const SEngineType& engine : {kDynamics2D, kKinematics2D}) {
    for (const auto& [mass, gap] : {std::pair(0.5, 0.02), std::pair(2.0, 0.02),
                                    std::pair(2.0, 0.023), std::pair(5.0, 0.02)}) {
      PrintRow(engine,
               "an e-puck, " + std::to_string(gap) + " m from a cylinder of " +
                   std::to_string(mass) + " kg: way in 10 s, m",
               [mass = mass, gap = gap](const SSetting& setting) {
                 return PushCylinder(setting, mass, gap);
               });
    }
    for (const Real friction : {30.0, 46.0, 300.0, 1e6}) {
      PrintRow(engine,
               "three foot-bots, a box of 1 kg, " + std::to_string(friction) + " N: way in 10 s, m",
               [=](const SSetting& setting) { return PushBox(setting, friction); });
    }
    PrintRow(engine, "an e-puck, two cylinders of 0.1 kg in a row: way, m", PushTwo);
    PrintRow(engine, "two foot-bots, a couple of 12 N m on a bar, 10^6 N m: rad", TurnBar);
    PrintRow(engine, "four e-pucks, a couple of 0.6 N m on a box: rad", TurnBox);
    for (const Real mass : {0.01, 0.5}) {
      PrintRow(engine, "ten foot-bots squeeze a box of " + std::to_string(mass) + " kg: mm",
               [=](const SSetting& setting) { return Squeeze(setting, mass); });
    }
    for (const Real share : {0.87, 1.1}) {
      PrintRow(engine, "a foot-bot, nine boxes of " + std::to_string(share) + " of its force: m/s",
               [=](const SSetting& setting) { return PushRow(setting, share * 15.0 / 9.0); });
    }
    for (const Real mass : {0.01, 0.3, 5.0}) {
      PrintRow(engine, "face to face over a cylinder of " + std::to_string(mass) + " kg: m/s",
               [=](const SSetting& setting) { return Face(setting, mass); });
    }
    for (const Real mass : {0.1, 1.0}) {
      PrintRow(engine, "three against two over a box of " + std::to_string(mass) + " kg: m/s",
               [=](const SSetting& setting) { return Balance(setting, mass); });
    }
    PrintRow(engine, "a foot-bot, a box beside its middle: place against 50 substeps, mm",
             PushAskew);
  }
}

}  // namespace argos::planar_push_table_test
