#include <argos3/core/simulator/geometry/grown_body.h>

#include <argos3/core/simulator/geometry/convex_solid.h>

namespace argos {

namespace {

// corners in the frame of the solid, m, whose base is at height 0
std::vector<CVector3> ListCorners(const SShapeDescription& solid) {
  if (solid.Kind == SShapeDescription::EKind::Hull) {
    return solid.Solid->GetCorners();
  }
  std::vector<CVector3> corners;
  for (const CVector2& vertex : *solid.Vertices) {
    for (const Real height : {0.0, solid.Size.GetZ()}) {
      corners.emplace_back(vertex.GetX(), vertex.GetY(), height);
    }
  }
  return corners;
}

SShapeDescription GrowPolyhedron(const SShapeDescription& solid, Real margin) {
  std::vector<CVector3> points;
  for (const CVector3& corner : ListCorners(solid)) {
    for (const Real x : {-margin, margin}) {
      for (const Real y : {-margin, margin}) {
        for (const Real z : {-margin, margin}) {
          points.push_back(corner + CVector3(x, y, z));
        }
      }
    }
  }
  return SShapeDescription::Hull(std::move(points));
}

SShapeDescription GrowSolid(const SShapeDescription& solid, Real margin) {
  using EKind = SShapeDescription::EKind;
  SShapeDescription grown;
  switch (solid.Kind) {
    case EKind::Box:
      grown = SShapeDescription::Box(solid.Size + 2.0 * margin * CVector3(1.0, 1.0, 1.0));
      break;
    case EKind::Cylinder:
      grown = SShapeDescription::Cylinder(solid.Radius + margin, solid.Size.GetZ() + 2.0 * margin);
      break;
    case EKind::Sphere:
      grown = SShapeDescription::Sphere(solid.Radius + margin);
      break;
    case EKind::Prism:
    case EKind::Hull:
      grown = GrowPolyhedron(solid, margin);
      break;
  }
  // the base moves down along the axis of the solid
  grown.Offset = solid.Offset + CVector3(0.0, 0.0, -margin).Rotate(solid.Orientation);
  grown.Orientation = solid.Orientation;
  grown.Link = solid.Link;
  return grown;
}

}  // namespace

SBodyDescription GrowBody(const SBodyDescription& body, Real margin) {
  SBodyDescription grown;
  for (const SShapeDescription& solid : body.Shapes) {
    grown.Shapes.push_back(GrowSolid(solid, margin));
  }
  return grown;
}

}  // namespace argos
