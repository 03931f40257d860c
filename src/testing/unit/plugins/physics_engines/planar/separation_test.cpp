// Compares lines that separate discs, rectangles and polygons with sampled points of both.

#include <argos3/plugins/simulator/physics_engines/planar/separation.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/convex_polygon.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>
#include <argos3/testing/support/polygons.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace argos::separation_test {

using Catch::Matchers::WithinAbs;

namespace {

// m; tolerance for roundings of numbers of order 1
constexpr Real kRounding = 1e-12;

SFootprint MakeBox(Real x, Real y, Real yaw, Real halfX, Real halfY) {
  return {x, y, std::cos(yaw), std::sin(yaw), halfX, halfY, 0.0};
}

// polygons whose memory lives as long as their footprints
class CPolygons {
 public:
  explicit CPolygons(const char* name) : m_random(1, "test", "separation", name) {}

  Real Uniform(Real low, Real high) { return m_random.Uniform(low, high); }
  SFootprint Make(Real spread, Real size) {
    const auto uniform = [this](Real low, Real high) { return Uniform(low, high); };
    m_shapes.push_back(SShapeDescription::Prism(RandomPolygon(size, uniform), 1.0));
    SFootprint footprint = Shape(m_shapes.back());
    footprint.X = Uniform(-spread, spread);
    footprint.Y = Uniform(-spread, spread);
    const Real yaw = Uniform(-std::numbers::pi, std::numbers::pi);
    footprint.Cos = std::cos(yaw);
    footprint.Sin = std::sin(yaw);
    return footprint;
  }
  static SFootprint Shape(const SShapeDescription& prism) {
    return {0.0,
            0.0,
            1.0,
            0.0,
            0.5 * prism.Size.GetX(),
            0.5 * prism.Size.GetY(),
            0.0,
            prism.Vertices.get()};
  }

 private:
  CRandomStream m_random;
  std::vector<SShapeDescription> m_shapes;
};

// a rectangle as a polygon
SFootprint AsPolygon(const SFootprint& box, std::vector<CVector2>& corners) {
  corners = RectanglePolygon(2.0 * box.HalfX, 2.0 * box.HalfY);
  SFootprint polygon = box;
  polygon.Polygon = &corners;
  return polygon;
}

std::vector<CVector2> ListCorners(const SFootprint& shape) {
  std::vector<CVector2> corners = shape.Polygon != nullptr
                                      ? *shape.Polygon
                                      : RectanglePolygon(2.0 * shape.HalfX, 2.0 * shape.HalfY);
  for (CVector2& corner : corners) {
    const SPlanarVector place = RotateOutOfFrame(shape, corner.GetX(), corner.GetY());
    corner.Set(shape.X + place.X, shape.Y + place.Y);
  }
  return corners;
}

// distance from a point to a shape, m; 0 inside
Real DistanceToShape(const SFootprint& box, Real x, Real y) {
  const Real dx = x - box.X;
  const Real dy = y - box.Y;
  if (box.Polygon != nullptr) {
    return std::max(0.0, FindNearest(ListCorners(box), CVector2(x, y)).Distance);
  }
  const Real outX = std::max(0.0, std::abs(box.Cos * dx + box.Sin * dy) - box.HalfX);
  const Real outY = std::max(0.0, std::abs(box.Cos * dy - box.Sin * dx) - box.HalfY);
  return std::hypot(outX, outY);
}

// least distance during a step of the centre, by sampling
Real LeastDistance(const SFootprint& box, Real x, Real y, const SPlanarVector& step) {
  Real least = HUGE_VAL;
  for (int i = 0; i <= 2000; ++i) {
    least = std::min(least, DistanceToShape(box, x + i / 2000.0 * step.X, y + i / 2000.0 * step.Y));
  }
  return least;
}

}  // namespace

TEST_CASE("separation: the line between discs that miss each other allows the whole step",
          "[unit][kinematics2d]") {
  CRandomStream random(1, "test", "separation", "discs");
  int missed = 0;
  for (int scene = 0; scene < 3000; ++scene) {
    const SPlanarVector offset = {random.Uniform(-1, 1), random.Uniform(-1, 1)};
    const SPlanarVector relative = {random.Uniform(-2, 2), random.Uniform(-2, 2)};
    constexpr Real kReach = 0.2;
    if (std::hypot(offset.X, offset.Y) <= kReach) {
      continue;
    }
    CAPTURE(offset.X, offset.Y, relative.X, relative.Y);
    const SSeparation line = SeparateDiscs(offset, relative, kReach);
    REQUIRE_THAT(std::hypot(line.NormalX, line.NormalY), WithinAbs(1.0, kRounding));
    REQUIRE(line.Gap >= -kRounding);
    const Real squared = relative.X * relative.X + relative.Y * relative.Y;
    const Real share =
        std::clamp(-(offset.X * relative.X + offset.Y * relative.Y) / squared, 0.0, 1.0);
    const Real nearest = std::hypot(offset.X + share * relative.X, offset.Y + share * relative.Y);
    const Real closing = -(line.NormalX * relative.X + line.NormalY * relative.Y);
    if (nearest > kReach) {
      ++missed;
      REQUIRE(closing <= line.Gap + kRounding);
    } else {
      REQUIRE(closing >= line.Gap - kRounding);
    }
  }
  CHECK(missed > 1000);
}

TEST_CASE("separation: disc and shape are on opposite sides of the line", "[unit][kinematics2d]") {
  const bool isPolygon = GENERATE(false, true);
  CAPTURE(isPolygon);
  CPolygons random("boxes");
  constexpr Real kRadius = 0.15;
  int missed = 0;
  int met = 0;
  for (int scene = 0; scene < 1500; ++scene) {
    const SFootprint box = isPolygon
                               ? random.Make(1.0, 0.5)
                               : MakeBox(random.Uniform(-1, 1), random.Uniform(-1, 1),
                                         random.Uniform(-std::numbers::pi, std::numbers::pi),
                                         random.Uniform(0.01, 0.5), random.Uniform(0.01, 0.5));
    const SPlanarVector step = {random.Uniform(-2, 2), random.Uniform(-2, 2)};
    const Real start = DistanceToShape(box, 0.0, 0.0);
    if (start <= kRadius) {
      continue;
    }
    const SSeparation line = SeparateFromFootprint(0.0, 0.0, kRadius, step, box);
    CAPTURE(scene, line.NormalX, line.NormalY, line.Gap);
    REQUIRE_THAT(std::hypot(line.NormalX, line.NormalY), WithinAbs(1.0, kRounding));
    REQUIRE(line.Gap >= -kRounding);
    // all corners are beyond the line, whose distance from the disc's centre is radius plus gap
    for (const CVector2& corner : ListCorners(box)) {
      const Real along = line.NormalX * corner.GetX() + line.NormalY * corner.GetY();
      REQUIRE(along >= kRadius + line.Gap - kRounding);
    }
    REQUIRE_THAT(DistanceToShape(box, line.PointX, line.PointY), WithinAbs(0.0, kRounding));
    const Real closing = line.NormalX * step.X + line.NormalY * step.Y;
    const Real least = LeastDistance(box, 0.0, 0.0, step);
    // sampling finds the least distance to about 1e-6
    if (least > kRadius + 1e-5) {
      ++missed;
      REQUIRE(closing <= line.Gap + kRounding);
    } else if (least < kRadius - 1e-5) {
      ++met;
      REQUIRE(closing >= line.Gap - kRounding);
    }
  }
  CHECK(missed > 300);
  CHECK(met > 200);
}

TEST_CASE("separation: a disc inside a rectangle leaves it by the shortest way",
          "[unit][kinematics2d]") {
  const SFootprint box = MakeBox(0.0, 0.0, 0.0, 1.0, 0.5);
  const SSeparation line = SeparateFromFootprint(0.2, 0.4, 0.1, {}, box);
  // 10 cm from its centre to the upper side plus 10 cm of radius
  CHECK_THAT(line.NormalY, WithinAbs(-1.0, kRounding));
  CHECK_THAT(line.Gap, WithinAbs(-0.2, kRounding));
}

TEST_CASE("separation: a centre inside a shape leaves it by the nearest side, whichever that is",
          "[unit][kinematics2d]") {
  const bool isPolygon = GENERATE(false, true);
  // place of the centre; normal and point of the way out: 1 m x 0.5 m, 5 cm from a side or more
  const auto [x, y, normalX, normalY, pointX, pointY] =
      GENERATE(table<Real, Real, Real, Real, Real, Real>({{0.45, 0.1, -1.0, 0.0, 0.5, 0.1},
                                                          {-0.45, 0.1, 1.0, 0.0, -0.5, 0.1},
                                                          {0.3, 0.2, 0.0, -1.0, 0.3, 0.25},
                                                          {0.3, -0.2, 0.0, 1.0, 0.3, -0.25},
                                                          // on the border
                                                          {0.5, 0.1, -1.0, 0.0, 0.5, 0.1},
                                                          {0.3, -0.25, 0.0, 1.0, 0.3, -0.25}}));
  CAPTURE(isPolygon, x, y);
  const SFootprint box = MakeBox(0.0, 0.0, 0.0, 0.5, 0.25);
  std::vector<CVector2> corners;
  const SFootprint shape = isPolygon ? AsPolygon(box, corners) : box;
  const SSeparation line = SeparateFromFootprint(x, y, 0.125, {0.3, 0.3}, shape);
  CHECK_THAT(line.NormalX, WithinAbs(normalX, kRounding));
  CHECK_THAT(line.NormalY, WithinAbs(normalY, kRounding));
  const Real depth = std::abs(pointX - x) + std::abs(pointY - y);
  CHECK_THAT(line.Gap, WithinAbs(-depth - 0.125, kRounding));
  CHECK_THAT(line.PointX, WithinAbs(pointX, kRounding));
  CHECK_THAT(line.PointY, WithinAbs(pointY, kRounding));
}

TEST_CASE("separation: discs with one centre are separated along x", "[unit][kinematics2d]") {
  const SPlanarVector relative = GENERATE(SPlanarVector{0.0, 0.0}, SPlanarVector{0.0, 0.5});
  const SSeparation line = SeparateDiscs({0.0, 0.0}, relative, 0.25);
  CHECK(line.NormalX == 1.0);
  CHECK(line.NormalY == 0.0);
  CHECK(line.Gap == -0.25);
}

TEST_CASE("separation: a disc touches any shape in one point, in the one order or the other",
          "[unit][kinematics2d]") {
  const SFootprint disc = {0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.25};
  const SFootprint other = {0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.5};
  const SFootprint box = MakeBox(0.25, 1.0, 0.0, 1.0, 0.5);
  // along y, 0.25 m apart; the point is of the second shape if the first one is a disc, else of
  // the first one
  for (const auto& [a, b, normal, point] :
       {std::tuple(disc, other, 1.0, 0.5), std::tuple(other, disc, -1.0, 0.25),
        std::tuple(disc, box, 1.0, 0.5), std::tuple(box, disc, -1.0, 0.5)}) {
    SSeparation contacts[2];
    REQUIRE(FindContacts(a, b, contacts) == 1);
    CHECK_THAT(contacts[0].NormalX, WithinAbs(0.0, kRounding));
    CHECK_THAT(contacts[0].NormalY, WithinAbs(normal, kRounding));
    CHECK_THAT(contacts[0].Gap, WithinAbs(0.25, kRounding));
    CHECK_THAT(contacts[0].PointX, WithinAbs(0.0, kRounding));
    CHECK_THAT(contacts[0].PointY, WithinAbs(point, kRounding));
  }
}

TEST_CASE("separation: of boxes that pass each other the nearest corners are compared",
          "[unit][kinematics2d]") {
  // the second box is ahead of the first one, and aside, and turned towards it
  const Real side = GENERATE(-1.0, 1.0);
  CAPTURE(side);
  const SFootprint a = MakeBox(0.0, 0.0, 0.0, 0.5, 0.5);
  const SFootprint b = MakeBox(2.0, 1.5 * side, -0.1 * side, 0.5, 0.5);
  SSeparation contacts[2];
  REQUIRE(FindContacts(a, b, contacts) == 1);
  const SPlanarVector corner = RotateOutOfFrame(b, -0.5, -0.5 * side);
  CHECK_THAT(contacts[0].NormalX, WithinAbs(1.0, kRounding));
  CHECK_THAT(contacts[0].PointX, WithinAbs(b.X + corner.X, kRounding));
  CHECK_THAT(contacts[0].PointY, WithinAbs(b.Y + corner.Y, kRounding));
  CHECK_THAT(contacts[0].Gap, WithinAbs(b.X + corner.X - 0.5, kRounding));
}

TEST_CASE("separation: boxes that stand askew touch where their sides face each other",
          "[unit][kinematics2d]") {
  // of b's side x = 0.75, from y = 0.25 to 1.25, a's side reaches the lower half
  const SFootprint a = MakeBox(0.0, 0.0, 0.0, 0.5, 0.75);
  const SFootprint b = MakeBox(1.25, 0.75, 0.0, 0.5, 0.5);
  SSeparation contacts[2];
  REQUIRE(FindContacts(a, b, contacts) == 2);
  const Real upper = std::max(contacts[0].PointY, contacts[1].PointY);
  const Real lower = std::min(contacts[0].PointY, contacts[1].PointY);
  CHECK_THAT(upper, WithinAbs(0.75, kRounding));
  CHECK_THAT(lower, WithinAbs(0.25, kRounding));
  for (const SSeparation& contact : contacts) {
    CHECK_THAT(contact.PointX, WithinAbs(0.75, kRounding));
    CHECK_THAT(contact.Gap, WithinAbs(0.25, kRounding));
  }
}

TEST_CASE("separation: boxes face to face touch in two points", "[unit][kinematics2d]") {
  const Real yaw = GENERATE(0.0, 0.3, 2.0);
  CAPTURE(yaw);
  const SFootprint a = MakeBox(0.0, 0.0, yaw, 0.5, 0.5);
  // 0.25 m ahead of a's face and a third as wide as it
  const SFootprint b = MakeBox(0.85 * std::cos(yaw), 0.85 * std::sin(yaw), yaw, 0.1, 0.15);
  SSeparation contacts[2];
  REQUIRE(FindContacts(a, b, contacts) == 2);
  for (const SSeparation& contact : contacts) {
    CHECK_THAT(contact.NormalX, WithinAbs(std::cos(yaw), kRounding));
    CHECK_THAT(contact.NormalY, WithinAbs(std::sin(yaw), kRounding));
    CHECK_THAT(contact.Gap, WithinAbs(0.25, kRounding));
    CHECK_THAT(DistanceToShape(b, contact.PointX, contact.PointY), WithinAbs(0.0, kRounding));
  }
  CHECK_THAT(
      std::hypot(contacts[0].PointX - contacts[1].PointX, contacts[0].PointY - contacts[1].PointY),
      WithinAbs(0.3, kRounding));
  CHECK_THAT(ComputeGap(a, b), WithinAbs(0.25, kRounding));
  CHECK_THAT(ComputeGap(b, a), WithinAbs(0.25, kRounding));
}

TEST_CASE("separation: a rectangle as a polygon is separated as the rectangle",
          "[unit][kinematics2d]") {
  CRandomStream random(1, "test", "separation", "same");
  std::vector<CVector2> cornersA, cornersB;
  const auto check = [](const SSeparation& one, const SSeparation& other) {
    REQUIRE_THAT(one.NormalX, WithinAbs(other.NormalX, kRounding));
    REQUIRE_THAT(one.NormalY, WithinAbs(other.NormalY, kRounding));
    REQUIRE_THAT(one.Gap, WithinAbs(other.Gap, kRounding));
    REQUIRE_THAT(one.PointX, WithinAbs(other.PointX, kRounding));
    REQUIRE_THAT(one.PointY, WithinAbs(other.PointY, kRounding));
  };
  for (int scene = 0; scene < 2000; ++scene) {
    const auto make = [&] {
      return MakeBox(random.Uniform(-0.7, 0.7), random.Uniform(-0.7, 0.7), random.Uniform(-4, 4),
                     random.Uniform(0.05, 0.5), random.Uniform(0.05, 0.5));
    };
    const SFootprint a = make();
    const SFootprint b = make();
    const SFootprint sameA = AsPolygon(a, cornersA);
    const SFootprint sameB = AsPolygon(b, cornersB);
    CAPTURE(scene);
    const SPlanarVector step = {random.Uniform(-1, 1), random.Uniform(-1, 1)};
    check(SeparateFromFootprint(0.1, 0.2, 0.1, step, sameA),
          SeparateFromFootprint(0.1, 0.2, 0.1, step, a));
    SSeparation boxes[2], mixed[2], polygons[2];
    const int count = FindContacts(a, b, boxes);
    REQUIRE(FindContacts(sameA, b, mixed) == count);
    REQUIRE(FindContacts(sameA, sameB, polygons) == count);
    for (const SSeparation* contacts : {mixed, polygons}) {
      // the two ends of a side may be exchanged
      const Real aside =
          std::hypot(contacts[0].PointX - boxes[0].PointX, contacts[0].PointY - boxes[0].PointY);
      const int first = aside < 1e-9 ? 0 : count - 1;
      for (int i = 0; i < count; ++i) {
        check(contacts[i], boxes[first == 0 ? i : first - i]);
      }
    }
    REQUIRE_THAT(ComputeGap(sameA, sameB), WithinAbs(ComputeGap(a, b), kRounding));
  }
}

TEST_CASE("separation: the gap of two polygons is below their distance, and their depth is exact",
          "[unit][kinematics2d]") {
  CPolygons random("polygons");
  int apart = 0;
  int overlapping = 0;
  for (int scene = 0; scene < 2000; ++scene) {
    const SFootprint a = random.Make(0.5, 0.5);
    const SFootprint b =
        scene % 4 == 0 ? MakeBox(0.1, 0.2, 0.01 * scene, 0.3, 0.1) : random.Make(0.5, 0.5);
    CAPTURE(scene);
    const std::vector<CVector2> cornersA = ListCorners(a);
    const std::vector<CVector2> cornersB = ListCorners(b);
    Real distance = HUGE_VAL;  // between convex shapes that are apart: from a corner of either
    for (const CVector2& corner : cornersB) {
      distance = std::min(distance, FindNearest(cornersA, corner).Distance);
    }
    for (const CVector2& corner : cornersA) {
      distance = std::min(distance, FindNearest(cornersB, corner).Distance);
    }
    const Real gap = ComputeGap(a, b);
    REQUIRE_THAT(ComputeGap(b, a), WithinAbs(gap, kRounding));
    SSeparation contacts[2];
    const int count = FindContacts(a, b, contacts);
    REQUIRE((count == 1 || count == 2));
    if (gap > 0.0) {
      ++apart;
      REQUIRE(gap <= distance + kRounding);
      continue;
    }
    ++overlapping;
    const SSeparation& deepest =
        count == 2 && contacts[1].Gap < contacts[0].Gap ? contacts[1] : contacts[0];
    REQUIRE_THAT(deepest.Gap, WithinAbs(gap, 1e-9));
    // moved along the normal by the depth they touch, and by less they overlap
    SFootprint moved = b;
    moved.X -= gap * deepest.NormalX;
    moved.Y -= gap * deepest.NormalY;
    REQUIRE_THAT(ComputeGap(a, moved), WithinAbs(0.0, 1e-9));
    moved.X += 0.1 * gap * deepest.NormalX;
    moved.Y += 0.1 * gap * deepest.NormalY;
    REQUIRE(ComputeGap(a, moved) < 1e-9);
  }
  CHECK(apart > 500);
  CHECK(overlapping > 500);
}

TEST_CASE("separation: the gap is the least distance of discs and rectangles, negative inside",
          "[unit][kinematics2d]") {
  const SFootprint disc = {1.0, 2.0, 1.0, 0.0, 0.25, 0.25, 0.25};
  const SFootprint other = {4.0, 6.0, 1.0, 0.0, 0.5, 0.5, 0.5};
  // a quarter turn: 0.25 m along x and 0.5 m along y on each side
  const SFootprint box = MakeBox(2.0, 2.0, 0.5 * std::numbers::pi, 0.5, 0.25);
  const SFootprint near = MakeBox(1.125, 2.0, 0.0, 0.5, 0.25);
  const SFootprint far = MakeBox(4.0, 2.25, 0.0, 1.0, 0.5);
  // its nearest corner is 0.5 m away in x and in y from the centre of the disc
  const SFootprint aside = MakeBox(1.75, 2.75, 0.0, 0.25, 0.25);
  for (const auto& [a, b, gap] :
       {std::tuple(disc, other, 4.25), std::tuple(disc, box, 0.5), std::tuple(box, far, 0.75),
        std::tuple(disc, aside, std::sqrt(0.5) - 0.25),
        // the disc leaves through the long side, which is 0.25 m from its centre
        std::tuple(disc, near, -0.5), std::tuple(box, near, 0.125)}) {
    CHECK_THAT(ComputeGap(a, b), WithinAbs(gap, kRounding));
    CHECK_THAT(ComputeGap(b, a), WithinAbs(gap, kRounding));
  }
}

TEST_CASE("footprints: half of the narrowest side seen from above", "[unit][kinematics2d]") {
  SBodyDescription description;
  const auto narrowest = [&description](const std::vector<SShapeDescription>& shapes) {
    description.Shapes = shapes;
    return ComputeNarrowestHalf(description);
  };
  const auto disc = SShapeDescription::Cylinder(0.05, 0.01);
  const auto wide = SShapeDescription::Box(CVector3(0.4, 0.3, 0.01));
  const auto slim = SShapeDescription::Box(CVector3(0.06, 0.3, 1.0));
  // the height of a solid that lies is one of its sides
  auto lying = SShapeDescription::Box(CVector3(0.4, 0.3, 0.02));
  lying.Orientation = CQuaternion(CRadians::PI_OVER_TWO, CVector3::Y);
  CHECK(narrowest({disc}) == 0.05);
  CHECK(narrowest({wide}) == 0.15);
  CHECK(narrowest({lying}) == 0.01);
  for (const auto& [a, b, expected] :
       {std::tuple(disc, wide, 0.05), std::tuple(disc, slim, 0.03), std::tuple(lying, disc, 0.01),
        std::tuple(wide, slim, 0.03), std::tuple(lying, slim, 0.01)}) {
    CHECK(narrowest({a, b}) == expected);
    CHECK(narrowest({b, a}) == expected);
  }
}

}  // namespace argos::separation_test
