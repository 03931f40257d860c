#include <argos3/core/utility/spatial/planar_grid.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace planar_grid_test {

using namespace argos;

namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
constexpr Real kNaN = std::numeric_limits<Real>::quiet_NaN();

using TCells = std::set<std::pair<SInt32, SInt32>>;

TCells List(const SCellRange& range) {
  TCells cells;
  for (SInt32 j = range.MinJ; j <= range.MaxJ; ++j) {
    for (SInt32 i = range.MinI; i <= range.MaxI; ++i) {
      cells.insert({i, j});
    }
  }
  return cells;
}

// a cell as a closed rectangle; border cells reach to infinity
bool Touches(const CPlanarGrid<>& grid, SInt32 i, SInt32 j, Real x, Real y, Real reachX,
             Real reachY) {
  return x + reachX >= grid.GetX().GetLow(i) && x - reachX <= grid.GetX().GetHigh(i) &&
         y + reachY >= grid.GetY().GetLow(j) && y - reachY <= grid.GetY().GetHigh(j);
}

// distance of a point from a segment, both in the plane
Real ComputeDistance(Real px, Real py, Real x, Real y, Real dx, Real dy) {
  const Real square = dx * dx + dy * dy;
  const Real along = square > 0.0 ? ((px - x) * dx + (py - y) * dy) / square : 0.0;
  const Real t = std::fmin(1.0, std::fmax(0.0, along));
  return std::hypot(px - x - t * dx, py - y - t * dy);
}

}  // namespace

TEST_CASE("clamp to cells: inner places are rounded down, others belong to the border cells",
          "[spatial]") {
  CHECK(ClampToCells(0.0, 5) == 0);
  CHECK(ClampToCells(0.999, 5) == 0);
  CHECK(ClampToCells(1.0, 5) == 1);
  CHECK(ClampToCells(4.999, 5) == 4);
  for (const Real beyond : {5.0, 5.5, 1e12, 1e300, kInfinity}) {
    CAPTURE(beyond);
    CHECK(ClampToCells(beyond, 5) == 4);
    CHECK(ClampToCells(beyond, 1) == 0);
    CHECK(ClampToCells(-beyond, 5) == 0);
    CHECK(ClampToCells(beyond, -3, 4) == 4);
    CHECK(ClampToCells(-beyond, -3, 4) == -3);
  }
  CHECK(ClampToCells(kNaN, 5) == 0);
  CHECK(ClampToCells(kNaN, -3, 4) == -3);
  CHECK(ClampToCells(-0.5, -3, 4) == -1);
  CHECK(ClampToCells(-1.0, -3, 4) == -1);
  CHECK(ClampToCells(-1.001, -3, 4) == -2);
  CHECK(ClampToCells(3.7, -3, 4) == 3);
}

TEST_CASE("clamp to cells: both forms agree", "[spatial]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> place(-3.0, 10.0);
  for (int n = 0; n < 1000; ++n) {
    const Real at = n % 2 == 0 ? place(random) : std::floor(place(random));
    CAPTURE(at);
    REQUIRE(ClampToCells(at, 7) == ClampToCells(at, 0, 6));
  }
}

TEST_CASE("grid axis: a cell holds what is between its ends, and the ends of adjoining cells meet",
          "[spatial]") {
  const SInt32 count = GENERATE(1, 2, 17);
  const SGridAxis axis(-1.5, 0.25, count);
  for (SInt32 cell = 0; cell < count; ++cell) {
    CAPTURE(count, cell);
    CHECK(axis.CellOf(-1.5 + (cell + 0.5) * 0.25) == cell);
    // the edges are exact here: a cell holds its lower end
    CHECK(axis.CellOf(-1.5 + cell * 0.25) == cell);
    CHECK((cell == 0 ? axis.GetLow(cell) == -kInfinity
                     : axis.GetLow(cell) == axis.GetHigh(cell - 1)));
  }
  CHECK(axis.GetHigh(count - 1) == kInfinity);
}

TEST_CASE("planar grid: the cells around a box are those that it touches", "[spatial]") {
  const SInt32 countX = GENERATE(1, 2, 9);
  const SInt32 countY = GENERATE(1, 6);
  const unsigned seed = GENERATE(1U, 2U);
  CAPTURE(countX, countY, seed);
  CPlanarGrid<> grid;
  grid.Lay({-2.0, 0.5, countX}, {1.0, 0.375, countY});
  REQUIRE(grid.GetNumCells() == static_cast<size_t>(countX * countY));
  std::mt19937 random(seed);
  std::uniform_real_distribution<Real> position(-6.0, 6.0);
  std::uniform_real_distribution<Real> reach(0.0, 2.0);
  for (int n = 0; n < 200; ++n) {
    const Real x = position(random);
    const Real y = position(random);
    const Real reachX = reach(random);
    const Real reachY = reach(random);
    CAPTURE(x, y, reachX, reachY);
    TCells expected;
    for (SInt32 j = 0; j < countY; ++j) {
      for (SInt32 i = 0; i < countX; ++i) {
        if (Touches(grid, i, j, x, y, reachX, reachY)) {
          expected.insert({i, j});
        }
      }
    }
    REQUIRE(List(grid.CellsAround(x, y, reachX, reachY)) == expected);
  }
}

TEST_CASE("planar grid: far away and undefined places are in the table", "[spatial]") {
  CPlanarGrid<> grid;
  grid.Cover({-1.0, -1.0, 1.0, 1.0}, 0.1, 100.0);
  const std::vector<Real> places = {-kInfinity, -1e300, -1e10, 0.0, 1e10, 1e300, kInfinity, kNaN};
  for (const Real x : places) {
    for (const Real y : places) {
      for (const Real reach : {0.0, 1.0, 1e300, kInfinity}) {
        CAPTURE(x, y, reach);
        CHECK(grid.CellAt(x, y) < grid.GetNumCells());
        grid.ForCells(grid.CellsAround(x, y, reach),
                      [&](UInt32 cell) { REQUIRE(cell < grid.GetNumCells()); });
      }
    }
  }
}

TEST_CASE("planar grid: a cover holds its area and keeps to its bounds", "[spatial]") {
  const size_t items = GENERATE(0u, 1u, 100u, 10000u);
  const Real width = GENERATE(0.0, 0.3, 40.0, 1e4);
  const Real height = GENERATE(0.0, 0.5, 40.0);
  const Real minEdge = GENERATE(0.01, 1.0);
  CAPTURE(items, width, height, minEdge);
  CPlanarGrid<> bare;
  CFramedGrid framed;
  const SPlanarArea area = {-3.0, 7.0, -3.0 + width, 7.0 + height};
  bare.Cover(area, minEdge, CPlanarGrid<>::AimedCells(items));
  framed.Cover(area, minEdge, CFramedGrid::AimedCells(items));
  CHECK(bare.GetNumCells() <= CPlanarGrid<>::MaxCells(items));
  CHECK(framed.GetNumCells() <= CFramedGrid::MaxCells(items));
  CHECK(bare.GetX().Edge >= minEdge);
  CHECK(bare.GetX().Edge == bare.GetY().Edge);
  // without the rule for border cells
  CHECK(area.MinX + bare.GetX().Count * bare.GetX().Edge >= area.MaxX);
  CHECK(area.MinY + bare.GetY().Count * bare.GetY().Edge >= area.MaxY);
}

TEST_CASE("planar grid: around a framed grid is a ring of cells to which nothing belongs",
          "[spatial]") {
  CFramedGrid grid;
  const UInt32 before = grid.GetGeneration();
  grid.Lay({0.0, 1.0, 4}, {0.0, 1.0, 3});
  CHECK(grid.GetGeneration() != before);
  REQUIRE(grid.GetNumCells() == 6 * 5);
  std::set<UInt32> used;
  grid.ForCells(grid.CellsAround(0.0, 0.0, kInfinity), [&](UInt32 cell) { used.insert(cell); });
  REQUIRE(used.size() == 12);
  for (const UInt32 cell : used) {
    // the eight neighbours are in the table
    CHECK(cell >= grid.GetStride() + 1);
    CHECK(cell + grid.GetStride() + 1 < grid.GetNumCells());
  }
  CHECK(used.count(grid.CellAt(0.5, 0.5)) == 1);
  CHECK(grid.CellAt(1.5, 0.5) == grid.CellAt(0.5, 0.5) + 1);
  CHECK(grid.CellAt(0.5, 1.5) == grid.CellAt(0.5, 0.5) + grid.GetStride());
}

TEST_CASE("planar grid: an item in several cells counts once in every query that meets it",
          "[spatial]") {
  CPlanarGrid<> grid;
  grid.Lay({0.0, 1.0, 7}, {0.0, 1.0, 5});
  std::mt19937 random(3);
  std::uniform_real_distribution<Real> position(-2.0, 9.0);
  std::uniform_real_distribution<Real> reach(0.0, 4.0);
  for (int n = 0; n < 500; ++n) {
    const SCellRange item = grid.CellsAround(position(random), position(random), reach(random));
    const SCellRange query = grid.CellsAround(position(random), position(random), reach(random));
    std::set<UInt32> listed;
    grid.ForCells(item, [&](UInt32 cell) { listed.insert(cell); });
    int visits = 0;
    bool doMeet = false;
    grid.ForCells(query, [&](UInt32 cell) {
      if (listed.count(cell) > 0) {
        doMeet = true;
        visits += grid.IsFirstCommon(cell, item.GetFirst(), query) ? 1 : 0;
      }
    });
    REQUIRE(visits == (doMeet ? 1 : 0));
  }
}

TEST_CASE("planar grid: the rows along a segment hold all cells near it, and few others",
          "[spatial]") {
  const SInt32 count = GENERATE(1, 8);
  const Real margin = GENERATE(0.0, 0.4);
  CAPTURE(count, margin);
  CPlanarGrid<> grid;
  grid.Lay({0.0, 1.0, count}, {0.0, 1.0, count});
  std::mt19937 random(4);
  std::uniform_real_distribution<Real> position(-3.0, 11.0);
  for (int n = 0; n < 300; ++n) {
    const Real x = position(random);
    const Real y = position(random);
    // some along an axis, some without a length
    const Real dx = n % 5 == 0 ? 0.0 : position(random) - x;
    const Real dy = n % 7 == 0 || n % 5 == 0 ? 0.0 : position(random) - y;
    CAPTURE(x, y, dx, dy);
    TCells visited;
    SInt32 lastRow = -1;
    grid.ForRowsAlongSegment(
        x, y, dx, dy, margin,
        [&](const SCellRange& row) {
          REQUIRE(row.MinJ == row.MaxJ);
          REQUIRE(row.MinJ > lastRow);
          lastRow = row.MinJ;
          visited.merge(List(row));
        },
        [] { return false; });
    // points within the margin of the segment are in cells that are visited
    for (int k = 0; k <= 40; ++k) {
      const Real t = k / 40.0;
      const Real angle = 0.7 * k;
      const Real px = x + t * dx + 0.999 * margin * std::cos(angle);
      const Real py = y + t * dy + 0.999 * margin * std::sin(angle);
      REQUIRE(visited.count({grid.GetX().CellOf(px), grid.GetY().CellOf(py)}) == 1);
    }
    // the segment comes within the margin of each visited cell along both axes; border cells have
    // no end
    for (const auto& [i, j] : visited) {
      if (i > 0 && j > 0 && i < count - 1 && j < count - 1) {
        REQUIRE(ComputeDistance(i + 0.5, j + 0.5, x, y, dx, dy) <=
                std::sqrt(2.0) * (0.5 + margin) + 1e-9);
      }
    }
  }
}

TEST_CASE("planar grid: a walk along a segment ends when its caller is done", "[spatial]") {
  CPlanarGrid<> grid;
  grid.Lay({0.0, 1.0, 3}, {0.0, 1.0, 10});
  int rows = 0;
  grid.ForRowsAlongSegment(
      0.5, 0.5, 0.0, 9.0, 0.0, [&](const SCellRange&) { ++rows; }, [&] { return rows == 4; });
  CHECK(rows == 4);
}

}  // namespace planar_grid_test
