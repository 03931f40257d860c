#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_HANDLE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_HANDLE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>

namespace argos {

/** What kind of body; each kind has its own dense array. */
enum class EPlanarKind : UInt8 { Immovable, Passive, Driven };

/** Where a body is kept; written by the world whenever that changes. */
struct SPlanarHandle {
  static constexpr UInt32 kNowhere = std::numeric_limits<UInt32>::max();

  EPlanarKind Kind = EPlanarKind::Immovable;
  UInt32 Slot = kNowhere;

  bool IsInWorld() const { return Slot != kNowhere; }
};

}  // namespace argos

#endif
