#include <argos3/plugins/simulator/entities/ray_layout.h>

#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <cmath>

namespace argos {

void SRayLayout::AddSensor(const CVector3& offset, const CVector3& direction, Real range,
                           UInt32 anchor) {
  RequirePositive(range, "sensor", "range (m)");
  RequirePositive(direction.Length(), "sensor", "length of the direction");
  SSensorRay ray;
  ray.Offset = offset;
  ray.Direction = direction;
  ray.Direction.Normalize();
  ray.Direction *= range;
  ray.Anchor = anchor;
  Rays.push_back(ray);
  ComputeBounds();
}

void SRayLayout::AddSensorFan(const CVector3& center, Real radius, const CRadians& startAngle,
                              const CRadians& endAngle, Real range, UInt32 num, UInt32 anchor) {
  for (UInt32 i = 0; i < num; ++i) {
    const CRadians angle = startAngle + (endAngle - startAngle) * i / num;
    const CVector3 outward(Cos(angle), Sin(angle), 0.0);
    AddSensor(center + outward * radius, outward, range, anchor);
  }
}

void SRayLayout::ComputeBounds() {
  Planar = true;
  CenterX = CenterY = Reach = FarthestStart = 0.0;
  for (const SSensorRay& ray : Rays) {
    Planar = Planar && ray.Direction.GetZ() == 0.0 && ray.Anchor == Rays.front().Anchor;
    CenterX += ray.Offset.GetX() / static_cast<Real>(Rays.size());
    CenterY += ray.Offset.GetY() / static_cast<Real>(Rays.size());
  }
  for (const SSensorRay& ray : Rays) {
    const Real startX = ray.Offset.GetX() - CenterX;
    const Real startY = ray.Offset.GetY() - CenterY;
    FarthestStart = std::max(FarthestStart, std::hypot(startX, startY));
    Reach = std::max({Reach, FarthestStart,
                      std::hypot(startX + ray.Direction.GetX(), startY + ray.Direction.GetY())});
  }
}

}  // namespace argos
