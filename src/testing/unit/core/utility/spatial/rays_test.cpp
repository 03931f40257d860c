#include <argos3/core/utility/math/ray_span.h>
#include <argos3/core/utility/spatial/rectangle.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace spatial_rays_test {

using namespace argos;
using Catch::WithinAbs;

namespace {

// a few products and one square root of numbers of the order of 1
constexpr Real kRounding = 1e-14;

struct SRectangle {
  Real X, Y, Cos, Sin, HalfX, HalfY;
};

SRectangle MakeRectangle(Real x, Real y, Real yaw, Real halfX, Real halfY) {
  return {x, y, std::cos(yaw), std::sin(yaw), halfX, halfY};
}

// distance of a point from the segment between two others
Real ComputeDistance(const SPlanarVector& p, const SPlanarVector& a, const SPlanarVector& b) {
  const Real dx = b.X - a.X;
  const Real dy = b.Y - a.Y;
  const Real t = std::clamp(((p.X - a.X) * dx + (p.Y - a.Y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(p.X - a.X - t * dx, p.Y - a.Y - t * dy);
}

SPlanarVector GetCorner(const SRectangle& r, int number) {
  const Real signX = number == 0 || number == 3 ? -1.0 : 1.0;
  const Real signY = number < 2 ? -1.0 : 1.0;
  const SPlanarVector offset = RotateOutOfFrame(r, signX * r.HalfX, signY * r.HalfY);
  return {r.X + offset.X, r.Y + offset.Y};
}

// the part of the ray from (x, y) along (dx, dy) inside a disc around the origin, by its two routes
SRaySpan FastDisc(Real x, Real y, Real dx, Real dy, Real radius) {
  return FindNegative(dx * dx + dy * dy, x * dx + y * dy, x * x + y * y - radius * radius);
}

SRaySpan ExactDisc(Real x, Real y, Real dx, Real dy, Real radius) {
  SRaySpan span;
  ClipToDisc(span, x, y, dx, dy, radius);
  return span;
}

}  // namespace

TEST_CASE("rectangle: the distance of a point is that to its nearest side", "[spatial]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> position(-3.0, 3.0);
  std::uniform_real_distribution<Real> half(0.05, 2.0);
  int inside = 0;
  for (int n = 0; n < 2000; ++n) {
    const SRectangle r = MakeRectangle(position(random), position(random), position(random),
                                       half(random), half(random));
    const Real x = position(random);
    const Real y = position(random);
    const SPlanarVector local = RotateIntoFrame(r, x - r.X, y - r.Y);
    Real expected = HUGE_VAL;
    for (int corner = 0; corner < 4; ++corner) {
      expected = std::min(
          expected, ComputeDistance({x, y}, GetCorner(r, corner), GetCorner(r, (corner + 1) % 4)));
    }
    if (std::abs(local.X) < r.HalfX && std::abs(local.Y) < r.HalfY) {
      expected = 0.0;
      ++inside;
    }
    REQUIRE_THAT(std::sqrt(ComputeSquareDistance(r, x, y)), WithinAbs(expected, 1e-12));
  }
  CHECK(inside > 100);
}

TEST_CASE("rectangle: into its frame and out of it again", "[spatial]") {
  const SRectangle r = MakeRectangle(4.0, 5.0, 0.7, 1.0, 2.0);
  const SPlanarVector local = RotateIntoFrame(r, 0.3, -1.2);
  const SPlanarVector back = RotateOutOfFrame(r, local.X, local.Y);
  CHECK_THAT(back.X, WithinAbs(0.3, kRounding));
  CHECK_THAT(back.Y, WithinAbs(-1.2, kRounding));
  // a quarter turn to the left takes x to y
  const SRectangle turned = {0.0, 0.0, 0.0, 1.0, 1.0, 1.0};
  CHECK(RotateOutOfFrame(turned, 1.0, 0.0).Y == 1.0);
  CHECK(RotateIntoFrame(turned, 0.0, 1.0).X == 1.0);
}

TEST_CASE("rectangle: its widths are those of its corners", "[spatial]") {
  std::mt19937 random(2);
  std::uniform_real_distribution<Real> angle(-7.0, 7.0);
  std::uniform_real_distribution<Real> half(0.0, 2.0);
  for (int n = 0; n < 500; ++n) {
    const SRectangle r = MakeRectangle(0.0, 0.0, angle(random), half(random), half(random));
    const Real towards = angle(random);
    Real width = 0.0;
    SPlanarVector bounds = {0.0, 0.0};
    for (int number = 0; number < 4; ++number) {
      const SPlanarVector corner = GetCorner(r, number);
      width = std::max(width, corner.X * std::cos(towards) + corner.Y * std::sin(towards));
      bounds = {std::max(bounds.X, corner.X), std::max(bounds.Y, corner.Y)};
    }
    REQUIRE_THAT(ComputeHalfWidth(r, std::cos(towards), std::sin(towards)),
                 WithinAbs(width, kRounding));
    REQUIRE_THAT(ComputeHalfBounds(r).X, WithinAbs(bounds.X, kRounding));
    REQUIRE_THAT(ComputeHalfBounds(r).Y, WithinAbs(bounds.Y, kRounding));
  }
}

TEST_CASE("ray span: where a ray enters", "[spatial]") {
  CHECK(SRaySpan().FindEntry() == 0.0);
  CHECK(SRaySpan::None().FindEntry() == kNoHit);
  CHECK(SRaySpan{0.25, 0.75}.FindEntry() == 0.25);
  CHECK(SRaySpan{-1.0, 0.5}.FindEntry() == 0.0);
  CHECK(SRaySpan{-1.0, 0.0}.FindEntry() == 0.0);
  CHECK(SRaySpan{-1.0, -0.1}.FindEntry() == kNoHit);
  CHECK(SRaySpan{1.0, 3.0}.FindEntry() == 1.0);
  CHECK(SRaySpan{1.1, 3.0}.FindEntry() == kNoHit);
  CHECK(kNoHit > 1.0);
  Real t = -1.0;
  CHECK(SRaySpan{1.1, 3.0}.FindFirst(t));
  CHECK(t == 1.1);
  CHECK(!SRaySpan{-2.0, -1.0}.FindFirst(t));
  CHECK(t == 1.1);
}

TEST_CASE("ray span: clipping to a slab", "[spatial]") {
  SRaySpan span;
  span.ClipToSlab(1.0, 2.0, 2.0, 4.0);
  CHECK(span.First == 0.5);
  CHECK(span.Last == 1.5);
  // the other way round, the same places are met from the other side
  SRaySpan back;
  back.ClipToSlab(3.0, -2.0, 2.0, 4.0);
  CHECK(back.First == -0.5);
  CHECK(back.Last == 0.5);
  // along the slab: inside, on its border, outside, undefined
  for (const Real inside : {2.0, 3.0, 4.0}) {
    SRaySpan along;
    along.ClipToSlab(inside, 0.0, 2.0, 4.0);
    CHECK(along.First == -HUGE_VAL);
    CHECK(along.Last == HUGE_VAL);
  }
  for (const Real outside : {1.999, 4.001, std::numeric_limits<Real>::quiet_NaN()}) {
    SRaySpan along;
    along.ClipToSlab(outside, 0.0, 2.0, 4.0);
    CHECK(along.IsEmpty());
    // it remains empty
    along.ClipToSlab(0.0, 1.0, -5.0, 5.0);
    CHECK(along.IsEmpty());
    CHECK(along.FindEntry() == kNoHit);
  }
}

TEST_CASE("ray span: both ways to clip to a slab around 0 agree", "[spatial]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<Real> number(-2.0, 2.0);
  for (int n = 0; n < 500; ++n) {
    const Real start = number(random);
    const Real direction = n % 10 == 0 ? 0.0 : number(random);
    const Real half = std::abs(number(random));
    SRaySpan a;
    SRaySpan b;
    a.ClipAround(start, direction, half);
    b.ClipToSlab(start, direction, -half, half);
    CAPTURE(start, direction, half);
    REQUIRE(a.IsEmpty() == b.IsEmpty());
    if (direction != 0.0) {
      REQUIRE_THAT(a.First, WithinAbs(b.First, 1e-12 * (1.0 + std::abs(b.First))));
      REQUIRE_THAT(a.Last, WithinAbs(b.Last, 1e-12 * (1.0 + std::abs(b.Last))));
    }
  }
}

TEST_CASE("ray span: a disc, in closed form and from both ends", "[spatial]") {
  // the chord of the unit circle at height h has its ends at +-sqrt(1 - h^2)
  for (const Real h : {0.0, 0.6, -0.8}) {
    const Real half = std::sqrt(1.0 - h * h);
    for (const SRaySpan& span :
         {FastDisc(-2.0, h, 4.0, 0.0, 1.0), ExactDisc(-2.0, h, 4.0, 0.0, 1.0)}) {
      CHECK_THAT(span.First, WithinAbs((2.0 - half) / 4.0, kRounding));
      CHECK_THAT(span.Last, WithinAbs((2.0 + half) / 4.0, kRounding));
    }
  }
  CHECK(FastDisc(-2.0, 1.001, 4.0, 0.0, 1.0).IsEmpty());
  CHECK(ExactDisc(-2.0, 1.001, 4.0, 0.0, 1.0).IsEmpty());
  // a ray without a length: inside, outside
  CHECK(FastDisc(0.5, 0.0, 0.0, 0.0, 1.0).FindEntry() == 0.0);
  CHECK(ExactDisc(0.5, 0.0, 0.0, 0.0, 1.0).FindEntry() == 0.0);
  CHECK(FastDisc(1.5, 0.0, 0.0, 0.0, 1.0).FindEntry() == kNoHit);
  CHECK(ExactDisc(1.5, 0.0, 0.0, 0.0, 1.0).FindEntry() == kNoHit);

  std::mt19937 random(4);
  std::uniform_real_distribution<Real> number(-3.0, 3.0);
  int hits = 0;
  for (int n = 0; n < 1000; ++n) {
    const Real x = number(random);
    const Real y = number(random);
    const Real dx = number(random);
    const Real dy = number(random);
    const SRaySpan there = FastDisc(x, y, dx, dy, 1.0);
    const SRaySpan exact = ExactDisc(x, y, dx, dy, 1.0);
    const SRaySpan back = FastDisc(x + dx, y + dy, -dx, -dy, 1.0);
    const Real length = std::hypot(dx, dy);
    const Real aside = std::abs(x * dy - y * dx) / length;
    if (std::abs(aside - 1.0) < 1e-3 || length < 0.1) {
      // almost a tangent, whose roots are ill-conditioned
      continue;
    }
    CAPTURE(x, y, dx, dy);
    REQUIRE(there.IsEmpty() == (aside > 1.0));
    REQUIRE(exact.IsEmpty() == (aside > 1.0));
    REQUIRE(IsCircleOnLine(-x, -y, dx, dy, 1.0, length * length) == (aside <= 1.0));
    if (!there.IsEmpty()) {
      ++hits;
      REQUIRE_THAT(there.First, WithinAbs(exact.First, 1e-9));
      REQUIRE_THAT(there.Last, WithinAbs(exact.Last, 1e-9));
      REQUIRE_THAT(there.First, WithinAbs(1.0 - back.Last, 1e-9));
      REQUIRE_THAT(std::hypot(x + there.First * dx, y + there.First * dy), WithinAbs(1.0, 1e-9));
      REQUIRE_THAT(std::hypot(x + there.Last * dx, y + there.Last * dy), WithinAbs(1.0, 1e-9));
    }
  }
  CHECK(hits > 200);
}

TEST_CASE("ray span: ClipToDisc() is exact from far away", "[spatial]") {
  // 1e8 radii away, the square of the start has lost all digits of the radius
  const SRaySpan span = ExactDisc(-1e8, 0.6, 1.0, 0.0, 1.0);
  CHECK_THAT(span.First, WithinAbs(1e8 - 0.8, 1e-7));
  CHECK_THAT(span.Last, WithinAbs(1e8 + 0.8, 1e-7));
}

TEST_CASE("ray span: a circle that only touches a line is on it", "[spatial]") {
  CHECK(IsCircleOnLine(3.0, 1.0, 2.0, 0.0, 1.0, 4.0));
  CHECK(!IsCircleOnLine(3.0, 1.001, 2.0, 0.0, 1.0, 4.0));
  // behind the start is on the line, too
  CHECK(IsCircleOnLine(-3.0, 0.5, 2.0, 0.0, 1.0, 4.0));
}

}  // namespace spatial_rays_test
