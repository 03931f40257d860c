// The shapes and masses that Box2D gets of a body.

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_shapes.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/testing/support/polygons.h>

#include <box2d/box2d.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace planar_shapes_test {

using namespace argos;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kScale = 10.0;  // units for a metre
constexpr float kRounding = 1e-5F;  // units

/** A body of a world of its own. */
struct SBox2DBody {
  b2World World{b2Vec2(0.0F, 0.0F)};
  b2Body* Body = nullptr;

  explicit SBox2DBody(const SShapeDescription& shape, Real friction = 0.5) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    Body = World.CreateBody(&definition);
    SBodyDescription description;
    description.Shapes.push_back(shape);
    AddFixtures(*Body, description, kScale, friction);
  }
  std::vector<const b2PolygonShape*> ListPolygons() const {
    std::vector<const b2PolygonShape*> polygons;
    for (const b2Fixture* f = Body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
      CHECK_THAT(f->GetFriction(), WithinAbs(0.25, 1e-6));
      CHECK(f->GetRestitution() == 0.0F);
      REQUIRE(f->GetType() == b2Shape::e_polygon);
      polygons.push_back(dynamic_cast<const b2PolygonShape*>(f->GetShape()));
    }
    return polygons;
  }
};

// sides in order, with outward normals. @return the area
float CheckPolygon(const b2PolygonShape& polygon) {
  CHECK(polygon.m_radius == kShapeMargin);
  float twice = 0.0F;
  for (int32 i = 0; i < polygon.m_count; ++i) {
    const b2Vec2 start = polygon.m_vertices[i];
    const b2Vec2 end = polygon.m_vertices[(i + 1) % polygon.m_count];
    const b2Vec2 normal = polygon.m_normals[i];
    CHECK(std::abs(normal.Length() - 1.0F) < kRounding);
    CHECK(std::abs(b2Dot(normal, end - start)) < kRounding);
    CHECK(b2Dot(normal, start - polygon.m_centroid) > kRounding);
    twice += b2Cross(start, end);
  }
  return 0.5F * twice;
}

bool HasVertex(const b2PolygonShape& polygon, const CVector2& corner) {
  return std::any_of(polygon.m_vertices, polygon.m_vertices + polygon.m_count,
                     [&](const b2Vec2& vertex) {
                       return std::abs(vertex.x - kScale * corner.GetX()) < kRounding &&
                              std::abs(vertex.y - kScale * corner.GetY()) < kRounding;
                     });
}

}  // namespace

TEST_CASE("planar shapes: a prism is a fan of polygons of up to eight corners",
          "[engine][dynamics2d]") {
  const size_t numCorners = GENERATE(3, 4, 6, 8, 9, 14, 15, 30);
  CAPTURE(numCorners);
  SShapeDescription prism =
      SShapeDescription::Prism(RegularPolygon(numCorners, 0.2), 0.1, CVector3(0.05, -0.03, 0.0));
  prism.Orientation = CQuaternion(CRadians(0.3), CVector3::Z);
  const SBox2DBody body(prism);
  const std::vector<const b2PolygonShape*> polygons = body.ListPolygons();
  CHECK(polygons.size() == (numCorners - 2 + 5) / 6);
  float area = 0.0F;
  for (const b2PolygonShape* polygon : polygons) {
    REQUIRE(polygon->m_count >= 3);
    REQUIRE(polygon->m_count <= 8);
    area += CheckPolygon(*polygon);
  }
  const Real angle = 2.0 * std::numbers::pi / static_cast<Real>(numCorners);
  CHECK_THAT(area, WithinAbs(0.5 * static_cast<Real>(numCorners) * std::sin(angle) * 4.0, 1e-4));
  for (CVector2 corner : *prism.Vertices) {
    corner.Rotate(CRadians(0.3));
    corner += CVector2(prism.Offset.GetX(), prism.Offset.GetY());
    CHECK(std::any_of(polygons.begin(), polygons.end(),
                      [&](const b2PolygonShape* polygon) { return HasVertex(*polygon, corner); }));
  }
}

TEST_CASE("planar shapes: boxes are rectangles, tilted ones those around them",
          "[engine][dynamics2d]") {
  SShapeDescription box = SShapeDescription::Box(CVector3(0.4, 0.2, 0.6), CVector3(0.1, -0.2, 0.0));
  const bool isTilted = GENERATE(true, false);
  CAPTURE(isTilted);
  // 90 degrees about z, or 30 degrees towards -y
  box.Orientation = isTilted ? CQuaternion(CRadians(std::numbers::pi / 6.0), CVector3::X)
                             : CQuaternion(CRadians(std::numbers::pi / 2.0), CVector3::Z);
  const SBox2DBody body(box);
  const std::vector<const b2PolygonShape*> polygons = body.ListPolygons();
  REQUIRE(polygons.size() == 1);
  const Real half = 0.1 * std::cos(std::numbers::pi / 6.0);
  const Real lowX = isTilted ? -0.1 : 0.0;
  const Real highX = isTilted ? 0.3 : 0.2;
  const Real lowY = isTilted ? -0.2 - half - 0.3 : -0.4;
  const Real highY = isTilted ? -0.2 + half : 0.0;
  CHECK_THAT(CheckPolygon(*polygons[0]),
             WithinAbs((highX - lowX) * (highY - lowY) * kScale * kScale, 1e-4));
  for (const Real x : {lowX, highX}) {
    for (const Real y : {lowY, highY}) {
      CAPTURE(x, y);
      CHECK(HasVertex(*polygons[0], CVector2(x, y)));
    }
  }
}

TEST_CASE("planar shapes: cylinders and spheres are circles", "[engine][dynamics2d]") {
  const SShapeDescription shape =
      GENERATE(SShapeDescription::Cylinder(0.15, 0.3, CVector3(0.1, -0.2, 0.05)),
               SShapeDescription::Sphere(0.15, CVector3(0.1, -0.2, 0.05)));
  const SBox2DBody body(shape);
  const b2Fixture* const fixture = body.Body->GetFixtureList();
  REQUIRE(fixture != nullptr);
  CHECK(fixture->GetNext() == nullptr);
  REQUIRE(fixture->GetType() == b2Shape::e_circle);
  const auto& circle = dynamic_cast<const b2CircleShape&>(*fixture->GetShape());
  CHECK(std::abs(circle.m_radius - 1.5F - kShapeMargin) < kRounding);
  CHECK(std::abs(circle.m_p.x - 1.0F) < kRounding);
  CHECK(std::abs(circle.m_p.y + 2.0F) < kRounding);
}

TEST_CASE("planar shapes: masses and moments are those of the description",
          "[engine][dynamics2d]") {
  SBodyDescription description;
  description.Shapes.push_back(
      SShapeDescription::Box(CVector3(0.4, 0.2, 0.6), CVector3(0.3, -0.1, 0.0)));
  description.Mass = 2.0;
  const SBox2DBody body(description.Shapes[0]);
  SetMass(*body.Body, description, kScale);
  CHECK(body.Body->GetMass() == 2.0F);
  CHECK(std::abs(body.Body->GetLocalCenter().x - 3.0F) < kRounding);
  CHECK(std::abs(body.Body->GetLocalCenter().y + 1.0F) < kRounding);
  // about the origin, by the parallel axis theorem
  const Real inertia = 2.0 * ((0.16 + 0.04) / 12.0 + 0.09 + 0.01);
  CHECK_THAT(body.Body->GetInertia(), WithinAbs(inertia * kScale * kScale, 1e-3));
  // less than the offset of the centre of mass needs
  description.PlanarInertia = 0.1;
  SetMass(*body.Body, description, kScale);
  CHECK_THAT(body.Body->GetInertia(), WithinAbs(0.2 * 1.001 * kScale * kScale, 1e-3));
}

}  // namespace planar_shapes_test
