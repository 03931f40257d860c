#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_ghosts.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/overlap_solver.h>

namespace argos {

void CGhostFilter::SetPartner(UInt32 body, UInt32 partner) {
  At(body).Partner = partner;
}

void CGhostFilter::SetDriven(UInt32 body, bool isDriven) {
  At(body).IsDriven = isDriven;
}

CGhostFilter::SBody& CGhostFilter::At(UInt32 body) {
  if (body >= m_bodies.size()) {
    m_bodies.resize(body + 1);
  }
  return m_bodies[body];
}

bool CGhostFilter::IsPartner(UInt32 ghost, UInt32 body) const {
  const UInt32 partner = m_bodies[ghost].Partner;
  return partner == kThings ? !m_bodies[body].IsDriven : partner == body;
}

bool CGhostFilter::ShouldCollide(b2Fixture* a, b2Fixture* b) {
  const UInt32 first = GetBodyNumber(*a->GetBody());
  const UInt32 second = GetBodyNumber(*b->GetBody());
  // the bodies that CPlanarWorld::Reserve() makes for a moment have no number of their own
  if (first >= m_bodies.size() || second >= m_bodies.size()) {
    return true;
  }
  if (m_bodies[first].Partner != kNoGhost) {
    return IsPartner(first, second);
  }
  return m_bodies[second].Partner == kNoGhost || IsPartner(second, first);
}

}  // namespace argos
