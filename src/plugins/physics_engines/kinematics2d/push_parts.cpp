#include <argos3/plugins/simulator/physics_engines/kinematics2d/push_parts.h>

#include <algorithm>

namespace argos {

namespace {

// of sweeps over everything
constexpr UInt32 kMaxRoundsOfParts = 40;
// share of the tolerance to which a part is solved
constexpr Real kPartTolerance = 0.5;

}  // namespace

UInt32 CPushParts::Solve(std::span<SBody> bodies, std::span<SContact> contacts, Real tolerance,
                         UInt32 mostSweeps) {
  CContactIsland<Real> all(bodies, contacts);
  Real sweeps = 0.0;
  for (UInt32 round = 0; round < kMaxRoundsOfParts && sweeps < mostSweeps; ++round) {
    sweeps += all.Solve(tolerance, 1);
    if (all.GetChange() <= tolerance) {
      return static_cast<UInt32>(sweeps);
    }
    FindParts(bodies, contacts);
    const auto most = static_cast<UInt32>(std::max(1.0, mostSweeps - sweeps));
    for (size_t body = 0, contact = 0; body < m_bodyOrder.size();) {
      const UInt32 part = m_bodyOrder[body].Root;
      const auto ofBodies = TakeTree(m_bodyOrder, part, body);
      const auto ofContacts = TakeTree(m_contactOrder, part, contact);
      if (!ofContacts.empty()) {
        const UInt32 made =
            SolvePart(bodies, contacts, ofBodies, ofContacts, kPartTolerance * tolerance, most);
        sweeps += made * static_cast<Real>(ofContacts.size()) / static_cast<Real>(contacts.size());
      }
    }
  }
  return static_cast<UInt32>(sweeps);
}

// A part is what contacts with a force connect; its contacts are all between its bodies, and with
// what does not move.
void CPushParts::FindParts(std::span<const SBody> bodies, std::span<const SContact> contacts) {
  const auto fixed = static_cast<UInt32>(bodies.size() - 1);
  ResetForest(m_parents, bodies.size());
  for (const SContact& contact : contacts) {
    if (contact.A != fixed && contact.Impulse.Now[kAxisNormal] > 0.0) {
      Connect(m_parents, contact.A, contact.B);
    }
  }
  m_bodyOrder.clear();
  m_contactOrder.clear();
  for (UInt32 i = 0; i < fixed; ++i) {
    m_bodyOrder.push_back({FindRootOf(m_parents, i), i});
  }
  for (UInt32 i = 0; i < contacts.size(); ++i) {
    const UInt32 part = FindRootOf(m_parents, contacts[i].B);
    if (contacts[i].A == fixed || FindRootOf(m_parents, contacts[i].A) == part) {
      m_contactOrder.push_back({part, i});
    }
  }
  std::sort(m_bodyOrder.begin(), m_bodyOrder.end());
  std::sort(m_contactOrder.begin(), m_contactOrder.end());
}

// @return the number of sweeps.
UInt32 CPushParts::SolvePart(std::span<SBody> bodies, std::span<SContact> contacts,
                             std::span<const SMember> ofBodies, std::span<const SMember> ofContacts,
                             Real tolerance, UInt32 mostSweeps) {
  const auto fixed = static_cast<UInt32>(bodies.size() - 1);
  m_places.resize(bodies.size());
  m_bodies.clear();
  for (const SMember& member : ofBodies) {
    m_places[member.Number] = static_cast<UInt32>(m_bodies.size());
    m_bodies.push_back(bodies[member.Number]);
  }
  m_places[fixed] = static_cast<UInt32>(m_bodies.size());
  m_bodies.push_back(bodies[fixed]);
  m_contacts.clear();
  for (const SMember& member : ofContacts) {
    SContact& contact = m_contacts.emplace_back(contacts[member.Number]);
    contact.A = m_places[contact.A];
    contact.B = m_places[contact.B];
  }
  const UInt32 sweeps = CContactIsland<Real>(m_bodies, m_contacts).Solve(tolerance, mostSweeps);
  for (size_t i = 0; i < ofBodies.size(); ++i) {
    bodies[ofBodies[i].Number].Velocity = m_bodies[i].Velocity;
    bodies[ofBodies[i].Number].Impulse = m_bodies[i].Impulse;
  }
  for (size_t i = 0; i < ofContacts.size(); ++i) {
    contacts[ofContacts[i].Number].Impulse = m_contacts[i].Impulse;
  }
  return sweeps;
}

}  // namespace argos
