#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_shapes.h>

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

b2PolygonShape MakePolygon(const SShapeDescription& shape, Real unitsPerMetre) {
  b2PolygonShape polygon;
  if (IsUpright(shape)) {
    const Real yaw = ComputeYaw(shape);
    polygon.SetAsBox(static_cast<float>(0.5 * shape.Size.GetX() * unitsPerMetre),
                     static_cast<float>(0.5 * shape.Size.GetY() * unitsPerMetre),
                     ToUnits(shape.Offset, unitsPerMetre), static_cast<float>(yaw));
  } else {
    // the rectangle around the projection of its bounding box
    Real minX = HUGE_VAL, minY = HUGE_VAL, maxX = -HUGE_VAL, maxY = -HUGE_VAL;
    for (UInt32 i = 0; i < 8; ++i) {
      CVector3 corner((i & 1U ? 0.5 : -0.5) * shape.Size.GetX(),
                      (i & 2U ? 0.5 : -0.5) * shape.Size.GetY(), i & 4U ? shape.Size.GetZ() : 0.0);
      corner.Rotate(shape.Orientation);
      minX = std::min(minX, corner.GetX());
      maxX = std::max(maxX, corner.GetX());
      minY = std::min(minY, corner.GetY());
      maxY = std::max(maxY, corner.GetY());
    }
    const CVector3 centre(0.5 * (minX + maxX), 0.5 * (minY + maxY), 0.0);
    polygon.SetAsBox(static_cast<float>(0.5 * (maxX - minX) * unitsPerMetre),
                     static_cast<float>(0.5 * (maxY - minY) * unitsPerMetre),
                     ToUnits(shape.Offset + centre, unitsPerMetre), 0.0F);
  }
  // Box2D's default margin would enlarge the described shape; it is for continuous collision, which
  // this engine does not use
  polygon.m_radius = kShapeMargin;
  return polygon;
}

Real ComputeVolume(const SShapeDescription& shape) {
  switch (shape.Kind) {
    case EKind::Box:
      return shape.Size.GetX() * shape.Size.GetY() * shape.Size.GetZ();
    case EKind::Cylinder:
      return ARGOS_PI * shape.Radius * shape.Radius * shape.Size.GetZ();
    case EKind::Sphere:
      break;
  }
  return 4.0 / 3.0 * ARGOS_PI * shape.Radius * shape.Radius * shape.Radius;
}

CVector3 ComputeCentreOfMass(const SBodyDescription& description) {
  Real volume = 0.0;
  CVector3 weighted;
  for (const SShapeDescription& shape : description.Shapes) {
    const Real shapeVolume = ComputeVolume(shape);
    CVector3 centroid(0.0, 0.0, 0.5 * shape.Size.GetZ());
    centroid.Rotate(shape.Orientation);
    weighted += (shape.Offset + centroid) * shapeVolume;
    volume += shapeVolume;
  }
  return volume > 0.0 ? weighted * (1.0 / volume) : CVector3();
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
  const b2CircleShape disc = MakeDisc(CVector3(), radius, unitsPerMetre);
  b2FixtureDef definition = DefineFixture(friction);
  definition.shape = &disc;
  body.CreateFixture(&definition);
}

void AddFixtures(b2Body& body, const SBodyDescription& description, Real unitsPerMetre,
                 Real friction) {
  b2FixtureDef definition = DefineFixture(friction);
  for (const SShapeDescription& shape : description.Shapes) {
    if (IsDisc(shape)) {
      const b2CircleShape disc = MakeDisc(shape.Offset, shape.Radius, unitsPerMetre);
      definition.shape = &disc;
      body.CreateFixture(&definition);
    } else {
      const b2PolygonShape polygon = MakePolygon(shape, unitsPerMetre);
      definition.shape = &polygon;
      body.CreateFixture(&definition);
    }
  }
}

void SetMass(b2Body& body, const SBodyDescription& description, Real unitsPerMetre) {
  const CVector3 centre = ComputeCentreOfMass(description);
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
