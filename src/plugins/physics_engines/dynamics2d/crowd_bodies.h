#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_BODIES_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_BODIES_H

#include <argos3/core/simulator/geometry/periodicity.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/planar_vector.h>

#include <cmath>

namespace argos {

/** A body of a crowd, as the solver moves it: its centre of mass. */
struct SCrowdDisc {
  float VX = 0.0F, VY = 0.0F;  // m/s
  float W = 0.0F;  // rad/s
  float InverseMass = 0.0F;  // 1/kg
  float InverseInertia = 0.0F;  // 1/(kg m^2)
  float Radius = 0.0F;  // of a disc, or half of the narrowest side of a solid, m

  /** @param x,y  impulse, N s. @param turn  impulse along the rim, anticlockwise, N s. */
  void ApplyImpulse(float x, float y, float turn) {
    VX += InverseMass * x;
    VY += InverseMass * y;
    W += InverseInertia * Radius * turn;
  }
};

/**
 * The drive of a body: what it aims at, and the bounds of its impulses. The friction of an object
 * on the ground aims at rest.
 */
struct SCrowdDrive {
  float TargetX = 0.0F, TargetY = 0.0F, TargetW = 0.0F;  // m/s, rad/s
  float InTick = 0.0F, AngularInTick = 0.0F;  // greatest impulses in a tick, N s and N m s
  float Spent = 0.0F, AngularSpent = 0.0F;  // in this tick
  float Most = 0.0F, AngularMost = 0.0F;  // in this substep
  float X = 0.0F, Y = 0.0F, Angular = 0.0F;  // impulses of this substep
  bool IsFriction = false;

  /** True if friction holds the body: it could resist more. */
  bool HoldsPlace() const { return X * X + Y * Y < kHolds * Most * Most; }
  bool HoldsYaw() const { return std::abs(Angular) < kHolds * AngularMost; }

 private:
  static constexpr float kHolds = 0.99F;
};

struct SCrowdPosition {
  Real X = 0.0, Y = 0.0;  // m
  Real Turn = 0.0;  // rad, since the start of the tick
};

/**
 * A grip in a tick: which bodies, by item, and what connects them. Offsets are those at the start
 * of the tick along the axes of the world, m.
 */
struct SCrowdGrip {
  UInt32 Holder = 0, Held = 0;
  SPlanarVector Pivot = {};  // from the holder's centre of mass to where its arm begins
  SPlanarVector Arm = {};  // from there to the end of the arm
  SPlanarVector Axis = {1.0, 0.0};  // along the arm, of unit length
  SPlanarVector Point = {};  // from the held body's centre of mass to the point that is held
  Real Stiffness = 0.0;  // N/m, along the arm
  Real Damping = 0.0;  // kg/s
  float NeededSubsteps = 1.0F;
  // the turret that bears the arm
  float InverseArmInertia = 0.0F;  // 1/(kg m^2); 0: there is none
  float ArmRate = 0.0F;  // rad/s, in the world
  Real Rotation = 0.0;  // rad, against the holder, since the start of the tick
  Real MotorTarget = 0.0;  // rad, the same at the end of the tick
  Real MotorRate = 0.0;  // rad/s, at which that changes in the tick
  float MotorTorque = 0.0F;  // N m, at most
  bool IsMotorOn = false;  // else its friction stops it
  // forces of the last substep, N, and the torque of the motor, N m
  float Along = 0.0F, Across = 0.0F, Motor = 0.0F;
};

/** A straight line that a disc does not cross: that half-way to a robot of another engine. */
struct SCrowdLine {
  Real NormalX, NormalY;  // towards the line, of unit length
  Real X, Y;  // a point on it, m
};

/** Numbers of obstacles from this one on are those of lines. */
constexpr UInt32 kFirstLine = UInt32(1) << 31;

/** Constants of a tick. */
struct SCrowdTick {
  Real Duration = 0.1;  // s
  UInt32 LeastSubsteps = 1;
  bool RefineInCrowds = true;  // more substeps where forces add up
  Real SmallestRadius = 0.0;  // m
  /** No disc moves farther in the tick, m: those farther apart than twice this cannot meet. */
  Real LongestPath = 0.0;
  SPeriodicity Period; /**< of the area in which bodies are at the start of the tick */
};

}  // namespace argos

#endif
