#include "planar_scene.h"

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_ghosts.h>

#include <catch2/catch.hpp>

namespace argos::planar_ghosts_test {

namespace {

constexpr Real kPath = 0.03;  // m, longest of a tick

/** A scene with ghosts. */
struct SGhostScene : CPlanarScene {
  CPlanarGhosts Ghosts{Store, Active};

  /** Finds the robots that can meet something, and places the ghosts of a tick. */
  void Place(const std::vector<SGhostDisc>& discs) {
    StartCrowd(kPath);
    Ghosts.Set(discs);
    Ghosts.Place(Pairs, Crowd, kPath, kPath);
  }
  /** One tick of the robots without a body in Box2D. */
  void Advance() {
    for (SDrivenBody& body : Store.GetDriven()) {
      Plan(body);
      body.Command = body.NextCommand;
    }
    Crowd.Advance(Pool, Pairs, kPath, kPath);
  }
};

}  // namespace

TEST_CASE("planar ghosts: a robot in Box2D stays on its half of the gap to a ghost",
          "[dynamics2d]") {
  SGhostScene scene;
  const auto& robot = scene.AddRobot(0.0, 0.0, 0.3, 0.3);
  scene.Active.Activate(robot.Handle.Slot);
  const int32 before = scene.Store.GetWorld().GetBodyCount();
  // the gap is 2 cm, the planned step 3 cm
  scene.Place({{0.12, 0.0, CPlanarScene::kRadius}});
  CHECK(scene.Store.GetWorld().GetBodyCount() == before + 1);
  scene.Drive(16);
  CHECK(scene.GetDriven(robot).NextPose.X > 0.005);
  CHECK(scene.GetDriven(robot).NextPose.X < 0.0125);
  scene.Ghosts.Remove();
  CHECK(scene.Store.GetWorld().GetBodyCount() == before);
}

TEST_CASE("planar ghosts: a robot of the crowd stays on its half of the gap to a ghost",
          "[dynamics2d]") {
  SGhostScene scene;
  const auto& robot = scene.AddRobot(0.0, 0.0, 0.3, 0.3);
  const auto& other = scene.AddRobot(0.0, 1.0, 0.3, 0.3);
  const int32 before = scene.Store.GetWorld().GetBodyCount();
  scene.Place({{0.12, 0.0, CPlanarScene::kRadius}});
  CHECK(scene.Store.GetWorld().GetBodyCount() == before);
  scene.Advance();
  // the line is 1 cm away
  CHECK(scene.GetDriven(robot).NextPose.X == Approx(0.01).margin(1e-4));
  CHECK(scene.GetDriven(robot).NextPose.Y == Approx(0.0).margin(1e-9));
  CHECK(scene.GetDriven(other).NextPose.X == Approx(0.03).epsilon(1e-12));
}

TEST_CASE("planar ghosts: a face affects its own robot only", "[dynamics2d]") {
  SGhostScene scene;
  const auto& robot = scene.AddRobot(0.0, 0.0, 0.3, 0.3);
  // inside the face of the first robot, but too far from the ghost to touch it
  const auto& other = scene.AddRobot(0.10, 0.19, 0.3, 0.3);
  for (const auto* each : {&robot, &other}) {
    scene.Active.Activate(each->Handle.Slot);
    scene.Active.SetVelocity(each->Handle, {0.3, 0.0, 0.0});
  }
  scene.Place({{0.12, 0.0, CPlanarScene::kRadius}});
  scene.Drive(4);
  CHECK(scene.GetDriven(robot).NextPose.X < 0.015);
  CHECK(scene.GetDriven(other).NextPose.X == Approx(0.13).epsilon(1e-12));
}

TEST_CASE("planar ghosts: a ghost far away has no body", "[dynamics2d]") {
  SGhostScene scene;
  scene.AddRobot(0.0, 0.0, 0.3, 0.3);
  scene.AddBox(0.0, 1.0, true);
  const int32 before = scene.Store.GetWorld().GetBodyCount();
  scene.Place({{3.0, 0.0, CPlanarScene::kRadius}});
  CHECK(scene.Store.GetWorld().GetBodyCount() == before);
}

TEST_CASE("planar ghosts: a ghost pushes a passive body, even if it sleeps", "[dynamics2d]") {
  SGhostScene scene;
  const auto& box = scene.AddBox(0.0, 0.0, true);
  b2Body& body = scene.Active.GetBox2DBody(box.Handle);
  body.SetAwake(false);
  // 5 mm deep in the box
  scene.Place({{-0.095, 0.0, CPlanarScene::kRadius}});
  CHECK(body.IsAwake());
  for (int i = 0; i < 20; ++i) {
    scene.Store.GetWorld().Step(0.01F, 8, 8);
  }
  CHECK(body.GetPosition().x > 0.01F);
  scene.Ghosts.Remove();
}

}  // namespace argos::planar_ghosts_test
