#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_BODY_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_BODY_H

#include <argos3/core/simulator/physics_engine/drive_source.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>

#include <ode/ode.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace argos {

class CDynamics3DModel;
class CGripperEquippedEntity;
class CJointEquippedEntity;
class CQuadRotorEntity;
class CTurretEntity;
struct SBodyDescription;
struct SBodyPose;
struct SHullArrays;
struct SRigidSettings;

inline CVector3 FromODE(const dReal* vector) {
  return CVector3(vector[0], vector[1], vector[2]);
}

/** The pose of a body: of the origin of its description, world frame. */
struct SRigidPose {
  CVector3 Position;  // m
  CQuaternion Orientation;
};

/** The motion of a link besides the first one. */
struct SLinkMotion {
  CVector3 Velocity;  // of its centre of mass, m/s
  CVector3 AngularVelocity;  // rad/s, world frame
};

/** The motion of a body: its state besides the pose, to continue in another engine. */
struct SRigidMotion {
  CVector3 Velocity;  // of the centre of mass, m/s
  CVector3 AngularVelocity;  // rad/s, world frame
  std::array<Real, 2> WheelSpins{};  // rad/s about the axle, positive forward
  std::vector<SLinkMotion> Links;  // from link 1 on; empty: they move rigidly with the body
};

/**
 * The contact geometry of a wheel or caster: a sphere that touches only bodies below the robot. It
 * is not an ODE geom, because contacts with a floor, the most frequent ones, need none.
 */
struct SRoller {
  CVector3 Offset;  // of its centre from the centre of mass, frame of the body, m
  Real Radius = 0.0;  // m; of a wheel, with its travel
};

/** The source of a rigid body; see CRigidWorld::Add(). */
struct SRigidSource {
  CDynamics3DModel* Owner = nullptr;  // not owned
  const SBodyDescription* Description = nullptr;  // outlives the body
  // the same, shared because spare parts (CPartsPool) may outlive the body; null: never free
  std::shared_ptr<const SBodyDescription> Shared;
  bool Movable = true;
  CDriveSource Drive;
  const CQuadRotorEntity* Quadrotor = nullptr;  // null without propellers
  CJointEquippedEntity* Joints = nullptr;  // null without an articulation
  const SBodyPose* LinkPoses = nullptr;  // of the entity, by link; null without an articulation
};

/** A link of an articulated body besides the first one. */
struct SRigidLink {
  dBodyID Part = nullptr;
  CVector3 CentreOfMass;  // in the frame of the origin at the start, m
  dJointID Joint = nullptr;  // to a link with a lower number
};

/** What a body consists of in ODE, besides links and turrets. */
struct SRigidParts {
  dBodyID Body = nullptr;  // null: fixed, or a free robot
  std::array<dBodyID, 2> Wheels{};  // left, right; null without wheels
  std::array<dJointID, 2> Axles{};
  // of a planar drive: motors that move and rotate the body over the ground; else null
  dJointID PlanarMotor = nullptr;
  dJointID YawMotor = nullptr;
  std::vector<dGeomID> Solids;  // by number of SBodyDescription::Shapes
  std::vector<std::shared_ptr<SHullArrays>> Hulls;  // what convex solids refer to
};

/** The state of a free robot: upright on the floor. */
struct SRollState {
  SPlanarPose Pose;
  Real Height = 0.0;  // m; z of its origin
  SDriveCommand Motion;  // of its origin
};

/** A solid of a body that may stand upright: what it covers of the floor, and its height. */
struct SUprightPart {
  SFootprint Footprint;  // frame of the body
  Real Low = 0.0;  // m, above the origin
  Real High = 0.0;
};

/**
 * A body in ODE: one rigid part, perhaps with a planar drive; or a chassis with two wheels on
 * hinges; or links on joints; or fixed geoms only. A free robot has no parts in ODE.
 */
struct SRigidBody : SRigidParts {
  SRigidSource Source;
  bool IsFree = false;  // it follows the arc of its drive (CFreeRobots), and has no parts
  SRollState Roll;  // while it is free
  SRigidPose Fixed;  // of a fixed body
  Real BoundingRadius = 0.0;  // m, around its origin, of a robot with a drive
  bool IsGripped = false;  // at the start of the tick: it holds a body or is held
  CVector3 ClaimLow;  // m, world frame; see CFreeRobots::Claim()
  CVector3 ClaimHigh;
  bool IsUpright = false;  // CUprightCrowd moves it in this tick, and its parts in ODE are idle
  Real TippingTime = 0.0;  // s: for so long it is not upright
  std::vector<SUprightPart> UprightParts;  // once it may have been upright
  // where the floor supported it in the last substep, from its centre of mass, m, its frame
  std::array<Real, 2> Pressure{};
  bool HasGroundContact = false;  // of a caster, in this substep
  // of the robot; null if it has none; not owned
  CGripperEquippedEntity* Gripper = nullptr;
  CTurretEntity* Turret = nullptr;
  bool HasManipulator = false;  // true if CRigidGrips tracks it
  dBodyID TurretBody = nullptr;  // while its gripper holds a body, see CRigidGrips
  std::vector<SRigidLink> Links;  // from link 1 on
  std::vector<std::pair<UInt32, UInt32>> SelfPairs;  // solids that collide with each other
  bool AreMotorsSet = false;  // false: the joints in ODE have no commands yet
  // by wheel: 1 + number of the contact in this substep that bears it; 0: none
  std::array<UInt32, 2> Supports{};
  std::array<SRoller, 6> Rollers;  // the wheels, then four casters; see GetFirstRoller()

  CVector3 Low;  // m, world frame; bounds of all parts
  CVector3 High;
  Real RollerMargin = 0.0;  // m; how far rollers reach beyond the bounds of the solids

  CVector3 CentreOfMass;  // of Body, in the frame of the origin, m
  Real WheelRadius = 0.0;  // m; of a planar drive: of wheels of which only casters are modelled
  Real Narrowest = 0.0;  // m, of the narrowest solid
  Real Friction = 1.0;
  Real Margin = 0.0;  // m; distance of its solids from the surface of its geoms
  // compliance of a robot's wheels as ODE's constraints have it, for the present substep and
  // gravity; both 0 without weight, when wheels have no grip
  Real WheelErp = 0.0;
  Real WheelCfm = 0.0;
  CVector3
      TiltGains;  // N m/rad, N m s/rad, N m; of the controller that keeps a flying body upright

  // forces of motors in the last substep, from which the next one starts: of wheels, N m; of a
  // planar drive: torque, then forces, N m and N
  std::array<Real, 2> AxleTorques{};
  std::array<Real, 3> DriveForces{};

  UInt64 Serial = 0;  // of no other body that ever was in the world; 0: of ghosts
  UInt32 Owned = 0;  // its number among all bodies of the world
  UInt32 Number = 0;  // in the world's list of movable or of fixed bodies
  UInt32 PartsNumber = 0;  // of a movable body with parts: in the world's list of these
  UInt32 ActiveNumber = 0;  // of those that are not upright either, in this tick
  // of the present substep, see CRigidStepper
  UInt32 SolverBody = 0;
  UInt32 SolverRotor = 0;  // the first of its rotors
  bool Rests = false;  // its island did not move in the last substep, see CRigidStepper
  bool Dozes = false;  // it is asleep until the end of the tick, because it rests
  bool Asleep = false;  // of a free robot: it has not moved in the last tick
  Real QuietTime = 0.0;  // s; since it was last faster than kQuietSpeed or kQuietTurn

  bool IsMovable() const { return Body != nullptr || IsFree; }
  bool IsPlane() const { return Source.Description == nullptr; }
  /** @return true for a plane that bounds all bodies from above. */
  bool IsCeiling() const { return IsPlane() && High.GetZ() == HUGE_VAL; }
  bool HasDrive() const { return Source.Movable && static_cast<bool>(Source.Drive); }
  bool HasWheels() const { return HasDrive() && Source.Drive.HasWheels(); }
  bool HasPlanarDrive() const { return HasDrive() && !Source.Drive.HasWheels(); }
  /** With a drive: the number of the first roller in use. */
  size_t GetFirstRoller() const { return HasWheels() ? 0 : Wheels.size(); }
  bool IsArticulated() const { return !Links.empty(); }
};

/** @return true for an object that is one ball, whose contacts are anticipated. */
inline bool IsBall(const SRigidBody& body) {
  return body.Body != nullptr && body.Solids.size() == 1 && !body.HasDrive() &&
         dGeomGetClass(body.Solids[0]) == dSphereClass;
}

/**
 * A bound on the speed of any point of a body against its main part's centre of mass, m/s; 0 for
 * what does not move, and for a ball, which covers the same place when it turns.
 */
Real ComputeRimSpeed(const SRigidBody& body);

/** Position of the centre of a roller of a robot, m, world frame. */
inline CVector3 LocateRoller(const SRigidBody& robot, size_t roller) {
  if (roller < robot.Wheels.size()) {
    return FromODE(dBodyGetPosition(robot.Wheels[roller]));
  }
  const dReal* const r = dBodyGetRotation(robot.Body);
  const CVector3& o = robot.Rollers[roller].Offset;
  return FromODE(dBodyGetPosition(robot.Body)) +
         CVector3(r[0] * o.GetX() + r[1] * o.GetY() + r[2] * o.GetZ(),
                  r[4] * o.GetX() + r[5] * o.GetY() + r[6] * o.GetZ(),
                  r[8] * o.GetX() + r[9] * o.GetY() + r[10] * o.GetZ());
}

/** Calls visit(dBodyID) for every part of a movable body that is not free. */
template <typename VISIT>
void ForEachPart(const SRigidBody& body, VISIT&& visit) {
  visit(body.Body);
  for (const SRigidLink& link : body.Links) {
    visit(link.Part);
  }
  if (body.HasWheels()) {
    visit(body.Wheels[0]);
    visit(body.Wheels[1]);
  }
  if (body.TurretBody != nullptr) {
    visit(body.TurretBody);
  }
}

/** Wakes all parts of a body, and resets its QuietTime; or puts all parts to sleep. */
void WakeRigidBody(SRigidBody& body);
void PutToSleep(SRigidBody& body);

/** Converts a unit quaternion in ODE's order: (w, x, y, z). */
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
