// The arena of the benchmark for a minute of simulated time: robots do not penetrate walls.

#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/overlap.h>
#include <argos3/testing/support/rooms.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace argos::testing::rooms_test {

TEST_CASE("rooms: 10,000 e-pucks stay out of the walls", "[scenario][dynamics2d]") {
  const std::string engine = GENERATE("dynamics2d", "kinematics2d");
  CAPTURE(engine);
  SRoomsWorld rooms;
  rooms.Engine = engine;
  rooms.Robots = 10000;
  rooms.Side = 40.0;
  rooms.RoomsPerSide = 4;
  rooms.Threads = 2;
  CTestWorld world(rooms.ToXML());
  REQUIRE(world.GetSpace().GetControllableEntities().size() == 10000);

  SOverlaps overlaps;
  Real deepestInWall = 0.0;
  for (UInt32 tick = 0; tick < FewerIfSanitized(600); ++tick) {
    world.Step();
    SOverlaps now;
    MeasureOverlaps(world.GetSpace(), now);
    deepestInWall = std::max(deepestInWall, SOverlaps::Quantile(now.WithWalls, 1.0));
    if (tick % 50 == 49) {
      overlaps.WithRobots.insert(overlaps.WithRobots.end(), now.WithRobots.begin(),
                                 now.WithRobots.end());
    }
  }
  // the limit of engines with default settings: 2 % of the radius
  CHECK(deepestInWall <= 0.02);
  CHECK(SOverlaps::Quantile(overlaps.WithRobots, 0.99) <= 0.02);

  // no robot has left the arena, whose outer walls are closed
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    const auto& body = robot->GetParent().GetComponent<CEmbodiedEntity>("body");
    const CVector3& position = body.GetOriginAnchor().Position;
    REQUIRE(std::abs(position.GetX()) < 20.0);
    REQUIRE(std::abs(position.GetY()) < 20.0);
  }
}

}  // namespace argos::testing::rooms_test
