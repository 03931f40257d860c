#include <argos3/core/simulator/geometry/indexed_shape.h>
#include <argos3/core/simulator/geometry/shape_overlap.h>
#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <random>

namespace indexed_shape_test {

using namespace argos;
using Catch::WithinAbs;

namespace {

// tolerance for a few products and one square root of numbers of the order of 1
constexpr Real kRounding = 1e-14;

SIndexedShape Disc(Real x, Real y, Real radius, Real zMin = 0.0, Real zMax = 1.0) {
  SIndexedShape shape{};
  shape.X = x;
  shape.Y = y;
  shape.Cos = 1.0;
  shape.HalfX = shape.HalfY = shape.Radius = radius;
  shape.ZMin = zMin;
  shape.ZMax = zMax;
  shape.Kind = SIndexedShape::EKind::Disc;
  return shape;
}

SIndexedShape Box(Real x, Real y, Real yaw, Real halfX, Real halfY, Real zMin = 0.0,
                  Real zMax = 1.0) {
  SIndexedShape shape{};
  shape.X = x;
  shape.Y = y;
  shape.Cos = std::cos(yaw);
  shape.Sin = std::sin(yaw);
  shape.HalfX = halfX;
  shape.HalfY = halfY;
  shape.Radius = std::hypot(halfX, halfY);
  shape.ZMin = zMin;
  shape.ZMax = zMax;
  shape.Kind = SIndexedShape::EKind::Box;
  return shape;
}

// where the ray enters, by the general and, for horizontal rays, by the
// horizontal test; both must agree
Real Hit(const SIndexedShape& shape, const CVector3& start, const CVector3& end) {
  const CVector3 d = end - start;
  const Real general = IntersectRay(shape, CRay3(start, end));
  if (d.GetZ() == 0.0) {
    const Real horizontal =
        IntersectHorizontalRay(shape, start.GetX(), start.GetY(), start.GetZ(), d.GetX(), d.GetY());
    CHECK(horizontal == general);
  }
  return general;
}

using TCorners = std::array<std::array<Real, 2>, 4>;

TCorners Corners(const SIndexedShape& box) {
  TCorners corners{};
  const Real signs[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  for (size_t i = 0; i < 4; ++i) {
    const Real x = signs[i][0] * box.HalfX;
    const Real y = signs[i][1] * box.HalfY;
    corners[i] = {box.X + box.Cos * x - box.Sin * y, box.Y + box.Sin * x + box.Cos * y};
  }
  return corners;
}

bool IsInside(const std::array<Real, 2>& point, const SIndexedShape& box) {
  const Real dx = point[0] - box.X;
  const Real dy = point[1] - box.Y;
  return std::abs(box.Cos * dx + box.Sin * dy) < box.HalfX &&
         std::abs(box.Cos * dy - box.Sin * dx) < box.HalfY;
}

Real Side(const std::array<Real, 2>& a, const std::array<Real, 2>& b,
          const std::array<Real, 2>& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

// reference: two rectangles overlap if a corner of one is in the other, or if two edges cross
bool MeetByEdges(const SIndexedShape& first, const SIndexedShape& second) {
  const TCorners a = Corners(first);
  const TCorners b = Corners(second);
  for (size_t i = 0; i < 4; ++i) {
    if (IsInside(a[i], second) || IsInside(b[i], first)) {
      return true;
    }
    for (size_t j = 0; j < 4; ++j) {
      const auto& a2 = a[(i + 1) % 4];
      const auto& b2 = b[(j + 1) % 4];
      if (Side(a[i], a2, b[j]) * Side(a[i], a2, b2) < 0.0 &&
          Side(b[j], b2, a[i]) * Side(b[j], b2, a2) < 0.0) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

TEST_CASE("ray and disc: the distance equals the closed form", "[core][space][rays]") {
  // for a ray that passes the centre at distance b, it enters sqrt(r^2
  // - b^2) before the closest point
  const Real offset = GENERATE(0.0, 0.03, -0.03, 0.0499);
  const Real angle = GENERATE(0.0, 0.3, 1.5707963267948966, 2.0, -3.0);
  CAPTURE(offset, angle);
  const Real radius = 0.05;
  const Real distance = 0.4;
  const Real length = 0.7;
  const CVector3 ahead(std::cos(angle), std::sin(angle), 0.0);
  const CVector3 left(-std::sin(angle), std::cos(angle), 0.0);
  const CVector3 start(1.0, -2.0, 0.3);
  const CVector3 centre = start + distance * ahead + offset * left;
  const Real t = Hit(Disc(centre.GetX(), centre.GetY(), radius), start, start + length * ahead);
  const Real expected = (distance - std::sqrt(radius * radius - offset * offset)) / length;
  // near the rim the square root magnifies the rounding of its argument, 1e-16 / 0.003
  CHECK_THAT(t, WithinAbs(expected, 1e-12));
}

TEST_CASE("ray and disc: rays beside, behind, beyond, above and below miss",
          "[core][space][rays]") {
  const SIndexedShape disc = Disc(0.0, 0.0, 0.1, 0.2, 0.5);
  CHECK(Hit(disc, CVector3(-1.0, 0.1001, 0.3), CVector3(1.0, 0.1001, 0.3)) > 1.0);
  CHECK(Hit(disc, CVector3(0.2, 0.0, 0.3), CVector3(1.0, 0.0, 0.3)) > 1.0);
  CHECK(Hit(disc, CVector3(-1.0, 0.0, 0.3), CVector3(-0.1001, 0.0, 0.3)) > 1.0);
  CHECK(Hit(disc, CVector3(-1.0, 0.0, 0.5001), CVector3(1.0, 0.0, 0.5001)) > 1.0);
  CHECK(Hit(disc, CVector3(-1.0, 0.0, 0.1999), CVector3(1.0, 0.0, 0.1999)) > 1.0);
  CHECK(Hit(disc, CVector3(-1.0, 0.0, 0.3), CVector3(1.0, 0.0, 0.3)) < 1.0);
}

TEST_CASE("ray and box: the distance equals the closed form at any yaw", "[core][space][rays]") {
  const Real yaw = GENERATE(0.0, 0.5235987755982988, -1.0, 2.5);
  CAPTURE(yaw);
  const Real halfX = 0.3;
  const Real halfY = 0.2;
  const SIndexedShape box = Box(0.5, 0.25, yaw, halfX, halfY);
  const CVector3 centre(0.5, 0.25, 0.4);
  const CVector3 x(std::cos(yaw), std::sin(yaw), 0.0);
  const CVector3 y(-std::sin(yaw), std::cos(yaw), 0.0);
  // perpendicular to each face
  CHECK_THAT(Hit(box, centre + x, centre), WithinAbs(1.0 - halfX, kRounding));
  CHECK_THAT(Hit(box, centre - x, centre), WithinAbs(1.0 - halfX, kRounding));
  CHECK_THAT(Hit(box, centre + y, centre), WithinAbs(1.0 - halfY, kRounding));
  CHECK_THAT(Hit(box, centre - y, centre), WithinAbs(1.0 - halfY, kRounding));
  // at 45 degrees to the face at y = halfY, entering 0.1 to the right of the centre
  const CVector3 start = centre + y * (halfY + 0.25) + x * 0.35;
  const CVector3 end = start - y * 0.5 - x * 0.5;
  CHECK_THAT(Hit(box, start, end), WithinAbs(0.5, kRounding));
  // parallel to a face, just outside and just inside
  CHECK(Hit(box, centre + y * (halfY + 1e-9) - x, centre + y * (halfY + 1e-9) + x) > 1.0);
  CHECK(Hit(box, centre + y * (halfY - 1e-9) - x, centre + y * (halfY - 1e-9) + x) < 1.0);
}

TEST_CASE("ray and solid: a ray that starts inside hits at distance 0", "[core][space][rays]") {
  const SIndexedShape shape = GENERATE(Disc(0.0, 0.0, 0.2), Box(0.0, 0.0, 0.7, 0.2, 0.3));
  CHECK(Hit(shape, CVector3(0.05, 0.05, 0.5), CVector3(3.0, 1.0, 0.5)) == 0.0);
  CHECK(Hit(shape, CVector3(0.05, 0.05, 0.5), CVector3(0.06, 0.05, 0.5)) == 0.0);
  CHECK(Hit(shape, CVector3(0.05, 0.05, 0.5), CVector3(0.05, 0.05, 3.0)) == 0.0);
  // a ray of no length
  CHECK(Hit(shape, CVector3(0.05, 0.05, 0.5), CVector3(0.05, 0.05, 0.5)) == 0.0);
  CHECK(Hit(shape, CVector3(0.9, 0.05, 0.5), CVector3(0.9, 0.05, 0.5)) > 1.0);
}

TEST_CASE("ray and solid: inclined rays enter through the top and the bottom",
          "[core][space][rays]") {
  const SIndexedShape shape =
      GENERATE(Disc(0.0, 0.0, 0.2, 0.1, 0.4), Box(0.0, 0.0, 0.7, 0.2, 0.3, 0.1, 0.4));
  // vertically down and up
  CHECK_THAT(Hit(shape, CVector3(0.05, 0.0, 1.4), CVector3(0.05, 0.0, 0.0)),
             WithinAbs(1.0 / 1.4, kRounding));
  CHECK_THAT(Hit(shape, CVector3(0.05, 0.0, -0.4), CVector3(0.05, 0.0, 0.6)),
             WithinAbs(0.5, kRounding));
  // at 45 degrees over the edge of the top: it starts 0.6 above the
  // top, so it enters over (-0.1, 0)
  CHECK_THAT(Hit(shape, CVector3(-0.7, 0.0, 1.0), CVector3(0.3, 0.0, 0.0)),
             WithinAbs(0.6, kRounding));
  // a ray that passes above the edge
  CHECK(Hit(shape, CVector3(-0.7, 0.0, 1.5), CVector3(0.8, 0.0, 0.5)) > 1.0);
}

TEST_CASE("overlap of discs: touching discs do not overlap, closer ones do",
          "[core][space][overlap]") {
  const Real angle = GENERATE(0.0, 1.0, 2.0, 3.0, 4.0);
  CAPTURE(angle);
  const auto at = [&](Real distance) {
    return ShapesOverlap(Disc(1.0, 2.0, 0.1), Disc(1.0 + distance * std::cos(angle),
                                                   2.0 + distance * std::sin(angle), 0.2));
  };
  CHECK(at(0.0));
  CHECK(at(0.299));
  CHECK(at(0.3 - 1e-8));
  CHECK_FALSE(at(0.3));
  CHECK_FALSE(at(0.301));
}

TEST_CASE("overlap of disc and box: results are right at faces, at corners and inside",
          "[core][space][overlap]") {
  const Real yaw = GENERATE(0.0, 0.4, -2.0);
  CAPTURE(yaw);
  const SIndexedShape box = Box(-1.0, 3.0, yaw, 0.4, 0.3);
  const auto at = [&](Real localX, Real localY) {
    const SIndexedShape disc = Disc(-1.0 + std::cos(yaw) * localX - std::sin(yaw) * localY,
                                    3.0 + std::sin(yaw) * localX + std::cos(yaw) * localY, 0.05);
    CHECK(ShapesOverlap(disc, box) == ShapesOverlap(box, disc));
    return ShapesOverlap(disc, box);
  };
  CHECK(at(0.0, 0.0));
  CHECK(at(0.449, 0.0));
  CHECK_FALSE(at(0.45, 0.0));
  CHECK(at(0.1, -0.349));
  CHECK_FALSE(at(0.1, -0.35));
  // 0.05 from the corner along the diagonal is 0.05 / sqrt(2) along each axis
  const Real diagonal = 0.05 / std::sqrt(2.0);
  CHECK(at(0.4 + 0.999 * diagonal, 0.3 + 0.999 * diagonal));
  CHECK_FALSE(at(-0.4 - 1.001 * diagonal, 0.3 + 1.001 * diagonal));
}

TEST_CASE("overlap of boxes: equals the reference by crossing edges", "[core][space][overlap]") {
  std::mt19937 generator(7);
  const auto in = [&](Real min, Real max) {
    return std::uniform_real_distribution<Real>(min, max)(generator);
  };
  int overlaps = 0;
  for (int i = 0; i < 5000; ++i) {
    const SIndexedShape a =
        Box(in(-1.0, 1.0), in(-1.0, 1.0), in(-4.0, 4.0), in(0.01, 0.8), in(0.01, 0.8));
    const SIndexedShape b =
        Box(in(-1.0, 1.0), in(-1.0, 1.0), in(-4.0, 4.0), in(0.01, 0.8), in(0.01, 0.8));
    const bool expected = MeetByEdges(a, b);
    overlaps += expected ? 1 : 0;
    CAPTURE(i);
    REQUIRE(ShapesOverlap(a, b) == expected);
    REQUIRE(ShapesOverlap(b, a) == expected);
  }
  // both results have occurred often
  CHECK(overlaps > 1000);
  CHECK(overlaps < 4000);
}

TEST_CASE("overlap of boxes: walls that share a face or a corner do not overlap",
          "[core][space][overlap]") {
  CHECK_FALSE(ShapesOverlap(Box(0.0, 0.0, 0.0, 0.5, 0.1), Box(1.0, 0.0, 0.0, 0.5, 0.1)));
  CHECK_FALSE(ShapesOverlap(Box(0.0, 0.0, 0.0, 0.5, 0.1), Box(1.0, 0.2, 0.0, 0.5, 0.1)));
  CHECK(ShapesOverlap(Box(0.0, 0.0, 0.0, 0.5, 0.1), Box(0.999, 0.0, 0.0, 0.5, 0.1)));
}

TEST_CASE("overlap: bodies one above the other do not overlap", "[core][space][overlap]") {
  const SIndexedShape below = Disc(0.0, 0.0, 0.1, 0.0, 0.5);
  CHECK_FALSE(ShapesOverlap(below, Box(0.0, 0.0, 0.0, 0.1, 0.1, 0.5, 1.0)));
  CHECK_FALSE(ShapesOverlap(Box(0.0, 0.0, 0.0, 0.1, 0.1, 0.5, 1.0), below));
  CHECK(ShapesOverlap(below, Box(0.0, 0.0, 0.0, 0.1, 0.1, 0.499, 1.0)));
}

}  // namespace indexed_shape_test
