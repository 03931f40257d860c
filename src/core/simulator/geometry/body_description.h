#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_BODY_DESCRIPTION_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_BODY_DESCRIPTION_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

#include <optional>
#include <vector>

namespace argos {

struct SBoundingBox;

/**
 * One convex solid of a body, in the frame of the body's origin anchor.
 *
 * Every solid stands on its base: Offset is the centre of the base, not the centroid.
 */
struct SShapeDescription {
  enum class EKind : UInt8 {
    Box, /**< extents Size along the local axes */
    Cylinder, /**< Radius and Size.Z = height, axis along local z */
    Sphere /**< Radius; Offset is the lowest point */
  };

  EKind Kind = EKind::Cylinder;
  CVector3 Offset; /**< centre of the base in the body frame, m */
  CQuaternion Orientation; /**< of the solid in the body frame */
  CVector3 Size; /**< m; full extents of a box; for cylinder and sphere (2R, 2R, height) */
  Real Radius = 0.0; /**< m; of a cylinder or sphere; of a box: of the circle around its base */

  /** A box with its base centre at @p offset. @param size full extents, m, all > 0. */
  static SShapeDescription Box(const CVector3& size, const CVector3& offset = CVector3());
  /** An upright cylinder. @param radius m, > 0. @param height m, > 0. */
  static SShapeDescription Cylinder(Real radius, Real height, const CVector3& offset = CVector3());
  /** A sphere whose lowest point is @p offset. @param radius m, > 0. */
  static SShapeDescription Sphere(Real radius, const CVector3& offset = CVector3());
};

/** Two driven wheels on one axis through the body's origin; y is the axis, x points ahead. */
struct SDifferentialDriveDescription {
  Real InterwheelDistance = 0.0; /**< m, > 0 */
  Real WheelRadius = 0.0; /**< m, > 0 */
  Real MaxForce = 0.0; /**< N, > 0: greatest force of the drive along or across its heading */
  Real MaxTorque = 0.0; /**< N m, > 0: greatest torque about z */
};

/** A controller with the output Proportional * error + Derivative * d(error)/dt. */
struct SControlGains {
  Real Proportional = 0.0;
  Real Derivative = 0.0;
};

/**
 * Propellers that lift a body and turn it about the vertical, and the controllers of their thrust.
 *
 * A body with propellers flies: its "quadrotor" component selects the control of position and yaw,
 * or of velocity and yaw rate. Horizontal thrust represents that of a robot that tilts; engines may
 * leave out the tilt. Yaw torque acts on the body's PlanarInertia, the other thrusts on its Mass.
 */
struct SPropellersDescription {
  SControlGains Position; /**< N/m and N s/m, both > 0; of each axis, world frame */
  SControlGains Yaw; /**< N m/rad and N m s/rad, both > 0 */
  SControlGains Velocity; /**< N s/m, > 0, and kg, >= 0; of each axis, world frame */
  SControlGains YawRate; /**< N m s/rad, > 0, and kg m^2, >= 0 */
  Real MaxForce = 0.0; /**< N, > 0: limit of a controller's force along each axis */
  Real MaxTorque = 0.0; /**< N m, > 0: limit of a controller's torque about the vertical */
};

/** Ground friction of a movable passive body: bounds of a velocity-matching friction. */
struct SGroundFrictionDescription {
  enum class EClass : UInt8 {
    Box, /**< engines use their box_* friction parameters */
    Cylinder /**< engines use their cylinder_* friction parameters */
  };
  EClass Class = EClass::Box;
};

/**
 * A part of the body that rotates about the vertical through the origin: the frame of the anchor
 * "turret", which the component "turret" (CTurretEntity) rotates.
 *
 * It has no solids of its own. While nothing is gripped, only its frame rotates.
 */
struct STurretDescription {
  Real Mass = 0.0; /**< kg, > 0; a part of the body's Mass, so below it */
  Real PlanarInertia = 0.0; /**< about the vertical, kg m^2, > 0; not part of that of the body */
  Real MaxTorque = 0.0; /**< N m, > 0: greatest torque of its motor, against the body */
  Real FreeTorque = 0.0; /**< N m, >= 0: greatest friction torque while the motor is off */
};

/**
 * A gripper, which the component "gripper" (CGripperEquippedEntity) locks: then it grips the first
 * grippable body that reaches into its sensing disc.
 */
struct SGripperDescription {
  CVector3 Offset; /**< centre of the disc, m, in the frame of the turret, or without one of the
                      origin anchor; off the vertical through the origin */
  CVector3 Direction = CVector3::X; /**< of unit length, same frame: towards its opening */
  Real SensorRadius = 0.01; /**< of the disc, m, > 0 */
  Real MaxForce = 10000.0; /**< N, > 0: a greater force breaks the grip */
};

/**
 * The properties of a body that a physics engine needs, independent of the engine.
 *
 * A robot or object describes itself once; every engine builds its own representation from it, so a
 * new robot needs no code in any engine and a new engine none in any robot. Robots of one type with
 * equal parameters share one description, which is constant while it is shared.
 */
struct SBodyDescription {
  std::vector<SShapeDescription> Shapes; /**< solids, rigidly joined; at least one */
  Real Mass = 0.0; /**< kg, > 0 if movable; ignored if not */
  /** Moment of inertia about the vertical through the origin, kg m^2; unset: that of the solids. */
  std::optional<Real> PlanarInertia;
  std::optional<SDifferentialDriveDescription> Drive; /**< needs a "wheels" component */
  std::optional<SPropellersDescription> Propellers; /**< needs a "quadrotor" component */
  std::optional<SGroundFrictionDescription> GroundFriction; /**< of passive movable bodies */
  std::optional<STurretDescription> Turret; /**< needs a "turret" component to rotate */
  std::optional<SGripperDescription> Gripper; /**< needs a "gripper" component to grip */
  bool Grippable = false; /**< true if grippers can hold it; movable bodies only */

  /** Radius of the vertical cylinder around the origin that contains every solid, m. */
  Real ComputeBoundingRadius() const;
  /** Moment of inertia about the vertical through the origin, kg m^2, for Mass spread evenly. */
  Real ComputePlanarInertia() const;
  /** PlanarInertia, or the result of ComputePlanarInertia() if that is unset; kg m^2. */
  Real GetPlanarInertia() const { return PlanarInertia ? *PlanarInertia : ComputePlanarInertia(); }
  /**
   * The smallest axis-aligned box around all solids.
   * @param position, orientation  of the origin anchor, m, world frame.
   */
  SBoundingBox ComputeBoundingBox(const CVector3& position, const CQuaternion& orientation) const;
};

}  // namespace argos

#endif
