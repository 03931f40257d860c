#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_BODIES_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_BODIES_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/encounters.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_handle.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>

#include <limits>
#include <vector>

class b2Body;
class b2MotorJoint;

namespace argos {

class CDynamics2DModel;
class CEmbodiedEntity;

/** The engine's references to a body: both null for a wall of the region. */
struct SPlanarOwner {
  CDynamics2DModel* Model = nullptr;
  CEmbodiedEntity* Body = nullptr;
  SPlanarHandle* Handle = nullptr;
};

/** A wall or another thing that never moves by itself. */
struct SImmovableBody {
  SPlanarOwner Owner;
  b2Body* Body = nullptr;
  std::vector<SFootprint> Obstacles;  // its solids, as robots look out for them
};

/** A movable thing without a drive. */
struct SPassiveBody {
  SPlanarPose Pose;
  SPlanarVelocity Velocity;
  SPlanarOwner Owner;
  b2Body* Body = nullptr;
  float X = 0.0F, Y = 0.0F, Angle = 0.0F;  // of Body when Pose was written, Box2D units, rad
  float Extent = 0.0F;  // half of its narrowest side, Box2D units
  Real BoundingRadius = 0.0;  // around the origin, m
  bool Moved = false;  // in this tick
  bool WasLetGo = false;  // by a gripper, in this tick
  UInt8 NumGrips = 0;  // that hold it
};

/**
 * A robot on two wheels.
 *
 * A disc that can meet nothing in a tick has no Box2D body: its exact motion is what was planned.
 * The others are "in play": see CPlanarWorld.
 */
struct SDrivenBody {
  static constexpr UInt32 kNotInPlay = std::numeric_limits<UInt32>::max();

  // state at the last tick's end
  SPlanarPose Pose;
  SPlanarVelocity Velocity;
  // where this tick leads: planned first, corrected by Box2D if in play
  SPlanarPose NextPose;
  SPlanarVelocity NextVelocity;

  // fixed
  const Real* Wheels = nullptr;  // m/s, (left, right), of the robot's wheels; not owned
  Real InverseInterwheel = 0.0;  // 1/m
  Real MaxSpeedChange = 0.0;  // m/s in a tick: the drive's force bounds it
  Real MaxYawRateChange = 0.0;  // rad/s in a tick: the drive's torque bounds it
  Real MaxSpeed = 0.0;  // m/s: as far as substeps can follow
  Real BoundingRadius = 0.0;  // around the origin, m
  Real NarrowestHalf = 0.0;  // half of its narrowest side, m
  Real Mass = 0.0;  // kg
  Real Inertia = 0.0;  // about the origin, kg m^2
  bool IsDisc = false;  // one disc around the origin
  bool IsGrippable = false;
  bool HasManipulator = false;
  UInt8 NumGrips = 0;  // that it holds with, or is held by

  UInt32 InPlay = kNotInPlay;  // number in the list of those in play
  SPlanarOwner Owner;
};

/** What a driven body has only while it is in play. */
struct SInPlay {
  UInt32 Slot = 0;
  b2Body* Body = nullptr;
  b2MotorJoint* Motor = nullptr;
  float StepX = 0.0F, StepY = 0.0F;  // where its wheels want it to go in the tick, Box2D units
  float StepAngle = 0.0F;  // rad in the tick
  float StartAngle = 0.0F;  // of the Box2D body at the tick's start, rad
  Real StartYaw = 0.0;  // rad
  float SpentImpulse = 0.0F;  // of the drive in this tick, Box2D units
  float SpentAngularImpulse = 0.0F;
};

}  // namespace argos

#endif
