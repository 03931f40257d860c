#include <argos3/plugins/robots/generic/simulator/light_eyes.h>

#include <argos3/core/simulator/geometry/indexed_shape.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vectorized.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

constexpr size_t kSize = SRayBlock::kSize;

// Places the sensors from a number on, of those in a block; at: where the block begins in the
// arrays.
ARGOS_VECTORIZED
void PlaceBlock(const SRayBlock& block, const SAnchor& anchor, size_t from, SLightEyes& eyes,
                size_t at) {
  const CQuaternion orientation = anchor.Orientation;
  const CVector3 origin = anchor.Position;
  Real x[kSize], y[kSize], z[kSize];
  Real directionX[kSize], directionY[kSize], directionZ[kSize];
  ARGOS_VECTOR_LOOP
  for (size_t i = 0; i < kSize; ++i) {
    CVector3 position(block.OffsetX[i], block.OffsetY[i], block.OffsetZ[i]);
    position.Rotate(orientation);
    position += origin;
    x[i] = position.GetX();
    y[i] = position.GetY();
    z[i] = position.GetZ();
    CVector3 direction(block.DirectionX[i], block.DirectionY[i], block.DirectionZ[i]);
    direction.Rotate(orientation).Normalize();
    directionX[i] = direction.GetX();
    directionY[i] = direction.GetY();
    directionZ[i] = direction.GetZ();
  }
  const auto copy = [from, at](const Real* values, Real* target) {
    std::copy(values + from, values + kSize, target + at + from);
  };
  copy(x, eyes.X);
  copy(y, eyes.Y);
  copy(z, eyes.Z);
  copy(directionX, eyes.DirectionX);
  copy(directionY, eyes.DirectionY);
  copy(directionZ, eyes.DirectionZ);
}

}  // namespace

void SLightEyes::Place(const SRayLayout& layout, const SAnchor* const* anchors, size_t first,
                       size_t count) {
  Count = count;
  for (size_t at = 0; at < count; at += kSize) {
    const SSensorRay* const rays = layout.Rays.data() + first + at;
    const size_t size = std::min(kSize, count - at);
    // nearly all robots have one anchor for all sensors
    for (size_t i = 0; i < size; ++i) {
      if (i == 0 || rays[i].Anchor != rays[i - 1].Anchor) {
        PlaceBlock(layout.Blocks[(first + at) / kSize], *anchors[rays[i].Anchor], i, *this, at);
      }
    }
  }
  std::fill_n(Readings, GetEnd(), 0.0);
  Enclose();
}

ARGOS_VECTORIZED
void SLightEyes::Enclose() {
  Center = CVector3();
  for (size_t i = 0; i < Count; ++i) {
    Center += GetPosition(i);
  }
  Center /= static_cast<Real>(Count);
  const Real centerX = Center.GetX();
  const Real centerY = Center.GetY();
  Real lowest[kSize], highest[kSize];
  Real farthest[kSize] = {};  // m^2
  std::copy_n(Z, kSize, lowest);
  std::copy_n(Z, kSize, highest);
  for (size_t at = 0; at < Count; at += kSize) {
    ARGOS_VECTOR_LOOP
    for (size_t i = 0; i < kSize; ++i) {
      const Real dx = X[at + i] - centerX;
      const Real dy = Y[at + i] - centerY;
      const Real square = dx * dx + dy * dy;
      const Real z = Z[at + i];
      farthest[i] = farthest[i] < square ? square : farthest[i];
      lowest[i] = z < lowest[i] ? z : lowest[i];
      highest[i] = highest[i] < z ? z : highest[i];
    }
  }
  MinZ = *std::min_element(lowest, lowest + kSize);
  MaxZ = *std::max_element(highest, highest + kSize);
  Reach = std::sqrt(*std::max_element(farthest, farthest + kSize));
}

ARGOS_VECTORIZED
size_t SLightEyes::LookAt(const CVector3& light) {
  Light = light;
  const Real lightX = light.GetX();
  const Real lightY = light.GetY();
  const Real lightZ = light.GetZ();
  const size_t end = GetEnd();
  for (size_t i = 0; i < end; ++i) {
    DX[i] = lightX - X[i];
    DY[i] = lightY - Y[i];
    DZ[i] = lightZ - Z[i];
    Distance[i] = std::sqrt(DX[i] * DX[i] + DY[i] * DY[i] + DZ[i] * DZ[i]);
    const Real ahead = DX[i] * DirectionX[i] + DY[i] * DirectionY[i] + DZ[i] * DirectionZ[i];
    const bool isBehind = ahead < -kGrazing * Distance[i];
    IsClear[i] = isBehind ? 0 : 1;
  }
  size_t numClear = 0;
  for (size_t i = 0; i < Count; ++i) {
    numClear += IsClear[i];
  }
  return numClear;
}

// IntersectRay() without branches. The heights of a level line at the top or the bottom of the disc
// are not numbers, and comparisons with them are false: they clip nothing.
ARGOS_VECTORIZED
bool SLightEyes::FindClear(const SIndexedShape& disc, UInt64* clear) const {
  const Real squareRadius = disc.HalfX * disc.HalfX;
  UInt64 isClear[kCapacity];
  const size_t end = GetEnd();
  for (size_t i = 0; i < end; ++i) {
    const Real x = X[i] - disc.X;
    const Real y = Y[i] - disc.Y;
    const Real a = DX[i] * DX[i] + DY[i] * DY[i];
    const Real b = x * DX[i] + y * DY[i];
    const Real c = x * x + y * y - squareRadius;
    const Real discriminant = b * b - a * c;
    const Real root = std::sqrt(discriminant > 0.0 ? discriminant : 0.0);
    const Real entry = (-b - root) / a;
    const Real exit = (-b + root) / a;
    // > 0 if the line is beside the disc
    const Real beside = a > 0.0 ? -discriminant : c;
    const Real enter = a > 0.0 ? entry : -HUGE_VAL;
    const Real leave = a > 0.0 ? exit : HUGE_VAL;
    const Real atBottom = (disc.ZMin - Z[i]) / DZ[i];
    const Real atTop = (disc.ZMax - Z[i]) / DZ[i];
    const Real lower = atTop < atBottom ? atTop : atBottom;
    const Real upper = atBottom > atTop ? atBottom : atTop;
    const Real first = enter < lower ? lower : enter;
    const Real last = upper < leave ? upper : leave;
    const Real begin = first > 0.0 ? first : 0.0;
    const Real over = last < 1.0 ? last : 1.0;
    const Real gap = beside > 0.0 ? 1.0 : begin - over;
    isClear[i] = gap > 0.0 ? IsClear[i] : 0;
  }
  UInt64 isAnyClear = 0;
  for (size_t i = 0; i < end; ++i) {
    isAnyClear |= isClear[i];
    clear[i] = isClear[i];
  }
  return isAnyClear != 0;
}

ARGOS_VECTORIZED
void SLightEyes::AddSquares(Real intensity) {
  const size_t end = GetEnd();
  for (size_t i = 0; i < end; ++i) {
    const Real ratio = intensity / Distance[i];
    const Real square = ratio * ratio;
    Readings[i] += IsClear[i] != 0 ? square : 0.0;
  }
}

}  // namespace argos
