#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_HANDLE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_HANDLE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>

namespace argos {

/** What kind of body; each kind has its own dense array. */
enum class EPlanarKind : UInt8 { Immovable, Passive, Driven };

/** How fast a body moves, world frame. */
struct SPlanarVelocity {
  Real X = 0.0;  // m/s
  Real Y = 0.0;  // m/s
  Real W = 0.0;  // rad/s, counter-clockwise
};

/** Where a body is kept; written by the world whenever that changes. */
struct SPlanarHandle {
  static constexpr UInt32 kNowhere = std::numeric_limits<UInt32>::max();

  EPlanarKind Kind = EPlanarKind::Immovable;
  UInt32 Slot = kNowhere;

  bool IsInWorld() const { return Slot != kNowhere; }
};

}  // namespace argos

#endif
