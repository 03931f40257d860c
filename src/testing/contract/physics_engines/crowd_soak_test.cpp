// Twenty thousand robots that press, of which some are added, removed and moved in each tick.

#include <argos3/testing/contract/physics_engines/turnover.h>
#include <argos3/testing/support/overlap.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/rooms.h>

#include <argos3/core/utility/plugins/dynamic_loading.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::crowd_soak_test {

using testing::MeasureOverlaps;
using testing::SOverlaps;
using testing::SRoomsWorld;

TEST_CASE("crowd: none is lost or enters a wall while robots are added, removed and moved",
          "[.][soak][crowd]") {
  constexpr UInt32 kRobots = 20000;
  CDynamicLoading::LoadLibrary(InBuildTree("experiments/libepuck_vector_diffusion"));
  SRoomsWorld rooms;
  rooms.Robots = kRobots;
  rooms.Side = 40.0 * std::sqrt(kRobots / 100000.0);  // discs cover a quarter of the ground
  rooms.RoomsPerSide = 2;
  rooms.DoorWidth = 2.0;
  rooms.Threads = 2;
  rooms.Controller = "epuck_vector_diffusion_controller";
  CTestWorld world(rooms.ToXML());
  CTurnover turnover(world, rooms.Side, 20);
  Real deepest = 0.0;
  const auto check = [&] {
    turnover.Check();
    // Walls are 10 cm thick: who has come through one was seen in it.
    SOverlaps overlaps;
    MeasureOverlaps(world.GetSpace(), overlaps);
    deepest = std::max(deepest, SOverlaps::Quantile(overlaps.WithWalls, 1.0));
    REQUIRE(SOverlaps::Quantile(overlaps.WithWalls, 1.0) <= 0.02);
    REQUIRE(SOverlaps::Quantile(overlaps.WithRobots, 0.99) <= 0.02);
  };
  Soak([&] { turnover.Tick(); }, check);
  WARN("at most " << 100.0 * deepest << " % of a radius in a wall");
}

}  // namespace argos::crowd_soak_test
