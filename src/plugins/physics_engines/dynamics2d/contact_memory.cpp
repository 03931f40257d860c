#include <argos3/plugins/simulator/physics_engines/dynamics2d/contact_memory.h>

namespace argos {

void CContactMemory::Reserve(size_t slots, size_t contacts) {
  m_collected.reserve(contacts);
  m_contacts.reserve(contacts);
  m_sort.Reserve(contacts, slots);
  m_serials.reserve(slots);
  m_serialsThen.reserve(slots);
}

void CContactMemory::Forget(UInt32 slot) {
  if (slot < m_serials.size()) {
    ++m_serials[slot];
  }
}

void CContactMemory::FinishCollecting(size_t slots) {
  m_serials.resize(slots, 0);
  m_serialsThen = m_serials;
  m_sort.Start(m_collected.size(), slots);
  for (size_t i = 0; i < m_collected.size(); ++i) {
    m_sort.SetKey(i, m_collected[i].Contact.Slot);
  }
  m_contacts.resize(m_sort.Finish());
  for (size_t i = 0; i < m_collected.size(); ++i) {
    SEntry& entry = m_contacts[m_sort.GetPlace(i)];
    entry = m_collected[i];
    entry.PartnerSerial = SerialOf(entry.Contact.Partner);
  }
}

SContactForce CContactMemory::Find(UInt32 slot, UInt32 partner) const {
  if (slot < m_sort.GetNumKeys() && !m_contacts.empty() && m_serials[slot] == m_serialsThen[slot]) {
    for (UInt32 i = m_sort.Begin(slot); i < m_sort.End(slot); ++i) {
      if (m_contacts[i].Contact.Partner == partner &&
          m_contacts[i].PartnerSerial == SerialOf(partner)) {
        return m_contacts[i].Contact.Force;
      }
    }
  }
  return SContactForce();
}

}  // namespace argos
