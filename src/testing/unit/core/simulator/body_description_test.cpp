#include <argos3/core/simulator/physics_engine/body_description.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace argos;
using Catch::WithinRel;

namespace {

// sums of a few products of numbers of the order of 1
constexpr Real kRounding = 1e-14;

SBodyDescription Body(std::vector<SShapeDescription> shapes, Real mass = 1.0) {
  SBodyDescription body;
  body.Shapes = std::move(shapes);
  body.Mass = mass;
  return body;
}

}  // namespace

TEST_CASE("shape description: a box knows its size and the circle around its base",
          "[core][body]") {
  const auto box = SShapeDescription::Box(CVector3(0.6, 0.8, 0.2), CVector3(1.0, 2.0, 3.0));
  CHECK(box.Kind == SShapeDescription::EKind::Box);
  CHECK(box.Size == CVector3(0.6, 0.8, 0.2));
  CHECK(box.Offset == CVector3(1.0, 2.0, 3.0));
  CHECK_THAT(box.Radius, WithinRel(0.5, kRounding));
}

TEST_CASE("shape description: a cylinder and a sphere know their bounding sizes", "[core][body]") {
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

TEST_CASE("body description: a box that lies down reaches as far as it is high", "[core][body]") {
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

TEST_CASE("body description: a tilted solid has the moment about the body's vertical",
          "[core][body]") {
  auto lying = SShapeDescription::Box(CVector3(0.3, 0.4, 1.2));
  lying.Orientation = CQuaternion(CRadians::PI_OVER_TWO, CVector3(1.0, 0.0, 0.0));
  // extents along the world's x, y: 0.3, 1.2; the centroid is 0.6 m off, along y
  const Real expected = 6.0 * ((0.3 * 0.3 + 1.2 * 1.2) / 12.0 + 0.6 * 0.6);
  CHECK_THAT(Body({lying}, 6.0).ComputePlanarInertia(), WithinRel(expected, kRounding));
}

TEST_CASE("body description: no solids, no inertia and no radius", "[core][body]") {
  CHECK(SBodyDescription().ComputePlanarInertia() == 0.0);
  CHECK(SBodyDescription().ComputeBoundingRadius() == 0.0);
}
