#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/periodicity.h>
#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/core/utility/configuration/value_range.h>
#include <argos3/core/utility/spatial/planar_grid.h>
#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace argos {

namespace {

// m; positions in files are rounded
constexpr Real kElevationTolerance = 1e-4;
// m; farther away, positions in the world are resolved to less than 1e-10 m
constexpr Real kMaxExtent = 1e6;
// moments of inertia, forces and torques; their inverses are numbers of single precision
constexpr SValueRange kPlanarPositive = {1e-18, 1e18};

void RequirePositive(const CEmbodiedEntity& body, const char* what, Real value) {
  if (!(value > 0.0)) {
    THROW_ARGOSEXCEPTION("the " << what << " of \"" << body.GetRootEntity().GetId()
                                << "\" must be a number > 0, found " << value);
  }
  // bodies that cross a border are checked in every tick: without a text, nothing is allocated
  if (!IsIn(kPlanarPositive, value)) {
    RequireIn(kPlanarPositive, value, '"' + body.GetRootEntity().GetId() + '"', what);
  }
}

// the axis-aligned rectangle around a rotated solid, m, from the centre of its base
SPlanarArea ComputeExtents(const SShapeDescription& shape, const SPlanarPose& pose) {
  const auto around = [](Real x, Real y) { return SPlanarArea{-x, -y, x, y}; };
  const CQuaternion& turn = shape.Orientation;
  if (turn.GetX() != 0.0 || turn.GetY() != 0.0) {
    // tilted: no point is farther from the centre of the base
    const Real reach = shape.Size.Length();
    return around(reach, reach);
  }
  if (IsDisc(shape)) {
    return around(shape.Radius, shape.Radius);
  }
  const Real yaw = pose.ComputeYaw() + ComputeYaw(shape);
  const Real cosine = std::cos(yaw);
  const Real sine = std::sin(yaw);
  if (shape.Kind == SShapeDescription::EKind::Prism) {
    SPlanarArea area = SPlanarArea::Empty();
    for (const CVector2& corner : *shape.Vertices) {
      area.Include(cosine * corner.GetX() - sine * corner.GetY(),
                   sine * corner.GetX() + cosine * corner.GetY());
    }
    return area;
  }
  const Real width = std::abs(cosine);
  const Real depth = std::abs(sine);
  return around(0.5 * (width * shape.Size.GetX() + depth * shape.Size.GetY()),
                0.5 * (depth * shape.Size.GetX() + width * shape.Size.GetY()));
}

}  // namespace

void ReadNotNegative(TConfigurationNode& node, const std::string& attribute, Real& value) {
  GetNodeAttributeOrDefault(node, attribute, value, value);
  if (!(value >= 0.0)) {
    THROW_ARGOSEXCEPTION(node.GetLocation() << ": <" << node.Value() << ">: \"" << attribute
                                            << "\" must be a number >= 0, found " << value);
  }
  RequireIn(kNotNegative, value, node.GetLocation() + ": <" + node.Value() + '>',
            '"' + attribute + '"');
}

Real ReadVelocityLag(TConfigurationNode& engine, UInt32 iterations) {
  constexpr Real kDefaultLag = 0.1;
  const bool hasIterations = NodeAttributeExists(engine, "iterations");
  Real lag = hasIterations ? 1.0 / iterations : kDefaultLag;
  GetNodeAttributeOrDefault(engine, "velocity_lag", lag, lag);
  if (!(lag >= 0.0 && lag <= 1.0)) {
    THROW_ARGOSEXCEPTION(engine.GetLocation()
                         << ": \"velocity_lag\" must be a share of a tick, from 0 to 1, found "
                         << lag);
  }
  return lag;
}

SDriveCommand FindCommand(const SBodyMotion& motion, const CEmbodiedEntity& body) {
  if (motion.Command) {
    return *motion.Command;
  }
  CVector3 velocity = motion.Velocity;
  velocity.Rotate(body.GetOriginAnchor().Orientation.Inverse());
  return {velocity.GetX(), velocity.GetY(), motion.Rotation.GetZ()};
}

void ReadGroundFriction(TConfigurationNode& engine, SGroundFriction& box,
                        SGroundFriction& cylinder) {
  if (!NodeExists(engine, "friction")) {
    return;
  }
  TConfigurationNode& node = GetNode(engine, "friction");
  ReadNotNegative(node, "box_linear_friction", box.Force);
  ReadNotNegative(node, "box_angular_friction", box.Torque);
  ReadNotNegative(node, "cylinder_linear_friction", cylinder.Force);
  ReadNotNegative(node, "cylinder_angular_friction", cylinder.Torque);
}

SGroundFriction ChooseGroundFriction(const SBodyDescription& description,
                                     const SGroundFriction& box, const SGroundFriction& cylinder) {
  if (!description.GroundFriction) {
    return {0.0, 0.0};
  }
  const SGroundFrictionDescription& described = *description.GroundFriction;
  const bool isBox = described.Class == SGroundFrictionDescription::EClass::Box;
  const SGroundFriction& ofEngine = isBox ? box : cylinder;
  return {described.MaxForce.value_or(ofEngine.Force),
          described.MaxTorque.value_or(ofEngine.Torque)};
}

void RequirePeriod(const SPeriodicity& period, Real necessary) {
  for (const SPeriodicAxis* axis : {&period.X, &period.Y}) {
    if (axis->IsOn() && !(axis->Period > necessary)) {
      THROW_ARGOSEXCEPTION(
          "a periodic arena must be wider than four times what a body and its "
          "path in a tick need, "
          << necessary << " m here; found " << axis->Period << " m");
    }
  }
}

void CheckPlanarBody(const CEmbodiedEntity& body) {
  const SBodyDescription& description = *body.GetBodyDescription();
  const CVector3& position = body.GetOriginAnchor().Position;
  const Real reach = std::max(std::abs(position.GetX()), std::abs(position.GetY())) +
                     description.ComputeBoundingRadius();
  if (!(reach <= kMaxExtent)) {
    THROW_ARGOSEXCEPTION(
        "\"" << body.GetRootEntity().GetId() << "\" is too large or too far away: it reaches "
             << reach << " m from the origin, but physics in the plane is accurate only up to "
             << kMaxExtent << " m");
  }
  if (!body.IsMovable()) {
    return;
  }
  RequirePositive(body, "mass (kg)", description.Mass);
  if (description.PlanarInertia) {
    RequirePositive(body, "moment of inertia (kg m^2)", *description.PlanarInertia);
  }
  if (description.Drive) {
    RequirePositive(body, "distance between the wheels (m)", description.Drive->InterwheelDistance);
  }
  if (description.HasDrive()) {
    const SPlanarDriveDescription limits = description.GetDriveLimits();
    RequirePositive(body, "greatest force of the drive (N)", limits.MaxForce);
    RequirePositive(body, "greatest torque of the drive (N m)", limits.MaxTorque);
  }
}

bool IsOnPlane(const CEmbodiedEntity& body, Real elevation) {
  return std::abs(body.GetOriginAnchor().Position.GetZ() - elevation) <= kElevationTolerance;
}

std::string ExplainPlanarRefusal(CEntity& entity, Real elevation) {
  CEmbodiedEntity* const body = FindDescribedBody(entity);
  if (body == nullptr) {
    return "accepts only bodies with an SBodyDescription, and <" + entity.GetTypeDescription() +
           "> has none";
  }
  if (body->GetBodyDescription()->Propellers) {
    return "is two-dimensional, but a <" + entity.GetTypeDescription() +
           "> flies: add an engine for flying robots, such as <pointmass3d>";
  }
  if (body->GetBodyDescription()->Articulation != nullptr) {
    return "is two-dimensional, but a <" + entity.GetTypeDescription() +
           "> with joints moves in space: add an engine for jointed bodies, such as <dynamics3d>";
  }
  CTextOutput reason;
  const Real z = body->GetOriginAnchor().Position.GetZ();
  reason << "has its plane at z = " << elevation << " m, but the base of the body is at z = " << z
         << " m: put the body there, or set elevation=\"" << z << "\" of an engine";
  return reason.str();
}

SBoundingBox ComputePlanarBounds(const CEmbodiedEntity& body) {
  const SAnchor& origin = body.GetOriginAnchor();
  return ComputePlanarBounds(body, MakePlanarPose(origin.Position, origin.Orientation));
}

SBoundingBox ComputePlanarBounds(const CEmbodiedEntity& body, const SPlanarPose& pose) {
  const Real elevation = body.GetOriginAnchor().Position.GetZ();
  const Real cosine = pose.HalfCos * pose.HalfCos - pose.HalfSin * pose.HalfSin;
  const Real sine = 2.0 * pose.HalfSin * pose.HalfCos;
  SBoundingBox bounds;
  bool first = true;
  for (const SShapeDescription& shape : body.GetBodyDescription()->Shapes) {
    const SPlanarArea extents = ComputeExtents(shape, pose);
    const CVector3 base(pose.X + cosine * shape.Offset.GetX() - sine * shape.Offset.GetY(),
                        pose.Y + sine * shape.Offset.GetX() + cosine * shape.Offset.GetY(),
                        elevation + shape.Offset.GetZ());
    const CVector3 low = base + CVector3(extents.MinX, extents.MinY, 0.0);
    const CVector3 high = base + CVector3(extents.MaxX, extents.MaxY, shape.Size.GetZ());
    if (first) {
      bounds.MinCorner = low;
      bounds.MaxCorner = high;
      first = false;
      continue;
    }
    for (UInt32 axis = 0; axis < 3; ++axis) {
      bounds.MinCorner[axis] = std::min(bounds.MinCorner[axis], low[axis]);
      bounds.MaxCorner[axis] = std::max(bounds.MaxCorner[axis], high[axis]);
    }
  }
  return bounds;
}

}  // namespace argos
