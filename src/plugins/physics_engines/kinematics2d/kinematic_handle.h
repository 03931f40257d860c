#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATIC_HANDLE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATIC_HANDLE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>

namespace argos {

class CEmbodiedEntity;
class CKinematics2DModel;

/** What kind of body; each kind has its own dense arrays. */
enum class EKinematicKind : UInt8 {
  Immovable, /**< never moves by itself */
  Solid, /**< movable, of any shape, without a drive, or with one but not round */
  Disc /**< a robot that is one disc around its origin */
};

/**
 * The place of a body in the arrays; the world writes it whenever it changes. A copy is stale from
 * then on, which ARGOS_ASSERT notices.
 */
struct SKinematicHandle {
  static constexpr UInt32 kNowhere = std::numeric_limits<UInt32>::max();

  EKinematicKind Kind = EKinematicKind::Immovable;
  UInt32 Slot = kNowhere;
  UInt32 Generation = 0;  // which of the bodies that had the slot
};

/** The engine's references to a body. */
struct SKinematicOwner {
  CKinematics2DModel* Model = nullptr;
  SKinematicHandle* Handle = nullptr;
  // of the model; here, too, so that a tick does not read the model for it
  CEmbodiedEntity* Body = nullptr;
};

}  // namespace argos

#endif
