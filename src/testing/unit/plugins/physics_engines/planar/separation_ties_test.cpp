// Shapes at places that are sums of powers of 2: distances are exactly equal, and the first counts.

#include <argos3/plugins/simulator/physics_engines/planar/separation.h>

#include <argos3/core/simulator/geometry/convex_polygon.h>
#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace argos::separation_ties_test {

namespace {

/* A rectangle along the axes, and the same as a polygon. */
struct SShapes {
  std::vector<CVector2> Corners;
  SFootprint Box;
  SFootprint Polygon;

  SShapes(Real x, Real y, Real halfX, Real halfY)
      : Corners(RectanglePolygon(2.0 * halfX, 2.0 * halfY)),
        Box{x, y, 1.0, 0.0, halfX, halfY, 0.0},
        Polygon(Box) {
    Polygon.Polygon = &Corners;
  }
};

void CheckEqual(const SSeparation& found, const SSeparation& expected) {
  CHECK(found.NormalX == expected.NormalX);
  CHECK(found.NormalY == expected.NormalY);
  CHECK(found.Gap == expected.Gap);
  CHECK(found.PointX == expected.PointX);
  CHECK(found.PointY == expected.PointY);
}

}  // namespace

TEST_CASE("separation ties: a centre as near to two sides of a rectangle leaves it along y",
          "[unit][kinematics2d]") {
  const auto [halfX, x, y, expected] = GENERATE(
      table<Real, Real, Real, SSeparation>({{0.5, 0.0, 0.0, {0.0, 1.0, -0.75, 0.0, -0.5}},
                                            {0.5, 0.25, 0.25, {0.0, -1.0, -0.5, 0.25, 0.5}},
                                            {0.5, -0.25, 0.25, {0.0, -1.0, -0.5, -0.25, 0.5}},
                                            {0.5, 0.25, -0.25, {0.0, 1.0, -0.5, 0.25, -0.5}},
                                            // at a corner, and on sides
                                            {0.5, 0.5, 0.5, {0.0, -1.0, -0.25, 0.5, 0.5}},
                                            {0.5, 0.5, 0.25, {-1.0, 0.0, -0.25, 0.5, 0.25}},
                                            {0.5, -0.5, 0.25, {1.0, 0.0, -0.25, -0.5, 0.25}},
                                            {0.5, 0.25, 0.5, {0.0, -1.0, -0.25, 0.25, 0.5}},
                                            // narrower along x, in its middle
                                            {0.25, 0.0, 0.0, {1.0, 0.0, -0.5, -0.25, 0.0}},
                                            {0.25, 0.0, 0.25, {0.0, -1.0, -0.5, 0.0, 0.5}}}));
  CAPTURE(halfX, x, y);
  const SShapes shape(0.0, 0.0, halfX, 0.5);
  CheckEqual(SeparateFromFootprint(x, y, 0.25, {0.5, 0.5}, shape.Box), expected);
}

TEST_CASE("separation ties: of places on a disc's way that are as near, the first counts",
          "[unit][kinematics2d]") {
  const bool isPolygon = GENERATE(false, true);
  // the square is at (4, 2): place of the disc from there, its step
  const auto [x, y, step, expected] = GENERATE_COPY(table<Real, Real, SPlanarVector, SSeparation>(
      {// past two corners, which it grazes: the first one of a polygon is the upper one
       {0.75, -1.0, {0.0, 2.0}, {-1.0, 0.0, 0.0, 4.5, isPolygon ? 2.5 : 1.5}},
       {0.75, 1.0, {0.0, -2.0}, {-1.0, 0.0, 0.0, 4.5, isPolygon ? 2.5 : 1.5}},
       // along a side, from and to places that are as near
       {-0.25, 0.8125, {0.5, 0.0}, {0.0, -1.0, 0.0625, 3.75, 2.5}},
       {0.25, 0.8125, {-0.5, 0.0}, {0.0, -1.0, 0.0625, 4.25, 2.5}},
       // towards a side, just to it, and not so far
       {1.0, 0.0, {-0.25, 0.0}, {-1.0, 0.0, 0.25, 4.5, 2.0}},
       {1.0, 0.0, {-0.5, 0.0}, {-1.0, 0.0, 0.25, 4.5, 2.0}},
       {1.0, 0.0, {-0.125, 0.0}, {-1.0, 0.0, 0.25, 4.5, 2.0}},
       // towards its ends
       {1.0, 0.5, {-0.5, 0.0}, {-1.0, 0.0, 0.25, 4.5, 2.5}},
       {1.0, -0.5, {-0.5, 0.0}, {-1.0, 0.0, 0.25, 4.5, 1.5}},
       {0.5, 1.0, {0.0, -0.5}, {0.0, -1.0, 0.25, 4.5, 2.5}},
       // away from it, and at rest
       {1.0, 0.0, {0.5, 0.0}, {-1.0, 0.0, 0.25, 4.5, 2.0}},
       {1.0, 0.25, {0.0, 0.0}, {-1.0, 0.0, 0.25, 4.5, 2.25}},
       // it touches the square
       {0.75, 0.25, {-0.5, 0.0}, {-1.0, 0.0, 0.0, 4.5, 2.25}},
       {0.75, 0.25, {0.0, 0.5}, {-1.0, 0.0, 0.0, 4.5, 2.25}}}));
  CAPTURE(isPolygon, x, y, step.X, step.Y);
  const SShapes square(4.0, 2.0, 0.5, 0.5);
  CheckEqual(
      SeparateFromFootprint(4.0 + x, 2.0 + y, 0.25, step, isPolygon ? square.Polygon : square.Box),
      expected);
}

TEST_CASE("separation ties: of sides that are as far the first one counts, and of corners the last",
          "[unit][kinematics2d]") {
  const SShapes a(0.0, 0.0, 0.5, 0.5);
  const auto [x, y, expected] = GENERATE(table<Real, Real, std::vector<SSeparation>>(
      {// corner to corner
       {1.25, 1.25, {{1.0, 0.0, 0.25, 0.75, 0.75}}},
       {-1.25, 1.25, {{-1.0, 0.0, 0.25, -0.75, 0.75}}},
       // the end of one side is beside that of the other
       {1.25, 1.0, {{1.0, 0.0, 0.25, 0.75, 0.5}, {1.0, 0.0, 0.25, 0.75, 0.5}}},
       {1.25, -1.0, {{1.0, 0.0, 0.25, 0.75, -0.5}, {1.0, 0.0, 0.25, 0.75, -0.5}}},
       // in one place
       {0.0, 0.0, {{1.0, 0.0, -1.0, -0.5, 0.5}, {1.0, 0.0, -1.0, -0.5, -0.5}}},
       // they touch
       {1.0, 0.0, {{1.0, 0.0, 0.0, 0.5, 0.5}, {1.0, 0.0, 0.0, 0.5, -0.5}}},
       {0.0, -1.0, {{0.0, -1.0, 0.0, 0.5, -0.5}, {0.0, -1.0, 0.0, -0.5, -0.5}}}}));
  CAPTURE(x, y);
  const SShapes b(x, y, 0.5, 0.5);
  SSeparation contacts[2];
  REQUIRE(FindContacts(a.Box, b.Box, contacts) == static_cast<int>(expected.size()));
  for (size_t i = 0; i < expected.size(); ++i) {
    CheckEqual(contacts[i], expected[i]);
  }
  CHECK(ComputeGap(a.Box, b.Box) == expected[0].Gap);
  CHECK(ComputeGap(a.Polygon, b.Polygon) == expected[0].Gap);
}

TEST_CASE("separation ties: of two sides that face another one as directly, that across y counts",
          "[unit][kinematics2d]") {
  // half a turn of a quarter, exactly
  const Real diagonal = std::sqrt(0.5);
  const SShapes a(0.0, 0.0, 0.5, 0.5);
  const SFootprint b = {2.0, 0.0, diagonal, diagonal, 0.5, 0.5, 0.0};
  SSeparation contacts[2];
  REQUIRE(FindContacts(a.Box, b, contacts) == 2);
  // rounding errors of numbers of order 1
  using Catch::Matchers::WithinAbs;
  CHECK_THAT(contacts[0].PointX, WithinAbs(2.5 - diagonal, 1e-12));
  CHECK_THAT(contacts[0].PointY, WithinAbs(0.5, 1e-12));
  CHECK_THAT(contacts[1].PointX, WithinAbs(2.0 - diagonal, 1e-12));
  CHECK_THAT(contacts[1].PointY, WithinAbs(0.0, 1e-12));
}

}  // namespace argos::separation_ties_test
