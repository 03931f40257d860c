#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINT_MASS_HANDLE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINT_MASS_HANDLE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>

namespace argos {

/**
 * The place of a body in the arrays of its kind; the engine writes it whenever it changes. A copy
 * is stale from then on, which ARGOS_ASSERT notices.
 */
struct SPointMassHandle {
  static constexpr UInt32 kNowhere = std::numeric_limits<UInt32>::max();

  UInt32 Slot = kNowhere;
  UInt32 Generation = 0;  // which of the bodies that had the slot
};

}  // namespace argos

#endif
