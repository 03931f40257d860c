#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/simulator/media/point_cells.h>
#include <argos3/testing/support/invariants.h>
#include <argos3/testing/support/no_allocation.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace point_cells_test {

using namespace argos;

namespace {

struct SPoints {
  std::vector<Real> X, Y;  // m
};

// half of the points are outside the arena of 10 m x 10 m, some of them far away
SPoints MakePoints(size_t num, UInt64 seed) {
  CRandomStream random(seed, "test", "point cells", "places");
  SPoints points;
  for (size_t i = 0; i < num; ++i) {
    const Real scale = i % 50 == 0 ? 1e12 : (i % 2 == 0 ? 5.0 : 20.0);
    points.X.push_back(random.Uniform(-scale, scale));
    points.Y.push_back(random.Uniform(-scale, scale));
  }
  return points;
}

SIndexChoice MakeOptions(SIndexChoice::EKind kind, SInt32 gridSize) {
  SIndexChoice options;
  options.Kind = kind;
  std::fill(options.GridSize, options.GridSize + 3, gridSize);
  return options;
}

const CRange<CVector3> kArena(CVector3(-5.0, -5.0, 0.0), CVector3(5.0, 5.0, 2.0));

}  // namespace

TEST_CASE("point cells: every point in reach is visited once", "[media]") {
  const auto kind =
      GENERATE(SIndexChoice::EKind::Grid, SIndexChoice::EKind::Hash, SIndexChoice::EKind::Dummy);
  const SInt32 gridSize = GENERATE(0, 1, 7, 2000);
  const size_t num = GENERATE(0, 1, 2, 300);
  const Real typicalReach = GENERATE(0.0, 0.3, 50.0, 1e15);
  CAPTURE(static_cast<int>(kind), gridSize, num, typicalReach);
  const SPoints points = MakePoints(num, 1);
  CPointCells cells;
  cells.SetOptions(MakeOptions(kind, gridSize), kArena);
  cells.Sort(points.X.data(), points.Y.data(), num, typicalReach);
  REQUIRE(cells.GetNumPoints() == num);
  CRandomStream random(2, "test", "point cells", "queries");
  for (int query = 0; query < 30; ++query) {
    const Real x = random.Uniform(-8.0, 8.0);
    const Real y = random.Uniform(-8.0, 8.0);
    const Real reach = query == 0 ? 1e13 : random.Uniform(0.0, 4.0);
    std::vector<int> visits(num, 0);
    cells.ForPlacesNear(x, y, reach, [&](size_t place) { ++visits[cells.GetPoint(place)]; });
    for (size_t i = 0; i < num; ++i) {
      CHECK(visits[i] <= 1);
      if (std::hypot(points.X[i] - x, points.Y[i] - y) <= reach) {
        CHECK(visits[i] == 1);
      }
    }
  }
}

TEST_CASE("point cells: few points out of reach are visited", "[media]") {
  const auto kind = GENERATE(SIndexChoice::EKind::Grid, SIndexChoice::EKind::Hash);
  CRandomStream random(3, "test", "point cells", "crowd");
  constexpr size_t kNum = 10000;
  constexpr Real kReach = 0.2;
  SPoints points;
  for (size_t i = 0; i < kNum; ++i) {
    points.X.push_back(random.Uniform(-5.0, 5.0));
    points.Y.push_back(random.Uniform(-5.0, 5.0));
  }
  // points far outside of the arena, which do not make the cells larger
  const Real stray = GENERATE(0.0, 1e6, -1e6);
  CAPTURE(stray);
  for (const Real place : {stray, 0.5 * stray}) {
    points.X.push_back(place);
    points.Y.push_back(place);
  }
  CPointCells cells;
  cells.SetOptions(MakeOptions(kind, 0), kArena);
  cells.Sort(points.X.data(), points.Y.data(), points.X.size(), kReach);
  size_t visited = 0;
  for (size_t i = 0; i < kNum; ++i) {
    cells.ForPlacesNear(points.X[i], points.Y[i], kReach, [&](size_t) { ++visited; });
  }
  // On average pi r^2 = 0.126 m^2 of the 100 m^2 are in reach. Cells of side r/2 cover a square of
  // at most 3 r, 2.9 times as much.
  CHECK(static_cast<Real>(visited) / kNum < 3.0 * 0.126 * kNum / 100.0);
}

TEST_CASE("index choice: cells of a metre, as many as the user wants, and at most 2^18",
          "[media]") {
  const auto count = [](const SIndexChoice& choice, const CVector3& extent) {
    const SIndexChoice::SCells cells = choice.MakeCells(extent);
    return std::vector<SInt32>(std::begin(cells.Number), std::end(cells.Number));
  };
  const SIndexChoice own = MakeOptions(SIndexChoice::EKind::Grid, 0);
  CHECK(count(own, CVector3(10.7, 0.5, 0.0)) == std::vector<SInt32>{10, 1, 1});
  CHECK(own.MakeCells(CVector3(10.7, 0.5, 0.0)).Extent == CVector3(10.7, 0.5, 1.0));
  CHECK(count(MakeOptions(SIndexChoice::EKind::Grid, 7), CVector3(10.7, 0.5, 0.0)) ==
        std::vector<SInt32>{7, 7, 7});
  // 2^18 along one axis
  CHECK(count(own, CVector3(0.5, 3e5, 1.0)) == std::vector<SInt32>{1, 1 << 18, 1});
  CHECK(count(own, CVector3(64.0, 64.0, 64.0)) == std::vector<SInt32>{64, 64, 64});
  // each axis shrinks alike, but one with a single cell
  for (const CVector3& extent : {CVector3(128.0, 128.0, 128.0), CVector3(1e7, 1e7, 1.0)}) {
    const std::vector<SInt32> many = count(own, extent);
    CHECK(many[0] == many[1]);
    CHECK(many[2] == (extent.GetZ() == 1.0 ? 1 : many[0]));
    CHECK(many[0] * many[1] * many[2] <= 1 << 18);
    CHECK(many[0] * many[1] * many[2] > 1 << 17);
  }
}

TEST_CASE("point cells: sorting the same number of points again allocates nothing",
          "[media][allocation]") {
  const auto kind =
      GENERATE(SIndexChoice::EKind::Grid, SIndexChoice::EKind::Hash, SIndexChoice::EKind::Dummy);
  CPointCells cells;
  cells.SetOptions(MakeOptions(kind, 0), kArena);
  const SPoints first = MakePoints(1000, 1);
  cells.Sort(first.X.data(), first.Y.data(), 1000, 0.5);
  const SPoints second = MakePoints(1000, 2);
  const SPoints third = MakePoints(900, 3);
  CheckAllocatesNothing([&] {
    cells.Sort(second.X.data(), second.Y.data(), 1000, 0.1);
    cells.Sort(third.X.data(), third.Y.data(), 900, 2.0);
  });
}

TEST_CASE("point cells: places of a former sort are noticed", "[media][invariants]") {
  const SPoints points = MakePoints(3, 1);
  CPointCells cells;
  cells.SetOptions(MakeOptions(SIndexChoice::EKind::Grid, 0), kArena);
  cells.Sort(points.X.data(), points.Y.data(), 3, 1.0);
  CHECK(cells.GetPoint(2) < 3);
  cells.Sort(points.X.data(), points.Y.data(), 2, 1.0);
  CheckCaught([&] { static_cast<void>(cells.GetPoint(2)); }, "there is no place 2");
}

}  // namespace point_cells_test
