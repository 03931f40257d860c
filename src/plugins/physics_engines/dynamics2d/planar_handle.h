#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_HANDLE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_HANDLE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/body_handle.h>

namespace argos {

class CDynamics2DBody;

/** What kind of body; each kind has its own dense array. */
enum class EPlanarKind : UInt8 { Immovable, Passive, Driven };

/** The velocity of a body, world frame. */
struct SPlanarVelocity {
  Real X = 0.0;  // m/s
  Real Y = 0.0;  // m/s
  Real W = 0.0;  // rad/s, counter-clockwise
};

using SPlanarHandle = SBodyHandle<EPlanarKind>;
using SPlanarOwner = SBodyOwner<CDynamics2DBody, EPlanarKind>;

}  // namespace argos

#endif
