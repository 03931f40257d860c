#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_contacts.h>

#include <bit>
#include <cmath>
#include <utility>

namespace argos {

namespace {

// places of the hash table for each contact, at least
constexpr size_t kRoom = 2;

}  // namespace

void CRigidContacts::StartSubstep() {
  std::swap(m_present, m_last);
  m_present.clear();
}

// Contacts of the same key follow each other.
void CRigidContacts::FillTable() {
  const size_t size = std::bit_ceil(kRoom * m_last.size() + 1);
  m_table.assign(size, 0);
  for (size_t i = 0; i < m_last.size(); ++i) {
    if (i > 0 && m_last[i].Key == m_last[i - 1].Key) {
      continue;
    }
    size_t place = m_last[i].Key & (size - 1);
    while (m_table[place] != 0) {
      place = (place + 1) & (size - 1);
    }
    m_table[place] = static_cast<UInt32>(i + 1);
  }
}

// @return the first contact of a key, or their number if there is none.
size_t CRigidContacts::FindLast(UInt64 key) const {
  for (size_t place = key & (m_table.size() - 1); m_table[place] != 0;
       place = (place + 1) & (m_table.size() - 1)) {
    if (m_last[m_table[place] - 1].Key == key) {
      return m_table[place] - 1;
    }
  }
  return m_last.size();
}

// Each contact inherits from the nearest one of the same solids that no other has inherited from.
void CRigidContacts::InheritForces() {
  FillTable();
  m_isTaken.assign(m_last.size(), false);
  for (SRigidContact& contact : m_present) {
    size_t best = m_last.size();
    Real nearest = HUGE_VAL;
    for (size_t i = FindLast(contact.Key); i < m_last.size() && m_last[i].Key == contact.Key; ++i) {
      const Real distance = (m_last[i].Place - contact.Place).SquareLength();
      if (!m_isTaken[i] && distance < nearest) {
        best = i;
        nearest = distance;
      }
    }
    if (best < m_last.size()) {
      m_isTaken[best] = true;
      contact.Force = m_last[best].Force;
      contact.Friction = m_last[best].Friction;
    }
  }
}

}  // namespace argos
