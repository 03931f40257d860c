#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ENGINE_POSES_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ENGINE_POSES_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace argos {

// Conversions between entities and the engine.

/** The quoted id of the body's robot or object, for messages. */
inline std::string NameOf(const CEmbodiedEntity& body) {
  return "\"" + body.GetRootEntity().GetId() + "\"";
}

inline SRigidPose PoseOf(const CEmbodiedEntity& body) {
  const SAnchor& origin = body.GetOriginAnchor();
  return {origin.Position, origin.Orientation};
}

/** The orientation without its lean; the yaw is kept. */
inline CQuaternion SetUpright(const CQuaternion& orientation) {
  const Real length = std::hypot(orientation.GetW(), orientation.GetZ());
  return CQuaternion(orientation.GetW() / length, 0.0, 0.0, orientation.GetZ() / length);
}

/** Angle between its z axis and the vertical, rad. */
inline Real ComputeLean(const CQuaternion& orientation) {
  return 2.0 * std::asin(std::min<Real>(1.0, std::hypot(orientation.GetX(), orientation.GetY())));
}

}  // namespace argos

#endif
