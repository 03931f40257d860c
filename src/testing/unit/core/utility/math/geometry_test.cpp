#include <argos3/core/utility/math/box.h>
#include <argos3/core/utility/math/cylinder.h>
#include <argos3/core/utility/math/plane.h>
#include <argos3/core/utility/math/pose2.h>
#include <argos3/core/utility/math/ray2.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/math/transforms.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <optional>
#include <sstream>

namespace geometry_test {

using Catch::Matchers::WithinAbs;
using namespace argos;

namespace {

// tolerance of a few roundings of numbers of about 1 to 10
constexpr Real kRounding = 1e-14;

template <typename SOLID>
std::optional<Real> Hit(const SOLID& solid, const CRay3& ray) {
  Real t = -7.0;
  if (solid.Intersects(t, ray)) {
    return t;
  }
  // a miss leaves t unchanged
  CHECK(t == -7.0);
  return std::nullopt;
}

CVector3 Rotated(const CVector3& vector, const CQuaternion& rotation) {
  return CVector3(vector).Rotate(rotation);
}

// transforms a ray from the frame of a solid to the world
CRay3 Place(const CRay3& ray, const CVector3& position, const CQuaternion& orientation) {
  return CRay3(LocalToGlobal(ray.GetStart(), position, orientation),
               LocalToGlobal(ray.GetEnd(), position, orientation));
}

}  // namespace

TEST_CASE("2D ray: ends, direction and points", "[core][math]") {
  CRay2 ray;
  CHECK(ray.GetStart() == CVector2::ZERO);
  CHECK(ray.GetEnd() == CVector2::ZERO);
  ray.Set(CVector2(1, 1), CVector2(4, 5));
  CHECK(ray.GetLength() == 5.0);
  CVector2 buffer;
  ray.ToVector(buffer);
  CHECK(buffer == CVector2(3, 4));
  ray.GetDirection(buffer);
  CHECK(buffer == CVector2(0.6, 0.8));
  ray.GetInverseDirection(buffer);
  CHECK(buffer == CVector2(-0.6, -0.8));
  ray.GetPoint(buffer, 0.5);
  CHECK(buffer == CVector2(2.5, 3));
  CHECK(ray.GetDistance(0.5) == 2.5);

  ray.Set(CVector2(1, 0), CVector2::Y, 3.0);
  CHECK(ray.GetEnd() == CVector2(1, 3));
  CHECK(CRay2(CVector2(1, 0), CVector2::Y, 3.0).GetEnd() == CVector2(1, 3));
  ray.SetStart(CVector2(2, 2));
  ray.SetEnd(CVector2(3, 3.5));
  CHECK(ray.GetStart() == CVector2(2, 2));
  std::ostringstream out;
  out << ray;
  CHECK(out.str() == "2,2 -> 3,3.5");
}

TEST_CASE("2D ray: segments with a common point intersect, end points included, in either order",
          "[core][math]") {
  const CRay2 ray(CVector2(0, 0), CVector2(2, 2));
  const auto intersect = [&](const CRay2& other) {
    const bool result = ray.Intersects(other);
    CHECK(other.Intersects(ray) == result);
    CHECK(CRay2(ray.GetEnd(), ray.GetStart()).Intersects(other) == result);
    return result;
  };
  CHECK(intersect(CRay2(CVector2(0, 2), CVector2(2, 0))));
  CHECK(intersect(CRay2(CVector2(2, 2), CVector2(5, 0))));
  CHECK(intersect(CRay2(CVector2(1, 1), CVector2(1, 5))));
  CHECK_FALSE(intersect(CRay2(CVector2(0, 2), CVector2(0.9, 1.1))));
  CHECK_FALSE(intersect(CRay2(CVector2(3, 0), CVector2(3, 9))));
  // parallel, overlapping, and without length
  CHECK_FALSE(intersect(CRay2(CVector2(1, 0), CVector2(3, 2))));
  CHECK_FALSE(intersect(CRay2(CVector2(1, 1), CVector2(3, 3))));
  CHECK_FALSE(intersect(CRay2(CVector2(1, 1), CVector2(1, 1))));
}

TEST_CASE("3D ray: ends, direction and points", "[core][math]") {
  CRay3 ray;
  CHECK(ray.GetStart() == CVector3::ZERO);
  ray.Set(CVector3(1, 1, 1), CVector3(3, 4, 7));
  CHECK(ray.GetLength() == 7.0);
  CVector3 buffer;
  CHECK(&ray.ToVector(buffer) == &buffer);
  CHECK(buffer == CVector3(2, 3, 6));
  ray.GetDirection(buffer);
  CHECK_THAT(Distance(buffer, CVector3(2, 3, 6) / 7.0), WithinAbs(0.0, kRounding));
  ray.GetInverseDirection(buffer);
  CHECK_THAT(Distance(buffer, CVector3(-2, -3, -6) / 7.0), WithinAbs(0.0, kRounding));
  ray.GetPoint(buffer, 0.5);
  CHECK(buffer == CVector3(2, 2.5, 4));
  CHECK(ray.GetDistance(0.5) == 3.5);
  ray.SetLength(14.0);
  CHECK_THAT(Distance(ray.GetEnd(), CVector3(5, 7, 13)), WithinAbs(0.0, kRounding));

  ray.Set(CVector3(1, 0, 0), CVector3::Y, 3.0);
  CHECK(ray.GetEnd() == CVector3(1, 3, 0));
  CHECK(CRay3(CVector3(1, 0, 0), CVector3::Y, 3.0).GetEnd() == CVector3(1, 3, 0));
  ray.GetStart().SetX(2.0);
  ray.GetEnd().SetZ(5.0);
  const CRay3& constant = ray;
  CHECK(constant.GetStart() == CVector3(2, 0, 0));
  CHECK(constant.GetEnd() == CVector3(1, 3, 5));
  ray.SetStart(CVector3(0, 0, 1));
  ray.SetEnd(CVector3(0, 0.5, 0));
  std::ostringstream out;
  out << ray;
  CHECK(out.str() == "0,0,1 -> 0,0.5,0");
}

TEST_CASE("plane: is constructed from point and normal or from three points", "[core][math]") {
  CPlane plane;
  plane.SetPosition(CVector3(1, 2, 3));
  plane.SetNormal(CVector3::X);
  CHECK(plane.GetPosition() == CVector3(1, 2, 3));
  CHECK(plane.GetNormal() == CVector3::X);
  CHECK(CPlane(CVector3(1, 2, 3), CVector3::X).GetNormal() == CVector3::X);
  // (p3 - p2) x (p1 - p2) = (0,1,0) x (2,0,0)
  const CPlane three(CVector3(3, 1, 1), CVector3(1, 1, 1), CVector3(1, 2, 1));
  CHECK(three.GetPosition() == CVector3(1, 1, 1));
  CHECK(three.GetNormal() == CVector3(0, 0, -2));
  plane.SetFromThreePoints(CVector3(3, 1, 1), CVector3(1, 1, 1), CVector3(1, 2, 1));
  CHECK(plane.GetNormal() == three.GetNormal());
}

TEST_CASE("plane: intersects with the segment only, not with its prolongation", "[core][math]") {
  const CPlane plane(CVector3(9, 9, 1), CVector3(0, 0, GENERATE(1.0, -1.0, 5.0)));
  CHECK(Hit(plane, CRay3(CVector3(0, 0, 0), CVector3(4, 0, 4))) == 0.25);
  CHECK(Hit(plane, CRay3(CVector3(4, 0, 4), CVector3(0, 0, 0))) == 0.75);
  CHECK(Hit(plane, CRay3(CVector3(0, 0, 1), CVector3(0, 0, 5))) == 0.0);
  CHECK(Hit(plane, CRay3(CVector3(0, 0, 5), CVector3(0, 0, 1))) == 1.0);
  CHECK(Hit(plane, CRay3(CVector3(0, 0, 1), CVector3(5, 0, 1))) == 0.0);
  CHECK_FALSE(Hit(plane, CRay3(CVector3(0, 0, 2), CVector3(0, 0, 5))));
  CHECK_FALSE(Hit(plane, CRay3(CVector3(0, 0, 0), CVector3(0, 0, 0.9))));
  CHECK_FALSE(Hit(plane, CRay3(CVector3(0, 0, 2), CVector3(5, 0, 2))));

  CVector3 point(7, 7, 7);
  CHECK(CRay3(CVector3(0, 0, 0), CVector3(4, 0, 4)).Intersects(plane, point));
  CHECK(point == CVector3(1, 0, 1));
  CHECK_FALSE(CRay3(CVector3(0, 0, 2), CVector3(0, 0, 5)).Intersects(plane, point));
  CHECK(point == CVector3(1, 0, 1));
}

TEST_CASE("box: rays hit the faces at the exact point", "[core][math]") {
  CBox box(CVector3(2, 4, 6));
  CHECK(box.GetBasePosition() == CVector3::ZERO);
  CHECK(box.GetOrientation() == CQuaternion());
  // x, y within +-1 and +-2 of the centre, z from the base up
  CHECK(Hit(box, CRay3(CVector3(-5, 0, 1), CVector3(5, 0, 1))) == 0.4);
  CHECK(Hit(box, CRay3(CVector3(0, 6, 1), CVector3(0, -2, 1))) == 0.5);
  CHECK(Hit(box, CRay3(CVector3(0, 0, 10), CVector3(0, 0, 0))) == 0.4);
  CHECK(Hit(box, CRay3(CVector3(0, 0, -2), CVector3(0, 0, 2))) == 0.5);
  SECTION("a hit beyond the end of the ray is reported too") {
    CHECK(Hit(box, CRay3(CVector3(-5, 0, 1), CVector3(-3, 0, 1))) == 2.0);
  }
  SECTION("a box behind the start is not hit") {
    CHECK_FALSE(Hit(box, CRay3(CVector3(-3, 0, 1), CVector3(-5, 0, 1))));
  }
  SECTION("from inside and from the surface the distance is 0") {
    CHECK(Hit(box, CRay3(CVector3(0, 0, 1), CVector3(5, 5, 5))) == 0.0);
    CHECK(Hit(box, CRay3(CVector3(1, 0, 1), CVector3(5, 0, 1))) == 0.0);
    CHECK(Hit(box, CRay3(CVector3(0, 0, 1), CVector3(0, 0, 1))) == 0.0);
  }
  SECTION("a ray that touches hits, a ray that passes beside does not") {
    CHECK(Hit(box, CRay3(CVector3(-5, 2, 1), CVector3(5, 2, 1))) == 0.4);
    CHECK_FALSE(Hit(box, CRay3(CVector3(-5, 2.001, 1), CVector3(5, 2.001, 1))));
    CHECK_FALSE(Hit(box, CRay3(CVector3(-5, 0, -0.001), CVector3(5, 0, -0.001))));
    CHECK_FALSE(Hit(box, CRay3(CVector3(-5, 0, 6.001), CVector3(5, 0, 6.001))));
    CHECK_FALSE(Hit(box, CRay3(CVector3(-3, 0, 1), CVector3(0, 5, 1))));
  }
  SECTION("setters change the box") {
    box.SetSize(CVector3(1, 1, 1));
    box.SetBasePosition(CVector3(10, 0, 0));
    box.SetOrientation(CQuaternion(CRadians::PI_OVER_FOUR, CVector3::Z));
    CHECK(box.GetSize() == CVector3(1, 1, 1));
    // the corner is half a diagonal from the centre
    const std::optional<Real> hit = Hit(box, CRay3(CVector3(0, 0, 0.5), CVector3(10, 0, 0.5)));
    REQUIRE(hit);
    CHECK_THAT(*hit, WithinAbs(1.0 - std::sqrt(0.5) / 10.0, kRounding));
  }
}

TEST_CASE("solids: hits are invariant under common motions of solid and ray", "[core][math]") {
  const CVector3 position(3, -2, 5);
  const CQuaternion orientation(CRadians(GENERATE(0.0, 0.7, 2.0, -1.1)), CVector3(2, -3, 6) / 7.0);
  const CRay3 rays[] = {CRay3(CVector3(-5, 0.3, 1), CVector3(5, 0.1, 2)),
                        CRay3(CVector3(0.2, 0.3, 9), CVector3(0.1, 0.1, 2)),
                        CRay3(CVector3(-5, -5, -5), CVector3(-3, -3, -3.5)),
                        CRay3(CVector3(3, 3, 9), CVector3(4, 3, 2))};
  for (const CRay3& ray : rays) {
    CAPTURE(ray);
    const CRay3 placed = Place(ray, position, orientation);
    const std::optional<Real> box = Hit(CBox(CVector3(2, 1, 3)), ray);
    const std::optional<Real> placedBox =
        Hit(CBox(CVector3(2, 1, 3), position, orientation), placed);
    REQUIRE(box.has_value() == placedBox.has_value());
    CHECK_THAT(box.value_or(0.0), WithinAbs(placedBox.value_or(0.0), kRounding));
    const std::optional<Real> cylinder = Hit(CCylinder(1.5, 3.0), ray);
    const std::optional<Real> placedCylinder =
        Hit(CCylinder(1.5, 3.0, position, Rotated(CVector3::Z, orientation)), placed);
    REQUIRE(cylinder.has_value() == placedCylinder.has_value());
    CHECK_THAT(cylinder.value_or(0.0), WithinAbs(placedCylinder.value_or(0.0), kRounding));
  }
}

TEST_CASE("cylinder: rays hit the side at the exact point", "[core][math]") {
  const CCylinder cylinder(1.0, 2.0);
  CHECK(cylinder.GetBasePosition() == CVector3::ZERO);
  CHECK(cylinder.GetAxis() == CVector3::Z);
  const Real offset = GENERATE(0.0, 0.3, -0.6, 0.999);
  const Real distance = GENERATE(2.0, 10.0, 1e6);
  CAPTURE(offset, distance);
  const std::optional<Real> hit =
      Hit(cylinder, CRay3(CVector3(-distance, offset, 1), CVector3(distance, offset, 1)));
  REQUIRE(hit);
  // in m from the start; t is in units of the ray's length and rounded at 1e-16
  const Real expected = distance - std::sqrt(1.0 - offset * offset);
  CHECK_THAT(*hit * 2.0 * distance, WithinAbs(expected, 4e-16 * distance + kRounding));
}

TEST_CASE("cylinder: rays hit the caps or miss", "[core][math]") {
  const CCylinder cylinder(1.0, 2.0, CVector3(0, 0, 1));
  // from above and below; the solid reaches from z = 1 to z = 3
  CHECK(Hit(cylinder, CRay3(CVector3(0.5, 0.5, 7), CVector3(0.5, 0.5, -1))) == 0.5);
  CHECK(Hit(cylinder, CRay3(CVector3(0, 0, -1), CVector3(0, 0, 3))) == 0.5);
  CHECK_FALSE(Hit(cylinder, CRay3(CVector3(0.8, 0.8, 7), CVector3(0.8, 0.8, -1))));
  CHECK_FALSE(Hit(cylinder, CRay3(CVector3(-5, 0, 0.999), CVector3(5, 0, 0.999))));
  CHECK_FALSE(Hit(cylinder, CRay3(CVector3(-5, 0, 3.001), CVector3(5, 0, 3.001))));
  CHECK_FALSE(Hit(cylinder, CRay3(CVector3(-5, 1.001, 2), CVector3(5, 1.001, 2))));
  CHECK(Hit(cylinder, CRay3(CVector3(-5, 1, 2), CVector3(5, 1, 2))) == 0.5);
  // enters through the cap although it leaves through the side
  CHECK(Hit(cylinder, CRay3(CVector3(0, 0, 4), CVector3(4, 0, 0))) == 0.25);
  // crosses the infinite cylinder above the solid and passes beside the solid
  CHECK_FALSE(Hit(cylinder, CRay3(CVector3(0, 0, 5), CVector3(2, 0, 3))));
  CHECK(Hit(cylinder, CRay3(CVector3(-9, 0, 2), CVector3(-5, 0, 2))) == 2.0);
  CHECK_FALSE(Hit(cylinder, CRay3(CVector3(-5, 0, 2), CVector3(-9, 0, 2))));
  CHECK(Hit(cylinder, CRay3(CVector3(0.2, 0.1, 2), CVector3(-9, 0, 2))) == 0.0);
  CHECK(Hit(cylinder, CRay3(CVector3(0.2, 0.1, 2), CVector3(0.2, 0.1, 2))) == 0.0);
  CHECK_FALSE(Hit(cylinder, CRay3(CVector3(2, 0.1, 2), CVector3(2, 0.1, 2))));
}

TEST_CASE("cylinder: only the direction of the axis vector matters, not its length",
          "[core][math]") {
  CCylinder cylinder(1.0, 4.0, CVector3::ZERO, CVector3(9, 0, 0));
  // extends along x from 0 to 4
  CHECK(Hit(cylinder, CRay3(CVector3(8, 0, 0), CVector3(0, 0, 0))) == 0.5);
  CHECK(Hit(cylinder, CRay3(CVector3(2, 0, 3), CVector3(2, 0, -1))) == 0.5);
  cylinder.SetRadius(0.5);
  cylinder.SetHeight(1.0);
  cylinder.SetBasePosition(CVector3(0, 0, 1));
  cylinder.SetAxis(CVector3(0, 0, -1));
  CHECK(cylinder.GetRadius() == 0.5);
  CHECK(cylinder.GetHeight() == 1.0);
  CHECK(cylinder.GetAxis() == -CVector3::Z);
  // extends downwards from z = 1 to z = 0
  CHECK(Hit(cylinder, CRay3(CVector3(0, 0, 2), CVector3(0, 0, 0))) == 0.5);
  CHECK(Hit(cylinder, CRay3(CVector3(0, 0, -1), CVector3(0, 0, 1))) == 0.5);
}

TEST_CASE("pose: construction and motions in its own frame", "[core][math]") {
  CHECK(CPose2() == CPose2(0, 0, 0));
  const CPose2 pose(CVector2(1, 2), CRadians(0.5));
  CHECK(pose == CPose2(1, 2, 0.5));
  CHECK(pose.GetPosition() == CVector2(1, 2));
  CHECK(pose.GetOrientation() == CRadians(0.5));
  CHECK(CPose2(pose) == pose);
  CHECK(pose != CPose2(1, 2, 0.6));
  CHECK(pose != CPose2(1, 3, 0.5));
  const CPose2 projected(CVector3(1, 2, 3), CQuaternion(CRadians(0.5), CVector3::Z));
  CHECK(projected.GetPosition() == CVector2(1, 2));
  CHECK_THAT(projected.GetOrientation().GetValue(), WithinAbs(0.5, kRounding));

  // 2 ahead, left turn, 1 ahead
  CPose2 walk;
  walk.Translate(CVector2(2, 0));
  walk.Rotate(CRadians::PI_OVER_TWO);
  walk.Translate(CVector2(1, 0));
  CHECK_THAT(Distance(walk.GetPosition(), CVector2(2, 1)), WithinAbs(0.0, kRounding));
  CHECK(walk.GetOrientation() == CRadians::PI_OVER_TWO);
}

TEST_CASE("pose: composition satisfies the group axioms", "[core][math]") {
  const CPose2 a(1, -2, 0.7);
  const CPose2 b(0.5, 3, -2.0);
  const CPose2 c(-1, 0.2, 1.1);
  const CVector2 point(0.4, 0.9);
  const auto checkClose = [](const CPose2& left, const CPose2& right) {
    CHECK_THAT(Distance(left.GetPosition(), right.GetPosition()), WithinAbs(0.0, kRounding));
    CHECK_THAT((left.GetOrientation() - right.GetOrientation()).GetValue(),
               WithinAbs(0.0, kRounding));
  };
  checkClose((a * b) * c, a * (b * c));
  checkClose(a * a.Inverse(), CPose2());
  checkClose(a.Inverse() * a, CPose2());
  checkClose(a * CPose2(), a);
  checkClose((a * b).Inverse(), b.Inverse() * a.Inverse());
  CHECK_THAT(Distance((a * b) * point, a * (b * point)), WithinAbs(0.0, kRounding));
  CPose2 product = a;
  CHECK(&(product *= b) == &product);
  CHECK(product == a * b);
  CHECK_THAT(Distance(CPose2(1, 2, ARGOS_PI / 2.0) * CVector2(3, 0), CVector2(1, 5)),
             WithinAbs(0.0, kRounding));
}

TEST_CASE("transforms: local and global coordinates", "[core][math]") {
  const CQuaternion left(CRadians::PI_OVER_TWO, CVector3::Z);
  // a robot at (1,2,0) that faces +y sees (1,5,0) three metres ahead
  CHECK_THAT(Distance(GlobalToLocal(CVector3(1, 5, 0), CVector3(1, 2, 0), left), CVector3(3, 0, 0)),
             WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(LocalToGlobal(CVector3(3, 0, 0), CVector3(1, 2, 0), left), CVector3(1, 5, 0)),
             WithinAbs(0.0, kRounding));
  const CQuaternion orientation(CRadians(1.3), CVector3(2, 3, -6) / 7.0);
  const CVector3 point(0.3, 4, -2);
  const CVector3 translation(-1, 2, 0.5);
  CHECK_THAT(Distance(LocalToGlobal(GlobalToLocal(point, translation, orientation), translation,
                                    orientation),
                      point),
             WithinAbs(0.0, kRounding));
}

}  // namespace geometry_test
