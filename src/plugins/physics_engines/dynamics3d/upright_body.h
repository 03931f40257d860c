#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_UPRIGHT_BODY_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_UPRIGHT_BODY_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rolling.h>

#include <array>
#include <vector>

namespace argos {

/**
 * A point on which an upright body stands, and its friction: a foot of an object, or a wheel.
 *
 * Its two directions are x and y of the world for a foot, ahead and left for a wheel.
 */
struct SUprightSupport {
  Real X = 0.0, Y = 0.0;  // from the centre of mass, m, frame of the body
  Real Load = 0.0;  // N
  // of a wheel
  Real Target = 0.0;  // m/s at the rim, of its motor
  Real StartSpin = 0.0;  // m/s at the rim, at the start of the substep
  Real Spin = 0.0;  // m/s at the rim
  Real MotorLimit = 0.0;  // N
  Real Rim = 0.0;  // kg: its moment of inertia as a mass at the rim
  Real Own = 0.0;  // N s at the rim: what brings it to its target
  // set for each substep
  Real EX = 1.0, EY = 0.0;  // the first direction, world frame
  Real Lever1 = 0.0, Lever2 = 0.0;  // m: of both directions about the centre of mass
  Real Share = 0.0;  // kg: impulse for a slip of 1, at most what stops it
  Real Grip = 0.0;  // greatest friction, N s
  Real Motor = 0.0;  // greatest impulse of the motor at the rim, N s
  Real Impulse1 = 0.0, Impulse2 = 0.0;  // N s
};

/** A body that stands upright on the floor, as the planar solver moves it: its centre of mass. */
struct alignas(64) SUprightBody {
  enum class EKind : UInt8 { Object, Wheels, PlanarDrive };

  Real VX = 0.0, VY = 0.0, W = 0.0;  // m/s, rad/s
  Real InverseMass = 0.0, InverseInertia = 0.0;  // 1/kg, 1/(kg m^2)
  Real Mass = 0.0, Inertia = 0.0;  // kg, kg m^2
  UInt32 LastSweep = 0;  // of the solver, in which its velocity has changed
  // the line of the cache that sweeps over contacts need ends here
  SPlanarPose Pose;  // of the centre of mass
  EKind Kind = EKind::Object;
  UInt8 NumSupports = 0;
  UInt32 FirstSupport = 0;
  UInt32 FirstPart = 0, NumParts = 0;
  Real Extent = 0.0;  // m, radius of the circle around the centre of mass
  Real Sweep = 0.0;  // m: the same, or 0 for a disc, which covers the same place when it turns
  // of a drive: what it aims at; of a planar one: its bounds, N s and N m s in the substep
  Real TargetX = 0.0, TargetY = 0.0, TargetW = 0.0;
  Real ForceLimit = 0.0, TorqueLimit = 0.0;
  // impulses of friction or of the drive in the substep, world frame
  Real DriveX = 0.0, DriveY = 0.0, DriveTurn = 0.0;

  SRigidBody* Rigid = nullptr;
  Real Height = 0.0;  // of the centre of mass above the floor, m
  Real OriginZ = 0.0;  // m, world frame
  Real LeanX = 0.0, LeanY = 0.0;  // rest of a lean, which fades: sines of half of it, its frame
  Real OffsetX = 0.0, OffsetY = 0.0;  // of the centre of mass from the origin, frame of the body, m
  Real Radius = 0.0;  // m, of a round foot; 0: its feet are corners
  Real StartX = 0.0, StartY = 0.0, StartW = 0.0;  // velocity at the start of the substep
  Real WayX = 0.0, WayY = 0.0, Turned = 0.0;  // m, rad: in the tick
  Real SupportX = 0.0, SupportY = 0.0;  // where the floor supports it, m, frame of the body
  // moments of contacts about the floor if they act at their lowest and highest points, N m s
  Real LowX = 0.0, LowY = 0.0, HighX = 0.0, HighY = 0.0;
  Real Highest = 0.0, Lowest = 0.0;  // m: of their lowest points, of their highest ones

  Real Cos() const { return Pose.HalfCos * Pose.HalfCos - Pose.HalfSin * Pose.HalfSin; }
  Real Sin() const { return 2.0 * Pose.HalfSin * Pose.HalfCos; }
  void Push(Real x, Real y, Real turn) {
    VX += InverseMass * x;
    VY += InverseMass * y;
    W += InverseInertia * turn;
  }
};

/** @return true if all solids of a body are upright in it, and no spheres or hulls. */
bool AreSolidsUpright(const SRigidBody& body);
/**
 * @return true if a body may stand: its solids are upright and made for it, whatever its pose. The
 * list of its parts is filled in.
 */
bool CanStand(SRigidBody& body);
/** @return true if an active body stands upright on the floor now, and nothing else acts on it. */
bool StandsUpright(const SRigidBody& body, const SRollGround& ground);

/** Reads an active body; appends its supports. */
void LoadUpright(SRigidBody& rigid, const SRollGround& ground, SUprightBody& body,
                 std::vector<SUprightSupport>& supports);
/** Writes place and motion to ODE. */
void StoreUpright(const SUprightBody& body, const std::vector<SUprightSupport>& supports);

/** Begins a substep: limits, directions and targets. */
void StartUprightSubstep(SUprightBody& body, SUprightSupport* supports, const SRollGround& ground,
                         Real substep);
/**
 * After a substep's impulses are found: distributes the weight over the feet of an object.
 * @return false if the floor cannot keep the body upright: an edge would lift.
 */
bool BalanceUpright(SUprightBody& body, SUprightSupport* supports, const SRollGround& ground,
                    Real substep);

}  // namespace argos

#endif
