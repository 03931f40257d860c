// Handles, slots and numbers whose body has left; see ARGOS_CHECK_INVARIANTS.

#include "planar_scene.h"

#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_grips.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_world.h>
#include <argos3/testing/support/invariants.h>

#include <catch2/catch.hpp>

namespace argos::dynamics2d_stale_handles_test {

namespace {

const std::string kStale = "stale handle of a body";

// adds a body of a kind
CPlanarScene::SBody& Add(CPlanarScene& scene, EPlanarKind kind, Real x) {
  return kind == EPlanarKind::Driven ? scene.AddRobot(x, 0.0)
                                     : scene.AddBox(x, 0.0, kind == EPlanarKind::Passive);
}

}  // namespace

TEST_CASE("planar store: the handle of a removed body is stale, also after its slot is used again",
          "[dynamics2d][invariants]") {
  const EPlanarKind kind =
      GENERATE(EPlanarKind::Immovable, EPlanarKind::Passive, EPlanarKind::Driven);
  CAPTURE(static_cast<int>(kind));
  CPlanarScene scene;
  const auto& first = Add(scene, kind, 0.0);
  const auto& second = Add(scene, kind, 1.0);
  const SPlanarHandle ofFirst = first.Handle;
  const SPlanarHandle ofSecond = second.Handle;
  CHECK(scene.Store.IsCurrent(ofFirst));
  CHECK_FALSE(ofFirst == ofSecond);

  // the second body gets the slot of the first
  scene.Store.Remove(first.Handle);
  CHECK(second.Handle.Slot == ofFirst.Slot);
  CHECK(scene.Store.IsCurrent(second.Handle));
  CHECK_FALSE(scene.Store.IsCurrent(first.Handle));
  // and a third one that of the second
  const auto& third = Add(scene, kind, 2.0);
  CHECK(third.Handle.Slot == ofSecond.Slot);
  for (const SPlanarHandle& stale : {ofFirst, ofSecond}) {
    CHECK_FALSE(scene.Store.IsCurrent(stale));
    CheckCaught([&] { scene.Store.Remove(stale); }, kStale);
    CheckCaught([&] { scene.Store.GetOwner(stale); }, kStale);
    CheckCaught([&] { scene.Store.GetVelocity(stale); }, kStale);
    if (kind != EPlanarKind::Immovable) {
      CheckCaught([&] { scene.Store.IsAt(stale, SPlanarPose()); }, kStale);
      CheckCaught([&] { scene.Store.GetNumGrips(stale); }, kStale);
      CheckCaught([&] { scene.Store.GetBoundingRadius(stale); }, kStale);
      CheckCaught([&] { scene.Store.GetNarrowestHalf(stale); }, kStale);
      CheckCaught([&] { static_cast<void>(scene.Store.IsGrippable(stale)); }, kStale);
      CheckCaught([&] { scene.Store.SetVelocity(stale, SPlanarVelocity()); }, kStale);
    }
  }
  CheckCaught([&] { scene.Store.Remove(first.Handle); }, kStale);
}

TEST_CASE("planar store: a handle is of one kind of body", "[dynamics2d][invariants]") {
  CPlanarScene scene;
  const auto& robot = scene.AddRobot(0.0, 0.0);
  const auto& box = scene.AddBox(1.0, 0.0, true);
  CheckCaught([&] { scene.Store.GetPassive(robot.Handle); }, "another kind");
  CheckCaught([&] { scene.Store.GetDriven(box.Handle); }, "another kind");
}

TEST_CASE("planar world: a stale handle is noticed", "[dynamics2d][invariants]") {
  CPlanarScene scene;
  CPlanarWorld world(CPlanarScene::MakeSettings());
  const std::array<Real, 2> wheels{};
  const auto add = [&](Real x) -> CPlanarScene::SBody& {
    CPlanarScene::SBody& body = scene.Bodies.emplace_back("robot");
    world.AddDriven(body.GetOwner(), CPlanarScene::DescribeRobot(), CPlanarScene::PoseAt(x, 0.0),
                    CDriveSource(wheels.data(), 0.08));
    return body;
  };
  const SPlanarHandle stale = add(0.0).Handle;
  world.Remove(scene.Bodies[0].Handle);
  add(1.0);
  CHECK(scene.Bodies[1].Handle.Slot == stale.Slot);
  CheckCaught([&] { world.Remove(stale); }, kStale);
  CheckCaught([&] { world.SetVelocity(stale, SPlanarVelocity()); }, kStale);
  CheckCaught([&] { static_cast<void>(world.GetVelocity(stale)); }, kStale);
  CThreadPool pool(0, std::make_unique<CBalanceQuantitySchedule>());
  world.Advance(pool);
}

TEST_CASE("planar grips: a holder and a held body that have left are noticed",
          "[dynamics2d][grip][invariants]") {
  CPlanarScene scene;
  CPlanarGrips grips(scene.Store);
  CGripperEquippedEntity gripper(nullptr);
  gripper.SetOffset(CVector3(CPlanarScene::kRadius, 0.0, 0.0));
  auto& robot = scene.AddRobot(0.0, 0.0);
  grips.SetManipulator(robot.GetOwner(), CPlanarScene::DescribeRobot(), &gripper, nullptr);
  const auto& box = scene.AddBox(0.105, 0.0, true);
  const SPlanarHandle held = box.Handle;
  gripper.SetLockState(1.0);
  grips.StartTick();
  scene.StartCrowd(0.01);
  grips.MakeGrips(scene.Pairs, scene.Crowd.GetSolids());
  REQUIRE(grips.IsInGrip(held));

  // a copy of the holder's handle is as good as the original
  const SPlanarHandle holder = robot.Handle;
  grips.Remove(holder);
  CHECK_FALSE(grips.IsHoldingAny());
  grips.SetManipulator(robot.GetOwner(), CPlanarScene::DescribeRobot(), &gripper, nullptr);
  CheckCaught([&] { grips.RestoreGrip(SGripTransfer(), held, held); }, "another kind");
  scene.Store.Remove(box.Handle);
  CheckCaught([&] { grips.RestoreGrip(SGripTransfer(), holder, held); }, kStale);
  CheckCaught([&] { static_cast<void>(grips.IsInGrip(held)); }, kStale);
  CheckCaught([&] { grips.Remove(held); }, kStale);

  // the robot leaves without its gripper
  scene.Store.Remove(robot.Handle);
  CheckCaught([&] { grips.MakeGrips(scene.Pairs, scene.Crowd.GetSolids()); }, "handle of a body");
}

TEST_CASE("proximity filter: the numbers of a former tick are noticed",
          "[dynamics2d][invariants]") {
  CThreadPool pool(0, std::make_unique<CBalanceQuantitySchedule>());
  CDiscPairs filter;
  filter.Start(2);
  filter.Place(0, 0.0, 0.0, 0.1);
  filter.Place(1, 1.0, 0.0, 0.1);
  filter.Find(pool, 0.01);
  filter.Start(1);
  CheckCaught([&] { filter.Place(1, 0.0, 0.0, 0.1); }, "no disc with the number 1");
  filter.Place(0, 0.0, 0.0, 0.1);
  filter.Find(pool, 0.01);
  CheckCaught([&] { static_cast<void>(filter.IsNear(1)); }, "no disc at place 1");
  CheckCaught([&] { static_cast<void>(filter.GetObstacle(0)); }, "no obstacle 0");
}

}  // namespace argos::dynamics2d_stale_handles_test
