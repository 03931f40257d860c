// Worlds of rigid bodies without an engine: rolling, substeps, sleep, and cylinders at borders.

#include "one_body_world.h"

#include <argos3/core/simulator/geometry/articulation.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/articulated_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_ghosts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_world.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rolling.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace rigid_world_test {

using namespace argos;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using SScene = SOneBodyWorld;

}  // namespace

namespace {

// A robot of 1 kg with a moment of inertia of 0.01 kg m^2. Its wheels, at 0.1 m from the middle,
// feel 0.25 m of the motion ahead, 0.25 I / arm^2 of the rotation, and half of their own mass.
constexpr Real kAhead = 0.25;  // kg
constexpr Real kTurn = 0.25;
constexpr Real kSpin = 0.5 * kWheelMassShare;
constexpr Real kStep = 0.01;  // s
const SRollGround kFloor{0.0, 1.0, 1000.0};  // so heavy that wheels do not slip

SRigidBody& AddRobot(SScene& scene, Real force, Real torque) {
  scene.Description.PlanarInertia = 0.01;
  scene.Description.Drive = SDifferentialDriveDescription{0.2, 0.02, force, torque};
  return scene.Add();
}

// the motion after one substep from rest
SDriveCommand Accelerate(const SRigidBody& robot, const SDriveCommand& command,
                         const SRollGround& ground = kFloor) {
  return Roll(robot, SRollState(), command, ground, kStep, 1).Motion;
}

}  // namespace

TEST_CASE("rolling: motors and friction limit the acceleration", "[dynamics3d]") {
  const Real sign = GENERATE(1.0, -1.0);
  CAPTURE(sign);
  // 2.5 N at each wheel, by the force or by the torque of the drive
  for (const auto& [force, torque] : {std::pair(5.0, 100.0), std::pair(100.0, 0.5)}) {
    CAPTURE(force, torque);
    SScene scene;
    const SRigidBody& robot = AddRobot(scene, force, torque);
    const SDriveCommand ahead = Accelerate(robot, {sign * 10.0, 0.0, 0.0});
    CHECK_THAT(ahead.Ahead, WithinRel(sign * 2.5 * kStep / (2.0 * kAhead + kSpin), 1e-12));
    CHECK(ahead.YawRate == 0.0);
    const SDriveCommand turn = Accelerate(robot, {0.0, 0.0, sign * 100.0});
    CHECK(turn.Ahead == 0.0);
    CHECK_THAT(turn.YawRate, WithinRel(sign * 2.5 * kStep / (2.0 * kTurn + kSpin) / 0.1, 1e-12));
    // one wheel only: the other one has to stay at rest
    for (const Real side : {1.0, -1.0}) {
      const SDriveCommand one = Accelerate(robot, {sign * 1.0, 0.0, sign * side * 10.0});
      const Real rim = sign * 2.5 * kStep / (kAhead + kTurn + kSpin);
      CHECK_THAT(one.Ahead, WithinRel(0.5 * rim, 1e-12));
      CHECK_THAT(one.YawRate, WithinRel(side * 0.5 * rim / 0.1, 1e-12));
    }
    // what the motors reach is exact
    const SDriveCommand slow = {sign * 0.01, 0.0, sign * 0.1};
    CHECK(Accelerate(robot, slow) == slow);
  }
  SScene scene;
  const SRigidBody& robot = AddRobot(scene, 100.0, 100.0);
  const Real grip = kWheelLoad * 9.81 * 0.5;  // N
  const SDriveCommand slipping = Accelerate(robot, {sign * 10.0, 0.0, 0.0}, {0.0, 0.5, 9.81});
  CHECK_THAT(slipping.Ahead, WithinRel(sign * 0.5 * grip * kStep / (2.0 * kAhead + kSpin), 1e-12));
}

TEST_CASE("rolling: a planar drive has a force and a torque", "[dynamics3d]") {
  SScene scene;
  scene.Description.PlanarInertia = 0.01;
  scene.Description.PlanarDrive = SPlanarDriveDescription{5.0, 0.2};
  const SDriveCommand none;
  SRigidSource source;
  source.Description = &scene.Description;
  source.Drive = CDriveSource(none);
  const SRigidBody& robot = scene.World.Add(source, SRigidPose());
  const Real sign = GENERATE(1.0, -1.0);
  CAPTURE(sign);
  // at most 0.05 m/s and 0.2 rad/s in a substep
  const SDriveCommand fast = Accelerate(robot, {sign * 3.0, sign * 4.0, sign * 7.0});
  CHECK_THAT(fast.Ahead, WithinRel(sign * 0.03, 1e-12));
  CHECK_THAT(fast.Left, WithinRel(sign * 0.04, 1e-12));
  CHECK_THAT(fast.YawRate, WithinRel(sign * 0.2, 1e-12));
  const SDriveCommand slow = {sign * 0.03, sign * 0.03, sign * 0.19};
  CHECK(Accelerate(robot, slow) == slow);
  const SDriveCommand turning = Accelerate(robot, {sign * 0.03, 0.0, sign * 0.3});
  CHECK_THAT(turning.Ahead, WithinRel(sign * 0.03, 1e-12));
  CHECK_THAT(turning.YawRate, WithinRel(sign * 0.2, 1e-12));
}

TEST_CASE("rigid world: fast bodies get substeps of half their narrowest side, up to a limit",
          "[dynamics3d]") {
  UseODEInThisThread();
  SRigidSettings settings;
  settings.Substeps = GENERATE(2U, 20U);
  CAPTURE(settings.Substeps);
  constexpr UInt32 kMax = 1000;
  struct SCase {
    Real Speed;  // m/s
    UInt32 Expected;
  };
  // a cube of 0.1 m in ticks of 0.1 s: a stride of 0.05 m
  for (const SCase& c : {SCase{0.0, settings.Substeps}, SCase{0.9, settings.Substeps},
                         SCase{20.9, 42}, SCase{1000.0, kMax}}) {
    CAPTURE(c.Speed);
    SBodyDescription description;
    description.Shapes.push_back(SShapeDescription::Box(CVector3(0.1, 0.1, 0.1)));
    description.Mass = 1.0;
    CRigidWorld world(settings, [] {});
    SRigidSource source;
    source.Description = &description;
    dBodySetLinearVel(world.Add(source, SRigidPose()).Body, c.Speed, 0.0, 0.0);
    world.Advance(nullptr);
    CHECK(world.GetNumSubsteps() == c.Expected);
  }
}

TEST_CASE(
    "rigid ghosts: the cylinder of a robot that lies is that of the spheres around its solids",
    "[dynamics3d]") {
  SBodyDescription description;
  description.Shapes.push_back(SShapeDescription::Cylinder(0.03, 0.08));
  description.Shapes.push_back(SShapeDescription::Sphere(0.02, CVector3(0.0, 0.0, 0.28)));
  SRigidPose upright;
  upright.Position.Set(1.0, 2.0, 0.5);
  const SGhostCylinder standing = EncloseRobot(description, upright);
  CHECK(standing.X == 1.0);
  CHECK(standing.Y == 2.0);
  CHECK_THAT(standing.Radius, WithinRel(0.03, 1e-12));
  CHECK_THAT(standing.Low, WithinRel(0.5, 1e-12));
  CHECK_THAT(standing.High, WithinRel(0.82, 1e-12));
  // its axis along x, from 1.0 m to 1.32 m
  SRigidPose lying = upright;
  lying.Orientation = CQuaternion(CRadians::PI_OVER_TWO, CVector3::Y);
  const SGhostCylinder found = EncloseRobot(description, lying);
  CHECK_THAT(found.X, WithinRel(1.16, 1e-12));
  CHECK_THAT(found.Y, WithinRel(2.0, 1e-12));
  // the middle of the cylinder is 0.12 m away, that of the sphere 0.14 m
  CHECK_THAT(found.Radius, WithinRel(0.12 + std::hypot(0.03, 0.04), 1e-12));
  CHECK_THAT(found.High - found.Low, WithinRel(0.06, 1e-9));
}

TEST_CASE("rigid ghosts: the gap of two cylinders is the greater of those across and up",
          "[dynamics3d]") {
  const SGhostCylinder low{0.0, 0.0, 0.1, 0.0, 1.0};
  const SGhostCylinder beside{0.5, 0.0, 0.1, 0.5, 1.5};
  const SGhostCylinder above{0.05, 0.0, 0.1, 1.2, 2.0};
  const Real half = 1e-12;
  CHECK_THAT(ComputeGap(low, beside), WithinAbs(0.3, half));
  CHECK_THAT(ComputeGap(beside, low), WithinAbs(0.3, half));
  CHECK_THAT(ComputeGap(low, above), WithinAbs(0.2, half));
  CHECK_THAT(ComputeGap(above, low), WithinAbs(0.2, half));
  CHECK_THAT(ComputeGap(low, low), WithinAbs(-0.2, half));
}

TEST_CASE("joints: limits of hinges beyond half a turn are a flaw", "[dynamics3d]") {
  SBodyDescription description;
  auto articulation = std::make_shared<SArticulation>();
  const auto flawOf = [&](Real min, Real max) {
    SJointDescription joint;
    joint.Id = "j";
    joint.Kind = SJointDescription::EKind::Hinge;
    joint.Limits = CRange<Real>(min, max);
    articulation->Joints = {joint};
    description.Articulation = articulation;
    return FindFlawOfJoints(description);
  };
  CHECK(flawOf(-ARGOS_PI, ARGOS_PI).empty());
  CHECK_THAT(flawOf(-3.2, 3.0), Catch::Contains("joint \"j\" must be within"));
  CHECK_THAT(flawOf(-3.0, 3.2), Catch::Contains("joint \"j\" must be within"));
  // two links
  auto& solids = description.Shapes;
  solids.push_back(SShapeDescription::Sphere(0.1));
  solids[0].Mass = 1.0;
  solids[0].Link = 1;
  CHECK(flawOf(-1.0, 1.0).empty());
  for (const Real mass : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    solids[0].Mass = mass;
    CHECK_THAT(flawOf(-1.0, 1.0), Catch::Contains("the number of a link, and a mass > 0"));
  }
  solids[0].Mass = 1.0;
  solids[0].Link = 2;
  CHECK_THAT(flawOf(-1.0, 1.0), Catch::Contains("the number of a link, and a mass > 0"));
}

TEST_CASE("rigid world: a body at rest on a fixed one sleeps after half a second, if it may",
          "[dynamics3d]") {
  UseODEInThisThread();
  SRigidSettings settings;
  settings.Sleep = GENERATE(true, false);
  CAPTURE(settings.Sleep);
  CRigidWorld world(settings, [] {});
  world.SetGravity(CVector3(0.0, 0.0, -9.81));
  const auto add = [&world](const SBodyDescription& description, Real z, bool movable) {
    SRigidSource source;
    source.Description = &description;
    source.Movable = movable;
    SRigidPose pose;
    pose.Position.SetZ(z);
    return &world.Add(source, pose);
  };
  SBodyDescription table;
  table.Shapes.push_back(SShapeDescription::Box(CVector3(1.0, 1.0, 0.2)));
  SBodyDescription cube;
  cube.Shapes.push_back(SShapeDescription::Box(CVector3(0.1, 0.1, 0.1)));
  cube.Mass = 1.0;
  add(table, -0.2, false);
  const SRigidBody* const resting = add(cube, 0.0, true);
  for (int tick = 0; tick < 4; ++tick) {
    world.Advance(nullptr);
    CHECK_FALSE(resting->Asleep);
  }
  for (int tick = 0; tick < 20; ++tick) {
    world.Advance(nullptr);
  }
  CHECK(resting->Asleep == settings.Sleep);
  CHECK_THAT(FromODE(dBodyGetPosition(resting->Body)).GetZ(), WithinAbs(0.05, 1e-4));
}

TEST_CASE("rigid world: a body without support never sleeps", "[dynamics3d]") {
  SScene scene;
  const SRigidBody& body = scene.Add();
  for (int tick = 0; tick < 20; ++tick) {
    scene.World.Advance(nullptr);
  }
  CHECK_FALSE(body.Asleep);
}

TEST_CASE("rigid world: movable bodies decide how far from a border ghosts matter",
          "[dynamics3d]") {
  SScene scene;
  // without gravity: two bodies that move by 1.5 times 0.5 m/s in 0.1 s
  const Real paths = 2.0 * 1.5 * 0.5 * 0.1;
  CHECK_THAT(scene.World.ComputeGhostReach(), WithinAbs(paths, 1e-12));
  SBodyDescription table;
  table.Shapes.push_back(SShapeDescription::Box(CVector3(1.0, 1.0, 0.2)));
  SRigidSource source;
  source.Description = &table;
  source.Movable = false;
  SRigidPose below;
  below.Position.SetZ(-1.0);
  scene.World.Add(source, below);
  CHECK_THAT(scene.World.ComputeGhostReach(), WithinAbs(paths, 1e-12));
  // half of the diagonal
  const Real radius = 0.05 * std::sqrt(2.0);
  const SRigidBody& cube = scene.Add();
  CHECK_THAT(scene.World.ComputeGhostReach(), WithinAbs(radius + paths, 1e-12));
  dBodySetLinearVel(cube.Body, 2.0, 0.0, 0.0);
  CHECK_THAT(scene.World.ComputeGhostReach(), WithinAbs(radius + 4.0 * paths, 1e-12));
}

}  // namespace rigid_world_test
