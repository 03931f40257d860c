#include <argos3/core/simulator/geometry/grown_body.h>

#include <argos3/core/simulator/geometry/bounding_box.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

namespace grown_body_test {

using namespace argos;

namespace {

SShapeDescription MakeSolid(const std::string& kind) {
  const CVector3 offset(0.1, -0.2, 0.3);
  if (kind == "box") {
    return SShapeDescription::Box(CVector3(0.2, 0.3, 0.4), offset);
  }
  if (kind == "cylinder") {
    return SShapeDescription::Cylinder(0.15, 0.2, offset);
  }
  if (kind == "sphere") {
    return SShapeDescription::Sphere(0.1, offset);
  }
  if (kind == "prism") {
    return SShapeDescription::Prism({{0.0, 0.0}, {0.3, 0.0}, {0.05, 0.2}}, 0.25, offset);
  }
  return SShapeDescription::Hull(
      {{0.0, 0.0, 0.0}, {0.3, 0.0, 0.1}, {0.0, 0.2, 0.0}, {0.1, 0.1, 0.4}}, offset);
}

}  // namespace

TEST_CASE("grown body: every face moves outwards by the margin", "[core][geometry]") {
  const std::string kind = GENERATE("box", "cylinder", "sphere", "prism", "hull");
  const bool isTilted = GENERATE(false, true);
  CAPTURE(kind, isTilted);
  constexpr Real kMargin = 0.01;
  SBodyDescription body;
  body.Shapes.push_back(MakeSolid(kind));
  body.Shapes[0].Link = 2;
  if (isTilted && kind != "sphere") {
    body.Shapes[0].Orientation = CQuaternion(CRadians(0.7), CVector3(0.6, 0.0, 0.8));
  }
  const SBodyDescription grown = GrowBody(body, kMargin);
  REQUIRE(grown.Shapes.size() == 1);
  CHECK(grown.Shapes[0].Link == 2);
  const Real most = kMargin * std::sqrt(3.0);  // to the corner of a cube
  for (const Real angle : {0.0, 0.4, 1.1, 2.5}) {
    const CQuaternion orientation(CRadians(angle), CVector3(0.8, 0.0, 0.6));
    const SBoundingBox before = body.ComputeBoundingBox(CVector3(), orientation);
    const SBoundingBox after = grown.ComputeBoundingBox(CVector3(), orientation);
    for (UInt32 axis = 0; axis < 3; ++axis) {
      const Real below = before.MinCorner[axis] - after.MinCorner[axis];
      const Real above = after.MaxCorner[axis] - before.MaxCorner[axis];
      CAPTURE(angle, axis, below, above);
      // coordinates of up to 1 m
      constexpr Real kRounding = 1e-14;
      CHECK(below >= kMargin - kRounding);
      CHECK(above >= kMargin - kRounding);
      CHECK(below <= most + kRounding);
      CHECK(above <= most + kRounding);
      if (angle == 0.0 && !isTilted) {
        CHECK(std::abs(below - kMargin) <= kRounding);
        CHECK(std::abs(above - kMargin) <= kRounding);
      }
      if (kind == "sphere") {
        CHECK(std::abs(above - kMargin) <= kRounding);
      }
    }
  }
}

}  // namespace grown_body_test
