// Robots of other engines as seen by discs and by robots of other shapes.

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/drive_source.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_world.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <memory>
#include <span>
#include <vector>

namespace kinematic_ghosts_test {

using namespace argos;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kTick = 0.1;  // s
constexpr Real kRadius = 0.05;  // m, of discs and ghosts
constexpr Real kHalf = 0.05;  // m, of the sides of square robots
// m, to which robots with corners are moved
constexpr Real kTolerance = 1e-4 * kHalf;

/** Robots that drive along x. */
class CGhostScene {
 public:
  const SKinematicHandle& Add(bool isDisc, Real x, Real speed) {
    SBodyDescription description;
    description.Mass = 1.0;
    description.Shapes.push_back(
        isDisc ? SShapeDescription::Cylinder(kRadius, 0.1)
               : SShapeDescription::Box(CVector3(2.0 * kHalf, 2.0 * kHalf, 0.1)));
    description.Drive = SDifferentialDriveDescription{0.08, 0.02, 1.0, 1.0};
    SKinematicOwner owner;
    owner.Handle = &m_handles.emplace_back();
    SPlanarPose pose;
    pose.X = x;
    const std::array<Real, 2>& wheels = m_wheels.emplace_back(std::array<Real, 2>{speed, speed});
    m_world.AddMovable(owner, description, pose, CDriveSource(wheels.data(), 0.08), {0.0, 0.0});
    return m_handles.back();
  }
  /** One tick. */
  void Step(const std::vector<SGhostDisc>& ghosts) {
    m_world.SetGhosts(ghosts, kTick, 1);
    m_world.Advance(m_pool, {kTick, 0.0, true});
    for (UInt32 slot = 0; slot < m_world.GetDiscs().GetSize(); ++slot) {
      m_world.GetDiscs().Commit(slot);
    }
  }
  SPlanarPose GetPose(const SKinematicHandle& handle) {
    return handle.Kind == EKinematicKind::Disc ? m_world.GetDiscs().GetPose(handle.Slot)
                                               : m_world.GetSolids().Get(handle.Slot).Pose;
  }

 private:
  CKinematicWorld m_world;
  CThreadPool m_pool{1, std::make_unique<CBalanceLengthSchedule>()};
  std::deque<SKinematicHandle> m_handles;  // addresses stay valid
  std::deque<std::array<Real, 2>> m_wheels;  // m/s
};

}  // namespace

TEST_CASE("kinematic ghosts: one exactly at a robot's centre does not hold it", "[kinematics2d]") {
  const bool isDisc = GENERATE(true, false);
  CAPTURE(isDisc);
  CGhostScene scene;
  const SKinematicHandle& robot = scene.Add(isDisc, 0.0, 0.1);
  scene.Step({{0.0, 0.0, kRadius}});
  CHECK_THAT(scene.GetPose(robot).X, WithinAbs(0.01, 1e-9));
  CHECK_THAT(scene.GetPose(robot).Y, WithinAbs(0.0, 1e-9));
}

TEST_CASE("kinematic ghosts: a robot stays on its half of the gap to a ghost", "[kinematics2d]") {
  const bool isDisc = GENERATE(true, false);
  // of the circles around robot and ghost, m
  const Real radius = isDisc ? kRadius : std::sqrt(2.0) * kHalf;
  const Real gap = 0.2 - kRadius - radius;
  // m/s; with 0.3 m/s its path is shorter than its half
  const Real speed = GENERATE(0.3, 0.6);
  // ahead of the robot or behind it
  const Real direction = GENERATE(1.0, -1.0);
  CAPTURE(isDisc, speed, direction);
  CGhostScene scene;
  const SKinematicHandle& robot = scene.Add(isDisc, 0.0, direction * speed);
  // that is too far away for the ghost, and that has one on the other side
  const SKinematicHandle& other = scene.Add(isDisc, direction * -2.0, direction * speed);
  scene.Step({{direction * 0.2, 0.0, kRadius}, {direction * -2.2, 0.0, kRadius}});
  const Real path = speed * kTick;
  CHECK_THAT(direction * scene.GetPose(robot).X,
             WithinAbs(std::min(path, 0.5 * gap), isDisc ? 1e-9 : kTolerance));
  CHECK_THAT(scene.GetPose(robot).Y, WithinAbs(0.0, 1e-9));
  CHECK_THAT(direction * scene.GetPose(other).X, WithinAbs(path - 2.0, 1e-9));
}

TEST_CASE("ghost lines: those of a disc are in the order of the ghosts", "[kinematics2d]") {
  CGhostLines lines;
  lines.Clear(3);
  // along x and y, gaps of 0.5 m and 1 m
  lines.Add(2, 0.0, 0.0, 0.25, 7, {0.0, 1.5, 0.25});
  lines.Add(0, 1.0, 0.0, 0.25, 4, {1.0, 0.0, 0.25});
  lines.Add(2, 0.0, 0.0, 0.25, 3, {-1.0, 0.0, 0.25});
  lines.Sort();
  // coincident centres define no line
  CHECK_FALSE(lines.Has(0));
  CHECK_FALSE(lines.Has(1));
  CHECK(lines.Get(0).empty());
  const std::span<const SGhostLine> found = lines.Get(2);
  REQUIRE(found.size() == 2);
  CHECK(found[0].Ghost == 3);
  CHECK(found[0].Normal.X == -1.0);
  CHECK(found[0].Room == 0.25);
  CHECK(found[1].Ghost == 7);
  CHECK(found[1].Normal.Y == 1.0);
  CHECK(found[1].Room == 0.5);
  lines.Clear(2);
  CHECK_FALSE(lines.Has(1));
  lines.Add(1, 0.0, 0.0, 0.25, 0, {1.0, 0.0, 0.25});
  lines.Sort();
  CHECK(lines.Get(1).size() == 1);
}

}  // namespace kinematic_ghosts_test
