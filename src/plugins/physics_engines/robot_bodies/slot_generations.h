#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_SLOT_GENERATIONS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_SLOT_GENERATIONS_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/body_handle.h>

#include <cstddef>
#include <vector>

namespace argos {

/**
 * Numbers the bodies that a slot of a dense array has had, so that ARGOS_ASSERT notices a handle
 * whose body has left: the slot may have another body by then.
 *
 * In a dense array the last body gets the slot of a removed one. A handle has a slot and the
 * generation of its body there; it is written when one of the two changes, and is stale from then
 * on wherever it was copied. Handles of all builds have the generation, so that
 * ARGOS_CHECK_INVARIANTS changes no type of an installed header.
 */
class CSlotGenerations {
 public:
  void Reserve(size_t slots) { m_generations.reserve(slots); }
  void Clear() { m_size = 0; }

  /** A body is added behind the last one. @return its generation. */
  UInt32 Add() {
    if (m_size == m_generations.size()) {
      m_generations.push_back(0);
    }
    return ++m_generations[m_size++];
  }
  /**
   * A body is removed, and the last one gets its slot.
   * @return the new generation of that one; of no use if it was itself removed.
   */
  UInt32 Remove(UInt32 slot) {
    ARGOS_ASSERT(slot < m_size, "there is no body in slot " << slot << " of " << m_size);
    --m_size;
    return ++m_generations[slot];
  }
  /** The generation of a slot that is in use. */
  UInt32 Get(UInt32 slot) const {
    ARGOS_ASSERT(slot < m_size, "there is no body in slot " << slot << " of " << m_size);
    return m_generations[slot];
  }
  /** @return true if a slot has the body to which it gave that generation. */
  bool IsCurrent(UInt32 slot, UInt32 generation) const {
    return slot < m_size && m_generations[slot] == generation;
  }
  /** Throws if ARGOS_ASSERT does and the handle is stale. */
  void Check([[maybe_unused]] const SSlotHandle& handle) const {
    ARGOS_ASSERT(IsCurrent(handle.Slot, handle.Generation), "stale handle of a body: generation "
                                                                << handle.Generation << " of slot "
                                                                << handle.Slot << ", among "
                                                                << m_size << " bodies");
  }

 private:
  // never shrinks: a slot that is used again gets its next generation
  std::vector<UInt32> m_generations;
  size_t m_size = 0;  // slots in use
};

}  // namespace argos

#endif
