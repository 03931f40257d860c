// Handles, slots and numbers whose body has left; see ARGOS_CHECK_INVARIANTS.

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/drive_source.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_world.h>
#include <argos3/testing/support/invariants.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <deque>

namespace kinematics2d_stale_handles_test {

using namespace argos;

namespace {

const std::string kStale = "stale handle of a body";

/** A world with discs of radius 5 cm, and boxes. */
struct SScene {
  CKinematicWorld World;
  CThreadPool Pool{1, std::make_unique<CBalanceLengthSchedule>()};
  std::deque<SKinematicHandle> Handles;  // addresses stay valid
  std::array<Real, 2> Wheels{};  // m/s

  const SKinematicHandle& Add(EKinematicKind kind, Real x) {
    SBodyDescription description;
    description.Mass = 1.0;
    SKinematicOwner owner;
    owner.Handle = &Handles.emplace_back();
    SPlanarPose pose;
    pose.X = x;
    if (kind == EKinematicKind::Disc) {
      description.Shapes.push_back(SShapeDescription::Cylinder(0.05, 0.1));
      description.Drive = SDifferentialDriveDescription{0.08, 0.02, 1.0, 1.0};
      World.AddMovable(owner, description, pose, CDriveSource(Wheels.data(), 0.08), {0.0, 0.0});
    } else {
      description.Shapes.push_back(SShapeDescription::Box(CVector3(0.1, 0.1, 0.1)));
      if (kind == EKinematicKind::Solid) {
        World.AddMovable(owner, description, pose, CDriveSource(), {1.0, 1.0});
      } else {
        World.AddImmovable(owner, description, pose);
      }
    }
    return Handles.back();
  }
};

}  // namespace

TEST_CASE("kinematic world: the handle of a removed body is stale, also after its slot is used",
          "[kinematics2d][invariants]") {
  const EKinematicKind kind =
      GENERATE(EKinematicKind::Immovable, EKinematicKind::Solid, EKinematicKind::Disc);
  CAPTURE(static_cast<int>(kind));
  SScene scene;
  const SKinematicHandle& first = scene.Add(kind, 0.0);
  const SKinematicHandle& second = scene.Add(kind, 1.0);
  const SKinematicHandle ofFirst = first;
  const SKinematicHandle ofSecond = second;
  REQUIRE(scene.World.IsCurrent(ofFirst));

  // the second body gets the slot of the first, and a third one that of the second
  scene.World.Remove(first);
  CHECK(second.Slot == ofFirst.Slot);
  CHECK(scene.World.IsCurrent(second));
  CHECK_FALSE(scene.World.IsCurrent(first));
  CHECK(scene.Add(kind, 2.0).Slot == ofSecond.Slot);
  for (const SKinematicHandle& stale : {ofFirst, ofSecond}) {
    CHECK_FALSE(scene.World.IsCurrent(stale));
    CheckCaught([&] { scene.World.Remove(stale); }, kStale);
    if (kind != EKinematicKind::Immovable) {
      CheckCaught([&] { scene.World.SetPose(stale, SPlanarPose()); }, kStale);
    }
  }
  scene.World.Remove(second);
  CHECK_NOTHROW(scene.World.Advance(scene.Pool, {0.1, 0.0, true}));
}

TEST_CASE("kinematic world: the pose of an immovable body is not set",
          "[kinematics2d][invariants]") {
  SScene scene;
  const SKinematicHandle& wall = scene.Add(EKinematicKind::Immovable, 0.0);
  CheckCaught([&] { scene.World.SetPose(wall, SPlanarPose()); }, "immovable body is set");
}

TEST_CASE("disc swarm: slots and places from before a removal are noticed",
          "[kinematics2d][invariants]") {
  SScene scene;
  const SKinematicHandle& first = scene.Add(EKinematicKind::Disc, 0.0);
  scene.Add(EKinematicKind::Disc, 1.0);
  scene.World.Advance(scene.Pool, {0.1, 0.0, true});
  CDiscSwarm& discs = scene.World.GetDiscs();
  const auto visitAll = [&] { discs.ForDiscsNear(0.0, 0.0, 1.0, [](UInt32) {}); };
  CHECK_NOTHROW(visitAll());
  scene.World.Remove(first);
  CheckCaught(visitAll, "the places of 2 discs are stale");
  CheckCaught([&] { discs.Step(scene.Pool, CCellLists(), CCellLists()); }, "are stale");
  CheckCaught([&] { static_cast<void>(discs.GetPose(1)); }, "no disc in slot 1 of 1");
  CheckCaught([&] { static_cast<void>(discs.GetOwner(1)); }, "no disc in slot 1 of 1");
  CheckCaught([&] { discs.Commit(1); }, "no disc in slot 1 of 1");
}

TEST_CASE("solids: slots from before a removal are noticed", "[kinematics2d][invariants]") {
  SScene scene;
  scene.World.Remove(scene.Add(EKinematicKind::Solid, 0.0));
  CheckCaught([&] { scene.World.GetSolids().Get(0); }, "no solid in slot 0");
}

TEST_CASE("ghost lines: lines of another number of discs are noticed",
          "[kinematics2d][invariants]") {
  CGhostLines lines;
  lines.Clear(1);
  CheckCaught([&] { lines.Add(1, 0.0, 0.0, 0.05, 0, {1.0, 0.0, 0.05}); }, "no disc in slot 1");
  lines.Add(0, 0.0, 0.0, 0.05, 0, {1.0, 0.0, 0.05});
  lines.Sort();
  CHECK(lines.Get(0).size() == 1);
  CheckCaught([&] { lines.Has(1); }, "of 1 discs, not of slot 1");
}

TEST_CASE("push solver: numbers from before Clear() are noticed", "[kinematics2d][invariants]") {
  CPushSolver solver;
  const UInt32 number = solver.AddBody(STwist(), 1.0, 1.0, 0.01);
  solver.Clear();
  CPushSolver::SContact contact;
  contact.Pushed = number;
  CheckCaught([&] { solver.AddContact(contact); }, "no body with the number 0");
  CheckCaught([&] { static_cast<void>(solver.GetTwist(number)); }, "no body with the number 0");
}

TEST_CASE("cell lists: numbers from before Clear() are noticed", "[kinematics2d][invariants]") {
  const std::array<SFootprint, 2> footprints{};
  CFramedGrid grid;
  grid.Cover({0.0, 0.0, 1.0, 1.0}, 0.5, 16.0);
  CCellLists lists;
  lists.List(grid, footprints, 0.0);
  CHECK(&lists.GetFootprint(1) == &footprints[1]);
  lists.List(grid, {footprints.data(), 1}, 0.0);
  CheckCaught([&] { static_cast<void>(lists.GetFootprint(1)); }, "no footprint with the number 1");
  lists.Clear();
  CheckCaught([&] { static_cast<void>(lists.Get(0)); }, "no key 0");
}

TEST_CASE("kinematic world: a command that is not finite is refused", "[kinematics2d]") {
  const Real bad = GENERATE(std::nan(""), HUGE_VAL, -HUGE_VAL);
  const size_t wheel = GENERATE(0U, 1U);
  const bool isDisc = GENERATE(false, true);
  CAPTURE(bad, wheel, isDisc);
  SScene scene;
  SBodyDescription description;
  description.Mass = 1.0;
  description.Shapes.push_back(isDisc ? SShapeDescription::Cylinder(0.05, 0.1)
                                      : SShapeDescription::Box(CVector3(0.1, 0.1, 0.1)));
  description.Drive = SDifferentialDriveDescription{0.08, 0.02, 1.0, 1.0};
  std::array<Real, 2> wheels{};
  SKinematicOwner owner;
  owner.Handle = &scene.Handles.emplace_back();
  scene.World.AddMovable(owner, description, SPlanarPose(), CDriveSource(wheels.data(), 0.08),
                         {0.0, 0.0});
  scene.World.Advance(scene.Pool, {0.1, 0.0, true});
  wheels[wheel] = bad;
  CHECK_THROWS_AS(scene.World.Advance(scene.Pool, {0.1, 0.0, true}), SBadDriveCommand);
}

}  // namespace kinematics2d_stale_handles_test
