// Many robots that cross many borders: none is lost, duplicated or stuck.

#include <argos3/testing/contract/physics_engines/regions.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/overlap.h>
#include <argos3/testing/support/rooms.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <catch2/catch.hpp>

#include <set>

namespace argos::border_crowd_test {

using testing::MeasureOverlaps;
using testing::SOverlaps;
using testing::SRoomsWorld;

namespace {

std::vector<CEmbodiedEntity*> ListBodies(CTestWorld& world) {
  std::vector<CEmbodiedEntity*> bodies;
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    bodies.push_back(&robot->GetParent().GetComponent<CEmbodiedEntity>("body"));
  }
  return bodies;
}

size_t CountModels(CTestWorld& world) {
  size_t count = 0;
  for (CPhysicsEngine* engine : world.GetSimulator().GetPhysicsEngines()) {
    count += engine->GetNumPhysicsModels();
  }
  return count;
}

/**
 * E-pucks that diffuse through rooms, in a grid of engines whose borders run through the rooms.
 * @return number of border crossings.
 */
int RunCrowd(const SEngineType& engine, UInt32 robots, UInt32 engines, UInt32 seconds) {
  SRoomsWorld rooms;
  rooms.Robots = robots;
  rooms.Side = SRoomsWorld::SideAtSameDensity(robots);
  rooms.RoomsPerSide = 3;
  rooms.Threads = 2;
  rooms.Engine = "auto_partition";
  rooms.EngineAttributes = "engine='" + engine.Tag + "' count='" + std::to_string(engines) + "'";
  CTestWorld world(rooms.ToXML());
  const std::vector<CEmbodiedEntity*> bodies = ListBodies(world);
  REQUIRE(bodies.size() == robots);
  const size_t models = CountModels(world);

  int crossings = 0;
  std::vector<CPhysicsEngine*> where;
  std::vector<CVector3> places;
  for (CEmbodiedEntity* body : bodies) {
    where.push_back(&body->GetPhysicsModel(size_t(0)).GetEngine());
    places.push_back(body->GetOriginAnchor().Position);
  }
  SOverlaps overlaps;
  for (UInt32 second = 0; second < seconds; ++second) {
    world.Step(10);
    for (size_t i = 0; i < bodies.size(); ++i) {
      // each robot is in one engine, the one that contains it
      REQUIRE(bodies[i]->GetPhysicsModelsNum() == 1);
      CPhysicsEngine& now = bodies[i]->GetPhysicsModel(size_t(0)).GetEngine();
      REQUIRE(now.IsPointContained(bodies[i]->GetOriginAnchor().Position));
      crossings += &now != where[i] ? 1 : 0;
      where[i] = &now;
    }
    REQUIRE(CountModels(world) == models);
    MeasureOverlaps(world.GetSpace(), overlaps);
    // at 10 cm/s, and turning a tenth of the time, every robot moves within a minute
    if (second % 60 == 59) {
      for (size_t i = 0; i < bodies.size(); ++i) {
        const CVector3& place = bodies[i]->GetOriginAnchor().Position;
        REQUIRE(Distance(place, places[i]) > 0.001);
        places[i] = place;
      }
    }
  }
  // the limit for robots in any engine, with or without borders
  CHECK(SOverlaps::Quantile(overlaps.WithRobots, 0.99) <= 0.02);
  CHECK(SOverlaps::Quantile(overlaps.WithWalls, 1.0) <= 0.02);
  return crossings;
}

}  // namespace

TEST_CASE("border crowd: robots that roam for a minute are neither lost nor duplicated nor stuck",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  if (IsSkipped(engine, engine.HasContacts, "contacts: its robots would leave the arena")) {
    return;
  }
  const UInt32 engines = GENERATE(4U, 16U);
  CAPTURE(engine, engines);
  // in 60 s each of 150 robots on about 24 m^2 drives 5 m
  CHECK(RunCrowd(engine, 150, engines, 60) > 150);
}

}  // namespace argos::border_crowd_test
