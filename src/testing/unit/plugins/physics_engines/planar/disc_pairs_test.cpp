// The grid finds the same pairs that comparing each with each does.

#include "random_scene.h"

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/planar/disc_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace argos::disc_pairs_test {

namespace {

using TPairs = std::vector<std::pair<UInt32, UInt32>>;

using TDiscs = std::vector<SRandomScene::SDisc>;

// by number of disc, the lower one first
TPairs PairEachWithEach(const TDiscs& discs, Real reach) {
  TPairs pairs;
  for (UInt32 i = 0; i < discs.size(); ++i) {
    for (UInt32 j = i + 1; j < discs.size(); ++j) {
      if (std::hypot(discs[i].X - discs[j].X, discs[i].Y - discs[j].Y) <=
          discs[i].Radius + discs[j].Radius + 2.0 * reach) {
        pairs.emplace_back(i, j);
      }
    }
  }
  return pairs;
}

TPairs FindObstacles(const TDiscs& discs, const std::vector<SFootprint>& obstacles, Real reach) {
  TPairs pairs;
  for (UInt32 i = 0; i < discs.size(); ++i) {
    for (UInt32 j = 0; j < obstacles.size(); ++j) {
      if (DistanceTo(obstacles[j], discs[i].X, discs[i].Y) <= discs[i].Radius + reach) {
        pairs.emplace_back(i, j);
      }
    }
  }
  return pairs;
}

void Place(CDiscPairs& found, const TDiscs& discs) {
  found.Start(discs.size());
  for (UInt32 i = 0; i < discs.size(); ++i) {
    found.Place(i, discs[i].X, discs[i].Y, discs[i].Radius);
  }
}

// as found, in the order of the parts
TPairs ListPairs(const CDiscPairs& found) {
  TPairs pairs;
  for (const CDiscPairs::SPart& part : found.GetParts()) {
    for (const CDiscPairs::SPair& pair : part.Pairs) {
      const UInt32 a = found.GetDiscs()[pair.A].Number;
      const UInt32 b = found.GetDiscs()[pair.B].Number;
      pairs.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  return pairs;
}

TPairs ListObstaclePairs(const CDiscPairs& found) {
  TPairs pairs;
  for (const CDiscPairs::SPart& part : found.GetParts()) {
    for (const CDiscPairs::SObstaclePair& pair : part.ObstaclePairs) {
      pairs.emplace_back(found.GetDiscs()[pair.Disc].Number, pair.Obstacle);
    }
  }
  return pairs;
}

TPairs Sorted(TPairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

TEST_CASE("disc pairs: nothing is left of a tick with more discs", "[planar]") {
  CThreadPool pool(0, std::make_unique<CBalanceQuantitySchedule>());
  CDiscPairs found;
  constexpr Real kReach = 0.02;
  // the parts become fewer
  for (const int numDiscs : {5000, 3000, 1500, 700, 3}) {
    CAPTURE(numDiscs);
    const SRandomScene scene(numDiscs, 5.0, 1);
    Place(found, scene.Discs);
    found.Find(pool, kReach);
    REQUIRE(Sorted(ListPairs(found)) == PairEachWithEach(scene.Discs, kReach));
  }
}

TEST_CASE("disc pairs: the grid finds what comparing each with each finds", "[planar]") {
  const int numDiscs = GENERATE(1, 2, 30, 400, 5000);
  const Real side = GENERATE(0.5, 5.0, 60.0);
  const unsigned seed = GENERATE(1U, 2U);
  const UInt32 threads = GENERATE(0U, 3U);
  if (numDiscs == 5000 && side < 1.0) {
    return;  // millions of pairs
  }
  CAPTURE(numDiscs, side, seed, threads);
  constexpr Real kReach = 0.02;
  const SRandomScene scene(numDiscs, side, seed);
  const TDiscs& discs = scene.Discs;
  const std::vector<SFootprint>& obstacles = scene.Obstacles;

  CThreadPool pool(threads, std::make_unique<CBalanceQuantitySchedule>());
  CDiscPairs found;
  found.SetObstacles(obstacles);
  Place(found, discs);
  found.Find(pool, kReach);
  const TPairs pairs = PairEachWithEach(discs, kReach);
  const TPairs obstaclePairs = FindObstacles(discs, obstacles, kReach);
  REQUIRE(Sorted(ListPairs(found)) == pairs);
  REQUIRE(Sorted(ListObstaclePairs(found)) == obstaclePairs);
  std::vector<bool> isNear(discs.size(), false);
  for (const auto& [a, b] : pairs) {
    isNear[a] = isNear[b] = true;
  }
  for (const auto& pair : obstaclePairs) {
    isNear[pair.first] = true;
  }
  for (UInt32 place = 0; place < discs.size(); ++place) {
    REQUIRE(found.IsNear(place) == isNear[found.GetDiscs()[place].Number]);
  }

  // the order of places and of pairs does not depend on threads
  CThreadPool alone(0, std::make_unique<CBalanceQuantitySchedule>());
  CDiscPairs other;
  other.SetObstacles(obstacles);
  Place(other, discs);
  other.Find(alone, kReach);
  CHECK(ListPairs(other) == ListPairs(found));
  CHECK(ListObstaclePairs(other) == ListObstaclePairs(found));
}

TEST_CASE("disc pairs: a circle meets the discs within its radius and their reach", "[planar]") {
  CThreadPool pool(0, std::make_unique<CBalanceQuantitySchedule>());
  CDiscPairs found;
  Place(found, {{0.0, 0.0, 0.1}, {2.0, 0.0, 0.1}, {0.0, 0.0, 0.1}, {-1.25, 0.0, 0.1}});
  found.LeaveOut(2);
  found.Find(pool, 0.01);
  CHECK(found.GetDiscs().size() == 3);
  const auto list = [&found](Real x, Real radius) {
    std::vector<UInt32> numbers;
    found.ForNear(x, 0.0, radius,
                  [&](UInt32 place) { numbers.push_back(found.GetDiscs()[place].Number); });
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  };
  CHECK(list(1.0, 0.9) == std::vector<UInt32>{0, 1});
  CHECK(list(1.0, 0.88).empty());
  CHECK(list(-2.0, 0.65) == std::vector<UInt32>{3});
}

TEST_CASE("disc pairs: the widest disc is found in any run of discs", "[planar]") {
  // a run is 1024 discs; all but the widest are far from each other
  const UInt32 widest = GENERATE(0U, 1500U, 2999U);
  CAPTURE(widest);
  TDiscs discs;
  for (int i = 0; i < 3000; ++i) {
    discs.push_back({0.5 * (i % 60), 0.5 * (i / 60), 0.05});
  }
  discs[widest].Radius = 2.0;
  CThreadPool pool(0, std::make_unique<CBalanceQuantitySchedule>());
  CDiscPairs found;
  Place(found, discs);
  found.Find(pool, 0.01);
  const TPairs pairs = Sorted(ListPairs(found));
  CHECK(pairs.size() > 10);
  CHECK(pairs == PairEachWithEach(discs, 0.01));
}

}  // namespace argos::disc_pairs_test
