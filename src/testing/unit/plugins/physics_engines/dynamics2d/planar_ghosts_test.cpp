#include "planar_scene.h"

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_ghosts.h>

#include <catch2/catch.hpp>

namespace argos::planar_ghosts_test {

namespace {

constexpr Real kPath = 0.03;  // m, longest of a tick

/** A scene with ghosts. */
struct SGhostScene : CPlanarScene {
  CPlanarGhosts Ghosts{Store};

  /** Finds the robots that can meet something, and places the ghosts of a tick. */
  void Place(const std::vector<SGhostDisc>& discs) {
    StartCrowd(kPath);
    Ghosts.Set(discs);
    Ghosts.Place(Pairs, Crowd, kPath, kPath);
  }
  /** One tick of all bodies. */
  void Advance() {
    for (SDrivenBody& body : Store.GetDriven()) {
      Plan(body);
      body.Command = body.NextCommand;
    }
    Crowd.Advance(Pool, Pairs, kPath, kPath);
  }
};

}  // namespace

TEST_CASE("planar ghosts: a robot stays on its half of the gap to a ghost", "[dynamics2d]") {
  SGhostScene scene;
  const auto& robot = scene.AddRobot(0.0, 0.0, 0.3, 0.3);
  const auto& other = scene.AddRobot(0.0, 1.0, 0.3, 0.3);
  scene.Place({{0.12, 0.0, CPlanarScene::kRadius}});
  scene.Advance();
  // the line is 1 cm away
  CHECK(scene.GetDriven(robot).NextPose.X == Approx(0.01).margin(1e-4));
  CHECK(scene.GetDriven(robot).NextPose.Y == Approx(0.0).margin(1e-9));
  CHECK(scene.GetDriven(other).NextPose.X == Approx(0.03).epsilon(1e-12));
}

TEST_CASE("planar ghosts: a line affects its own robot only", "[dynamics2d]") {
  SGhostScene scene;
  const auto& robot = scene.AddRobot(0.0, 0.0, 0.3, 0.3);
  // it crosses the line of the first robot, but is too far from the ghost to touch it
  const auto& other = scene.AddRobot(0.04, 0.19, 0.3, 0.3);
  for (const auto* each : {&robot, &other}) {
    scene.Store.SetVelocity(each->Handle, {0.3, 0.0, 0.0});
  }
  scene.Place({{0.12, 0.0, CPlanarScene::kRadius}});
  scene.Advance();
  CHECK(scene.GetDriven(robot).NextPose.X < 0.015);
  CHECK(scene.GetDriven(other).NextPose.X == Approx(0.07).epsilon(1e-12));
}

TEST_CASE("planar ghosts: a ghost far away has no effect", "[dynamics2d]") {
  SGhostScene scene;
  const auto& robot = scene.AddRobot(0.0, 0.0, 0.3, 0.3);
  scene.AddBox(0.0, 1.0, true);
  scene.Place({{3.0, 0.0, CPlanarScene::kRadius}});
  scene.Advance();
  CHECK(scene.GetDriven(robot).NextPose.X == Approx(0.03).epsilon(1e-12));
}

TEST_CASE("planar ghosts: a ghost pushes a passive body, even if it rests", "[dynamics2d]") {
  SGhostScene scene;
  const auto& box = scene.AddBox(0.0, 0.0, true);
  scene.GetPassive(box).IsFresh = false;
  // 5 mm deep in the box
  for (int i = 0; i < 20; ++i) {
    scene.Place({{-0.095, 0.0, CPlanarScene::kRadius}});
    scene.Advance();
  }
  CHECK(scene.GetPassive(box).Pose.X == Approx(0.005).margin(3e-4));
}

}  // namespace argos::planar_ghosts_test
