// Convex polygons against closed forms and sampling.

#include <argos3/core/simulator/geometry/convex_polygon.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/testing/support/polygons.h>

#include <catch2/catch.hpp>

#include <limits>

namespace argos::convex_polygon_test {

using Catch::WithinAbs;
using Catch::WithinRel;
using Catch::Matchers::Contains;
using TPolygon = std::vector<CVector2>;

namespace {

// sums of a few products of numbers of the order of 1
constexpr Real kRounding = 1e-13;

// true if a point is to the left of all sides, or to the right by at most a tolerance (m)
bool IsInside(const TPolygon& polygon, const CVector2& point, Real tolerance) {
  for (size_t i = 0; i < polygon.size(); ++i) {
    const CVector2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (side.CrossProduct(point - polygon[i]) < -tolerance * side.Length()) {
      return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("convex polygon: corners are counter-clockwise, without double and straight ones",
          "[core][geometry]") {
  const TPolygon square = MakeConvexPolygon(
      {CVector2(0, 0), CVector2(0, 1), CVector2(0, 1), CVector2(0.5, 1), CVector2(1, 1),
       CVector2(1, 0), CVector2(0.7, 0), CVector2(0.3, 0), CVector2(0, 1e-10)});
  REQUIRE(square.size() == 4);
  for (size_t i = 0; i < 4; ++i) {
    CHECK((square[(i + 1) % 4] - square[i]).CrossProduct(square[(i + 2) % 4] - square[i]) > 0.99);
  }
  CHECK(MakeConvexPolygon(RegularPolygon(200, 0.05)).size() == 200);
}

TEST_CASE("convex polygon: what is no convex polygon is refused", "[core][geometry][errors]") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK_THROWS_WITH(MakeConvexPolygon({}), Contains("at least 3 corners") && Contains("found 0"));
  CHECK_THROWS_WITH(MakeConvexPolygon({CVector2(0, 0), CVector2(1, 0), CVector2(1, 1e-7)}),
                    Contains("at least 3 corners") && Contains("found 2"));
  for (const CVector2& corner : {CVector2(1, nan), CVector2(nan, 1), CVector2(1, HUGE_VAL)}) {
    CHECK_THROWS_WITH(MakeConvexPolygon({CVector2(0, 0), corner, CVector2(1, 1)}),
                      Contains("finite"));
  }
  CHECK_THROWS_WITH(
      MakeConvexPolygon({CVector2(0, 0), CVector2(1, 1), CVector2(2, 2), CVector2(3, 3)}),
      Contains("in a line"));
  CHECK_THROWS_WITH(
      MakeConvexPolygon({CVector2(0, 0), CVector2(2, 0), CVector2(2, 2), CVector2(1.5, 0.5)}),
      Contains("not convex") && Contains("1.5,0.5") && Contains("dent"));
  CHECK_THROWS_WITH(
      MakeConvexPolygon({CVector2(0, 0), CVector2(1, 0), CVector2(1, 2e-6), CVector2(0, 2e-6)}),
      Contains("in a line"));
  // far from the line of its first side, but nowhere as wide as 1e-5 m: a needle of 2e-6 m x 1 m
  CHECK_THROWS_WITH(MakeConvexPolygon({CVector2(0, 0), CVector2(2e-6, 0), CVector2(1e-6, 1)}),
                    Contains("too narrow") && Contains("at least 1e-05 m, found 2e-06"));
  // a five-pointed star turns to the left at all corners
  const TPolygon pentagon = RegularPolygon(5, 1.0);
  CHECK_THROWS_WITH(
      MakeConvexPolygon({pentagon[0], pentagon[2], pentagon[4], pentagon[1], pentagon[3]}),
      Contains("intersect"));
}

TEST_CASE("convex polygon: moments of rectangles and right triangles", "[core][geometry]") {
  const CVector2 offset(0.3, -0.7);
  TPolygon rectangle = RectanglePolygon(0.6, 0.2);
  TPolygon triangle = {CVector2(0, 0), CVector2(0.6, 0), CVector2(0, 0.3)};
  for (TPolygon* polygon : {&rectangle, &triangle}) {
    for (CVector2& corner : *polygon) {
      corner += offset;
    }
  }
  const SPolygonMoments ofRectangle = ComputeMoments(rectangle);
  CHECK_THAT(ofRectangle.Area, WithinRel(0.12, kRounding));
  CHECK_THAT((ofRectangle.Centroid - offset).Length(), WithinAbs(0.0, kRounding));
  CHECK_THAT(ofRectangle.MeanXX, WithinRel(0.36 / 12, kRounding));
  CHECK_THAT(ofRectangle.MeanYY, WithinRel(0.04 / 12, kRounding));
  CHECK_THAT(ofRectangle.MeanXY, WithinAbs(0.0, kRounding));
  // with legs a and b: area a b / 2, centroid (a, b) / 3, mean squares a^2 / 18 and b^2 / 18, mean
  // product -a b / 36
  const SPolygonMoments ofTriangle = ComputeMoments(triangle);
  CHECK_THAT(ofTriangle.Area, WithinRel(0.09, kRounding));
  CHECK_THAT((ofTriangle.Centroid - offset - CVector2(0.2, 0.1)).Length(),
             WithinAbs(0.0, kRounding));
  CHECK_THAT(ofTriangle.MeanXX, WithinRel(0.36 / 18, kRounding));
  CHECK_THAT(ofTriangle.MeanYY, WithinRel(0.09 / 18, kRounding));
  CHECK_THAT(ofTriangle.MeanXY, WithinRel(-0.18 / 36, kRounding));
}

TEST_CASE("convex polygon: moments and width of regular polygons tend to those of a disc",
          "[core][geometry]") {
  const size_t corners = GENERATE(3, 4, 6, 8, 100, 1000);
  CAPTURE(corners);
  const Real radius = 0.4;
  const TPolygon polygon = RegularPolygon(corners, radius);
  const SPolygonMoments moments = ComputeMoments(polygon);
  const Real n = static_cast<Real>(corners);
  const Real angle = 2.0 * ARGOS_PI / n;
  CHECK_THAT(moments.Area, WithinRel(0.5 * n * radius * radius * std::sin(angle), kRounding));
  CHECK_THAT(moments.Centroid.Length(), WithinAbs(0.0, kRounding));
  // polar moment per area: r^2 (2 + cos a) / 6
  CHECK_THAT(moments.MeanXX + moments.MeanYY,
             WithinRel(radius * radius * (2.0 + std::cos(angle)) / 6.0, kRounding));
  CHECK_THAT(moments.MeanXX, WithinRel(moments.MeanYY, 1e-12));
  CHECK_THAT(moments.MeanXY, WithinAbs(0.0, kRounding));
  const Real height = radius * std::cos(0.5 * angle);
  CHECK_THAT(ComputeLeastWidth(polygon),
             WithinRel(corners % 2 == 0 ? 2.0 * height : height + radius, 1e-12));
  if (corners == 1000) {
    // terms of the order of the square of the angle
    CHECK_THAT(moments.Area, WithinRel(ARGOS_PI * radius * radius, angle * angle));
    CHECK_THAT(moments.MeanXX + moments.MeanYY, WithinRel(0.5 * radius * radius, angle * angle));
  }
}

TEST_CASE("convex polygon: rays enter and leave where sampling says", "[core][geometry]") {
  CRandomStream random(1, "test", "polygon", "rays");
  const auto uniform = [&](Real low, Real high) { return random.Uniform(low, high); };
  int hits = 0;
  for (int scene = 0; scene < 2000; ++scene) {
    const TPolygon polygon = RandomPolygon(0.5, uniform);
    const CVector2 start(uniform(-1, 1), uniform(-1, 1));
    const CVector2 way(uniform(-2, 2), uniform(-2, 2));
    const SRaySpan span = IntersectPolygon(polygon, start, way);
    for (int i = -100; i <= 100; ++i) {
      const Real t = 0.02 * i;
      // points near the border are left out
      if (span.First + 1e-9 < t && t < span.Last - 1e-9) {
        REQUIRE(IsInside(polygon, start + way * t, 1e-12));
      } else if (t < span.First - 1e-9 || span.Last + 1e-9 < t) {
        REQUIRE_FALSE(IsInside(polygon, start + way * t, -1e-12));
      }
    }
    hits += span.IsEmpty() ? 0 : 1;
  }
  CHECK(hits > 500);
  // closed form: along the diagonal of a square, and along its side
  const TPolygon square = RectanglePolygon(2.0, 2.0);
  CHECK_THAT(IntersectPolygon(square, CVector2(-3, -3), CVector2(4, 4)).First,
             WithinAbs(0.5, kRounding));
  CHECK(IntersectPolygon(square, CVector2(-3, 1), CVector2(4, 0)).First == 0.5);
  CHECK(IntersectPolygon(square, CVector2(-3, 1.001), CVector2(4, 0)).IsEmpty());
}

TEST_CASE("convex polygon: the nearest point of the border is that of a sampled border",
          "[core][geometry]") {
  CRandomStream random(1, "test", "polygon", "nearest");
  const auto uniform = [&](Real low, Real high) { return random.Uniform(low, high); };
  for (int scene = 0; scene < 1000; ++scene) {
    const TPolygon polygon = RandomPolygon(0.5, uniform);
    const CVector2 point(uniform(-0.8, 0.8), uniform(-0.8, 0.8));
    constexpr int kSamples = 500;
    Real least = HUGE_VAL;
    for (size_t i = 0; i < polygon.size(); ++i) {
      for (int k = 0; k <= kSamples; ++k) {
        const CVector2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
        least = std::min(least, (polygon[i] + side * (1.0 * k / kSamples) - point).Length());
      }
    }
    const SPolygonNearest nearest = FindNearest(polygon, point);
    // the distance between samples is at most 2 mm
    REQUIRE(std::abs(nearest.Distance) <= least + kRounding);
    REQUIRE(std::abs(nearest.Distance) >= least - 1e-3);
    REQUIRE((nearest.Distance < 0.0) == IsInside(polygon, point, 0.0));
    REQUIRE_THAT((nearest.Point + nearest.Normal * nearest.Distance - point).Length(),
                 WithinAbs(0.0, kRounding));
    REQUIRE_THAT(nearest.Normal.Length(), WithinAbs(1.0, kRounding));
    REQUIRE(IsInside(polygon, nearest.Point, kRounding));
  }
}

}  // namespace argos::convex_polygon_test
