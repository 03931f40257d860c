#include "planar_scene.h"

#include <catch2/catch.hpp>

namespace argos::active_set_test {

namespace {

void CheckNumbers(CPlanarScene& scene) {
  const std::vector<SActiveBody>& bodies = scene.Active.GetBodies();
  for (UInt32 i = 0; i < bodies.size(); ++i) {
    CHECK(scene.Store.GetDriven()[bodies[i].Slot].ActiveNumber == i);
  }
}

}  // namespace

TEST_CASE("active set: an active robot has a Box2D body with its state", "[dynamics2d]") {
  CPlanarScene scene;
  const auto& robot = scene.AddRobot(0.3, -0.2);
  scene.GetDriven(robot).Velocity = {0.1, 0.05, 0.7};
  const int32 before = scene.Store.GetWorld().GetBodyCount();
  scene.Active.Activate(robot.Handle.Slot);
  REQUIRE(scene.GetDriven(robot).IsActive());
  CHECK(scene.Store.GetWorld().GetBodyCount() == before + 1);
  const b2Body& body = scene.Active.GetBox2DBody(robot.Handle);
  CHECK(body.GetPosition().x == Approx(6.0));
  CHECK(body.GetPosition().y == Approx(-4.0));
  CHECK(body.GetLinearVelocity().x == Approx(2.0));
  CHECK(body.GetLinearVelocity().y == Approx(1.0));
  CHECK(body.GetAngularVelocity() == Approx(0.7));
  CHECK(body.GetMass() == Approx(0.5));

  scene.Active.Deactivate(robot.Handle.Slot);
  CHECK_FALSE(scene.GetDriven(robot).IsActive());
  CHECK(scene.Store.GetWorld().GetBodyCount() == before);
}

TEST_CASE("active set: the last robot takes the number of a deactivated one", "[dynamics2d]") {
  CPlanarScene scene;
  for (int i = 0; i < 3; ++i) {
    scene.AddRobot(0.5 * i, 0.0);
    scene.Active.Activate(static_cast<UInt32>(i));
  }
  scene.Active.Deactivate(0);
  REQUIRE(scene.Active.GetBodies().size() == 2);
  CHECK(scene.Active.GetBodies()[0].Slot == 2);
  CHECK(scene.Active.GetBodies()[1].Slot == 1);
  CheckNumbers(scene);

  // slot 0 is removed, and gets the robot of slot 2
  scene.Store.Remove(scene.Bodies[0].Handle);
  scene.Active.UpdateSlot(0);
  CHECK(scene.Bodies[2].Handle.Slot == 0);
  CHECK(scene.Active.GetBodies()[0].Slot == 0);
  CheckNumbers(scene);
}

TEST_CASE("active set: the discs of excluded clusters are active", "[dynamics2d]") {
  CPlanarScene scene;
  scene.AddRobot(0.0, 0.0);  // can meet the next one, which is excluded
  scene.AddRobot(0.1, 0.0);
  scene.AddRobot(2.0, 0.0);  // excluded, and alone
  scene.AddRobot(4.0, 0.0);  // active, but not excluded
  scene.AddRobot(6.0, 0.0);  // can meet the next one; neither is excluded
  scene.AddRobot(6.1, 0.0);
  scene.Active.Activate(3);
  scene.StartCrowd(0.01);
  for (const Real x : {0.1, 2.0}) {
    scene.Pairs.ForNear(x, 0.0, -0.055, [&scene](UInt32 place) { scene.Crowd.Exclude(place); });
  }
  scene.Active.Select(scene.Pairs, scene.Crowd);

  CHECK(scene.Store.GetDriven()[0].IsActive());
  CHECK(scene.Store.GetDriven()[1].IsActive());
  CHECK(scene.Store.GetDriven()[2].IsActive());
  CHECK_FALSE(scene.Store.GetDriven()[3].IsActive());
  CHECK_FALSE(scene.Store.GetDriven()[4].IsActive());
  CHECK_FALSE(scene.Store.GetDriven()[5].IsActive());
  CheckNumbers(scene);
}

TEST_CASE("active set: a robot that nothing pushes ends exactly at its planned pose",
          "[dynamics2d]") {
  CPlanarScene scene;
  const auto& robot = scene.AddRobot(0.3, 0.1, 0.10, 0.08);
  scene.Active.Activate(robot.Handle.Slot);
  const Real yawRate = (0.08 - 0.10) * (1.0 / 0.08);
  const SArc arc =
      FollowArc(scene.GetDriven(robot).Pose, {0.09, 0.0, yawRate}, CPlanarScene::kTick);
  scene.Drive(3);
  const SDrivenBody& body = scene.GetDriven(robot);
  CHECK(body.NextPose.X == arc.End.X);
  CHECK(body.NextPose.Y == arc.End.Y);
  CHECK(body.NextPose.HalfSin == arc.End.HalfSin);
  CHECK(body.NextVelocity.X == arc.DX / CPlanarScene::kTick);
}

TEST_CASE("active set: a wall stops a robot, which gets Box2D's pose", "[dynamics2d]") {
  CPlanarScene scene;
  // the gap is 5 mm, the planned step 20 mm
  const auto& robot = scene.AddRobot(-0.105, 0.0, 0.2, 0.2);
  scene.AddBox(0.0, 0.0, false);
  scene.Active.Activate(robot.Handle.Slot);
  scene.Drive(8);
  const SDrivenBody& body = scene.GetDriven(robot);
  CHECK(body.NextPose.X > -0.105);
  CHECK(body.NextPose.X < -0.095);
  CHECK(body.NextVelocity.X < 0.1);
}

TEST_CASE("active set: the velocity of an inactive robot is set without Box2D", "[dynamics2d]") {
  CPlanarScene scene;
  const auto& idle = scene.AddRobot(0.0, 0.0);
  const auto& active = scene.AddRobot(1.0, 0.0);
  scene.Active.Activate(active.Handle.Slot);
  const SPlanarVelocity velocity = {0.2, -0.1, 0.4};
  scene.Active.SetVelocity(idle.Handle, velocity);
  scene.Active.SetVelocity(active.Handle, velocity);
  CHECK(scene.Store.GetVelocity(idle.Handle).X == 0.2);
  CHECK(scene.Store.GetVelocity(active.Handle).W == 0.4);
  CHECK(scene.Active.GetBox2DBody(active.Handle).GetLinearVelocity().x == Approx(4.0));
}

TEST_CASE("active set: the needed substeps grow with the speed", "[dynamics2d]") {
  CPlanarScene scene;
  const auto& robot = scene.AddRobot(0.0, 0.0, 0.5, 0.5);
  scene.Active.Activate(robot.Handle.Slot);
  scene.GetDriven(robot).NextCommand = {0.5, 0.0, 0.0};
  scene.Active.StartTick();
  // 5 cm in a tick, at most half a radius in a substep
  CHECK(scene.Active.ComputeNeededSubsteps() == Approx(2.0));
  // force 1 N, radius 5 cm, mass 0.5 kg
  CHECK(scene.Active.ComputeWeakestDrive() == Approx(0.025));
}

}  // namespace argos::active_set_test
