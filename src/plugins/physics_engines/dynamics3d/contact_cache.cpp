#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_cache.h>

#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_spread.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// m; solids that have moved against each other by less keep their contacts: they touch within
// their skin, which is five times as thick
constexpr Real kStill = 0.2 * kSkin;

bool IsNear(const CVector3& a, const CVector3& b, Real most) {
  return std::abs(a.GetX() - b.GetX()) <= most && std::abs(a.GetY() - b.GetY()) <= most &&
         std::abs(a.GetZ() - b.GetZ()) <= most;
}

bool IsFixed(dGeomID solid) {
  return dGeomGetBody(solid) == nullptr;
}

// half the diagonal of the solid's bounds, m
Real ComputeReach(dGeomID solid) {
  dReal bounds[6];
  dGeomGetAABB(solid, bounds);
  return 0.5 *
         CVector3(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]).Length();
}

}  // namespace

CVector3 CContactCache::SFrame::ToWorld(const CVector3& v) const {
  return Axes[0] * v.GetX() + Axes[1] * v.GetY() + Axes[2] * v.GetZ();
}

CVector3 CContactCache::SFrame::ToOwn(const CVector3& v) const {
  return CVector3(Axes[0].DotProduct(v), Axes[1].DotProduct(v), Axes[2].DotProduct(v));
}

void CContactCache::StartSubstep() {
  m_last.Swap(m_present);
  m_present.clear();
  m_next = 0;
}

void CContactCache::KeepDozing() {
  for (const SPair& pair : m_present) {
    if (pair.Body->Dozes) {
      m_dozing.Add() = pair;
    }
  }
}

void CContactCache::Clear() {
  m_present.clear();
  m_dozing.Clear();
}

// A plane is its own frame.
CContactCache::SFrame CContactCache::FrameOf(dGeomID solid) {
  SFrame frame;
  if (dGeomGetClass(solid) == dPlaneClass) {
    frame.Axes = {CVector3::X, CVector3::Y, CVector3::Z};
    return frame;
  }
  const dReal* const rotation = dGeomGetRotation(solid);
  frame.Place = FromODE(dGeomGetPosition(solid));
  for (UInt32 i = 0; i < 3; ++i) {
    frame.Axes[i].Set(rotation[i], rotation[4 + i], rotation[8 + i]);
  }
  return frame;
}

const CContactCache::SPair* CContactCache::FindLast(UInt64 key) {
  const std::vector<SPair>& last = m_last.Get();
  if (m_next >= last.size() || last[m_next].Key != key) {
    m_next = m_last.Find(key);
  }
  if (m_next < last.size()) {
    return &last[m_next++];
  }
  const size_t dozing = m_dozing.Find(key);
  return dozing < m_dozing.Get().size() ? &m_dozing.Get()[dozing] : nullptr;
}

// Adds the pair to the present ones.
void CContactCache::Describe(dGeomID first, dGeomID second) {
  m_first = FrameOf(first);
  m_second = FrameOf(second);
  m_isOfSecond = IsFixed(second);
  m_reach = std::min(dGeomGetClass(first) == dPlaneClass ? HUGE_VAL : ComputeReach(first),
                     dGeomGetClass(second) == dPlaneClass ? HUGE_VAL : ComputeReach(second));
  SPair& pair = m_present.back();
  pair.Place = m_first.ToOwn(m_second.Place - m_first.Place);
  for (size_t i = 0; i < 3; ++i) {
    pair.Axes[i] = m_first.ToOwn(m_second.Axes[i]);
  }
}

bool CContactCache::IsStill(const SPair& last) const {
  const SPair& now = m_present.back();
  const Real turn = kStill / m_reach;
  return IsNear(last.Place, now.Place, kStill) && IsNear(last.Axes[0], now.Axes[0], turn) &&
         IsNear(last.Axes[1], now.Axes[1], turn) && IsNear(last.Axes[2], now.Axes[2], turn);
}

int CContactCache::Find(UInt64 key, const SRigidBody& body, dGeomID first, dGeomID second,
                        dContact* contacts) {
  SPair& added = m_present.emplace_back();
  added.Key = key;
  added.Body = &body;
  Describe(first, second);
  const SPair* const last = FindLast(key);
  if (last == nullptr || !IsStill(*last)) {
    return -1;
  }
  // the pose at which the contacts were found
  m_present.back() = *last;
  for (int i = 0; i < last->Count; ++i) {
    const SPoint& point = last->Points[i];
    const CVector3 own = m_first.Place + m_first.ToWorld(point.OfFirst);
    const CVector3 other = m_second.Place + m_second.ToWorld(point.OfSecond);
    const CVector3 normal = (m_isOfSecond ? m_second : m_first).ToWorld(point.Normal);
    SetContact(contacts[i].geom, (own + other) * 0.5, normal,
               point.Depth - normal.DotProduct(own - other), first, second);
  }
  return last->Count;
}

void CContactCache::Store(const dContact* contacts, int count) {
  SPair& pair = m_present.back();
  pair.Count = count;
  for (int i = 0; i < count; ++i) {
    const dContactGeom& contact = contacts[i].geom;
    const CVector3 place = FromODE(contact.pos);
    const CVector3 normal = FromODE(contact.normal);
    pair.Points[i] = {m_first.ToOwn(place - m_first.Place), m_second.ToOwn(place - m_second.Place),
                      (m_isOfSecond ? m_second : m_first).ToOwn(normal), contact.depth};
  }
}

}  // namespace argos
