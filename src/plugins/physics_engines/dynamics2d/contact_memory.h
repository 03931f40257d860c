#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CONTACT_MEMORY_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CONTACT_MEMORY_H

#include <argos3/core/utility/spatial/counting_sort.h>

#include <algorithm>
#include <vector>

namespace argos {

/** The force of a contact, N: along the normal, and along the tangent, 90 degrees from it. */
struct SContactForce {
  float Normal = 0.0F;
  float Tangent = 0.0F;
  /**
   * The normal force from which a solver starts: the last one, unless it is far greater than that
   * before. The force of an impact acts in one substep only.
   */
  float Steady = 0.0F;

  static constexpr float kMaxGrowth = 1.5F;  // of a steady force in a substep

  /** Sets the forces of a substep. */
  void Take(float normal, float tangent) {
    Steady = std::min(kMaxGrowth * Normal, normal);
    Normal = normal;
    Tangent = tangent;
  }
};

/**
 * The forces of contacts at the end of the last tick, from which a solver starts in the next one.
 *
 * A contact is named by the slot of a robot, and by a partner: the slot of another robot, or the
 * number of an obstacle.
 */
class CContactMemory {
 public:
  struct SContact {
    UInt32 Slot, Partner;
    SContactForce Force;
  };

  void Reserve(size_t slots, size_t contacts);
  /** Forgets the contacts of the robot that was in a slot, before another one gets it. */
  void Forget(UInt32 slot);
  /** Forgets everything. */
  void Clear() { m_contacts.clear(); }

  /** Collects contacts for the next tick: one thread. */
  void StartCollecting() { m_collected.clear(); }
  void Collect(const SContact& contact) { m_collected.push_back({contact, 0}); }
  /** Replaces the contacts. @param slots  number of slots. */
  void FinishCollecting(size_t slots);

  /** Safe on several threads. @return no force if there was no such contact. */
  SContactForce Find(UInt32 slot, UInt32 partner) const;

 private:
  struct SEntry {
    SContact Contact;
    UInt32 PartnerSerial;  // of the robot in the slot of the partner
  };
  UInt32 SerialOf(UInt32 slot) const { return slot < m_serials.size() ? m_serials[slot] : 0; }

  std::vector<SEntry> m_collected;
  std::vector<SEntry> m_contacts;  // by slot
  CCountingSort m_sort;  // of the contacts by slot
  std::vector<UInt32> m_serials;  // by slot: changes when another robot gets the slot
  std::vector<UInt32> m_serialsThen;  // by slot, when the contacts were collected
};

}  // namespace argos

#endif
