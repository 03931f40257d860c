#include <argos3/core/simulator/geometry/region_geometry.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace region_geometry_test {

using namespace argos;
using Catch::Matchers::WithinAbs;

namespace {

const TPolygon kSquare = {CVector2(0, 0), CVector2(2, 0), CVector2(2, 2), CVector2(0, 2)};

TPolygon Shift(const TPolygon& polygon, Real x, Real y) {
  TPolygon shifted;
  for (const CVector2& corner : polygon) {
    shifted.push_back(corner + CVector2(x, y));
  }
  return shifted;
}

}  // namespace

TEST_CASE("region geometry: the intersection of aligned squares is a rectangle", "[core][volume]") {
  const TPolygon shared = Intersect(kSquare, Shift(kSquare, 1.5, 0.5));
  CHECK(shared.size() == 4);
  CHECK_THAT(0.5 * ComputeTwiceArea(shared), WithinAbs(0.5 * 1.5, 1e-15));
  CHECK_THAT(0.5 * ComputeTwiceArea(Intersect(kSquare, kSquare)), WithinAbs(4.0, 1e-15));
  // squares with a common side, with a common corner, and apart
  CHECK(std::abs(ComputeTwiceArea(Intersect(kSquare, Shift(kSquare, 2, 0)))) <= 1e-15);
  CHECK(std::abs(ComputeTwiceArea(Intersect(kSquare, Shift(kSquare, 2, 2)))) <= 1e-15);
  CHECK(Intersect(kSquare, Shift(kSquare, 5, 0)).empty());
}

TEST_CASE(
    "region geometry: the intersection of a square with one turned by 45 degrees is an octagon",
    "[core][volume]") {
  const Real half = std::sqrt(2.0);
  const TPolygon diamond = {CVector2(1 + half, 1), CVector2(1, 1 + half), CVector2(1 - half, 1),
                            CVector2(1, 1 - half)};
  const TPolygon shared = Intersect(kSquare, diamond);
  CHECK(shared.size() == 8);
  // a regular octagon of inradius 1 has the area 8 tan(pi / 8)
  CHECK_THAT(0.5 * ComputeTwiceArea(shared), WithinAbs(8.0 * (half - 1.0), 1e-12));
}

TEST_CASE("region geometry: segments are cut at the border", "[core][volume]") {
  const auto inside = Clip(CRay2(CVector2(-1, 1), CVector2(5, 1)), kSquare, 0.0);
  REQUIRE(inside);
  CHECK_THAT(inside->GetStart().GetX(), WithinAbs(0.0, 1e-12));
  CHECK_THAT(inside->GetEnd().GetX(), WithinAbs(2.0, 1e-12));
  const auto wide = Clip(CRay2(CVector2(-1, 1), CVector2(5, 1)), kSquare, 0.5);
  REQUIRE(wide);
  CHECK_THAT(wide->GetLength(), WithinAbs(3.0, 1e-12));
  CHECK_FALSE(Clip(CRay2(CVector2(-1, 3), CVector2(5, 3)), kSquare, 0.5));
  CHECK(Clip(CRay2(CVector2(-1, 2.4), CVector2(5, 2.4)), kSquare, 0.5));
  // past a corner: it is beyond no side for its whole length
  CHECK_FALSE(Clip(CRay2(CVector2(1.5, 3), CVector2(3, 1.5)), kSquare, 0.0));
  const auto corner = Clip(CRay2(CVector2(1, 2.5), CVector2(2.5, 1)), kSquare, 0.0);
  REQUIRE(corner);
  CHECK_THAT(corner->GetLength(), WithinAbs(0.5 * std::sqrt(2.0), 1e-12));
}

TEST_CASE("region geometry: the nearest point of a segment is between its ends", "[core][volume]") {
  const CRay2 segment(CVector2(1, 1), CVector2(4, 5));
  CHECK(FindNearest(segment, CVector2(0, 0)) == CVector2(1, 1));
  CHECK(FindNearest(segment, CVector2(9, 9)) == CVector2(4, 5));
  // 0.4 of the way, and 5 m aside
  CHECK(Distance(FindNearest(segment, CVector2(2.2 - 4, 2.6 + 3)), CVector2(2.2, 2.6)) < 1e-12);
  // of no length
  CHECK(FindNearest(CRay2(CVector2(1, 1), CVector2(1, 1)), CVector2(9, 9)) == CVector2(1, 1));
}

TEST_CASE("region geometry: distances from a square", "[core][volume]") {
  CHECK(ComputeDistance(kSquare, CVector2(1, 0.1)) == 0.0);
  CHECK(ComputeDistance(kSquare, CVector2(2, 2)) == 0.0);
  CHECK_THAT(ComputeDistance(kSquare, CVector2(1, -3)), WithinAbs(3.0, 1e-15));
  CHECK_THAT(ComputeDistance(kSquare, CVector2(5, 6)), WithinAbs(5.0, 1e-15));
}

TEST_CASE("region geometry: the crossing sides of a polygon are found", "[core][volume]") {
  CHECK_FALSE(FindCrossing(kSquare));
  const auto crossing =
      FindCrossing({CVector2(0, 0), CVector2(4, 0), CVector2(0, 2), CVector2(4, 2)});
  REQUIRE(crossing);
  CHECK(crossing->First == 1);
  CHECK(crossing->Second == 3);
  CHECK(Distance(crossing->Point, CVector2(2, 1)) <= 1e-12);
  // not convex, but simple
  CHECK_FALSE(FindCrossing({CVector2(0, 0), CVector2(4, 0), CVector2(1, 1), CVector2(0, 4)}));
}

}  // namespace region_geometry_test
