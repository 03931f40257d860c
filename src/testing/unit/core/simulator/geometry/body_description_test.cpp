#include <argos3/core/simulator/geometry/body_description.h>

#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/testing/support/polygons.h>
#include <argos3/testing/support/solid_reference.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace body_description_test {

using namespace argos;
using Catch::WithinAbs;
using Catch::WithinRel;

namespace {

// tolerance for sums of a few products of numbers of the order of 1
constexpr Real kRounding = 1e-14;

SBodyDescription Body(std::vector<SShapeDescription> shapes, Real mass = 1.0) {
  SBodyDescription body;
  body.Shapes = std::move(shapes);
  body.Mass = mass;
  return body;
}

}  // namespace

TEST_CASE("shape description: a box reports its size and the circle around its base",
          "[core][body]") {
  const auto box = SShapeDescription::Box(CVector3(0.6, 0.8, 0.2), CVector3(1.0, 2.0, 3.0));
  CHECK(box.Kind == SShapeDescription::EKind::Box);
  CHECK(box.Size == CVector3(0.6, 0.8, 0.2));
  CHECK(box.Offset == CVector3(1.0, 2.0, 3.0));
  CHECK_THAT(box.Radius, WithinRel(0.5, kRounding));
}

TEST_CASE("shape description: a cylinder and a sphere report their bounding sizes",
          "[core][body]") {
  const auto cylinder = SShapeDescription::Cylinder(0.2, 0.7);
  CHECK(cylinder.Kind == SShapeDescription::EKind::Cylinder);
  CHECK(cylinder.Size == CVector3(0.4, 0.4, 0.7));
  CHECK(cylinder.Radius == 0.2);
  const auto sphere = SShapeDescription::Sphere(0.3);
  CHECK(sphere.Kind == SShapeDescription::EKind::Sphere);
  CHECK(sphere.Size == CVector3(0.6, 0.6, 0.6));
}

TEST_CASE("shape description: sizes must be positive and finite", "[core][body]") {
  const Real bad = GENERATE(0.0, -1.0, std::numeric_limits<Real>::quiet_NaN(),
                            std::numeric_limits<Real>::infinity());
  CAPTURE(bad);
  CHECK_THROWS_AS(SShapeDescription::Box(CVector3(bad, 1.0, 1.0)), CARGoSException);
  CHECK_THROWS_AS(SShapeDescription::Box(CVector3(1.0, bad, 1.0)), CARGoSException);
  CHECK_THROWS_AS(SShapeDescription::Box(CVector3(1.0, 1.0, bad)), CARGoSException);
  CHECK_THROWS_AS(SShapeDescription::Cylinder(bad, 1.0), CARGoSException);
  CHECK_THROWS_AS(SShapeDescription::Cylinder(1.0, bad), CARGoSException);
  CHECK_THROWS_AS(SShapeDescription::Sphere(bad), CARGoSException);
}

TEST_CASE("body description: the bounding radius reaches the farthest point", "[core][body]") {
  CHECK_THAT(Body({SShapeDescription::Box(CVector3(0.6, 0.8, 0.2))}).ComputeBoundingRadius(),
             WithinRel(0.5, kRounding));
  CHECK_THAT(Body({SShapeDescription::Cylinder(0.2, 1.0, CVector3(0.3, 0.4, 0.0))})
                 .ComputeBoundingRadius(),
             WithinRel(0.7, kRounding));
  CHECK_THAT(Body({SShapeDescription::Sphere(0.1), SShapeDescription::Cylinder(0.2, 1.0)})
                 .ComputeBoundingRadius(),
             WithinRel(0.2, kRounding));
}

TEST_CASE("body description: the bounding radius of a box lying on its side includes its height",
          "[core][body]") {
  auto box = SShapeDescription::Box(CVector3(0.2, 0.2, 1.0));
  box.Orientation = CQuaternion(CRadians::PI_OVER_TWO, CVector3(0.0, 1.0, 0.0));
  // the top, 1 m along x, is 0.2 m wide
  CHECK_THAT(Body({box}).ComputeBoundingRadius(), WithinRel(std::hypot(1.0, 0.1), kRounding));
}

TEST_CASE("body description: inertia of the homogeneous solids", "[core][body]") {
  CHECK_THAT(Body({SShapeDescription::Box(CVector3(0.3, 0.4, 5.0))}, 12.0).ComputePlanarInertia(),
             WithinRel(0.25, kRounding));  // m (a^2 + b^2) / 12
  CHECK_THAT(Body({SShapeDescription::Cylinder(0.5, 5.0)}, 8.0).ComputePlanarInertia(),
             WithinRel(1.0, kRounding));  // m r^2 / 2
  CHECK_THAT(Body({SShapeDescription::Sphere(0.5)}, 10.0).ComputePlanarInertia(),
             WithinRel(1.0, kRounding));  // 2 m r^2 / 5
}

TEST_CASE("body description: the parallel axis theorem holds", "[core][body]") {
  const auto centred = Body({SShapeDescription::Cylinder(0.1, 0.2)}, 2.0);
  const auto off = Body({SShapeDescription::Cylinder(0.1, 0.2, CVector3(0.3, -0.4, 1.0))}, 2.0);
  CHECK_THAT(off.ComputePlanarInertia(),
             WithinRel(centred.ComputePlanarInertia() + 2.0 * 0.25, kRounding));
}

TEST_CASE("body description: two halves of a box have the inertia of the box", "[core][body]") {
  const auto whole = Body({SShapeDescription::Box(CVector3(2.0, 1.0, 0.5))}, 3.0);
  const auto halves = Body({SShapeDescription::Box(CVector3(1.0, 1.0, 0.5), CVector3(-0.5, 0, 0)),
                            SShapeDescription::Box(CVector3(1.0, 1.0, 0.5), CVector3(0.5, 0, 0))},
                           3.0);
  CHECK_THAT(halves.ComputePlanarInertia(), WithinRel(whole.ComputePlanarInertia(), kRounding));
}

TEST_CASE(
    "body description: a tilted solid has the moment of inertia about the body's vertical axis",
    "[core][body]") {
  auto lying = SShapeDescription::Box(CVector3(0.3, 0.4, 1.2));
  lying.Orientation = CQuaternion(CRadians::PI_OVER_TWO, CVector3(1.0, 0.0, 0.0));
  // extents along the world's x, y: 0.3, 1.2; the centroid is 0.6 m off, along y
  const Real expected = 6.0 * ((0.3 * 0.3 + 1.2 * 1.2) / 12.0 + 0.6 * 0.6);
  CHECK_THAT(Body({lying}, 6.0).ComputePlanarInertia(), WithinRel(expected, kRounding));
}

TEST_CASE("body description: without solids there are neither inertia nor radius", "[core][body]") {
  CHECK(SBodyDescription().ComputePlanarInertia() == 0.0);
  CHECK(SBodyDescription().ComputeBoundingRadius() == 0.0);
}

TEST_CASE("body description: the bounding box of upright solids", "[core][body]") {
  const CVector3 position(1.0, 2.0, 3.0);
  // a quarter turn swaps x and y
  const CQuaternion quarter(CRadians::PI_OVER_TWO, CVector3::Z);
  const SBodyDescription body = Body({SShapeDescription::Box(CVector3(0.6, 0.2, 0.4)),
                                      SShapeDescription::Cylinder(0.1, 0.1, CVector3(0, 0, 0.4)),
                                      SShapeDescription::Sphere(0.2, CVector3(0.5, 0, -0.1))});
  const SBoundingBox box = body.ComputeBoundingBox(position, quarter);
  // sums of numbers below 4
  CHECK_THAT(Distance(box.MinCorner, CVector3(0.8, 1.7, 2.9)), WithinAbs(0.0, 4 * kRounding));
  CHECK_THAT(Distance(box.MaxCorner, CVector3(1.2, 2.7, 3.5)), WithinAbs(0.0, 4 * kRounding));
}

TEST_CASE("body description: the bounding box of tilted solids", "[core][body]") {
  const CRadians tilt = ToRadians(CDegrees(30.0));
  const Real sine = 0.5;
  const Real cosine = std::sqrt(0.75);
  const CQuaternion aboutY(tilt, CVector3::Y);
  const auto extents = [&](const SShapeDescription& shape) {
    const SBoundingBox box = Body({shape}).ComputeBoundingBox(CVector3(), aboutY);
    return box.MaxCorner - box.MinCorner;
  };
  CHECK_THAT(Distance(extents(SShapeDescription::Cylinder(0.1, 1.0)),
                      CVector3(sine + 0.2 * cosine, 0.2, cosine + 0.2 * sine)),
             WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(extents(SShapeDescription::Box(CVector3(0.4, 0.6, 1.0))),
                      CVector3(sine + 0.4 * cosine, 0.6, cosine + 0.4 * sine)),
             WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(extents(SShapeDescription::Sphere(0.3)), CVector3(0.6, 0.6, 0.6)),
             WithinAbs(0.0, kRounding));
  // a solid tilted within its body has the bounding box of an upright solid in a tilted body
  auto leaning = SShapeDescription::Cylinder(0.1, 1.0);
  leaning.Orientation = aboutY;
  const SBoundingBox box = Body({leaning}).ComputeBoundingBox(CVector3(), CQuaternion());
  CHECK_THAT(Distance(box.MinCorner, CVector3(-0.1 * cosine, -0.1, -0.1 * sine)),
             WithinAbs(0.0, kRounding));
}

TEST_CASE("body description: the bounding box holds every point of the surface", "[core][body]") {
  CRandomStream random(7, "test", "bounding boxes", "");
  SBodyDescription body = Body({SShapeDescription::Box(CVector3(0.6, 0.2, 0.4)),
                                SShapeDescription::Cylinder(0.1, 0.5, CVector3(0.2, 0, 0.4)),
                                SShapeDescription::Sphere(0.2, CVector3(0.5, 0, -0.1))});
  for (int i = 0; i < 100; ++i) {
    const auto turn = [&random] {
      CVector3 axis(random.Gaussian(1.0), random.Gaussian(1.0), random.Gaussian(1.0));
      return CQuaternion(CRadians(random.Uniform(-3.0, 3.0)), axis.Normalize());
    };
    const CVector3 position(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
    const CQuaternion orientation = turn();
    body.Shapes[0].Orientation = turn();
    body.Shapes[1].Orientation = turn();
    const SBoundingBox box = body.ComputeBoundingBox(position, orientation);
    for (size_t solid = 0; solid < body.Shapes.size(); ++solid) {
      for (const CVector3& point : SurfacePoints({&body, position, orientation}, solid)) {
        for (UInt32 axis = 0; axis < 3; ++axis) {
          REQUIRE(point[axis] >= box.MinCorner[axis] - kRounding);
          REQUIRE(point[axis] <= box.MaxCorner[axis] + kRounding);
        }
      }
    }
  }
}

TEST_CASE("shape description: a prism is centred on the bounding rectangle of its base",
          "[core][body]") {
  // clockwise, and far from the point to which the corners are relative
  const auto prism = SShapeDescription::Prism(
      {CVector2(1.0, 1.0), CVector2(1.0, 1.4), CVector2(1.8, 1.0)}, 0.5, CVector3(0.1, 0.2, 0.3));
  CHECK(prism.Kind == SShapeDescription::EKind::Prism);
  CHECK_THAT(Distance(prism.Offset, CVector3(1.5, 1.4, 0.3)), WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(prism.Size, CVector3(0.8, 0.4, 0.5)), WithinAbs(0.0, kRounding));
  CHECK_THAT(prism.Radius, WithinRel(std::hypot(0.4, 0.2), kRounding));
  REQUIRE(prism.Vertices->size() == 3);
  const auto& corners = *prism.Vertices;
  CHECK((corners[1] - corners[0]).CrossProduct(corners[2] - corners[0]) > 0.0);
  CHECK_THAT(Distance(prism.ComputeMiddle(), CVector3(1.5, 1.4, 0.55)), WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(prism.ComputeCentroid(), CVector3(0.1 + 3.8 / 3.0, 0.2 + 3.4 / 3.0, 0.55)),
             WithinAbs(0.0, kRounding));
  CHECK_THAT(prism.ComputeVolume(), WithinRel(0.08, 10 * kRounding));
  CHECK_THROWS_AS(SShapeDescription::Prism({CVector2(0, 0), CVector2(1, 0), CVector2(0, 1)}, 0.0),
                  CARGoSException);
  CHECK_THROWS_AS(SShapeDescription::Prism({CVector2(0, 0), CVector2(1, 0)}, 1.0), CARGoSException);
}

TEST_CASE("body description: a rectangle as a prism has the numbers of the box", "[core][body]") {
  CRandomStream random(3, "test", "prism", "boxes");
  for (int i = 0; i < 100; ++i) {
    const CVector3 size(random.Uniform(0.05, 1), random.Uniform(0.05, 1), random.Uniform(0.05, 1));
    const CVector3 offset(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
    auto box = SShapeDescription::Box(size, offset);
    auto prism =
        SShapeDescription::Prism(RectanglePolygon(size.GetX(), size.GetY()), size.GetZ(), offset);
    const CQuaternion turn = CQuaternion(random.Uniform(-1, 1), random.Uniform(-1, 1),
                                         random.Uniform(-1, 1), random.Uniform(-1, 1))
                                 .Normalize();
    box.Orientation = prism.Orientation = i % 2 == 0 ? CQuaternion() : turn;
    const SBodyDescription a = Body({box}, 2.0);
    const SBodyDescription b = Body({prism}, 2.0);
    REQUIRE_THAT(b.ComputeBoundingRadius(), WithinRel(a.ComputeBoundingRadius(), 1e-12));
    REQUIRE_THAT(b.ComputePlanarInertia(), WithinRel(a.ComputePlanarInertia(), 1e-12));
    REQUIRE(Distance(a.ComputeCentreOfMass(), b.ComputeCentreOfMass()) < 1e-12);
    REQUIRE_THAT(prism.ComputeBaseWidth(), WithinRel(box.ComputeBaseWidth(), 1e-12));
    const SBoundingBox boxA = a.ComputeBoundingBox(offset, turn);
    const SBoundingBox boxB = b.ComputeBoundingBox(offset, turn);
    REQUIRE(Distance(boxA.MinCorner, boxB.MinCorner) < 1e-12);
    REQUIRE(Distance(boxA.MaxCorner, boxB.MaxCorner) < 1e-12);
  }
}

TEST_CASE("body description: inertia of prisms of other shapes", "[core][body]") {
  // the right triangle with legs a and b about its centroid: m (a^2 + b^2) / 18
  const auto triangle = SShapeDescription::Prism(
      {CVector2(-0.2, -0.1), CVector2(0.4, -0.1), CVector2(-0.2, 0.2)}, 0.1);
  CHECK_THAT(Body({triangle}, 2.0).ComputePlanarInertia(),
             WithinRel(2.0 * (0.36 + 0.09) / 18.0, 10 * kRounding));
  // a hexagon with a circumscribed circle of radius r: 5 m r^2 / 12
  CHECK_THAT(
      Body({SShapeDescription::Prism(RegularPolygon(6, 0.3), 0.2)}, 2.0).ComputePlanarInertia(),
      WithinRel(2.0 * 5.0 * 0.09 / 12.0, 10 * kRounding));
  // two halves along a diagonal make a box, in any orientation: the products of inertia matter
  const CQuaternion turn = CQuaternion(0.3, -0.5, 0.7, 0.2).Normalize();
  const auto turned = [&](std::vector<CVector2> corners) {
    auto half = SShapeDescription::Prism(std::move(corners), 0.5);
    half.Orientation = turn;
    half.Offset.Rotate(turn);
    return half;
  };
  auto box = SShapeDescription::Box(CVector3(0.4, 0.8, 0.5));
  box.Orientation = turn;
  const SBodyDescription whole = Body({box}, 3.0);
  const SBodyDescription halves =
      Body({turned({CVector2(-0.2, -0.4), CVector2(0.2, -0.4), CVector2(0.2, 0.4)}),
            turned({CVector2(-0.2, -0.4), CVector2(0.2, 0.4), CVector2(-0.2, 0.4)})},
           3.0);
  CHECK_THAT(halves.ComputePlanarInertia(), WithinRel(whole.ComputePlanarInertia(), 1e-12));
}

TEST_CASE("body description: the bounds of prisms are those of their corners", "[core][body]") {
  CRandomStream random(5, "test", "prism", "bounds");
  const auto uniform = [&](Real low, Real high) { return random.Uniform(low, high); };
  for (int i = 0; i < 200; ++i) {
    auto prism = SShapeDescription::Prism(RandomPolygon(0.3, uniform), uniform(0.1, 0.5),
                                          CVector3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
    prism.Orientation =
        CQuaternion(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).Normalize();
    const SBodyDescription body = Body({prism});
    const SReferenceBody reference{&body, CVector3(), CQuaternion()};
    SBoundingBox expected;
    expected.MinCorner.Set(HUGE_VAL, HUGE_VAL, HUGE_VAL);
    expected.MaxCorner = -expected.MinCorner;
    Real reach = 0.0;
    for (const CVector3& point : SurfacePoints(reference, 0)) {
      reach = std::max(reach, std::hypot(point.GetX(), point.GetY()));
      for (UInt32 axis = 0; axis < 3; ++axis) {
        expected.MinCorner[axis] = std::min(expected.MinCorner[axis], point[axis]);
        expected.MaxCorner[axis] = std::max(expected.MaxCorner[axis], point[axis]);
      }
    }
    const SBoundingBox box = body.ComputeBoundingBox(CVector3(), CQuaternion());
    REQUIRE(Distance(box.MinCorner, expected.MinCorner) < 1e-12);
    REQUIRE(Distance(box.MaxCorner, expected.MaxCorner) < 1e-12);
    REQUIRE_THAT(body.ComputeBoundingRadius(), WithinRel(reach, 1e-12));
  }
}

TEST_CASE("body description: solids without a mass share what the others leave", "[core][body]") {
  // 1 kg at x = 2 m; the other two, of 1 and 2 l, share the rest at x = -1 m and x = 0
  auto heavy = SShapeDescription::Box(CVector3(0.1, 0.1, 0.1), CVector3(2.0, 0.0, 0.0));
  heavy.Mass = 1.0;
  const std::vector<SShapeDescription> shapes = {
      heavy, SShapeDescription::Box(CVector3(0.1, 0.1, 0.1), CVector3(-1.0, 0.0, 0.0)),
      SShapeDescription::Box(CVector3(0.1, 0.2, 0.1), CVector3())};
  CHECK_THAT(Body(shapes, 4.0).ComputeCentreOfMass().GetX(),
             WithinRel((2.0 * 1.0 - 1.0 * 1.0) / 4.0, 1e-12));
  // what has more mass than the body leaves nothing
  CHECK_THAT(Body(shapes, 0.5).ComputeCentreOfMass().GetX(), WithinRel(2.0, 1e-12));
}

TEST_CASE("shape description: hulls and prisms without points are refused",
          "[core][body][errors]") {
  CHECK_THROWS_WITH(SShapeDescription::Hull({}), Catch::Contains("span a volume, found none"));
  const Real bad = GENERATE(std::numeric_limits<Real>::quiet_NaN(), HUGE_VAL);
  CHECK_THROWS_WITH(
      SShapeDescription::Hull({CVector3(), CVector3::X, CVector3::Y, CVector3(0.0, bad, 1.0)}),
      Catch::Contains("must be finite"));
  auto prism = SShapeDescription::Box(CVector3(0.1, 0.1, 0.1));
  prism.Kind = SShapeDescription::EKind::Prism;
  CHECK_THROWS_WITH(Body({prism}).ComputeBoundingRadius(), Catch::Contains("has no Vertices"));
}

}  // namespace body_description_test
