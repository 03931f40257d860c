#include <argos3/core/simulator/geometry/body_description.h>

#include <argos3/core/simulator/geometry/bounding_box.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/angles.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

void RequirePositive(Real value, const char* what) {
  // written so that NaN fails too
  if (!(value > 0.0 && std::isfinite(value))) {
    THROW_ARGOSEXCEPTION("the " << what << " of a solid must be a positive number of metres, not "
                                << value);
  }
}

Real HorizontalDistance(const CVector3& point) {
  return std::hypot(point.GetX(), point.GetY());
}

CVector3 Rotated(CVector3 vector, const CQuaternion& rotation) {
  return vector.Rotate(rotation);
}

CVector3 Centroid(const SShapeDescription& shape) {
  return shape.Offset + Rotated(CVector3(0.0, 0.0, 0.5 * shape.Size.GetZ()), shape.Orientation);
}

Real Volume(const SShapeDescription& shape) {
  using EKind = SShapeDescription::EKind;
  const Real radius = shape.Radius;
  switch (shape.Kind) {
    case EKind::Box:
      return shape.Size.GetX() * shape.Size.GetY() * shape.Size.GetZ();
    case EKind::Cylinder:
      return ARGOS_PI * radius * radius * shape.Size.GetZ();
    case EKind::Sphere:
      break;
  }
  return 4.0 / 3.0 * ARGOS_PI * radius * radius * radius;
}

// Moments of inertia per kg about the axes through the centroid, m^2. Source: tables of homogeneous
// cuboids, cylinders and balls, e.g. Goldstein, Classical Mechanics, ch. 5.
CVector3 PrincipalMoments(const SShapeDescription& shape) {
  using EKind = SShapeDescription::EKind;
  const Real xx = shape.Size.GetX() * shape.Size.GetX();
  const Real yy = shape.Size.GetY() * shape.Size.GetY();
  const Real zz = shape.Size.GetZ() * shape.Size.GetZ();
  const Real rr = shape.Radius * shape.Radius;
  switch (shape.Kind) {
    case EKind::Box:
      return CVector3((yy + zz) / 12.0, (xx + zz) / 12.0, (xx + yy) / 12.0);
    case EKind::Cylinder:
      return CVector3((3.0 * rr + zz) / 12.0, (3.0 * rr + zz) / 12.0, 0.5 * rr);
    case EKind::Sphere:
      break;
  }
  return CVector3(0.4 * rr, 0.4 * rr, 0.4 * rr);
}

Real HorizontalReach(const SShapeDescription& shape) {
  if (shape.Kind == SShapeDescription::EKind::Sphere) {
    return HorizontalDistance(Centroid(shape)) + shape.Radius;
  }
  const CVector3 top = Rotated(CVector3(0.0, 0.0, shape.Size.GetZ()), shape.Orientation);
  if (shape.Kind == SShapeDescription::EKind::Cylinder) {
    // a tilted disc reaches sideways by at most its radius
    return std::max(HorizontalDistance(shape.Offset), HorizontalDistance(shape.Offset + top)) +
           shape.Radius;
  }
  Real reach = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const CVector3 inShape((corner & 1 ? 0.5 : -0.5) * shape.Size.GetX(),
                           (corner & 2 ? 0.5 : -0.5) * shape.Size.GetY(),
                           corner & 4 ? shape.Size.GetZ() : 0.0);
    const CVector3 inBody = shape.Offset + Rotated(inShape, shape.Orientation);
    reach = std::max(reach, HorizontalDistance(inBody));
  }
  return reach;
}

// half extents of the axis-aligned box around a rotated solid
CVector3 ComputeHalfExtents(const SShapeDescription& shape, const CQuaternion& orientation) {
  using EKind = SShapeDescription::EKind;
  if (shape.Kind == EKind::Sphere) {
    return CVector3(shape.Radius, shape.Radius, shape.Radius);
  }
  const CVector3 alongZ = Rotated(CVector3(0.0, 0.0, 0.5 * shape.Size.GetZ()), orientation);
  CVector3 half;
  if (shape.Kind == EKind::Cylinder) {
    // the projection of a disc on an axis at an angle a to its normal has the length 2 r sin a
    const CVector3 axis = Rotated(CVector3(0.0, 0.0, 1.0), orientation);
    for (UInt32 i = 0; i < 3; ++i) {
      half[i] =
          std::abs(alongZ[i]) + shape.Radius * std::sqrt(std::max(0.0, 1.0 - axis[i] * axis[i]));
    }
    return half;
  }
  const CVector3 alongX = Rotated(CVector3(0.5 * shape.Size.GetX(), 0.0, 0.0), orientation);
  const CVector3 alongY = Rotated(CVector3(0.0, 0.5 * shape.Size.GetY(), 0.0), orientation);
  for (UInt32 i = 0; i < 3; ++i) {
    half[i] = std::abs(alongX[i]) + std::abs(alongY[i]) + std::abs(alongZ[i]);
  }
  return half;
}

}  // namespace

SShapeDescription SShapeDescription::Box(const CVector3& size, const CVector3& offset) {
  RequirePositive(size.GetX(), "length");
  RequirePositive(size.GetY(), "width");
  RequirePositive(size.GetZ(), "height");
  SShapeDescription shape;
  shape.Kind = EKind::Box;
  shape.Offset = offset;
  shape.Size = size;
  shape.Radius = 0.5 * HorizontalDistance(size);
  return shape;
}

SShapeDescription SShapeDescription::Cylinder(Real radius, Real height, const CVector3& offset) {
  RequirePositive(radius, "radius");
  RequirePositive(height, "height");
  SShapeDescription shape;
  shape.Kind = EKind::Cylinder;
  shape.Offset = offset;
  shape.Size = CVector3(2.0 * radius, 2.0 * radius, height);
  shape.Radius = radius;
  return shape;
}

SShapeDescription SShapeDescription::Sphere(Real radius, const CVector3& offset) {
  RequirePositive(radius, "radius");
  SShapeDescription shape;
  shape.Kind = EKind::Sphere;
  shape.Offset = offset;
  shape.Size = CVector3(2.0 * radius, 2.0 * radius, 2.0 * radius);
  shape.Radius = radius;
  return shape;
}

Real SBodyDescription::ComputeBoundingRadius() const {
  Real radius = 0.0;
  for (const SShapeDescription& shape : Shapes) {
    radius = std::max(radius, HorizontalReach(shape));
  }
  return radius;
}

Real SBodyDescription::ComputePlanarInertia() const {
  Real volume = 0.0;
  Real momentPerDensity = 0.0;
  for (const SShapeDescription& shape : Shapes) {
    // the components of the vertical in the frame of the solid weight its principal moments
    const CVector3 vertical = Rotated(CVector3(0.0, 0.0, 1.0), shape.Orientation.Inverse());
    const CVector3 moments = PrincipalMoments(shape);
    Real moment = 0.0;
    for (UInt32 axis = 0; axis < 3; ++axis) {
      moment += moments[axis] * vertical[axis] * vertical[axis];
    }
    // parallel axis theorem
    const Real distance = HorizontalDistance(Centroid(shape));
    const Real shapeVolume = Volume(shape);
    volume += shapeVolume;
    momentPerDensity += shapeVolume * (moment + distance * distance);
  }
  return volume > 0.0 ? Mass * momentPerDensity / volume : 0.0;
}

SBoundingBox SBodyDescription::ComputeBoundingBox(const CVector3& position,
                                                  const CQuaternion& orientation) const {
  SBoundingBox box;
  for (size_t i = 0; i < Shapes.size(); ++i) {
    const CVector3 centre = position + Rotated(Centroid(Shapes[i]), orientation);
    const CVector3 half = ComputeHalfExtents(Shapes[i], orientation * Shapes[i].Orientation);
    for (UInt32 axis = 0; axis < 3; ++axis) {
      const Real low = centre[axis] - half[axis];
      const Real high = centre[axis] + half[axis];
      box.MinCorner[axis] = i == 0 ? low : std::min(box.MinCorner[axis], low);
      box.MaxCorner[axis] = i == 0 ? high : std::max(box.MaxCorner[axis], high);
    }
  }
  return box;
}

}  // namespace argos
