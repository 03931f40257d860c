#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_BODY_DESCRIPTION_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_BODY_DESCRIPTION_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

#include <memory>
#include <optional>
#include <vector>

namespace argos {

class CConvexSolid;
struct SArticulation;
struct SBodyPose;
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
    Sphere, /**< Radius; Offset is the lowest point */
    Prism, /**< convex base Vertices, Size.Z = height, axis along local z */
    Hull /**< Solid, a convex hull of points */
  };

  EKind Kind = EKind::Cylinder;
  CVector3 Offset; /**< centre of the base in the body frame, m */
  CQuaternion Orientation; /**< orientation of the solid in the body frame */
  /** m; full extents of a box, or of the box around a prism; otherwise (2R, 2R, height). */
  CVector3 Size;
  /** m; of a cylinder or sphere; otherwise of the circle around Offset that contains the base. */
  Real Radius = 0.0;
  /**
   * Of a prism: the corners of its base in the frame of the solid, m, counter-clockwise, strictly
   * convex, at least three. Their bounding rectangle has its centre at the origin (at Offset). Null
   * for other kinds. Shared, because descriptions are copied.
   */
  std::shared_ptr<const std::vector<CVector2>> Vertices;
  /**
   * Of a hull: its corners in the frame of the solid, m. The box around them, of extents Size,
   * stands on its base like any solid. Null for other kinds. Shared, because descriptions are
   * copied.
   */
  std::shared_ptr<const CConvexSolid> Solid;
  Real Mass = 0.0; /**< kg; 0: its share, by volume, of what the body's other solids leave */
  UInt32 Link = 0; /**< link of an articulated body to which it belongs */

  /** A box with its base centre at @p offset. @param size full extents, m, all > 0. */
  static SShapeDescription Box(const CVector3& size, const CVector3& offset = CVector3());
  /** An upright cylinder. @param radius m, > 0. @param height m, > 0. */
  static SShapeDescription Cylinder(Real radius, Real height, const CVector3& offset = CVector3());
  /** A sphere whose lowest point is @p offset. @param radius m, > 0. */
  static SShapeDescription Sphere(Real radius, const CVector3& offset = CVector3());
  /**
   * An upright prism over a convex polygon.
   * @param vertices  corners of the base, m, in either order, relative to @p offset, which need not
   *                  be inside. Double corners and those on a straight side are removed.
   * @param height    m, > 0.
   * @param offset    m, in the body frame. The Offset of the result is the centre of the bounding
   *                  rectangle of the base: about it, an Orientation rotates the solid.
   * @throws CARGoSException if the polygon is not convex, degenerate or too narrow (1e-5 m).
   */
  static SShapeDescription Prism(std::vector<CVector2> vertices, Real height,
                                 const CVector3& offset = CVector3());

  /**
   * The convex hull of points.
   * @param points  m, relative to @p offset, in the body frame. The Offset of the result is the
   *                centre of the base of the box around the points.
   * @throws CARGoSException if the points do not span a volume.
   */
  static SShapeDescription Hull(std::vector<CVector3> points, const CVector3& offset = CVector3());

  /** Half-way up the axis through Offset, m, in the body frame. */
  CVector3 ComputeMiddle() const;
  /** The centre of mass, m, in the body frame. */
  CVector3 ComputeCentroid() const;
  /** m^3. */
  Real ComputeVolume() const;
  /** The least width of the base, m. */
  Real ComputeBaseWidth() const;
};

/** Moments of inertia of a homogeneous solid per kg, m^2; about axes through its centroid. */
struct SUnitInertia {
  Real XX, YY, ZZ; /**< about the axes of the solid's frame */
  Real XY; /**< product: mean of x y; 0 for all kinds but prisms and hulls */
  Real XZ = 0.0, YZ = 0.0; /**< 0 for all kinds but hulls */
};
SUnitInertia ComputeUnitInertia(const SShapeDescription& shape);

/** Two driven wheels on one axis through the body's origin; y is the axis, x points ahead. */
struct SDifferentialDriveDescription {
  Real InterwheelDistance = 0.0; /**< m, > 0 */
  Real WheelRadius = 0.0; /**< m, > 0 */
  Real MaxForce = 0.0; /**< N, > 0: greatest force of the drive along or across its heading */
  Real MaxTorque = 0.0; /**< N m, > 0: greatest torque about z */
};

/**
 * A drive that can move the body to all sides, such as omnidirectional wheels, or two steered ones:
 * its component "planar_drive" orders a velocity in the plane, in the frame of the body.
 */
struct SPlanarDriveDescription {
  Real MaxForce = 0.0; /**< N, > 0: greatest force in the plane */
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
  /** N and N m, >= 0: have precedence over the parameters of engines with such friction. */
  std::optional<Real> MaxForce, MaxTorque;
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
  CVector3 Direction = CVector3::X; /**< has unit length, same frame: towards its opening */
  Real SensorRadius = 0.01; /**< radius of the disc, m, > 0 */
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
  std::vector<SShapeDescription> Shapes; /**< solids; at least one */
  Real Mass = 0.0; /**< kg, > 0 if movable; ignored if not */
  /** Moment of inertia about the vertical through the origin, kg m^2; unset: that of the solids. */
  std::optional<Real> PlanarInertia;
  std::optional<SDifferentialDriveDescription> Drive; /**< needs a "wheels" component */
  /** Needs a component "planar_drive"; excludes Drive and Propellers. */
  std::optional<SPlanarDriveDescription> PlanarDrive;
  std::optional<SPropellersDescription> Propellers; /**< needs a "quadrotor" component */
  std::optional<SGroundFrictionDescription> GroundFriction; /**< set for passive movable bodies */
  std::optional<STurretDescription> Turret; /**< needs a "turret" component to rotate */
  std::optional<SGripperDescription> Gripper; /**< needs a "gripper" component to grip */
  bool Grippable = false; /**< true if grippers can hold it; movable bodies only */
  /** Links and joints; null if the solids are rigidly joined. Shapes are as at the start. */
  std::shared_ptr<const SArticulation> Articulation;
  /** True if a user's model describes the body in place of the entity; see CBodyRecorder. */
  bool IsRecorded = false;

  /** @return true if the body drives on the ground. */
  bool HasDrive() const { return Drive || PlanarDrive; }
  /** Limits of the force and torque of either drive; HasDrive() must be true. */
  SPlanarDriveDescription GetDriveLimits() const {
    return PlanarDrive ? *PlanarDrive : SPlanarDriveDescription{Drive->MaxForce, Drive->MaxTorque};
  }

  /** Radius of the wheels of a robot that does not describe them, assumed from its size, m. */
  Real AssumeWheelRadius() const;

  /** Radius of the vertical cylinder around the origin that contains every solid, m. */
  Real ComputeBoundingRadius() const;
  /** The centre of Mass spread evenly, m, in the body frame. */
  CVector3 ComputeCentreOfMass() const;
  /** Moment of inertia about the vertical through the origin, kg m^2, for Mass spread evenly. */
  Real ComputePlanarInertia() const;
  /** PlanarInertia, or the result of ComputePlanarInertia() if that is unset; kg m^2. */
  Real GetPlanarInertia() const { return PlanarInertia ? *PlanarInertia : ComputePlanarInertia(); }
  /**
   * The smallest axis-aligned box around all solids.
   * @param position, orientation  of the origin anchor, m, world frame.
   * @param links  poses of the links, see CEmbodiedEntity::GetLinkPoses(); null: as at the start.
   */
  SBoundingBox ComputeBoundingBox(const CVector3& position, const CQuaternion& orientation,
                                  const SBodyPose* links = nullptr) const;
  /** Weights in proportion to the masses of the solids; without given ones, their volumes, m^3. */
  std::vector<Real> ComputeWeights() const;
};

}  // namespace argos

#endif
