// The grid finds the same discs that comparing each with each does.

#include "random_scene.h"

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/planar/proximity_filter.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace argos::proximity_filter_test {

namespace {

CProximityFilter::EMark MarkOf(Real gap, Real margin) {
  if (gap <= 0.0) {
    return CProximityFilter::Active;
  }
  return gap <= margin ? CProximityFilter::Guarded : CProximityFilter::Free;
}

std::vector<CProximityFilter::EMark> MarkEachWithEach(const SRandomScene& scene, Real margin) {
  const std::vector<SRandomScene::SDisc>& discs = scene.Discs;
  std::vector<CProximityFilter::EMark> marks(discs.size(), CProximityFilter::Free);
  for (size_t i = 0; i < discs.size(); ++i) {
    for (size_t j = 0; j < discs.size(); ++j) {
      if (i != j) {
        const Real gap = std::hypot(discs[i].X - discs[j].X, discs[i].Y - discs[j].Y) -
                         discs[i].Radius - discs[j].Radius;
        marks[i] = std::max(marks[i], MarkOf(gap, margin));
      }
    }
    for (const SFootprint& obstacle : scene.Obstacles) {
      const Real gap = DistanceTo(obstacle, discs[i].X, discs[i].Y) - discs[i].Radius;
      marks[i] = std::max(marks[i], MarkOf(gap, margin));
    }
  }
  return marks;
}

}  // namespace

TEST_CASE("proximity filter: the grid finds what comparing each with each finds", "[dynamics2d]") {
  const int numDiscs = GENERATE(1, 2, 30, 400);
  const Real side = GENERATE(0.5, 5.0, 60.0);
  const unsigned seed = GENERATE(1U, 2U, 3U);
  CAPTURE(numDiscs, side, seed);
  constexpr Real kMargin = 0.02;
  const SRandomScene scene(numDiscs, side, seed);
  const std::vector<SRandomScene::SDisc>& discs = scene.Discs;

  CThreadPool pool(0, std::make_unique<CBalanceQuantitySchedule>());
  CProximityFilter filter;
  filter.SetMargin(kMargin);
  filter.SetObstacles(scene.Obstacles);
  filter.Clear(discs.size());
  for (UInt32 i = 0; i < discs.size(); ++i) {
    filter.Place(i, discs[i].X, discs[i].Y, discs[i].Radius);
  }
  filter.MarkAll(pool);
  const std::vector<CProximityFilter::EMark> expected = MarkEachWithEach(scene, kMargin);
  for (UInt32 i = 0; i < discs.size(); ++i) {
    CAPTURE(i, discs[i].X, discs[i].Y, discs[i].Radius);
    REQUIRE(filter.GetMark(i) == expected[i]);
  }
}

TEST_CASE("proximity filter: a body that is no disc marks the discs that it may meet",
          "[dynamics2d]") {
  CThreadPool pool(0, std::make_unique<CBalanceQuantitySchedule>());
  CProximityFilter filter;
  filter.SetMargin(0.1);
  filter.Clear(4);
  filter.Place(0, 0.0, 0.0, 0.1);
  filter.Place(1, 2.0, 0.0, 0.1);
  filter.Place(3, -1.25, 0.0, 0.1);
  filter.MarkAll(pool);
  filter.MarkNear(1.0, 0.0, 0.95);
  CHECK(filter.GetMark(0) == CProximityFilter::Active);
  CHECK(filter.GetMark(1) == CProximityFilter::Active);
  // never placed
  CHECK(filter.GetMark(2) == CProximityFilter::Free);
  CHECK(filter.GetMark(3) == CProximityFilter::Free);
  // 0.05 m are missing, less than the margin
  filter.MarkNear(-2.0, 0.0, 0.6);
  CHECK(filter.GetMark(3) == CProximityFilter::Guarded);
}

TEST_CASE("proximity filter: a disc may reach farther than others do", "[dynamics2d]") {
  // two that are far apart, in a row of small ones
  CThreadPool pool(0, std::make_unique<CBalanceQuantitySchedule>());
  CProximityFilter filter;
  filter.SetMargin(0.01);
  filter.Clear(102);
  for (UInt32 i = 0; i < 100; ++i) {
    filter.Place(i, 0.5 * i, 10.0, 0.05);
  }
  filter.Place(100, 0.0, 0.0, 3.0);
  filter.Place(101, 5.0, 0.0, 2.5);
  filter.MarkAll(pool);
  CHECK(filter.GetMark(0) == CProximityFilter::Free);
  CHECK(filter.GetMark(100) == CProximityFilter::Active);
  CHECK(filter.GetMark(101) == CProximityFilter::Active);
}

}  // namespace argos::proximity_filter_test
