#include <argos3/core/simulator/visualization/solid_part.h>

#include <argos3/core/simulator/geometry/body_description.h>

namespace argos {

SVisualPart MakeSolidPart(const SShapeDescription& shape, const CColor& color) {
  using EKind = SVisualPart::EKind;
  SVisualPart part;
  part.Position = shape.Offset;
  part.Orientation = shape.Orientation;
  part.Size = shape.Size;
  part.Color = color;
  if (shape.Kind == SShapeDescription::EKind::Cylinder) {
    part.Kind = EKind::Cylinder;
  } else if (shape.Kind == SShapeDescription::EKind::Sphere) {
    part.Kind = EKind::Sphere;
    part.Position = shape.ComputeMiddle();
  }
  return part;
}

}  // namespace argos
