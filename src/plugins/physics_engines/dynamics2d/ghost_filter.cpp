#include <argos3/plugins/simulator/physics_engines/dynamics2d/ghost_filter.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/overlap_solver.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_store.h>

namespace argos {

void CGhostFilter::SetPartner(UInt32 body, UInt32 partner) {
  if (body >= m_partners.size()) {
    m_partners.resize(body + 1, kNoGhost);
  }
  m_partners[body] = partner;
}

bool CGhostFilter::IsPartner(UInt32 ghost, UInt32 body) const {
  const UInt32 partner = GetPartner(ghost);
  return partner == kPassive ? !m_store.IsDriven(body) : partner == body;
}

bool CGhostFilter::ShouldCollide(b2Fixture* a, b2Fixture* b) {
  const UInt32 first = GetBodyNumber(*a->GetBody());
  const UInt32 second = GetBodyNumber(*b->GetBody());
  if (GetPartner(first) != kNoGhost) {
    return IsPartner(first, second);
  }
  return GetPartner(second) == kNoGhost || IsPartner(second, first);
}

}  // namespace argos
