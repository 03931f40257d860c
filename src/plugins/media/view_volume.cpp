#include <argos3/plugins/simulator/media/view_volume.h>

#include <argos3/core/utility/math/vectorized.h>

#include <algorithm>

namespace argos {

namespace {

const CVector3 kMargins(CViewVolume::kMargin, CViewVolume::kMargin, CViewVolume::kMargin);

static_assert(sizeof(kLaneBits) == CViewVolume::kBlock * sizeof(UInt64));

// the box around the eight corners
SBoundingBox Enclose(const SFrustum& frustum) {
  SBoundingBox box = {frustum.Eye + frustum.Depth.GetMin() * frustum.Ahead, CVector3()};
  box.MaxCorner = box.MinCorner;
  for (const Real right : {frustum.SlopeRight.GetMin(), frustum.SlopeRight.GetMax()}) {
    for (const Real down : {frustum.SlopeDown.GetMin(), frustum.SlopeDown.GetMax()}) {
      const CVector3 edge = frustum.Ahead + right * frustum.Right + down * frustum.Down;
      for (const Real depth : {frustum.Depth.GetMin(), frustum.Depth.GetMax()}) {
        const CVector3 corner = frustum.Eye + depth * edge;
        for (UInt32 axis = 0; axis < 3; ++axis) {
          box.MinCorner[axis] = std::min(box.MinCorner[axis], corner[axis]);
          box.MaxCorner[axis] = std::max(box.MaxCorner[axis], corner[axis]);
        }
      }
    }
  }
  return box;
}

}  // namespace

CViewVolume::CViewVolume(const SBoundingBox& box)
    : m_box{box.MinCorner - kMargins, box.MaxCorner + kMargins} {
  for (UInt32 axis = 0; axis < 3; ++axis) {
    CVector3 outward;
    outward[axis] = 1.0;
    SetPlane(2 * axis, outward, m_box.MaxCorner[axis]);
    SetPlane(2 * axis + 1, -outward, -m_box.MinCorner[axis]);
  }
}

CViewVolume::CViewVolume(const SFrustum& frustum) : CViewVolume(Enclose(frustum)) {
  const auto set = [this, &frustum](size_t plane, CVector3 outward, Real distance) {
    outward.Normalize();
    SetPlane(plane, outward, outward.DotProduct(frustum.Eye) + distance + kMargin);
  };
  // a side is the plane through the eye on which one slope is constant
  const auto setSides = [&set, &frustum](size_t plane, const CVector3& axis,
                                         const CRange<Real>& slope) {
    set(plane, axis - slope.GetMax() * frustum.Ahead, 0.0);
    set(plane + 1, slope.GetMin() * frustum.Ahead - axis, 0.0);
  };
  setSides(0, frustum.Right, frustum.SlopeRight);
  setSides(2, frustum.Down, frustum.SlopeDown);
  set(4, frustum.Ahead, frustum.Depth.GetMax());
  set(5, -frustum.Ahead, -frustum.Depth.GetMin());
}

void CViewVolume::SetPlane(size_t plane, const CVector3& outward, Real distance) {
  m_normalX[plane] = outward.GetX();
  m_normalY[plane] = outward.GetY();
  m_normalZ[plane] = outward.GetZ();
  m_distance[plane] = distance;
}

void CViewVolume::Move(const CVector3& way) {
  m_box.MinCorner += way;
  m_box.MaxCorner += way;
  for (size_t i = 0; i < kNumPlanes; ++i) {
    m_distance[i] +=
        m_normalX[i] * way.GetX() + m_normalY[i] * way.GetY() + m_normalZ[i] * way.GetZ();
  }
}

ARGOS_VECTORIZED
UInt64 CViewVolume::FindInside(const Real* x, const Real* y, const Real* z) const {
  Real beyond[kBlock];  // m, the greatest distance beyond a plane
  ARGOS_VECTOR_LOOP
  for (size_t i = 0; i < kBlock; ++i) {
    beyond[i] = m_normalX[0] * x[i] + m_normalY[0] * y[i] + m_normalZ[0] * z[i] - m_distance[0];
  }
  for (size_t plane = 1; plane < kNumPlanes; ++plane) {
    ARGOS_VECTOR_LOOP
    for (size_t i = 0; i < kBlock; ++i) {
      const Real more = m_normalX[plane] * x[i] + m_normalY[plane] * y[i] +
                        m_normalZ[plane] * z[i] - m_distance[plane];
      beyond[i] = beyond[i] > more ? beyond[i] : more;
    }
  }
  UInt64 inside = 0;
  ARGOS_VECTOR_LOOP
  for (size_t i = 0; i < kBlock; ++i) {
    inside |= beyond[i] < 0.0 ? kLaneBits[i] : 0;
  }
  return inside;
}

}  // namespace argos
