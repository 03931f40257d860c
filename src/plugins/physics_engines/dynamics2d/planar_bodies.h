#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_BODIES_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_BODIES_H

#include <argos3/core/simulator/physics_engine/drive_source.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_handle.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_solid.h>
#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>

#include <memory>
#include <vector>

namespace argos {

/** A wall or another object that never moves by itself. */
struct SImmovableBody {
  SPlanarOwner Owner;
  std::vector<SFootprint> Obstacles;  // its solids, for the proximity filter
};

/** A movable object without a drive. */
struct SPassiveBody {
  SPlanarPose Pose;
  SPlanarVelocity Velocity;
  SPlanarOwner Owner;
  SPlanarSolid Solid;
  Real BoundingRadius = 0.0;  // around the origin, m
  bool IsFresh = true;  // it may overlap others, although nothing moves: it was added
  bool Moved = false;  // in this tick
  bool IsGrippable = false;
  bool WasReleased = false;  // by a gripper, in this tick
  UInt8 NumGrips = 0;  // that hold it
};

/** Constants of robots of one description. */
struct SDrivenKind {
  Real MaxSpeedChange = 0.0;  // m/s in a tick: limited by the drive's force
  Real MaxYawRateChange = 0.0;  // rad/s in a tick: limited by the drive's torque
  Real MaxSpeed = 0.0;  // m/s: limited by the number of substeps
  Real NarrowestHalf = 0.0;  // half of its narrowest side, m
  Real Mass = 0.0;  // kg
  Real Inertia = 0.0;  // about the origin, kg m^2

  friend bool operator==(const SDrivenKind&, const SDrivenKind&) = default;
};

/**
 * A robot with a drive. A disc that cannot touch anything in a tick moves exactly as planned.
 */
struct SDrivenBody {
  // state at the end of the last tick
  SPlanarPose Pose;
  SPlanarVelocity Velocity;
  SDriveCommand Command;  // of the last tick
  // state at the end of this tick: as planned, then corrected by the crowd
  SPlanarPose NextPose;
  SPlanarVelocity NextVelocity;
  SDriveCommand NextCommand;
  bool IsLimited = false;  // force or torque bound the plan: it is less than the command

  // constant
  CDriveSource Drive;
  const SDrivenKind* Kind = nullptr;  // shared by many; owned by the store
  std::unique_ptr<const SPlanarSolid> Solid;  // null for a disc
  Real BoundingRadius = 0.0;  // around the origin, m
  bool IsDisc = false;  // one disc around the origin
  bool IsGrippable = false;
  bool HasManipulator = false;
  UInt8 NumGrips = 0;  // in which it is the holder or is held

  // in a grip: impulse of the drive in the last substep, as a share of the greatest one
  float PullX = 0.0F, PullY = 0.0F;
  SPlanarOwner Owner;
};

}  // namespace argos

#endif
