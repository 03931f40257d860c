#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_BODY_HANDLE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_BODY_HANDLE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>

namespace argos {

class CEmbodiedEntity;

/** The place of a body in dense arrays; see CSlotGenerations. */
struct SSlotHandle {
  static constexpr UInt32 kNowhere = std::numeric_limits<UInt32>::max();

  UInt32 Slot = kNowhere;
  UInt32 Generation = 0;  // which of the bodies that had the slot

  friend bool operator==(const SSlotHandle& a, const SSlotHandle& b) {
    return a.Slot == b.Slot && a.Generation == b.Generation;
  }
};

/**
 * The place of a body in the arrays of its kind; the engine's world writes it whenever it changes.
 * A copy is stale from then on, which ARGOS_ASSERT notices.
 *
 * @tparam KIND  enumeration of the engine; each kind of body has its own arrays.
 */
template <typename KIND>
struct SBodyHandle : SSlotHandle {
  KIND Kind = KIND();

  SBodyHandle() = default;
  SBodyHandle(KIND kind, UInt32 slot, UInt32 generation)
      : SSlotHandle{slot, generation}, Kind(kind) {}

  friend bool operator==(const SBodyHandle& a, const SBodyHandle& b) {
    return a.Kind == b.Kind && a.Slot == b.Slot && a.Generation == b.Generation;
  }
};

/** The engine's references to a body: Model and Body are null for a wall of the region. */
template <typename MODEL, typename KIND>
struct SBodyOwner {
  MODEL* Model = nullptr;
  // of the model; here, too, so that a tick does not read the model for it
  CEmbodiedEntity* Body = nullptr;
  SBodyHandle<KIND>* Handle = nullptr;  // receives the place of the body
};

}  // namespace argos

#endif
