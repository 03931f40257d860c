#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_contacts.h>

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <cmath>

namespace argos {

void CRigidContacts::Remember(const SRigidContact& contact, SMemory& memory) {
  memory = {contact.Key, contact.Place, contact.Force, contact.Friction, contact.Settled};
}

void CRigidContacts::StartSubstep() {
  m_last.Clear();
  for (const SRigidContact& contact : m_present) {
    Remember(contact, m_last.Add());
  }
  m_present.clear();
}

void CRigidContacts::KeepDozing() {
  for (const SRigidContact& contact : m_present) {
    if ((contact.First->IsMovable() ? contact.First : contact.Second)->Dozes) {
      Remember(contact, m_dozing.Add());
    }
  }
}

// From the nearest contact of the same solids that no other has inherited from.
bool CRigidContacts::Inherit(CKeyTable<SMemory>& memories, SRigidContact& contact,
                             std::vector<bool>& isTaken) {
  const std::vector<SMemory>& all = memories.Get();
  size_t best = all.size();
  Real nearest = HUGE_VAL;
  const size_t first = memories.Find(contact.Key);
  for (size_t i = first; i < all.size() && all[i].Key == contact.Key; ++i) {
    const Real distance = (all[i].Place - contact.Place).SquareLength();
    if (!isTaken[i] && distance < nearest) {
      best = i;
      nearest = distance;
    }
  }
  if (best < all.size()) {
    isTaken[best] = true;
    contact.Force = all[best].Force;
    contact.Friction = all[best].Friction;
    contact.Settled = all[best].Settled;
  }
  return first < all.size();
}

void CRigidContacts::InheritForces() {
  m_isTaken.assign(m_last.Get().size(), false);
  m_isDozingTaken.assign(m_dozing.Get().size(), false);
  for (SRigidContact& contact : m_present) {
    if (!Inherit(m_last, contact, m_isTaken)) {
      Inherit(m_dozing, contact, m_isDozingTaken);
    }
  }
}

}  // namespace argos
