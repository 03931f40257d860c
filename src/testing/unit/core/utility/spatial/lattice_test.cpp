#include <argos3/core/utility/spatial/lattice.h>

#include <catch2/catch.hpp>

#include <array>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace lattice_test {

using namespace argos;

namespace {

using TCell = std::array<SInt32, 3>;

TCell ToArray(const SCellNumber& cell) {
  TCell array{};
  cell.Get(array[0], array[1], array[2]);
  return array;
}

SLattice MakeLattice(SInt32 count) {
  const SInt32 last = count - 1;
  return {{0.0, -1.0, 2.0}, {1.0, 0.5, 0.25}, {{0, 0, 0}}, {{last, last, last}}};
}

}  // namespace

TEST_CASE("lattice: far away and undefined places belong to border cells", "[spatial]") {
  constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
  constexpr Real kNaN = std::numeric_limits<Real>::quiet_NaN();
  const SLattice lattice = MakeLattice(4);
  CHECK(ToArray(lattice.CellOf(CVector3(2.5, -0.75, 2.25))) == TCell{2, 0, 1});
  CHECK(ToArray(lattice.CellOf(CVector3(kInfinity, -kInfinity, kNaN))) == TCell{3, 0, 0});
  CHECK(ToArray(lattice.CellOf(CVector3(1e300, -1e300, 1e12))) == TCell{3, 0, 3});
}

TEST_CASE("lattice: the cells of a box come in order, until the visitor ends the loop",
          "[spatial]") {
  std::vector<TCell> visited;
  const auto visit = [&](SInt32 i, SInt32 j, SInt32 k) {
    visited.push_back({i, j, k});
    return visited.size() < 5;
  };
  ForCellsInBox({{1, -1, 7}}, {{2, 0, 8}}, visit);
  CHECK(visited == std::vector<TCell>{{1, -1, 7}, {2, -1, 7}, {1, 0, 7}, {2, 0, 7}, {1, -1, 8}});
}

TEST_CASE("lattice: a walk visits the cells of all points of a ray, each once", "[spatial]") {
  const SInt32 count = GENERATE(1, 6);
  const SLattice lattice = MakeLattice(count);
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> position(-3.0, 8.0);
  for (int n = 0; n < 200; ++n) {
    const CVector3 start(position(random), position(random), position(random));
    CVector3 end(position(random), position(random), position(random));
    if (n % 3 == 0) {
      end.SetY(start.GetY());
    }
    std::set<TCell> visited;
    WalkLattice(lattice, CRay3(start, end), [&](const SCellNumber& cell) {
      REQUIRE(visited.insert(ToArray(cell)).second);
      return true;
    });
    for (int k = 0; k <= 100; ++k) {
      const CVector3 point = start + (end - start) * (k / 100.0);
      REQUIRE(visited.count(ToArray(lattice.CellOf(point))) == 1);
    }
  }
}

}  // namespace lattice_test
