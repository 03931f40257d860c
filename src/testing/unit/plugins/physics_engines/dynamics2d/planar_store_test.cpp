#include "planar_scene.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::planar_store_test {

TEST_CASE("planar store: handles follow the bodies", "[dynamics2d]") {
  CPlanarScene scene;
  for (int i = 0; i < 3; ++i) {
    scene.AddRobot(i, 0.0);
    scene.AddBox(i, 1.0, true);
    scene.AddBox(i, 2.0, false);
  }
  // bodies 0, 3, 6 are robots, 1, 4, 7 boxes, 2, 5, 8 walls
  for (const size_t first : {0U, 1U, 2U}) {
    scene.Store.Remove(scene.Bodies[first].Handle);
    CHECK(scene.Bodies[first].Handle.Slot == SPlanarHandle::kNowhere);
    CHECK(scene.Bodies[first + 6].Handle.Slot == 0);
    CHECK(scene.Bodies[first + 3].Handle.Slot == 1);
    CHECK(scene.Store.GetOwner(scene.Bodies[first + 6].Handle).Body ==
          &scene.Bodies[first + 6].Entity);
  }
  CHECK(scene.GetDriven(scene.Bodies[6]).Pose.X == 2.0);
  CHECK(scene.GetPassive(scene.Bodies[7]).Pose.X == 2.0);
}

TEST_CASE("planar store: masses and moments of solids are those of the description",
          "[engine][dynamics2d]") {
  SBodyDescription description;
  description.Shapes.push_back(
      SShapeDescription::Box(CVector3(0.4, 0.2, 0.6), CVector3(0.3, -0.1, 0.0)));
  description.Mass = 2.0;
  const SPlanarSolid solid = DescribeSolid(description, {0.0, 0.0});
  CHECK(solid.Mass == 2.0);
  CHECK(solid.CentreX == Approx(0.3));
  CHECK(solid.CentreY == Approx(-0.1));
  CHECK(solid.Inertia == Approx(2.0 * (0.16 + 0.04) / 12.0));
  CHECK(solid.NarrowestHalf == Approx(0.1));
  // less than the offset of the centre of mass needs
  description.PlanarInertia = 0.1;
  CHECK(DescribeSolid(description, {0.0, 0.0}).Inertia == Approx(0.2 * 0.001));
}

TEST_CASE("planar store: obstacles are listed when they have changed", "[dynamics2d]") {
  CPlanarScene scene;
  CHECK_FALSE(scene.Store.HaveObstaclesChanged());
  const auto& wall = scene.AddBox(1.0, 2.0, false);
  REQUIRE(scene.Store.HaveObstaclesChanged());
  const std::vector<SFootprint> obstacles = scene.Store.ListObstacles();
  REQUIRE(obstacles.size() == 1);
  CHECK(obstacles[0].X == 1.0);
  CHECK(obstacles[0].HalfX == Approx(0.05));
  CHECK_FALSE(scene.Store.HaveObstaclesChanged());
  scene.Store.Remove(wall.Handle);
  CHECK(scene.Store.HaveObstaclesChanged());
  CHECK(scene.Store.ListObstacles().empty());
}

TEST_CASE("planar store: the widest movable body is any robot or object that was added",
          "[dynamics2d]") {
  CPlanarScene scene;
  scene.AddBox(0.0, 0.0, false);
  CHECK(scene.Store.GetWidestMovable() == 0.0);
  scene.AddRobot(1.0, 0.0);
  CHECK(scene.Store.GetWidestMovable() == CPlanarScene::kRadius);
  scene.AddBox(2.0, 0.0, true);
  const Real wide = scene.Store.GetWidestMovable();
  // half of the diagonal
  CHECK(wide == Approx(0.05 * std::sqrt(2.0)).epsilon(1e-12));
  scene.AddRobot(3.0, 0.0);
  CHECK(scene.Store.GetWidestMovable() == wide);
  SBodyDescription wider = CPlanarScene::DescribeRobot();
  wider.Shapes[0] = SShapeDescription::Cylinder(0.2, 0.1);
  scene.AddRobot(4.0, 0.0, 0.0, 0.0, wider);
  scene.AddBox(5.0, 0.0, true);
  CHECK(scene.Store.GetWidestMovable() == 0.2);
}

TEST_CASE("planar store: a pose is compared except for rounding", "[dynamics2d]") {
  CPlanarScene scene;
  const auto& robot = scene.AddRobot(0.1, 0.2);
  const auto& wall = scene.AddBox(1.0, 2.0, false);
  SPlanarPose pose = CPlanarScene::PoseAt(0.1, 0.2);
  CHECK(scene.Store.IsAt(robot.Handle, pose));
  // the same heading with the other sign of the half angle
  pose.HalfCos = -1.0;
  CHECK(scene.Store.IsAt(robot.Handle, pose));
  pose.SetYaw(1e-13);
  CHECK(scene.Store.IsAt(robot.Handle, pose));
  pose.SetYaw(1e-9);
  CHECK_FALSE(scene.Store.IsAt(robot.Handle, pose));
  CHECK_FALSE(scene.Store.IsAt(robot.Handle, CPlanarScene::PoseAt(std::nextafter(0.1, 1.0), 0.2)));
  CHECK_FALSE(scene.Store.IsAt(wall.Handle, CPlanarScene::PoseAt(1.0, 2.0)));
}

}  // namespace argos::planar_store_test
