// The arena of the benchmark for a minute of simulated time: robots do not penetrate walls.

#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/overlap.h>
#include <argos3/testing/support/rooms.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
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
  rooms.Robots = FewerIfSanitized(10000);
  rooms.Side = 40.0;
  rooms.RoomsPerSide = 4;
  rooms.Threads = 2;
  CTestWorld world(rooms.ToXML());
  REQUIRE(world.GetSpace().GetControllableEntities().size() == rooms.Robots);

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

TEST_CASE("walls: boxes follow the size of the arena and the points of a line",
          "[scenario][walls]") {
  const std::string side = GENERATE("2", "30");
  CAPTURE(side);
  SExperiment experiment;
  experiment.ArenaSize = side + "," + side + ",1";
  experiment.Engines = "<dynamics2d id='e'/>";
  experiment.Arena =
      "<walls thickness='0.1' height='0.3'/>"
      "<walls id='line' points='0,0 0.5,0.5' thickness='0.02' height='0.2' base='0'/>";
  CTestWorld world(experiment);
  CSpace& space = world.GetSpace();
  CHECK(space.GetRootEntityVector().size() == 5);
  const auto& east = dynamic_cast<CBoxEntity&>(space.GetEntity("walls_1"));
  CHECK_THAT(east.GetEmbodiedEntity().GetOriginAnchor().Position.GetX(),
             Catch::WithinAbs(0.5 * std::stod(side) - 0.05, 1e-12));
  CHECK(!east.GetEmbodiedEntity().IsMovable());
  const auto& line = dynamic_cast<CBoxEntity&>(space.GetEntity("line_0"));
  CHECK_THAT(line.GetSize().GetX(), Catch::WithinAbs(std::sqrt(0.5), 1e-12));
  CHECK(line.GetSize().GetZ() == 0.2);
  CRadians z;
  CRadians y;
  CRadians x;
  line.GetEmbodiedEntity().GetOriginAnchor().Orientation.ToEulerAngles(z, y, x);
  CHECK_THAT(z.GetValue(), Catch::WithinAbs(M_PI / 4.0, 1e-12));
}

}  // namespace argos::testing::rooms_test
