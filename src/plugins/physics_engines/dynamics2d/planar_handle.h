#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_HANDLE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_HANDLE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>

namespace argos {

/** What kind of body; each kind has its own dense array. */
enum class EPlanarKind : UInt8 { Immovable, Passive, Driven };

/** The velocity of a body, world frame. */
struct SPlanarVelocity {
  Real X = 0.0;  // m/s
  Real Y = 0.0;  // m/s
  Real W = 0.0;  // rad/s, counter-clockwise
};

/**
 * The place of a body in the arrays; the world writes it whenever it changes. A copy is stale from
 * then on, which ARGOS_ASSERT notices.
 */
struct SPlanarHandle {
  static constexpr UInt32 kNowhere = std::numeric_limits<UInt32>::max();

  EPlanarKind Kind = EPlanarKind::Immovable;
  UInt32 Slot = kNowhere;
  UInt32 Generation = 0;  // which of the bodies that had the slot

  bool IsInWorld() const { return Slot != kNowhere; }
  friend bool operator==(const SPlanarHandle& a, const SPlanarHandle& b) {
    return a.Kind == b.Kind && a.Slot == b.Slot && a.Generation == b.Generation;
  }
};

}  // namespace argos

#endif
