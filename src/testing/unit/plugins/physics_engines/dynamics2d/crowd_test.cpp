// Discs that touch each other and immovable things, against the laws of mechanics.

#include "planar_scene.h"

#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <deque>

namespace argos::dynamics2d_crowd_test {

namespace {

constexpr Real kPath = 0.05;  // m, longest of a tick

/** Robots of 0.5 kg and radius 5 cm, with drives of 1 N and 1 N m unless they are weakened. */
struct SCrowdScene : CPlanarScene {
  std::deque<SDrivenKind> Kinds;

  /** Gives a robot constants of its own, to be changed. */
  SDrivenKind& MakeKind(SDrivenBody& body) {
    SDrivenKind& kind = Kinds.emplace_back(*body.Kind);
    body.Kind = &kind;
    return kind;
  }
  /** Robots without a drive. */
  void DisableDrives() {
    for (SDrivenBody& body : Store.GetDriven()) {
      SDrivenKind& kind = MakeKind(body);
      kind.MaxSpeedChange = kind.MaxYawRateChange = 0.0;
    }
  }
  void Tick() {
    for (SDrivenBody& body : Store.GetDriven()) {
      Plan(body);
      if (body.Kind->MaxSpeedChange == 0.0) {
        // without a drive
        body.NextVelocity = body.Velocity;
        body.NextPose = body.Pose;
        body.NextPose.X += body.Velocity.X * kTick;
        body.NextPose.Y += body.Velocity.Y * kTick;
      }
    }
    if (Store.HaveObstaclesChanged()) {
      Pairs.SetObstacles(Store.ListObstacles());
      Crowd.ForgetObstacles();
    }
    StartCrowd(kPath);
    Crowd.Advance(Pool, Pairs, kPath, kPath);
    for (SDrivenBody& body : Store.GetDriven()) {
      body.Pose = body.NextPose;
      body.Velocity = body.NextVelocity;
      body.Command = body.NextCommand;
    }
  }
  SPlanarVelocity SumMomentum() {
    SPlanarVelocity sum;
    for (const SDrivenBody& body : Store.GetDriven()) {
      sum.X += body.Kind->Mass * body.Velocity.X;
      sum.Y += body.Kind->Mass * body.Velocity.Y;
      sum.W += body.Kind->Inertia * body.Velocity.W +
               body.Kind->Mass * (body.Pose.X * body.Velocity.Y - body.Pose.Y * body.Velocity.X);
    }
    return sum;
  }
  Real SumEnergy() {
    Real sum = 0.0;
    for (const SDrivenBody& body : Store.GetDriven()) {
      sum += 0.5 * body.Kind->Mass *
                 (body.Velocity.X * body.Velocity.X + body.Velocity.Y * body.Velocity.Y) +
             0.5 * body.Kind->Inertia * body.Velocity.W * body.Velocity.W;
    }
    return sum;
  }
  Real GapBetween(size_t a, size_t b) {
    const SPlanarPose& first = Store.GetDriven()[a].Pose;
    const SPlanarPose& second = Store.GetDriven()[b].Pose;
    return std::hypot(second.X - first.X, second.Y - first.Y) - 2.0 * kRadius;
  }
};

}  // namespace

TEST_CASE("crowd: discs without drives keep their momentum and gain no energy",
          "[dynamics2d][crowd]") {
  SCrowdScene scene;
  // hits two at rest, off their centres
  scene.AddRobot(0.0, 0.0);
  scene.AddRobot(0.11, 0.03);
  scene.AddRobot(0.20, -0.02);
  scene.DisableDrives();
  scene.GetDriven(scene.Bodies[0]).Velocity = {0.4, 0.05, 1.0};
  const SPlanarVelocity before = scene.SumMomentum();
  Real energy = scene.SumEnergy();
  for (int tick = 0; tick < 10; ++tick) {
    scene.Tick();
    const SPlanarVelocity after = scene.SumMomentum();
    CHECK(after.X == Approx(before.X).margin(1e-6));
    CHECK(after.Y == Approx(before.Y).margin(1e-6));
    // a push acts at the point of contact at the start of a substep, 2 cm before it at most
    CHECK(after.W == Approx(before.W).margin(1e-3));
    CHECK(scene.SumEnergy() <= energy + 1e-7);
    energy = scene.SumEnergy();
  }
  CHECK(scene.GetDriven(scene.Bodies[1]).Velocity.X > 0.05);
  CHECK(std::abs(scene.GetDriven(scene.Bodies[1]).Velocity.W) > 0.01);
}

TEST_CASE("crowd: two discs that collide head-on go on together", "[dynamics2d][crowd]") {
  SCrowdScene scene;
  scene.AddRobot(0.0, 0.0);
  scene.AddRobot(0.13, 0.0);
  scene.DisableDrives();
  scene.GetDriven(scene.Bodies[0]).Velocity = {0.4, 0.0, 0.0};
  scene.GetDriven(scene.Bodies[1]).Velocity = {-0.1, 0.0, 0.0};
  for (int tick = 0; tick < 4; ++tick) {
    scene.Tick();
    CHECK(scene.GapBetween(0, 1) >= -1e-4 * CPlanarScene::kRadius);
  }
  for (const auto& robot : scene.Bodies) {
    CHECK(scene.GetDriven(robot).Velocity.X == Approx(0.15).margin(1e-4));
    CHECK(scene.GetDriven(robot).Velocity.Y == 0.0);
  }
}

TEST_CASE("crowd: robots that push against each other equally stand still", "[dynamics2d][crowd]") {
  SCrowdScene scene;
  scene.AddRobot(0.0, 0.0, 0.3, 0.3);
  scene.AddRobot(0.11, 0.0, -0.3, -0.3);
  for (int tick = 0; tick < 30; ++tick) {
    scene.Tick();
  }
  CHECK(scene.GapBetween(0, 1) == Approx(0.0).margin(2e-3 * CPlanarScene::kRadius));
  CHECK(scene.GetDriven(scene.Bodies[0]).Velocity.X == Approx(0.0).margin(1e-3));
  // 1 N against 1 N: neither moves from the middle
  CHECK(scene.GetDriven(scene.Bodies[0]).Pose.X == Approx(0.055 - 0.05).margin(1e-3));
}

TEST_CASE("crowd: a stronger robot pushes a weaker one at the speed of its wheels",
          "[dynamics2d][crowd]") {
  SCrowdScene scene;
  scene.AddRobot(0.0, 0.0, 0.1, 0.1);
  scene.AddRobot(0.11, 0.0);  // brakes
  scene.MakeKind(scene.GetDriven(scene.Bodies[1])).MaxSpeedChange *= 0.5;
  for (int tick = 0; tick < 30; ++tick) {
    scene.Tick();
  }
  CHECK(scene.GetDriven(scene.Bodies[0]).Velocity.X == Approx(0.1).margin(1e-3));
  CHECK(scene.GetDriven(scene.Bodies[1]).Velocity.X == Approx(0.1).margin(1e-3));

  // and not a robot whose brake is stronger than the drive
  scene.MakeKind(scene.GetDriven(scene.Bodies[1])).MaxSpeedChange *= 2.5;
  const Real x = scene.GetDriven(scene.Bodies[1]).Pose.X;
  for (int tick = 0; tick < 30; ++tick) {
    scene.Tick();
  }
  CHECK(scene.GetDriven(scene.Bodies[1]).Pose.X - x < 0.02);
  CHECK(scene.GetDriven(scene.Bodies[1]).Velocity.X == Approx(0.0).margin(1e-3));
}

TEST_CASE("crowd: a row presses on a wall, and the last does not move", "[dynamics2d][crowd]") {
  SCrowdScene scene;
  const int length = GENERATE(1, 5, 20);
  CAPTURE(length);
  scene.AddBox(0.0, 0.0, false);
  for (int i = 0; i < length; ++i) {
    scene.AddRobot(-0.1 - 0.105 * i, 0.0, 0.2, 0.2);
  }
  for (int tick = 0; tick < 20 + 10 * length; ++tick) {
    scene.Tick();
    CHECK(-0.05 - scene.Store.GetDriven()[0].Pose.X >= CPlanarScene::kRadius * (1.0 - 0.005));
    for (int i = 1; i < length; ++i) {
      REQUIRE(scene.GapBetween(i - 1, i) >= -0.02 * CPlanarScene::kRadius);
    }
  }
  // The velocity of a contact is solved up to 0.1 % of a radius in a substep, 1 mm/s, and that of a
  // robot is the sum over the contacts ahead of it; wheels turn at 200 mm/s.
  for (const SDrivenBody& body : scene.Store.GetDriven()) {
    CHECK(std::abs(body.Velocity.X) < 1e-3 * length);
  }
}

TEST_CASE("crowd: friction at a wall is 0.07 of the pressing force", "[dynamics2d][crowd]") {
  // the heading of the robot is 45 degrees from the wall; friction shortens the step along it
  SCrowdScene scene;
  auto& robot = scene.AddRobot(-0.1, 0.0, 0.2, 0.2);
  for (int i = -5; i <= 5; ++i) {
    scene.AddBox(0.0, 0.1 * i, false);
  }
  scene.GetDriven(robot).Pose.SetYaw(0.25 * ARGOS_PI);
  scene.MakeKind(scene.GetDriven(robot)).MaxYawRateChange = 1e3;  // keeps its heading
  for (int tick = 0; tick < 20; ++tick) {
    scene.Tick();
  }
  // The drive exerts its 1 N along the velocity that is missing, (target, target - v_y). This force
  // is in balance with that of the wall, (f, 0.07 f).
  const SDrivenBody& body = scene.GetDriven(robot);
  const Real target = 0.2 * std::sqrt(0.5);
  CHECK(body.Velocity.X == Approx(0.0).margin(1e-4));
  CHECK(body.Velocity.Y < target);
  CHECK(body.Velocity.Y == Approx(target * (1.0 - 0.07)).margin(2e-3));
}

TEST_CASE("crowd: robots that were placed into each other part without speed",
          "[dynamics2d][crowd]") {
  SCrowdScene scene;
  scene.AddRobot(0.0, 0.0);
  scene.AddRobot(0.05, 0.0);
  scene.Crowd.ExpectOverlaps();
  Real last = -1.0;
  for (int tick = 0; tick < 20; ++tick) {
    scene.Tick();
    const Real gap = scene.GapBetween(0, 1);
    CHECK(gap >= last);
    last = gap;
  }
  CHECK(last == Approx(0.0).margin(0.006 * CPlanarScene::kRadius));
  CHECK(std::abs(scene.GetDriven(scene.Bodies[0]).Velocity.X) < 1e-2);
}

TEST_CASE("crowd: a robot that nothing pushes ends exactly at its planned pose",
          "[dynamics2d][crowd]") {
  SCrowdScene scene;
  scene.AddRobot(0.0, 0.0, 0.10, 0.08);
  scene.AddRobot(0.0, 0.14, 0.2, 0.2);  // near, but passes
  for (int tick = 0; tick < 3; ++tick) {
    const SDrivenBody& body = scene.Store.GetDriven()[0];
    const SArc arc = FollowArc(body.Pose, body.Drive.Read(), CPlanarScene::kTick);
    scene.Tick();
    CHECK(scene.Store.GetDriven()[0].Pose.X == arc.End.X);
    CHECK(scene.Store.GetDriven()[0].Pose.HalfSin == arc.End.HalfSin);
  }
}

TEST_CASE("crowd: a disc moves no farther in a tick than the longest path", "[dynamics2d][crowd]") {
  // 3 m/s against a robot at rest are 1.5 m/s of both; the longest path allows 0.5 m/s
  SCrowdScene scene;
  scene.AddRobot(0.0, 0.0);
  scene.AddRobot(0.1, 0.0);
  scene.DisableDrives();
  scene.GetDriven(scene.Bodies[0]).Velocity = {3.0, 0.0, 0.0};
  scene.Tick();
  for (size_t i = 0; i < 2; ++i) {
    const SDrivenBody& body = scene.Store.GetDriven()[i];
    CHECK(body.Velocity.X == Approx(kPath / CPlanarScene::kTick).epsilon(1e-5));
    CHECK(body.Pose.X - 0.1 * static_cast<Real>(i) == Approx(kPath).epsilon(1e-5));
  }
}

TEST_CASE("crowd: the path to leave an overlap is at most half a radius", "[dynamics2d][crowd]") {
  // A pile so deep that a tick does not resolve it. In the next one, all are at the greatest speed.
  SCrowdScene scene;
  for (int i = 0; i < 100; ++i) {
    scene.AddRobot(1e-3 * (i % 10), 1e-3 * (i / 10));
  }
  scene.DisableDrives();
  scene.Tick();
  REQUIRE(scene.Crowd.GetAllowance() == Approx(0.5 * CPlanarScene::kRadius));
  for (SDrivenBody& body : scene.Store.GetDriven()) {
    body.Velocity = {6.0, 0.0, 0.0};
  }
  scene.Tick();
  Real fastest = 0.0;
  for (const SDrivenBody& body : scene.Store.GetDriven()) {
    fastest = std::max(fastest, std::hypot(body.Velocity.X, body.Velocity.Y));
  }
  CHECK(fastest ==
        Approx((kPath + 0.5 * CPlanarScene::kRadius) / CPlanarScene::kTick).epsilon(1e-5));
}

TEST_CASE("crowd: a drive that presses exerts its impulse once in a tick", "[dynamics2d][crowd]") {
  // two robots in contact, the second without a drive, which adds no momentum
  SCrowdScene scene;
  scene.AddRobot(0.0, 0.0, 0.3, 0.3);
  scene.AddRobot(0.1, 0.0);
  scene.DisableDrives();
  SDrivenBody& pusher = scene.GetDriven(scene.Bodies[0]);
  scene.MakeKind(pusher).MaxSpeedChange = 0.02;
  for (int tick = 1; tick <= 5; ++tick) {
    scene.Tick();
    CHECK(scene.SumMomentum().X == Approx(pusher.Kind->Mass * 0.02 * tick).epsilon(1e-4));
  }
}

TEST_CASE("crowd: a drive that has used its impulse before an impact adds none to it",
          "[dynamics2d][crowd]") {
  // It reaches its speed at the start of the tick, and hits the other one in the second substep.
  // The other one wants to turn so fast that there are four, but has no torque.
  const bool areFour = GENERATE(false, true);
  CAPTURE(areFour);
  SCrowdScene scene;
  const Real turn = areFour ? 0.8 : 0.0;
  scene.AddRobot(0.0, 0.0, 0.2, 0.2);
  scene.AddRobot(areFour ? 0.109 : 0.111, 0.0, -turn, turn);
  SDrivenBody& pusher = scene.GetDriven(scene.Bodies[0]);
  scene.MakeKind(pusher).MaxSpeedChange = 0.2;
  SDrivenKind& weak = scene.MakeKind(scene.GetDriven(scene.Bodies[1]));
  weak.MaxSpeedChange = weak.MaxYawRateChange = 1e-9;
  scene.Tick();
  CHECK(scene.GetDriven(scene.Bodies[1]).Velocity.X > 0.05);
  CHECK(scene.SumMomentum().X == Approx(pusher.Kind->Mass * 0.2).epsilon(1e-4));
}

TEST_CASE("crowd: a drive that touches nothing uses its impulse and torque once in a tick",
          "[dynamics2d][crowd]") {
  // both are far below what the wheels want; an impact in the third of four substeps, as above,
  // makes the result of the tick count
  SCrowdScene scene;
  scene.AddRobot(0.0, 0.0, 0.0, 0.4);
  scene.AddRobot(0.1022, 0.0, -0.8, 0.8);
  SDrivenBody& pusher = scene.GetDriven(scene.Bodies[0]);
  SDrivenKind& kind = scene.MakeKind(pusher);
  kind.MaxSpeedChange = 0.04;
  kind.MaxYawRateChange = 1.0;
  SDrivenKind& weak = scene.MakeKind(scene.GetDriven(scene.Bodies[1]));
  weak.MaxSpeedChange = weak.MaxYawRateChange = 1e-9;
  scene.Tick();
  REQUIRE(scene.GetDriven(scene.Bodies[1]).Velocity.X > 0.001);
  CHECK(std::hypot(scene.SumMomentum().X, scene.SumMomentum().Y) ==
        Approx(kind.Mass * 0.04).epsilon(1e-3));
  // friction at the impact takes at most 0.4 rad/s
  CHECK(pusher.Velocity.W == Approx(0.8).margin(0.25));
}

TEST_CASE("crowd: a drive that has used its torque before an impact adds none to it",
          "[dynamics2d][crowd]") {
  // as above, with four substeps; it rolls so slowly that the friction of the impact takes 2 %
  SCrowdScene scene;
  scene.AddRobot(0.0, 0.0, 0.01 - 0.2, 0.01 + 0.2);
  scene.AddRobot(0.10035, 0.0, -0.8, 0.8);
  SDrivenKind& kind = scene.MakeKind(scene.GetDriven(scene.Bodies[0]));
  kind.MaxSpeedChange = 0.01;
  kind.MaxYawRateChange = 5.0;  // rad/s, just enough
  SDrivenKind& weak = scene.MakeKind(scene.GetDriven(scene.Bodies[1]));
  weak.MaxSpeedChange = weak.MaxYawRateChange = 1e-9;
  scene.Tick();
  CHECK(scene.GetDriven(scene.Bodies[1]).Velocity.X > 0.001);
  CHECK(scene.GetDriven(scene.Bodies[0]).Velocity.W == Approx(4.95).margin(0.06));
}

TEST_CASE("crowd: friction between discs is 0.49 of the pressing impulse", "[dynamics2d][crowd]") {
  SCrowdScene scene;
  scene.AddRobot(0.0, 0.0);
  scene.AddRobot(0.1, 0.0);
  scene.DisableDrives();
  const Real turn = GENERATE(200.0, -200.0);  // rad/s: the rims slip for the whole impact
  scene.GetDriven(scene.Bodies[0]).Velocity = {0.2, 0.0, turn};
  scene.Tick();
  const SDrivenBody& hit = scene.GetDriven(scene.Bodies[1]);
  CHECK(hit.Velocity.X == Approx(0.1).epsilon(1e-3));
  CHECK(hit.Velocity.Y == Approx(std::copysign(0.49 * hit.Velocity.X, turn)).epsilon(1e-3));
}

TEST_CASE("crowd: discs leave a deep overlap with a quarter of a radius in a tick",
          "[dynamics2d][crowd]") {
  constexpr Real kSpeed = 0.25 * CPlanarScene::kRadius / CPlanarScene::kTick;  // m/s
  SCrowdScene scene;
  const bool isWall = GENERATE(false, true);
  CAPTURE(isWall);
  // 4 cm deep, of which 60 % would be more than that
  if (isWall) {
    scene.AddBox(0.0, 0.0, false);
    scene.AddRobot(0.06, 0.0);
  } else {
    scene.AddRobot(0.0, 0.0);
    scene.AddRobot(0.06, 0.0);
  }
  scene.DisableDrives();
  scene.Tick();
  const SDrivenBody& leaving = scene.Store.GetDriven().back();
  CHECK(leaving.Velocity.X == Approx(isWall ? kSpeed : 0.5 * kSpeed).epsilon(1e-3));
}

TEST_CASE("crowd: a drive that presses exerts its torque once in a tick", "[dynamics2d][crowd]") {
  // the touch is so slight that its friction is a thousandth of the torque
  SCrowdScene scene;
  scene.AddRobot(0.0, 0.0, -0.2, 0.2);
  scene.AddRobot(0.1, 0.0);
  scene.DisableDrives();
  SDrivenBody& turning = scene.GetDriven(scene.Bodies[0]);
  turning.Velocity = {1e-4, 0.0, 0.0};
  SDrivenKind& kind = scene.MakeKind(turning);
  kind.MaxSpeedChange = 1e-9;
  kind.MaxYawRateChange = 1.0;
  scene.Tick();
  REQUIRE(scene.GetDriven(scene.Bodies[1]).Velocity.X > 0.0);
  CHECK(turning.Velocity.W == Approx(1.0).epsilon(5e-3));
}

}  // namespace argos::dynamics2d_crowd_test
