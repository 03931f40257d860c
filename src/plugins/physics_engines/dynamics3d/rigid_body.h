#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_BODY_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_BODY_H

#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

#include <ode/ode.h>

#include <array>
#include <vector>

namespace argos {

class CDynamics3DModel;
class CQuadRotorEntity;
struct SBodyDescription;
struct SRigidSettings;

/** Where a body is: the origin of its description, world frame. */
struct SRigidPose {
  CVector3 Position;  // m
  CQuaternion Orientation;
};

/** How a body moves; what it needs to go on in another engine, besides its pose. */
struct SRigidMotion {
  CVector3 Velocity;  // of the centre of mass, m/s
  CVector3 AngularVelocity;  // rad/s, world frame
  std::array<Real, 2> WheelSpins{};  // rad/s on the axle, positive ahead
  std::array<Real, 4> FlightErrors{};  // of the last substep: x, y, z (m) and yaw (rad)
};

/** What a geom is, as ODE's category bits. */
namespace geom_kind {
constexpr unsigned long kFixed = 1;
constexpr unsigned long kSolid = 2;
constexpr unsigned long kWheel = 4;
constexpr unsigned long kCaster = 8;
}  // namespace geom_kind

/** What a rigid body is made of; see CRigidWorld::Add(). */
struct SRigidSource {
  CDynamics3DModel* Owner = nullptr;  // not owned
  const SBodyDescription* Description = nullptr;  // outlives the body
  bool Movable = true;
  const Real* Wheels = nullptr;  // speeds of the left and right rim, m/s; null without a drive
  const CQuadRotorEntity* Quadrotor = nullptr;  // null without propellers
};

/** A body in ODE: one rigid part, or a chassis with two wheels on hinges; or fixed geoms only. */
struct SRigidBody {
  SRigidSource Source;
  dBodyID Body = nullptr;  // null: fixed
  std::array<dBodyID, 2> Wheels{};  // left, right; null without a drive
  std::array<dJointID, 2> Axles{};
  std::vector<dGeomID> Geoms;

  CVector3 Low;  // m, world frame: bounds of all geoms
  CVector3 High;

  CVector3 CentreOfMass;  // of Body, in the frame of the origin, m
  Real WheelRadius = 0.0;  // m
  Real Narrowest = 0.0;  // m, of the narrowest solid
  Real Friction = 1.0;
  // how a robot's wheels give way, for the present substep and gravity: as ODE's constraints do;
  // both 0 without weight, which gives them no hold
  Real WheelErp = 0.0;
  Real WheelCfm = 0.0;
  std::array<Real, 4> FlightErrors{};
  CVector3 TiltGains;  // N m/rad, N m s/rad, N m: of what keeps a flying body upright

  UInt32 Owned = 0;  // its number among all bodies of the world
  UInt32 Number = 0;  // in the world's list of movable or of fixed bodies
  bool Asleep = false;
  Real QuietTime = 0.0;  // s: for how long it has hardly moved

  bool IsMovable() const { return Body != nullptr; }
  bool HasWheels() const { return Wheels[0] != nullptr; }
};

/** Calls visit(dBodyID) for every part of a movable body. */
template <typename VISIT>
void ForEachPart(const SRigidBody& body, VISIT&& visit) {
  visit(body.Body);
  if (body.HasWheels()) {
    visit(body.Wheels[0]);
    visit(body.Wheels[1]);
  }
}

/** Both for all of its parts; awake, it has been quiet for no time. */
void WakeRigidBody(SRigidBody& body);
void LayToSleep(SRigidBody& body);

inline CVector3 FromODE(const dReal* vector) {
  return CVector3(vector[0], vector[1], vector[2]);
}

/** Of a unit quaternion as ODE keeps it: (w, x, y, z). */
inline CQuaternion QuaternionFromODE(const dReal* quaternion) {
  return CQuaternion(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
}

inline CVector3 Rotated(CVector3 vector, const CQuaternion& rotation) {
  return vector.Rotate(rotation);
}

inline CVector3 Cross(CVector3 a, const CVector3& b) {
  return a.CrossProduct(b);
}

}  // namespace argos

#endif
