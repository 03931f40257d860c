#include "planar_scene.h"

#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_grips.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_world.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace argos::planar_grips_test {

namespace {

/** Robots with grippers that reach 1 cm out of their circle, ahead. */
struct SGripScene : CPlanarScene {
  CPlanarGrips Grips{Store};
  std::deque<CGripperEquippedEntity> Grippers;
  std::deque<SAnchor> Anchors;
  std::deque<CTurretEntity> Turrets;

  SBody& AddGripper(Real x, Real y, const SBodyDescription& description = DescribeRobot()) {
    SBody& body = AddRobot(x, y, 0.0, 0.0, description);
    CGripperEquippedEntity& gripper = Grippers.emplace_back(nullptr);
    gripper.SetOffset(CVector3(kRadius, 0.0, 0.0));
    Grips.SetManipulator(body.GetOwner(), description, &gripper, nullptr);
    return body;
  }
  /** A robot with a gripper and a turret of a speed, rad/s, which no gripper can grip. */
  SBody& AddTurret(Real x, Real y, Real speed) {
    SBodyDescription description = DescribeRobot();
    description.Grippable = false;
    description.Turret = STurretDescription{0.1, 1e-4, 1.0, 0.0};
    SBody& body = AddGripper(x, y, description);
    SAnchor& anchor = Anchors.emplace_back(body.Entity, "turret", 1, CVector3(), CQuaternion(),
                                           CVector3(), CQuaternion());
    CTurretEntity& turret =
        Turrets.emplace_back(nullptr, "turret", anchor, SControlGains{0.4, 0.2});
    turret.SetMode(CTurretEntity::MODE_SPEED_CONTROL);
    turret.SetDesiredRotationSpeed(speed);
    Grips.SetManipulator(body.GetOwner(), description, &Grippers.back(), &turret);
    return body;
  }
  /** Locks all grippers, and starts a tick. */
  void Lock() {
    for (CGripperEquippedEntity& gripper : Grippers) {
      gripper.SetLockState(1.0);
    }
    Grips.StartTick();
    MakeGrips();
  }
  void MakeGrips() {
    StartCrowd(0.01);
    Grips.MakeGrips(Pairs, Crowd.GetSolids());
  }
};

}  // namespace

TEST_CASE("planar grips: a locked gripper grips the body in its reach", "[dynamics2d][grip]") {
  SGripScene scene;
  auto& robot = scene.AddGripper(0.0, 0.0);
  auto& near = scene.AddBox(0.105, 0.0, true);  // 5 mm ahead
  const auto& far = scene.AddBox(0.0, 0.3, true);

  scene.Grips.StartTick();
  scene.MakeGrips();
  CHECK_FALSE(scene.Grips.IsHoldingAny());  // not locked

  scene.Grippers[0].SetLockState(1.0);
  scene.Grips.StartTick();
  scene.MakeGrips();
  REQUIRE(scene.Grips.IsHoldingAny());
  CHECK(&scene.Grippers[0].GetGrippedEntity() == &near.Entity);
  CHECK(scene.Grips.IsInGrip(robot.Handle));
  CHECK(scene.Grips.IsInGrip(near.Handle));
  CHECK_FALSE(scene.Grips.IsInGrip(far.Handle));
  CHECK(scene.GetDriven(robot).NumGrips == 1);
  CHECK(scene.GetPassive(near).NumGrips == 1);
}

TEST_CASE("planar grips: a gripper does not grip beyond its reach", "[dynamics2d][grip]") {
  SGripScene scene;
  scene.AddGripper(0.0, 0.0);
  scene.AddBox(0.112, 0.0, true);
  scene.Lock();
  CHECK_FALSE(scene.Grips.IsHoldingAny());
}

TEST_CASE("planar grips: unlocking releases the body", "[dynamics2d][grip]") {
  SGripScene scene;
  const auto& robot = scene.AddGripper(0.0, 0.0);
  const auto& box = scene.AddBox(0.105, 0.0, true);
  scene.Lock();
  scene.Grippers[0].SetLockState(0.0);
  scene.Grips.StartTick();
  CHECK_FALSE(scene.Grips.IsHoldingAny());
  CHECK_FALSE(scene.Grippers[0].IsGripping());
  CHECK(scene.GetDriven(robot).NumGrips == 0);
  CHECK(scene.GetPassive(box).NumGrips == 0);
  CHECK(scene.GetPassive(box).WasReleased);
}

TEST_CASE("planar grips: the held body follows, and an overloaded grip breaks",
          "[dynamics2d][grip]") {
  const bool isWeak = GENERATE(false, true);
  CAPTURE(isWeak);
  CPlanarScene scene;  // owns the bodies only
  CPlanarWorld world(CPlanarScene::MakeSettings());
  SBodyDescription description = CPlanarScene::DescribeRobot();
  description.Drive->MaxForce = 5.0;
  description.Gripper->MaxForce = isWeak ? 0.1 : 100.0;
  // its friction on the ground is 1.49 N
  SBodyDescription load;
  load.Shapes.push_back(SShapeDescription::Box(CVector3(0.1, 0.1, 0.1)));
  load.Mass = 0.5;
  load.GroundFriction = SGroundFrictionDescription();
  load.Grippable = true;
  const std::array<Real, 2> wheels{-0.1, -0.1};
  auto& robot = scene.Bodies.emplace_back("robot");
  auto& box = scene.Bodies.emplace_back("box");
  world.AddDriven(robot.GetOwner(), description, CPlanarScene::PoseAt(0.0, 0.0),
                  CDriveSource(wheels.data(), 0.08));
  world.AddPassive(box.GetOwner(), load, CPlanarScene::PoseAt(0.105, 0.0));
  CGripperEquippedEntity gripper(nullptr);
  gripper.SetOffset(CVector3(CPlanarScene::kRadius, 0.0, 0.0));
  gripper.SetLockState(1.0);
  world.GetGrips().SetManipulator(robot.GetOwner(), description, &gripper, nullptr);
  CThreadPool pool(0, std::make_unique<CBalanceQuantitySchedule>());
  world.Advance(pool);
  world.CommitDriven(0, 1, [](const SDrivenBody&, size_t) {});
  CHECK(world.GetGrips().IsHoldingAny() == !isWeak);
  if (isWeak) {
    gripper.SetLockState(0.0);
  }
  for (int i = 0; i < 9; ++i) {
    world.Advance(pool);
    world.CommitDriven(0, 1, [](const SDrivenBody&, size_t) {});
  }
  // 1 cm a tick, as long as it is held
  const Real expected = 0.105 - (isWeak ? 0.01 : 0.1);
  world.ForEachPassive(
      [&](const SPassiveBody& body) { CHECK(body.Pose.X == Approx(expected).margin(2e-3)); });
}

TEST_CASE("planar grips: removing a body ends its grips only", "[dynamics2d][grip]") {
  SGripScene scene;
  scene.AddGripper(0.0, 0.0);
  const auto& box = scene.AddBox(0.105, 0.0, true);
  auto& second = scene.AddGripper(0.0, 1.0);
  scene.AddBox(0.105, 1.0, true);
  scene.Lock();
  scene.Grips.Remove(box.Handle);
  CHECK_FALSE(scene.Grippers[0].IsGripping());
  CHECK(scene.Grippers[1].IsGripping());
  scene.Grips.Remove(second.Handle);
  CHECK_FALSE(scene.Grips.IsHoldingAny());
  CHECK_FALSE(scene.GetDriven(second).HasManipulator);
}

TEST_CASE("planar grips: a cluster is transferred with its grips", "[dynamics2d][grip]") {
  SGripScene scene;
  // the first robot holds the second one, which holds a box; the third robot is apart
  auto& first = scene.AddGripper(0.0, 0.0);
  auto& second = scene.AddGripper(0.105, 0.0);
  auto& box = scene.AddBox(0.21, 0.0, true);
  auto& third = scene.AddGripper(0.0, 1.0);
  scene.Lock();
  REQUIRE(scene.Grips.IsInGrip(box.Handle));

  std::vector<CEmbodiedEntity*> cluster;
  for (const SPlanarOwner& member : {first.GetOwner(), second.GetOwner(), box.GetOwner()}) {
    scene.Grips.FindCluster(*member.Body, cluster);
    CHECK(cluster.size() == 3);
    CHECK(std::count(cluster.begin(), cluster.end(), &third.Entity) == 0);
  }
  std::vector<SGripTransfer> grips;
  scene.Grips.CopyGrips(cluster, grips);
  REQUIRE(grips.size() == 2);
  CHECK(grips[0].Holder == &first.Entity);
  CHECK(grips[0].Held == &second.Entity);
  CHECK(grips[1].Held == &box.Entity);
  CHECK(grips[1].Arm.GetX() == Approx(0.055).margin(1e-4));

  SGripScene next;
  auto& robot = next.AddGripper(0.105, 0.0);
  auto& load = next.AddBox(0.21, 0.0, true);
  SGripTransfer grip = grips[1];
  grip.Holder = &robot.Entity;
  grip.Held = &load.Entity;
  next.Grips.RestoreGrip(grip, robot.Handle, load.Handle);
  REQUIRE(next.Grips.IsHoldingAny());
  next.Grips.CopyGrips({&robot.Entity}, grips);
  REQUIRE(grips.size() == 1);
  CHECK(grips[0].Arm == grip.Arm);
  CHECK(grips[0].PointOnHeld == grip.PointOnHeld);
}

TEST_CASE("planar grips: 255 grippers hold a body, and no more", "[dynamics2d][grip]") {
  // so many are counted
  SGripScene scene;
  SBodyDescription description = CPlanarScene::DescribeRobot();
  description.Grippable = false;
  for (int i = 0; i < 300; ++i) {
    scene.AddGripper(0.0, 0.0, description);
  }
  auto& box = scene.AddBox(0.105, 0.0, true);
  scene.Lock();
  CHECK(scene.GetPassive(box).NumGrips == 255);
  const auto isGripping = [](const CGripperEquippedEntity& each) { return each.IsGripping(); };
  CHECK(std::count_if(scene.Grippers.begin(), scene.Grippers.end(), isGripping) == 255);
  // a released place is taken by another
  scene.Grippers.front().SetLockState(0.0);
  scene.Grips.StartTick();
  CHECK(scene.GetPassive(box).NumGrips == 254);
  scene.MakeGrips();
  CHECK(scene.GetPassive(box).NumGrips == 255);
}

TEST_CASE("planar grips: a robot that 255 grippers hold does not grip", "[dynamics2d][grip]") {
  SGripScene scene;
  SBodyDescription description = CPlanarScene::DescribeRobot();
  description.Grippable = false;
  const int holders = GENERATE(254, 255);
  CAPTURE(holders);
  for (int i = 0; i < holders; ++i) {
    scene.AddGripper(0.0, 0.0, description);
  }
  auto& held = scene.AddGripper(0.105, 0.0);
  scene.AddBox(0.21, 0.0, true);
  scene.Lock();
  CHECK(scene.GetDriven(held).NumGrips == 255);
  CHECK(scene.Grippers.back().IsGripping() == (holders < 255));
}

TEST_CASE("planar grips: the rate of a turret with a load is bounded by that of its substeps",
          "[dynamics2d][grip]") {
  const Real speed = GENERATE(2.0, 1e4, -1e4);  // rad/s
  CAPTURE(speed);
  SGripScene scene;
  scene.AddTurret(0.0, 0.0, speed);
  scene.AddBox(0.105, 0.0, true);
  scene.Lock();
  REQUIRE(scene.Grips.IsHoldingAny());
  const Real rate = std::min(std::abs(speed), kMaxSubsteps * kMaxStepTurn / CPlanarScene::kTick);
  // the box is held 5.5 cm ahead; half of its diagonal is its bounding radius
  const Real reach = 0.055 + 2.0 * 0.05 * std::sqrt(2.0);
  CHECK(scene.Grips.ComputeLongestPath() ==
        Approx(rate * CPlanarScene::kTick * reach).epsilon(1e-4));
  scene.StartCrowd(0.01);
  scene.Grips.AddTo(scene.Pairs, scene.Crowd);
  REQUIRE(scene.Crowd.GetGrips().size() == 1);
  CHECK(scene.Crowd.GetGrips()[0].NeededSubsteps ==
        Approx(rate * CPlanarScene::kTick *
               std::max(reach / (kMaxStepShare * 0.05), 1.0 / kMaxStepTurn))
            .epsilon(1e-4));
}

TEST_CASE("planar grips: a pair without drives keeps its momentum and its spin",
          "[dynamics2d][grip]") {
  const UInt32 substeps = GENERATE(1, 2, 10, 50);
  const bool refine = GENERATE(false, true);
  CAPTURE(substeps, refine);
  constexpr Real kDistance = 2.0 * CPlanarScene::kRadius + 0.005;  // m
  constexpr Real kDrift = 0.02;  // m/s
  constexpr Real kSpin = 0.5;  // rad/s
  SPlanarSettings settings = CPlanarScene::MakeSettings();
  settings.Substeps = substeps;
  settings.RefineInCrowds = refine;
  CPlanarWorld world(settings);
  CPlanarScene scene;  // owns the bodies only
  // drives that change the speed by 1e-9 m/s in a second
  SBodyDescription description = CPlanarScene::DescribeRobot();
  description.Drive = SDifferentialDriveDescription{0.08, 0.02, 5e-10, 1e-12};
  CGripperEquippedEntity gripper(nullptr);
  gripper.SetOffset(CVector3(CPlanarScene::kRadius, 0.0, 0.0));
  gripper.SetLockState(1.0);
  const std::array<Real, 2> wheels{};
  for (const Real side : {-0.5, 0.5}) {
    CPlanarScene::SBody& body = scene.Bodies.emplace_back("robot");
    world.AddDriven(body.GetOwner(), description, CPlanarScene::PoseAt(side * kDistance, 0.0),
                    CDriveSource(wheels.data(), 0.08));
    world.SetVelocity(body.Handle, {kDrift, kSpin * side * kDistance, kSpin});
  }
  world.GetGrips().SetManipulator(scene.Bodies[0].GetOwner(), description, &gripper, nullptr);
  CThreadPool pool(0, std::make_unique<CBalanceQuantitySchedule>());
  for (int tick = 1; tick <= 100; ++tick) {
    world.Advance(pool);
    world.CommitDriven(0, 2, [](const SDrivenBody&, size_t) {});
    const SDrivenBody& a = world.GetDriven(0);
    const SDrivenBody& b = world.GetDriven(1);
    CAPTURE(tick);
    REQUIRE(gripper.IsGripping());
    CHECK(0.5 * (a.Velocity.X + b.Velocity.X) == Approx(kDrift).margin(1e-6));
    CHECK(0.5 * (a.Velocity.Y + b.Velocity.Y) == Approx(0.0).margin(1e-6));
    CHECK(0.5 * (a.Pose.X + b.Pose.X) == Approx(kDrift * 0.1 * tick).margin(1e-5));
    // about the centre of both: of the two on their circle, and their own
    const Real x = b.Pose.X - a.Pose.X;
    const Real y = b.Pose.Y - a.Pose.Y;
    const Real orbit = 0.5 * a.Kind->Mass *
                       (x * (b.Velocity.Y - a.Velocity.Y) - y * (b.Velocity.X - a.Velocity.X));
    const Real own = a.Kind->Inertia * (a.Velocity.W + b.Velocity.W);
    const Real before =
        (0.5 * a.Kind->Mass * kDistance * kDistance + 2.0 * a.Kind->Inertia) * kSpin;
    CHECK(orbit + own == Approx(before).epsilon(0.01));
    // a substep of 0.1 s is a chord of 0.05 rad: 0.13 mm
    CHECK(std::hypot(x, y) == Approx(kDistance).margin(2e-4));
  }
}

TEST_CASE("planar grips: two drives that balance share a pull by mass", "[dynamics2d][grip]") {
  const Real mass = GENERATE(0.1, 0.5, 2.0);  // kg, of the robot that pulls; the other: 0.5 kg
  const Real share = GENERATE(0.99, 1.0, 1.01);  // of its force in that of the other
  CAPTURE(mass, share);
  constexpr Real kSpeed = 0.1;  // m/s
  CPlanarWorld world(CPlanarScene::MakeSettings());
  CPlanarScene scene;  // owns the bodies only
  CGripperEquippedEntity gripper(nullptr);
  gripper.SetOffset(CVector3(CPlanarScene::kRadius, 0.0, 0.0));
  gripper.SetLockState(1.0);
  const std::array<Real, 2> back{-kSpeed, -kSpeed};
  const std::array<Real, 2> still{};
  const auto add = [&](Real x, const SBodyDescription& description, const auto& wheels) {
    CPlanarScene::SBody& body = scene.Bodies.emplace_back("robot");
    world.AddDriven(body.GetOwner(), description, CPlanarScene::PoseAt(x, 0.0),
                    CDriveSource(wheels.data(), 0.08));
  };
  SBodyDescription puller = CPlanarScene::DescribeRobot();
  puller.Mass = mass;
  puller.Drive->MaxForce *= share;
  add(0.0, puller, back);
  add(2.0 * CPlanarScene::kRadius + 0.005, CPlanarScene::DescribeRobot(), still);
  world.GetGrips().SetManipulator(scene.Bodies[0].GetOwner(), puller, &gripper, nullptr);
  CThreadPool pool(0, std::make_unique<CBalanceQuantitySchedule>());
  for (int tick = 0; tick < 300; ++tick) {
    world.Advance(pool);
    world.CommitDriven(0, 2, [](const SDrivenBody&, size_t) {});
  }
  REQUIRE(gripper.IsGripping());
  const Real balanced = kSpeed * mass / (mass + 0.5);
  const Real expected = share < 1.0 ? 0.0 : share > 1.0 ? kSpeed : balanced;
  for (UInt32 slot = 0; slot < 2; ++slot) {
    CHECK(world.GetDriven(slot).Velocity.X == Approx(-expected).margin(1e-3));
  }
}

}  // namespace argos::planar_grips_test
