#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_RIGID_SCENE_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_RIGID_SCENE_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/testing/contract/physics_engines/drive_world.h>

#include <string>

namespace argos {

/** m/s^2, of every scene with gravity. */
constexpr Real kSceneGravity = 9.81;

/** XML of a dynamics3d engine. @param children  such as `<floor/>`. */
std::string RigidEngine(const std::string& attributes, const std::string& children);
/** XML of the engine with a floor and gravity. */
std::string GroundedEngine(const std::string& attributes = "", const std::string& children = "");

/** A box in a scene. */
struct SBoxXml {
  std::string Id;
  CVector3 Size; /**< m */
  CVector3 Position; /**< of the centre of its base, m */
  CVector3 Degrees = CVector3(); /**< rotations about z, then y, then x */
  Real Mass = 1.0; /**< kg; 0: immovable */

  std::string ToXml() const;
};

/**
 * XML of an add-on that applies an impulse to a body in the first substep of the first tick.
 * @param impulse N s, at the centre of mass.
 */
std::string KickXml(const std::string& id, const CVector3& impulse);

/** World with bodies and accessors to their motion. */
class CRigidScene : public CDriveWorld {
 public:
  using CDriveWorld::CDriveWorld;

  CQuaternion Orientation(const std::string& id) { return Body(id).GetOriginAnchor().Orientation; }
  /** Angle between the body's z axis and the vertical, rad. */
  Real Tilt(const std::string& id);
};

}  // namespace argos

#endif
