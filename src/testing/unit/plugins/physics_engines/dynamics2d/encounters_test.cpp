// The grid finds the same discs as a comparison of all pairs.

#include <argos3/plugins/simulator/physics_engines/dynamics2d/encounters.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace argos {

namespace {

struct SDisc {
  Real X, Y, Reach;
};

Real DistanceTo(const SFootprint& obstacle, Real x, Real y) {
  const Real dx = x - obstacle.X;
  const Real dy = y - obstacle.Y;
  const Real along = std::abs(obstacle.Cos * dx + obstacle.Sin * dy) - obstacle.HalfX;
  const Real across = std::abs(obstacle.Cos * dy - obstacle.Sin * dx) - obstacle.HalfY;
  const Real outside = std::hypot(std::max(along, 0.0), std::max(across, 0.0));
  return std::max(outside - obstacle.Radius, 0.0);
}

CEncounters::EMark MarkOf(Real gap, Real margin) {
  if (gap <= 0.0) {
    return CEncounters::Near;
  }
  return gap <= margin ? CEncounters::Around : CEncounters::Alone;
}

std::vector<CEncounters::EMark> MarkEachWithEach(const std::vector<SDisc>& discs,
                                                 const std::vector<SFootprint>& obstacles,
                                                 Real margin) {
  std::vector<CEncounters::EMark> marks(discs.size(), CEncounters::Alone);
  for (size_t i = 0; i < discs.size(); ++i) {
    for (size_t j = 0; j < discs.size(); ++j) {
      if (i != j) {
        const Real gap = std::hypot(discs[i].X - discs[j].X, discs[i].Y - discs[j].Y) -
                         discs[i].Reach - discs[j].Reach;
        marks[i] = std::max(marks[i], MarkOf(gap, margin));
      }
    }
    for (const SFootprint& obstacle : obstacles) {
      const Real gap = DistanceTo(obstacle, discs[i].X, discs[i].Y) - discs[i].Reach;
      marks[i] = std::max(marks[i], MarkOf(gap, margin));
    }
  }
  return marks;
}

}  // namespace

TEST_CASE("encounters: the grid finds the discs that a comparison of all pairs finds",
          "[dynamics2d]") {
  const int numDiscs = GENERATE(1, 2, 30, 400);
  const Real side = GENERATE(0.5, 5.0, 60.0);
  const unsigned seed = GENERATE(1U, 2U, 3U);
  CAPTURE(numDiscs, side, seed);
  constexpr Real kMargin = 0.02;
  std::mt19937 generator(seed);
  std::uniform_real_distribution<Real> position(-0.5 * side, 0.5 * side);
  std::uniform_real_distribution<Real> reach(0.03, 0.12);
  std::uniform_real_distribution<Real> angle(0.0, 6.28);

  std::vector<SDisc> discs;
  for (int i = 0; i < numDiscs; ++i) {
    discs.push_back({position(generator), position(generator), reach(generator)});
  }
  std::vector<SFootprint> obstacles;
  for (int i = 0; i < 10; ++i) {
    const Real yaw = angle(generator);
    const bool disc = i % 3 == 0;
    obstacles.push_back({position(generator), position(generator), disc ? 1.0 : std::cos(yaw),
                         disc ? 0.0 : std::sin(yaw), disc ? 0.0 : 0.1 * side, disc ? 0.0 : 0.01,
                         disc ? reach(generator) : 0.0});
  }

  CEncounters encounters;
  encounters.SetMargin(kMargin);
  encounters.SetObstacles(obstacles);
  encounters.Clear(discs.size());
  for (UInt32 i = 0; i < discs.size(); ++i) {
    encounters.Place(i, discs[i].X, discs[i].Y, discs[i].Reach);
  }
  encounters.MarkAll();
  const std::vector<CEncounters::EMark> expected = MarkEachWithEach(discs, obstacles, kMargin);
  for (UInt32 i = 0; i < discs.size(); ++i) {
    CAPTURE(i, discs[i].X, discs[i].Y, discs[i].Reach);
    REQUIRE(encounters.GetMark(i) == expected[i]);
  }
}

TEST_CASE("encounters: a body that is not a disc marks the discs within its reach",
          "[dynamics2d]") {
  CEncounters encounters;
  encounters.SetMargin(0.1);
  encounters.Clear(4);
  encounters.Place(0, 0.0, 0.0, 0.1);
  encounters.Place(1, 2.0, 0.0, 0.1);
  encounters.Place(3, -1.25, 0.0, 0.1);
  encounters.MarkAll();
  encounters.MarkNear(1.0, 0.0, 0.95);
  CHECK(encounters.GetMark(0) == CEncounters::Near);
  CHECK(encounters.GetMark(1) == CEncounters::Near);
  // disc 2 was never placed
  CHECK(encounters.GetMark(2) == CEncounters::Alone);
  CHECK(encounters.GetMark(3) == CEncounters::Alone);
  // the gap of 0.05 m is less than the margin
  encounters.MarkNear(-2.0, 0.0, 0.6);
  CHECK(encounters.GetMark(3) == CEncounters::Around);
}

TEST_CASE("encounters: discs of longer reach than the others are found", "[dynamics2d]") {
  // two discs of long reach 5 m apart, and a row of small ones
  CEncounters encounters;
  encounters.SetMargin(0.01);
  encounters.Clear(102);
  for (UInt32 i = 0; i < 100; ++i) {
    encounters.Place(i, 0.5 * i, 10.0, 0.05);
  }
  encounters.Place(100, 0.0, 0.0, 3.0);
  encounters.Place(101, 5.0, 0.0, 2.5);
  encounters.MarkAll();
  CHECK(encounters.GetMark(0) == CEncounters::Alone);
  CHECK(encounters.GetMark(100) == CEncounters::Near);
  CHECK(encounters.GetMark(101) == CEncounters::Near);
}

}  // namespace argos
