#include <argos3/plugins/robots/generic/simulator/light_eyes.h>

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

void SLightEyes::Enclose() {
  Center = CVector3();
  MinZ = HUGE_VAL;
  MaxZ = -HUGE_VAL;
  for (size_t i = 0; i < Count; ++i) {
    Center += GetPosition(i);
    MinZ = std::min(MinZ, Z[i]);
    MaxZ = std::max(MaxZ, Z[i]);
  }
  Center /= static_cast<Real>(Count);
  Real squareReach = 0.0;
  for (size_t i = 0; i < Count; ++i) {
    const Real dx = X[i] - Center.GetX();
    const Real dy = Y[i] - Center.GetY();
    squareReach = std::max(squareReach, dx * dx + dy * dy);
  }
  Reach = std::sqrt(squareReach);
}

ARGOS_VECTORIZED
size_t SLightEyes::LookAt(const CVector3& light) {
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
