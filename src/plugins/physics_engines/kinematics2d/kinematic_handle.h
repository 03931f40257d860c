#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATIC_HANDLE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATIC_HANDLE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/body_handle.h>

namespace argos {

class CKinematics2DModel;

/** What kind of body; each kind has its own dense arrays. */
enum class EKinematicKind : UInt8 {
  Immovable, /**< never moves by itself */
  Solid, /**< movable, of any shape, without a drive, or with one but not round */
  Disc /**< a robot that is one disc around its origin */
};

using SKinematicHandle = SBodyHandle<EKinematicKind>;
using SKinematicOwner = SBodyOwner<CKinematics2DModel, EKinematicKind>;

}  // namespace argos

#endif
