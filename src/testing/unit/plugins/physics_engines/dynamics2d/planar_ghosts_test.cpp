#include "planar_scene.h"

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_ghosts.h>

#include <catch2/catch.hpp>

namespace argos {

namespace {

constexpr Real kPath = 0.03;  // m, longest of a tick

/** Marks the robots, and places the ghosts of a tick. */
void Place(CPlanarScene& scene, CPlanarGhosts& ghosts, const std::vector<SGhostDisc>& discs) {
  CProximityFilter marks;
  marks.SetMargin(0.1);
  marks.Clear(scene.Store.GetDriven().size());
  for (UInt32 slot = 0; slot < scene.Store.GetDriven().size(); ++slot) {
    const SDrivenBody& body = scene.Store.GetDriven()[slot];
    marks.Place(slot, body.Pose.X, body.Pose.Y, body.BoundingRadius + kPath);
  }
  marks.MarkAll();
  ghosts.Set(discs);
  ghosts.FindMeetings(marks, kPath);
  scene.Active.Select(marks);
  ghosts.Place(kPath);
}

}  // namespace

TEST_CASE("planar ghosts: a robot stays on its half of the gap to a ghost", "[dynamics2d]") {
  CPlanarScene scene;
  CPlanarGhosts ghosts(scene.Store, scene.Active);
  const auto& robot = scene.AddRobot(0.0, 0.0, 0.3, 0.3);
  const int32 before = scene.Store.GetWorld().GetBodyCount();
  // the gap is 2 cm, the planned step 3 cm
  Place(scene, ghosts, {{0.12, 0.0, CPlanarScene::kRadius}});
  REQUIRE(scene.GetDriven(robot).IsActive());
  CHECK(scene.Store.GetWorld().GetBodyCount() == before + 2);
  scene.Drive(16);
  CHECK(scene.GetDriven(robot).NextPose.X > 0.005);
  CHECK(scene.GetDriven(robot).NextPose.X < 0.0125);
  ghosts.Remove();
  CHECK(scene.Store.GetWorld().GetBodyCount() == before + 1);
}

TEST_CASE("planar ghosts: a face affects its own robot only", "[dynamics2d]") {
  CPlanarScene scene;
  CPlanarGhosts ghosts(scene.Store, scene.Active);
  const auto& robot = scene.AddRobot(0.0, 0.0, 0.3, 0.3);
  // inside the face of the first robot, but too far from the ghost to touch it
  const auto& other = scene.AddRobot(0.10, 0.15, 0.3, 0.3);
  scene.Active.Activate(other.Handle.Slot);
  scene.Active.SetVelocity(other.Handle, {0.3, 0.0, 0.0});
  std::vector<SGhostDisc> discs = {{0.12, 0.0, CPlanarScene::kRadius}};
  CProximityFilter marks;
  marks.SetMargin(1.0);
  marks.Clear(2);
  marks.Place(0, 0.0, 0.0, 0.08);
  marks.Place(1, 0.10, 0.15, 0.0);
  marks.MarkAll();
  ghosts.Set(discs);
  ghosts.FindMeetings(marks, kPath);
  scene.Active.Select(marks);
  ghosts.Place(kPath);
  scene.Drive(4);
  CHECK(scene.GetDriven(robot).NextPose.X < 0.015);
  CHECK(scene.GetDriven(other).NextPose.X == Approx(0.13).epsilon(1e-12));
}

TEST_CASE("planar ghosts: a ghost far away has no body", "[dynamics2d]") {
  CPlanarScene scene;
  CPlanarGhosts ghosts(scene.Store, scene.Active);
  scene.AddRobot(0.0, 0.0, 0.3, 0.3);
  scene.AddBox(0.0, 1.0, true);
  const int32 before = scene.Store.GetWorld().GetBodyCount();
  Place(scene, ghosts, {{3.0, 0.0, CPlanarScene::kRadius}});
  CHECK(scene.Store.GetWorld().GetBodyCount() == before);
}

TEST_CASE("planar ghosts: a ghost pushes a passive body, even if it sleeps", "[dynamics2d]") {
  CPlanarScene scene;
  CPlanarGhosts ghosts(scene.Store, scene.Active);
  const auto& box = scene.AddBox(0.0, 0.0, true);
  b2Body& body = scene.Active.GetBox2DBody(box.Handle);
  body.SetAwake(false);
  // 5 mm deep in the box
  Place(scene, ghosts, {{-0.095, 0.0, CPlanarScene::kRadius}});
  CHECK(body.IsAwake());
  for (int i = 0; i < 20; ++i) {
    scene.Store.GetWorld().Step(0.01F, 8, 8);
  }
  CHECK(body.GetPosition().x > 0.01F);
  ghosts.Remove();
}

}  // namespace argos
