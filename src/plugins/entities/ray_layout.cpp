#include <argos3/plugins/simulator/entities/ray_layout.h>

#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// m^2; a shorter ray may have a square length that loses bits when it is rotated
constexpr Real kMinSquareLength = 1e-200;

}  // namespace

void FillBlocks(const SSensorRay* rays, size_t count, SRayBlock* blocks) {
  const size_t numPlaces = SRayBlock::GetNumBlocks(count) * SRayBlock::kSize;
  for (size_t i = 0; i < numPlaces; ++i) {
    const SSensorRay& ray = rays[std::min(i, count - 1)];
    SRayBlock& block = blocks[i / SRayBlock::kSize];
    const size_t place = i % SRayBlock::kSize;
    block.OffsetX[place] = ray.Offset.GetX();
    block.OffsetY[place] = ray.Offset.GetY();
    block.OffsetZ[place] = ray.Offset.GetZ();
    block.DirectionX[place] = ray.Direction.GetX();
    block.DirectionY[place] = ray.Direction.GetY();
    block.DirectionZ[place] = ray.Direction.GetZ();
  }
}

void SRayBounds::Include(const SSensorRay& ray, bool isFirst) {
  const Real z = ray.Offset.GetZ();
  MinZ = isFirst ? z : std::min(MinZ, z);
  MaxZ = isFirst ? z : std::max(MaxZ, z);
  HaveLengths = HaveLengths && ray.Direction.SquareLength() > kMinSquareLength;
}

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
  Planar = HaveLengths = true;
  CenterX = CenterY = Reach = FarthestStart = 0.0;
  Lengths.clear();
  for (const SSensorRay& ray : Rays) {
    Planar = Planar && ray.Direction.GetZ() == 0.0 && ray.Anchor == Rays.front().Anchor;
    CenterX += ray.Offset.GetX() / static_cast<Real>(Rays.size());
    CenterY += ray.Offset.GetY() / static_cast<Real>(Rays.size());
    Include(ray, &ray == &Rays.front());
    Lengths.push_back(ray.Direction.Length());
  }
  for (const SSensorRay& ray : Rays) {
    const Real startX = ray.Offset.GetX() - CenterX;
    const Real startY = ray.Offset.GetY() - CenterY;
    FarthestStart = std::max(FarthestStart, std::hypot(startX, startY));
    Reach = std::max({Reach, FarthestStart,
                      std::hypot(startX + ray.Direction.GetX(), startY + ray.Direction.GetY())});
  }
  Blocks.resize(SRayBlock::GetNumBlocks(Rays.size()));
  FillBlocks(Rays.data(), Rays.size(), Blocks.data());
}

}  // namespace argos
