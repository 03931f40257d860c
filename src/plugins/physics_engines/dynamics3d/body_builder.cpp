#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>

#include <argos3/core/simulator/geometry/articulation.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/articulated_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/hull_geom.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/prism_geom.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_mass.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/skin.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rolling.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace argos {

namespace {

using EKind = SShapeDescription::EKind;

bool IsPositive(Real value) {
  return value > 0.0 && std::isfinite(value);
}

Real NarrowestSide(const SShapeDescription& shape) {
  return std::min(shape.ComputeBaseWidth(), shape.Size.GetZ());
}

// Scales to the described moment about the vertical. Moments about the horizontal axes are raised
// to half of it if they are smaller, because no rigid body has smaller ones.
void SetPlanarInertia(dMass& mass, Real inertia) {
  mass.I[10] = inertia;
  mass.I[0] = std::max<Real>(mass.I[0], 0.5 * inertia);
  mass.I[5] = std::max<Real>(mass.I[5], 0.5 * inertia);
}

Real GetWheelMass(const SBodyDescription& description) {
  return kWheelMassShare * description.Mass;
}

// the same about every axis, as the contact geometry of a wheel is a sphere
Real GetWheelInertia(const SBodyDescription& description) {
  const Real radius = description.Drive->WheelRadius;
  return 0.5 * GetWheelMass(description) * radius * radius;
}

// Sets what follows from the masses, and gives those of the body without its wheels.
dMass ComputeMass(SRigidBody& body) {
  const SBodyDescription& description = *body.Source.Description;
  const Real chassis =
      description.Mass - (body.HasWheels() ? 2.0 * GetWheelMass(description) : 0.0);
  dMass mass = AddUpSolids(description, chassis, 0);
  body.CentreOfMass = CentreMass(mass);
  if (body.HasDrive()) {
    // motors and batteries are near the ground
    body.CentreOfMass.SetZ(std::min(body.CentreOfMass.GetZ(), body.WheelRadius));
  }
  if (description.PlanarInertia) {
    const CVector3& centre = body.CentreOfMass;
    Real inertia = *description.PlanarInertia -
                   chassis * (centre.GetX() * centre.GetX() + centre.GetY() * centre.GetY());
    if (body.HasWheels()) {
      const Real arm = 0.5 * description.Drive->InterwheelDistance;
      inertia -= 2.0 * (GetWheelInertia(description) + GetWheelMass(description) * arm * arm);
    }
    // wheels far from the centre may leave no inertia for the rest
    SetPlanarInertia(mass, std::max(inertia, 0.1 * *description.PlanarInertia));
  }
  if (description.Propellers) {
    // the same frequency and damping as for the yaw
    const SControlGains& yaw = description.Propellers->Yaw;
    const Real ratio = 0.5 * (mass.I[0] + mass.I[5]) / mass.I[10];
    body.TiltGains.Set(yaw.Proportional * ratio, yaw.Derivative * ratio,
                       description.Propellers->MaxTorque);
  }
  return mass;
}

bool HasFixedBase(const SRigidBody& body) {
  const auto& articulation = body.Source.Description->Articulation;
  return articulation != nullptr && articulation->HasFixedBase;
}

void AddLinks(SRigidBody& body, dWorldID world) {
  const SBodyDescription& description = *body.Source.Description;
  for (UInt32 link = 1; link < description.Articulation->GetNumLinks(); ++link) {
    SRigidLink& added = body.Links.emplace_back();
    added.Part = dBodyCreate(world);
    dMass mass = AddUpSolids(description, description.Mass, link);
    added.CentreOfMass = CentreMass(mass);
    dBodySetMass(added.Part, &mass);
  }
  if (HasFixedBase(body)) {
    dBodySetKinematic(body.Body);
  }
}

// the part of a solid of a robot on wheels that is above its clearance
SShapeDescription Lift(SShapeDescription shape, Real clearance) {
  const Real missing = clearance - shape.Offset.GetZ();
  if (missing <= 0.0) {
    return shape;
  }
  shape.Offset.SetZ(clearance);
  const bool upright = shape.Orientation.GetX() == 0.0 && shape.Orientation.GetY() == 0.0;
  if (upright && shape.Kind != EKind::Sphere && shape.Size.GetZ() > 2.0 * missing) {
    shape.Size.SetZ(shape.Size.GetZ() - missing);
  }
  return shape;
}

// in no ODE space: CBroadPhase finds the pairs that may touch
dGeomID MakeGeom(SRigidBody& body, const SShapeDescription& shape) {
  const Real skin = body.Margin;
  const CVector3 size = shape.Size + CVector3(2.0, 2.0, 2.0) * skin;
  switch (shape.Kind) {
    case EKind::Box:
      return dCreateBox(nullptr, size.GetX(), size.GetY(), size.GetZ());
    case EKind::Cylinder:
      return dCreateCylinder(nullptr, shape.Radius + skin, size.GetZ());
    case EKind::Hull:
      body.Hulls.push_back(std::make_shared<SHullArrays>());
      return MakeHullGeom(*shape.Solid, *body.Hulls.back());
    case EKind::Prism:
      return CreatePrism(*shape.Vertices, shape.Size.GetZ());
    case EKind::Sphere:
      break;
  }
  return dCreateSphere(nullptr, shape.Radius + skin);
}

// the origin of a geom, in the frame of the body
CVector3 CentreOfGeom(const SShapeDescription& shape) {
  return shape.Kind == SShapeDescription::EKind::Hull ? shape.ComputeCentroid()
                                                      : shape.ComputeMiddle();
}

// puts a solid without a part of its own at its place on a fixed body
void PutFixedSolid(dGeomID solid, const SShapeDescription& shape, const SRigidPose& pose) {
  const CVector3 place = pose.Position + Rotated(CentreOfGeom(shape), pose.Orientation);
  dQuaternion orientation;
  ToODE(pose.Orientation * shape.Orientation, orientation);
  dGeomSetPosition(solid, place.GetX(), place.GetY(), place.GetZ());
  dGeomSetQuaternion(solid, orientation);
}

void AddSolids(SRigidBody& body, const SRigidPose& pose) {
  const SBodyDescription& description = *body.Source.Description;
  for (const SShapeDescription& described : description.Shapes) {
    const SShapeDescription shape =
        body.HasDrive() ? Lift(described, kClearance * body.WheelRadius) : described;
    const dGeomID geom = MakeGeom(body, shape);
    body.Solids.push_back(geom);
    const SRigidLink* const link = shape.Link > 0 ? &body.Links[shape.Link - 1] : nullptr;
    if (!body.IsMovable() || (link == nullptr && HasFixedBase(body))) {
      PutFixedSolid(geom, shape, pose);
      continue;
    }
    dGeomSetBody(geom, link != nullptr ? link->Part : body.Body);
    const CVector3 place =
        CentreOfGeom(shape) - (link != nullptr ? link->CentreOfMass : body.CentreOfMass);
    dGeomSetOffsetPosition(geom, place.GetX(), place.GetY(), place.GetZ());
    dQuaternion orientation;
    ToODE(shape.Orientation, orientation);
    dGeomSetOffsetQuaternion(geom, orientation);
  }
}

CVector3 GetWheelOffset(const SRigidBody& body, size_t wheel) {
  const Real arm = 0.5 * body.Source.Description->Drive->InterwheelDistance;
  return CVector3(0.0, wheel == 0 ? arm : -arm, body.WheelRadius);
}

void AddRollers(SRigidBody& body) {
  const SBoundingBox box = body.Source.Description->ComputeBoundingBox(CVector3(), CQuaternion());
  const Real radius = kCasterRadius * body.WheelRadius;
  const CVector3 unused;
  body.RollerMargin = 0.0;
  const std::array<CVector3, 6> centres = {body.HasWheels() ? GetWheelOffset(body, 0) : unused,
                                           body.HasWheels() ? GetWheelOffset(body, 1) : unused,
                                           CVector3(box.MaxCorner.GetX() - radius, 0.0, radius),
                                           CVector3(box.MinCorner.GetX() + radius, 0.0, radius),
                                           CVector3(0.0, box.MaxCorner.GetY() - radius, radius),
                                           CVector3(0.0, box.MinCorner.GetY() + radius, radius)};
  for (size_t i = body.GetFirstRoller(); i < centres.size(); ++i) {
    SRoller& roller = body.Rollers[i];
    roller.Offset = centres[i] - body.CentreOfMass;
    roller.Radius = i < body.Wheels.size() ? (1.0 + kWheelTravel) * body.WheelRadius : radius;
    for (UInt32 axis = 0; axis < 3; ++axis) {
      // the solids have a clearance from the ground
      const Real lowest = box.MinCorner[axis] + (axis == 2 ? kClearance * body.WheelRadius : 0.0);
      body.RollerMargin =
          std::max({body.RollerMargin, centres[i][axis] + roller.Radius - box.MaxCorner[axis],
                    lowest - centres[i][axis] + roller.Radius});
    }
  }
  // for any orientation of the robot
  body.RollerMargin *= std::sqrt(3.0);
}

void MountWheels(SRigidBody& body, const SRigidPose& pose, dWorldID world) {
  const SBodyDescription& description = *body.Source.Description;
  const SDifferentialDriveDescription& drive = *description.Drive;
  const Real force = std::min(0.5 * drive.MaxForce, drive.MaxTorque / drive.InterwheelDistance);
  const CVector3 axis = Rotated(CVector3::Y, pose.Orientation);
  for (size_t i = 0; i < body.Wheels.size(); ++i) {
    const CVector3 centre = pose.Position + Rotated(GetWheelOffset(body, i), pose.Orientation);
    const dJointID axle = dJointCreateHinge(world, nullptr);
    dJointAttach(axle, body.Wheels[i], body.Body);
    dJointSetHingeAnchor(axle, centre.GetX(), centre.GetY(), centre.GetZ());
    dJointSetHingeAxis(axle, axis.GetX(), axis.GetY(), axis.GetZ());
    dJointSetHingeParam(axle, dParamFMax, force * body.WheelRadius);
    body.Axles[i] = axle;
  }
}

// Force acts along two axes, of which SetPlanarMotor() turns the first to where it is needed.
void MountPlanarMotors(SRigidBody& body, dWorldID world) {
  body.PlanarMotor = dJointCreateLMotor(world, nullptr);
  dJointAttach(body.PlanarMotor, body.Body, nullptr);
  dJointSetLMotorNumAxes(body.PlanarMotor, 2);
  body.YawMotor = dJointCreateAMotor(world, nullptr);
  dJointAttach(body.YawMotor, body.Body, nullptr);
  dJointSetAMotorMode(body.YawMotor, dAMotorUser);
  dJointSetAMotorNumAxes(body.YawMotor, 1);
  dJointSetAMotorAxis(body.YawMotor, 0, 0, 0.0, 0.0, 1.0);
  // ODE's faster rotations lose (w dt)^2 / 12 of the angle
  dBodySetFiniteRotationMode(body.Body, 1);
  // hard, so that speeds are exact: forces are bounded
  dJointSetLMotorParam(body.PlanarMotor, dParamCFM, kMotorSoftness);
  dJointSetLMotorParam(body.PlanarMotor, dParamCFM2, kMotorSoftness);
  dJointSetAMotorParam(body.YawMotor, dParamCFM, kMotorSoftness);
}

void PutPart(dBodyID part, const CVector3& position, const CQuaternion& orientation,
             const CVector3& velocity, const CVector3& angularVelocity) {
  dQuaternion quaternion;
  ToODE(orientation, quaternion);
  dBodySetPosition(part, position.GetX(), position.GetY(), position.GetZ());
  dBodySetQuaternion(part, quaternion);
  dBodySetLinearVel(part, velocity.GetX(), velocity.GetY(), velocity.GetZ());
  dBodySetAngularVel(part, angularVelocity.GetX(), angularVelocity.GetY(), angularVelocity.GetZ());
  dBodySetForce(part, 0.0, 0.0, 0.0);
  dBodySetTorque(part, 0.0, 0.0, 0.0);
}

std::string FindFlawOfDrive(const SBodyDescription& description) {
  const SDifferentialDriveDescription& drive = *description.Drive;
  if (!IsPositive(drive.InterwheelDistance) || !IsPositive(drive.WheelRadius)) {
    return "the distance between the wheels and their radius must be numbers > 0 (m)";
  }
  if (!IsPositive(drive.MaxForce) || !IsPositive(drive.MaxTorque)) {
    return "the greatest force (N) and torque (N m) of the drive must be numbers > 0";
  }
  const Real caster = kCasterRadius * drive.WheelRadius;
  const SBoundingBox box = description.ComputeBoundingBox(CVector3(), CQuaternion());
  const Real reach = std::min(
      {box.MaxCorner.GetX(), -box.MinCorner.GetX(), box.MaxCorner.GetY(), -box.MinCorner.GetY()});
  if (!(reach > caster)) {
    CTextOutput flaw;
    flaw << "its solids must reach more than " << caster
         << " m to all four sides, where its casters are";
    return flaw.str();
  }
  return "";
}

std::string FindFlawOfPlanarDrive(const SBodyDescription& description) {
  const SPlanarDriveDescription& drive = *description.PlanarDrive;
  if (!IsPositive(drive.MaxForce) || !IsPositive(drive.MaxTorque)) {
    return "the greatest force (N) and torque (N m) of the drive must be numbers > 0";
  }
  return IsPositive(description.AssumeWheelRadius())
             ? ""
             : "its solids must reach to all four sides of its origin, where its casters are";
}

std::string FindFlawOfPropellers(const SPropellersDescription& propellers) {
  for (const SControlGains* gains : {&propellers.Position, &propellers.Yaw}) {
    // without a derivative gain, a loop on position has no damping
    if (!IsPositive(gains->Proportional) || !IsPositive(gains->Derivative)) {
      return "the gains on position and yaw must be numbers > 0";
    }
  }
  for (const SControlGains* gains : {&propellers.Velocity, &propellers.YawRate}) {
    if (!IsPositive(gains->Proportional) || !(gains->Derivative >= 0.0)) {
      return "of the gains on velocity and yaw rate, the first must be > 0 and the second >= 0";
    }
  }
  if (!IsPositive(propellers.MaxForce) || !IsPositive(propellers.MaxTorque)) {
    return "the greatest force (N) and torque (N m) of the propellers must be numbers > 0";
  }
  return "";
}

std::string FindFlawOfMotion(const SBodyDescription& description) {
  if (description.Drive) {
    return FindFlawOfDrive(description);
  }
  if (description.PlanarDrive) {
    return FindFlawOfPlanarDrive(description);
  }
  if (description.Articulation != nullptr) {
    return FindFlawOfJoints(description);
  }
  return description.Propellers ? FindFlawOfPropellers(*description.Propellers) : "";
}

// ODE aborts if a moment of inertia is not positive, which rounding makes of one that is small
// compared to that about the origin.
std::string FindFlawOfMasses(const SBodyDescription& description) {
  const UInt32 links =
      description.Articulation != nullptr ? description.Articulation->GetNumLinks() : 1;
  for (UInt32 link = 0; link < links; ++link) {
    dMass mass = AddUpSolids(description, description.Mass, link);
    CentreMass(mass);
    if (dMassCheck(&mass) == 0) {
      return "its solids are too far from its origin, or from each other, to compute with their "
             "moments of inertia";
    }
  }
  return "";
}

// Links are at their present poses; without motion, they move rigidly with the body.
void PlaceLinks(const SRigidBody& body, const SRigidPose& pose, const SRigidMotion& motion) {
  const CVector3 centre = pose.Position + Rotated(body.CentreOfMass, pose.Orientation);
  for (size_t i = 0; i < body.Links.size(); ++i) {
    const SRigidLink& link = body.Links[i];
    const SBodyPose frame =
        Compose({pose.Position, pose.Orientation}, body.Source.LinkPoses[i + 1]);
    const CVector3 place = frame.Position + Rotated(link.CentreOfMass, frame.Orientation);
    const SLinkMotion own =
        i < motion.Links.size()
            ? motion.Links[i]
            : SLinkMotion{motion.Velocity + Cross(motion.AngularVelocity, place - centre),
                          motion.AngularVelocity};
    PutPart(link.Part, place, frame.Orientation, own.Velocity, own.AngularVelocity);
  }
}

// joints take the poses of their links when they are made as coordinate 0
void MountLinksAtStart(SRigidBody& body, const SRigidPose& pose, dWorldID world) {
  const SBodyPose* const present = body.Source.LinkPoses;
  const std::vector<SBodyPose> start(body.Links.size() + 1);
  body.Source.LinkPoses = start.data();
  PlaceLinks(body, pose, {});
  MountLinks(body, pose, world);
  body.Source.LinkPoses = present;
  PlaceLinks(body, pose, {});
}

}  // namespace

std::string FindFlaw(const SBodyDescription& description, bool movable) {
  for (const SShapeDescription& shape : description.Shapes) {
    if (!IsPositive(NarrowestSide(shape)) || !std::isfinite(shape.Size.Length()) ||
        !std::isfinite(shape.Offset.Length()) || !IsPositive(shape.Orientation.Length())) {
      return "the sizes of its solids must be numbers > 0 (m), and their places finite";
    }
  }
  if (!movable) {
    return "";
  }
  if (!IsPositive(description.Mass)) {
    return "the mass must be a number > 0 (kg)";
  }
  if (description.PlanarInertia && !IsPositive(*description.PlanarInertia)) {
    return "the moment of inertia must be a number > 0 (kg m^2)";
  }
  const std::string flaw = FindFlawOfMotion(description);
  return flaw.empty() ? FindFlawOfMasses(description) : flaw;
}

void DescribeRigidBody(SRigidBody& body, const SRigidSettings& settings) {
  const SBodyDescription& description = *body.Source.Description;
  body.Friction = settings.Friction;
  body.Narrowest = NarrowestSide(description.Shapes.front());
  for (const SShapeDescription& shape : description.Shapes) {
    body.Narrowest = std::min(body.Narrowest, NarrowestSide(shape));
  }
  body.Margin = ComputeSkin(body, settings);
  if (body.HasDrive()) {
    body.WheelRadius =
        body.HasWheels() ? description.Drive->WheelRadius : description.AssumeWheelRadius();
    body.BoundingRadius = description.ComputeBoundingRadius();
  }
  if (body.Source.Movable) {
    ComputeMass(body);
  }
  if (body.HasDrive()) {
    AddRollers(body);
  }
}

void BuildRigidBody(SRigidBody& body, const SRigidPose& pose, const SRigidSettings& settings,
                    dWorldID world) {
  DescribeRigidBody(body, settings);
  const SBodyDescription& description = *body.Source.Description;
  if (body.Source.Movable) {
    body.Body = dBodyCreate(world);
    if (body.HasPlanarDrive()) {
      MountPlanarMotors(body, world);
    } else if (body.HasWheels()) {
      dMass mass;
      dMassSetSphereTotal(&mass, GetWheelMass(description), body.WheelRadius);
      mass.I[0] = mass.I[5] = mass.I[10] = GetWheelInertia(description);
      for (dBodyID& wheel : body.Wheels) {
        wheel = dBodyCreate(world);
        dBodySetMass(wheel, &mass);
        dBodySetGyroscopicMode(wheel, 0);
      }
    }
    const dMass mass = ComputeMass(body);
    dBodySetMass(body.Body, &mass);
    if (description.Articulation != nullptr) {
      AddLinks(body, world);
    }
    PlaceRigidBody(body, pose, {});
  }
  body.Fixed = pose;
  AddSolids(body, pose);
  if (body.IsArticulated()) {
    ListSelfPairs(body);
    MountLinksAtStart(body, pose, world);
  }
  if (body.HasWheels()) {
    MountWheels(body, pose, world);
  }
}

// see ODE's manual, "Soft constraints", for the equivalent spring and damper
void TuneWheels(SRigidBody& body, Real gravity, Real substep) {
  const Real mass = body.Source.Description->Mass;
  const Real stiffness = 0.5 * kWheelLoad * mass * gravity / (kWheelTravel * body.WheelRadius);
  // critical damping for half of the robot
  const Real damping = 2.0 * std::sqrt(stiffness * 0.5 * mass);
  if (!(stiffness > 0.0)) {
    body.WheelErp = body.WheelCfm = 0.0;
    return;
  }
  body.WheelErp = substep * stiffness / (substep * stiffness + damping);
  body.WheelCfm = 1.0 / (substep * stiffness + damping);
}

void SetPlanarMotor(SRigidBody& body, Real substep) {
  const SPlanarDriveDescription& drive = *body.Source.Description->PlanarDrive;
  const SDriveCommand command = body.Source.Drive.Read();
  const SRigidPose pose = GetRigidPose(body);
  const SPlanarPose start = MakePlanarPose(pose.Position, pose.Orientation);
  const SArc arc = FollowArc(start, command, substep);
  // ODE moves the centre of mass
  const auto locate = [&body](const SPlanarPose& of) {
    const CVector3 centre(body.CentreOfMass.GetX(), body.CentreOfMass.GetY(), 0.0);
    return Rotated(centre, CQuaternion(of.HalfCos, 0.0, 0.0, of.HalfSin));
  };
  const CVector3 target =
      (CVector3(arc.DX, arc.DY, 0.0) + locate(arc.End) - locate(start)) / substep;
  const CVector3 velocity = FromODE(dBodyGetLinearVel(body.Body));
  // the limit of the force holds along the direction in which it acts
  CVector3 change(target.GetX() - velocity.GetX(), target.GetY() - velocity.GetY(), 0.0);
  const Real length = change.Length();
  const CVector3 axis = length > 0.0 ? change / length : CVector3::X;
  const CVector3 across(-axis.GetY(), axis.GetX(), 0.0);
  dJointSetLMotorAxis(body.PlanarMotor, 0, 0, axis.GetX(), axis.GetY(), 0.0);
  dJointSetLMotorAxis(body.PlanarMotor, 1, 0, across.GetX(), across.GetY(), 0.0);
  dJointSetLMotorParam(body.PlanarMotor, dParamVel, target.DotProduct(axis));
  dJointSetLMotorParam(body.PlanarMotor, dParamVel2, target.DotProduct(across));
  const Real force = body.HasGroundContact ? drive.MaxForce : 0.0;
  dJointSetLMotorParam(body.PlanarMotor, dParamFMax, force);
  dJointSetLMotorParam(body.PlanarMotor, dParamFMax2, force);
  dJointSetAMotorParam(body.YawMotor, dParamVel, command.YawRate);
  dJointSetAMotorParam(body.YawMotor, dParamFMax, body.HasGroundContact ? drive.MaxTorque : 0.0);
}

namespace {

// parts are missing if the building was interrupted
void DestroyJoint(dJointID joint) {
  if (joint != nullptr) {
    dJointDestroy(joint);
  }
}

void DestroyPart(dBodyID part) {
  if (part != nullptr) {
    dBodyDestroy(part);
  }
}

}  // namespace

void DestroyRigidParts(SRigidParts& parts) {
  for (const dGeomID geom : parts.Solids) {
    dGeomDestroy(geom);
  }
  for (size_t i = 0; i < parts.Wheels.size(); ++i) {
    DestroyJoint(parts.Axles[i]);
    DestroyPart(parts.Wheels[i]);
  }
  DestroyJoint(parts.PlanarMotor);
  DestroyJoint(parts.YawMotor);
  DestroyPart(parts.Body);
  parts = {};
}

void DestroyRigidBody(SRigidBody& body) {
  for (const SRigidLink& link : body.Links) {
    DestroyJoint(link.Joint);
    DestroyPart(link.Part);
  }
  body.Links.clear();
  DestroyRigidParts(body);
}

void PlaceRigidBody(SRigidBody& body, const SRigidPose& pose, const SRigidMotion& motion) {
  const CQuaternion& orientation = pose.Orientation;
  for (size_t i = 0; i < body.Solids.size(); ++i) {
    if (dGeomGetBody(body.Solids[i]) == nullptr) {
      PutFixedSolid(body.Solids[i], body.Source.Description->Shapes[i], pose);
    }
  }
  if (!body.IsMovable()) {
    body.Fixed = pose;
    return;
  }
  const CVector3 centre = Rotated(body.CentreOfMass, orientation);
  PutPart(body.Body, pose.Position + centre, orientation, motion.Velocity, motion.AngularVelocity);
  PlaceLinks(body, pose, motion);
  const CVector3 axis = Rotated(CVector3::Y, orientation);
  for (size_t i = 0; body.HasWheels() && i < body.Wheels.size(); ++i) {
    const CVector3 offset = Rotated(GetWheelOffset(body, i), orientation);
    PutPart(body.Wheels[i], pose.Position + offset, orientation,
            motion.Velocity + Cross(motion.AngularVelocity, offset - centre),
            motion.AngularVelocity + axis * motion.WheelSpins[i]);
  }
}

void WakeRigidBody(SRigidBody& body) {
  body.QuietTime = 0.0;
  body.Dozes = false;
  if (body.Asleep) {
    body.Asleep = false;
    ForEachPart(body, &dBodyEnable);
  }
}

void PutToSleep(SRigidBody& body) {
  body.Asleep = true;
  // otherwise the rest of its motion would continue when it wakes
  ForEachPart(body, [](dBodyID part) {
    dBodySetLinearVel(part, 0.0, 0.0, 0.0);
    dBodySetAngularVel(part, 0.0, 0.0, 0.0);
    dBodyDisable(part);
  });
}

SRigidPose GetRigidPose(const SRigidBody& body) {
  if (body.IsFree) {
    return GetRollPose(body.Roll);
  }
  const CQuaternion orientation = QuaternionFromODE(dBodyGetQuaternion(body.Body));
  return {FromODE(dBodyGetPosition(body.Body)) - Rotated(body.CentreOfMass, orientation),
          orientation};
}

CVector3 GetRigidVelocity(const SRigidBody& body) {
  return body.IsFree ? GetRollMotion(body).Velocity : FromODE(dBodyGetLinearVel(body.Body));
}

CVector3 GetRigidAngularVelocity(const SRigidBody& body) {
  return body.IsFree ? GetRollMotion(body).AngularVelocity : FromODE(dBodyGetAngularVel(body.Body));
}

SRigidMotion GetRigidMotion(const SRigidBody& body) {
  if (body.IsFree) {
    return GetRollMotion(body);
  }
  SRigidMotion motion;
  motion.Velocity = FromODE(dBodyGetLinearVel(body.Body));
  motion.AngularVelocity = FromODE(dBodyGetAngularVel(body.Body));
  for (size_t i = 0; body.HasWheels() && i < body.Wheels.size(); ++i) {
    motion.WheelSpins[i] = dJointGetHingeAngleRate(body.Axles[i]);
  }
  for (const SRigidLink& link : body.Links) {
    motion.Links.push_back(
        {FromODE(dBodyGetLinearVel(link.Part)), FromODE(dBodyGetAngularVel(link.Part))});
  }
  return motion;
}

}  // namespace argos
