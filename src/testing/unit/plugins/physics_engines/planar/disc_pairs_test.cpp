// The grid finds the same pairs that comparing each with each does.

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/planar/disc_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace argos {

namespace {

using TPairs = std::vector<std::pair<UInt32, UInt32>>;

struct SDisc {
  Real X, Y, Radius;
};

Real DistanceTo(const SFootprint& obstacle, Real x, Real y) {
  const Real dx = x - obstacle.X;
  const Real dy = y - obstacle.Y;
  const Real along = std::abs(obstacle.Cos * dx + obstacle.Sin * dy) - obstacle.HalfX;
  const Real across = std::abs(obstacle.Cos * dy - obstacle.Sin * dx) - obstacle.HalfY;
  const Real outside = std::hypot(std::max(along, 0.0), std::max(across, 0.0));
  return std::max(outside - obstacle.Radius, 0.0);
}

// by number of disc, the lower one first
TPairs PairEachWithEach(const std::vector<SDisc>& discs, Real reach) {
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

TPairs FindObstacles(const std::vector<SDisc>& discs, const std::vector<SFootprint>& obstacles,
                     Real reach) {
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

void Place(CDiscPairs& filter, const std::vector<SDisc>& discs) {
  filter.Start(discs.size());
  for (UInt32 i = 0; i < discs.size(); ++i) {
    filter.Place(i, discs[i].X, discs[i].Y, discs[i].Radius);
  }
}

// as found, in the order of the parts
TPairs ListPairs(const CDiscPairs& filter) {
  TPairs pairs;
  for (const CDiscPairs::SPart& part : filter.GetParts()) {
    for (const CDiscPairs::SPair& pair : part.Pairs) {
      const UInt32 a = filter.GetDiscs()[pair.A].Number;
      const UInt32 b = filter.GetDiscs()[pair.B].Number;
      pairs.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  return pairs;
}

TPairs ListObstaclePairs(const CDiscPairs& filter) {
  TPairs pairs;
  for (const CDiscPairs::SPart& part : filter.GetParts()) {
    for (const CDiscPairs::SObstaclePair& pair : part.ObstaclePairs) {
      pairs.emplace_back(filter.GetDiscs()[pair.Disc].Number, pair.Obstacle);
    }
  }
  return pairs;
}

TPairs Sorted(TPairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

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
  std::mt19937 generator(seed);
  std::uniform_real_distribution<Real> position(-0.5 * side, 0.5 * side);
  std::uniform_real_distribution<Real> radius(0.03, 0.12);
  std::uniform_real_distribution<Real> angle(0.0, 6.28);

  std::vector<SDisc> discs;
  for (int i = 0; i < numDiscs; ++i) {
    discs.push_back({position(generator), position(generator), radius(generator)});
  }
  std::vector<SFootprint> obstacles;
  for (int i = 0; i < 10; ++i) {
    const Real yaw = angle(generator);
    const bool disc = i % 3 == 0;
    obstacles.push_back({position(generator), position(generator), disc ? 1.0 : std::cos(yaw),
                         disc ? 0.0 : std::sin(yaw), disc ? 0.0 : 0.1 * side, disc ? 0.0 : 0.01,
                         disc ? radius(generator) : 0.0});
  }

  CThreadPool pool(threads, std::make_unique<CBalanceQuantitySchedule>());
  CDiscPairs filter;
  filter.SetObstacles(obstacles);
  Place(filter, discs);
  filter.Find(pool, kReach);
  const TPairs pairs = PairEachWithEach(discs, kReach);
  const TPairs obstaclePairs = FindObstacles(discs, obstacles, kReach);
  REQUIRE(Sorted(ListPairs(filter)) == pairs);
  REQUIRE(Sorted(ListObstaclePairs(filter)) == obstaclePairs);
  std::vector<bool> isNear(discs.size(), false);
  for (const auto& [a, b] : pairs) {
    isNear[a] = isNear[b] = true;
  }
  for (const auto& pair : obstaclePairs) {
    isNear[pair.first] = true;
  }
  for (UInt32 place = 0; place < discs.size(); ++place) {
    REQUIRE(filter.IsNear(place) == isNear[filter.GetDiscs()[place].Number]);
  }

  // the order of places and of pairs does not depend on threads
  CThreadPool alone(0, std::make_unique<CBalanceQuantitySchedule>());
  CDiscPairs other;
  other.SetObstacles(obstacles);
  Place(other, discs);
  other.Find(alone, kReach);
  CHECK(ListPairs(other) == ListPairs(filter));
  CHECK(ListObstaclePairs(other) == ListObstaclePairs(filter));
}

TEST_CASE("disc pairs: a circle meets the discs within its radius and their reach", "[planar]") {
  CThreadPool pool(0, std::make_unique<CBalanceQuantitySchedule>());
  CDiscPairs filter;
  Place(filter, {{0.0, 0.0, 0.1}, {2.0, 0.0, 0.1}, {0.0, 0.0, 0.1}, {-1.25, 0.0, 0.1}});
  filter.LeaveOut(2);
  filter.Find(pool, 0.01);
  CHECK(filter.GetDiscs().size() == 3);
  const auto list = [&filter](Real x, Real radius) {
    std::vector<UInt32> numbers;
    filter.ForNear(x, 0.0, radius,
                   [&](UInt32 place) { numbers.push_back(filter.GetDiscs()[place].Number); });
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  };
  CHECK(list(1.0, 0.9) == std::vector<UInt32>{0, 1});
  CHECK(list(1.0, 0.88).empty());
  CHECK(list(-2.0, 0.65) == std::vector<UInt32>{3});
}

}  // namespace argos
