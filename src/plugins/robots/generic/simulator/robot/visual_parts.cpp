#include <argos3/plugins/robots/generic/simulator/visual_parts.h>

#include <argos3/core/utility/math/angles.h>

namespace argos {

SVisualPart& AddPart(SAppearance& robot, SVisualPart::EKind kind, const CVector3& position,
                     const CVector3& size, const CColor& color, EMaterial material) {
  SVisualPart& part = robot.Parts.emplace_back();
  part.Kind = kind;
  part.Position = position;
  part.Size = size;
  part.Color = color;
  part.Material = material;
  return part;
}

void AddDisc(SAppearance& robot, Real radius, Real bottom, Real top, const CColor& color,
             const CVector3& axis, EMaterial material) {
  AddPart(robot, SVisualPart::EKind::Cylinder, axis + CVector3(0.0, 0.0, bottom),
          CVector3(2.0 * radius, 2.0 * radius, top - bottom), color, material);
}

void AddLED(SAppearance& robot, UInt32 number, const CVector3& position, Real diameter,
            const CColor& color) {
  const CVector3 size(diameter, diameter, diameter);
  AddPart(robot, SVisualPart::EKind::LED, position, size, color).LED = number;
}

void AddLEDRing(SAppearance& robot, const SVisualLEDRing& ring, Real diameter,
                const CColor& color) {
  for (UInt32 i = 0; i < ring.Num; ++i) {
    const CRadians angle = ToRadians(CDegrees(ring.StartAngle + 360.0 / ring.Num * i));
    const CVector3 position(ring.Radius * Cos(angle), ring.Radius * Sin(angle), ring.Elevation);
    AddLED(robot, ring.First + i, position, diameter, color);
  }
}

}  // namespace argos
