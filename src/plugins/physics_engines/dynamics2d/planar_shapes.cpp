#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_shapes.h>

#include <argos3/core/simulator/geometry/convex_polygon.h>
#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>

namespace argos {

const float kShapeMargin = 0.5F * b2_linearSlop;

namespace {

using EKind = SShapeDescription::EKind;

b2Vec2 ToUnits(const CVector3& point, Real unitsPerMetre) {
  return b2Vec2(static_cast<float>(point.GetX() * unitsPerMetre),
                static_cast<float>(point.GetY() * unitsPerMetre));
}

b2CircleShape MakeDisc(const CVector3& offset, Real radius, Real unitsPerMetre) {
  b2CircleShape disc;
  disc.m_p = ToUnits(offset, unitsPerMetre);
  disc.m_radius = static_cast<float>(radius * unitsPerMetre) + kShapeMargin;
  return disc;
}

b2PolygonShape MakeRectangle(const SShapeDescription& shape, Real unitsPerMetre) {
  b2PolygonShape polygon;
  if (IsUpright(shape)) {
    const Real yaw = ComputeYaw(shape);
    polygon.SetAsBox(static_cast<float>(0.5 * shape.Size.GetX() * unitsPerMetre),
                     static_cast<float>(0.5 * shape.Size.GetY() * unitsPerMetre),
                     ToUnits(shape.Offset, unitsPerMetre), static_cast<float>(yaw));
  } else {
    const SFootprint around = EncloseTilted(shape);
    polygon.SetAsBox(static_cast<float>(around.HalfX * unitsPerMetre),
                     static_cast<float>(around.HalfY * unitsPerMetre),
                     ToUnits(CVector3(around.X, around.Y, 0.0), unitsPerMetre),
                     static_cast<float>(std::atan2(around.Sin, around.Cos)));
  }
  // Box2D's default margin would enlarge the described shape; it is for continuous collision, which
  // this engine does not use
  polygon.m_radius = kShapeMargin;
  return polygon;
}

void AddFixture(b2Body& body, b2FixtureDef& definition, const b2Shape& shape) {
  definition.shape = &shape;
  body.CreateFixture(&definition);
}

// Adds the polygons of a fan around the first corner of a prism's base. b2PolygonShape::Set() is
// not used: it merges corners that are half a slop apart.
void AddPrism(b2Body& body, b2FixtureDef& definition, const SShapeDescription& prism,
              Real unitsPerMetre) {
  constexpr size_t kMax = b2_maxPolygonVertices;
  std::vector<CVector2> corners = *prism.Vertices;
  for (CVector2& corner : corners) {
    corner.Rotate(CRadians(ComputeYaw(prism)));
  }
  for (size_t first = 1; first + 1 < corners.size(); first += kMax - 2) {
    const size_t last = std::min(first + kMax - 2, corners.size() - 1);
    std::vector<CVector2> piece = {corners[0]};
    piece.insert(piece.end(), corners.begin() + static_cast<std::ptrdiff_t>(first),
                 corners.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const auto place = [&](const CVector2& point) {
      return ToUnits(prism.Offset + CVector3(point.GetX(), point.GetY(), 0.0), unitsPerMetre);
    };
    b2PolygonShape polygon;
    polygon.m_count = static_cast<int32>(piece.size());
    polygon.m_radius = kShapeMargin;
    polygon.m_centroid = place(ComputeMoments(piece).Centroid);
    for (size_t i = 0; i < piece.size(); ++i) {
      const CVector2 normal = ComputeSideNormal(piece, i);
      polygon.m_vertices[i] = place(piece[i]);
      polygon.m_normals[i].Set(static_cast<float>(normal.GetX()),
                               static_cast<float>(normal.GetY()));
    }
    AddFixture(body, definition, polygon);
  }
}

b2FixtureDef DefineFixture(Real friction) {
  b2FixtureDef definition;
  // Box2D combines coefficients by the root of their product, this engine by the product
  definition.friction = static_cast<float>(friction * friction);
  definition.restitution = 0.0F;
  return definition;
}

}  // namespace

void AddDisc(b2Body& body, Real radius, Real unitsPerMetre, Real friction) {
  b2FixtureDef definition = DefineFixture(friction);
  AddFixture(body, definition, MakeDisc(CVector3(), radius, unitsPerMetre));
}

void AddFixtures(b2Body& body, const SBodyDescription& description, Real unitsPerMetre,
                 Real friction) {
  b2FixtureDef definition = DefineFixture(friction);
  for (const SShapeDescription& shape : description.Shapes) {
    if (IsDisc(shape)) {
      AddFixture(body, definition, MakeDisc(shape.Offset, shape.Radius, unitsPerMetre));
    } else if (shape.Kind == EKind::Prism && IsUpright(shape)) {
      AddPrism(body, definition, shape, unitsPerMetre);
    } else {
      AddFixture(body, definition, MakeRectangle(shape, unitsPerMetre));
    }
  }
}

void SetMass(b2Body& body, const SBodyDescription& description, Real unitsPerMetre) {
  const CVector3 centre = description.ComputeCentreOfMass();
  const Real offsetInertia =
      description.Mass * (centre.GetX() * centre.GetX() + centre.GetY() * centre.GetY());
  Real inertia =
      description.PlanarInertia ? *description.PlanarInertia : description.ComputePlanarInertia();
  // a described moment below that of the offset of the centre of mass is impossible, and Box2D
  // needs a positive difference
  inertia = std::max(inertia, offsetInertia * (1.0 + 1e-3));
  b2MassData mass;
  mass.mass = static_cast<float>(description.Mass);
  mass.center = ToUnits(centre, unitsPerMetre);
  mass.I = static_cast<float>(inertia * unitsPerMetre * unitsPerMetre);
  body.SetMassData(&mass);
}

}  // namespace argos
