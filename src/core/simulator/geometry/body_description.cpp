#include <argos3/core/simulator/geometry/body_description.h>

#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/core/simulator/geometry/bounding_box.h>
#include <argos3/core/simulator/geometry/convex_polygon.h>
#include <argos3/core/simulator/geometry/convex_solid.h>
#include <argos3/core/utility/configuration/value_range.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/angles.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

void RequirePositive(Real value, const char* what) {
  if (!IsIn(kSolidLength, value)) {
    THROW_ARGOSEXCEPTION("the " << what << " of a solid must be a positive number of metres, from "
                                << kSolidLength.Min << " to " << kSolidLength.Max << ", not "
                                << value);
  }
}

Real HorizontalDistance(const CVector3& point) {
  return std::hypot(point.GetX(), point.GetY());
}

CVector3 Rotated(CVector3 vector, const CQuaternion& rotation) {
  return vector.Rotate(rotation);
}

const std::vector<CVector2>& CornersOf(const SShapeDescription& prism) {
  if (prism.Vertices == nullptr) {
    THROW_ARGOSEXCEPTION("a solid of kind Prism has no Vertices: use SShapeDescription::Prism()");
  }
  return *prism.Vertices;
}

// the point of a solid at that place of its base and height, in the body frame
CVector3 InBody(const SShapeDescription& shape, Real x, Real y, Real z) {
  return shape.Offset + Rotated(CVector3(x, y, z), shape.Orientation);
}

Real HorizontalReach(const SShapeDescription& shape) {
  if (shape.Kind == SShapeDescription::EKind::Sphere) {
    return HorizontalDistance(shape.ComputeMiddle()) + shape.Radius;
  }
  const CVector3 top = Rotated(CVector3(0.0, 0.0, shape.Size.GetZ()), shape.Orientation);
  if (shape.Kind == SShapeDescription::EKind::Cylinder) {
    // a tilted disc reaches sideways by at most its radius
    return std::max(HorizontalDistance(shape.Offset), HorizontalDistance(shape.Offset + top)) +
           shape.Radius;
  }
  Real reach = 0.0;
  if (shape.Kind == SShapeDescription::EKind::Prism) {
    for (const CVector2& corner : CornersOf(shape)) {
      for (const Real height : {0.0, shape.Size.GetZ()}) {
        reach = std::max(reach,
                         HorizontalDistance(InBody(shape, corner.GetX(), corner.GetY(), height)));
      }
    }
    return reach;
  }
  if (shape.Kind == SShapeDescription::EKind::Hull) {
    for (const CVector3& corner : shape.Solid->GetCorners()) {
      reach = std::max(
          reach, HorizontalDistance(InBody(shape, corner.GetX(), corner.GetY(), corner.GetZ())));
    }
    return reach;
  }
  for (int corner = 0; corner < 8; ++corner) {
    const CVector3 inBody =
        InBody(shape, (corner & 1 ? 0.5 : -0.5) * shape.Size.GetX(),
               (corner & 2 ? 0.5 : -0.5) * shape.Size.GetY(), corner & 4 ? shape.Size.GetZ() : 0.0);
    reach = std::max(reach, HorizontalDistance(inBody));
  }
  return reach;
}

// the axis-aligned box around a rotated solid, from its middle
SBoundingBox ComputeExtents(const SShapeDescription& shape, const CQuaternion& orientation) {
  using EKind = SShapeDescription::EKind;
  if (shape.Kind == EKind::Sphere) {
    const CVector3 half(shape.Radius, shape.Radius, shape.Radius);
    return {-half, half};
  }
  const CVector3 alongZ = Rotated(CVector3(0.0, 0.0, 0.5 * shape.Size.GetZ()), orientation);
  if (shape.Kind == EKind::Hull) {
    SBoundingBox box;
    const CQuaternion toShape = orientation.Inverse();
    for (UInt32 i = 0; i < 3; ++i) {
      const CVector3 axis = Rotated(i == 0   ? CVector3::X
                                    : i == 1 ? CVector3::Y
                                             : CVector3::Z,
                                    toShape);
      box.MinCorner[i] = shape.Solid->FindFarthest(-axis).DotProduct(axis) - alongZ[i];
      box.MaxCorner[i] = shape.Solid->FindFarthest(axis).DotProduct(axis) - alongZ[i];
    }
    return box;
  }
  CVector3 half;
  if (shape.Kind == EKind::Cylinder) {
    // the projection of a disc on an axis at an angle a to its normal has the length 2 r sin a
    const CVector3 axis = Rotated(CVector3(0.0, 0.0, 1.0), orientation);
    for (UInt32 i = 0; i < 3; ++i) {
      half[i] =
          std::abs(alongZ[i]) + shape.Radius * std::sqrt(std::max(0.0, 1.0 - axis[i] * axis[i]));
    }
    return {-half, half};
  }
  if (shape.Kind == EKind::Prism) {
    const std::vector<CVector2>& corners = CornersOf(shape);
    const CVector3 axisX = Rotated(CVector3::X, orientation);
    const CVector3 axisY = Rotated(CVector3::Y, orientation);
    SBoundingBox box;
    for (UInt32 i = 0; i < 3; ++i) {
      const CVector2 direction(axisX[i], axisY[i]);
      const auto reach = [&](const CVector2& towards) {
        return direction.DotProduct(corners[FindFarthestCorner(corners, towards)]);
      };
      box.MinCorner[i] = reach(-direction) - std::abs(alongZ[i]);
      box.MaxCorner[i] = reach(direction) + std::abs(alongZ[i]);
    }
    return box;
  }
  const CVector3 alongX = Rotated(CVector3(0.5 * shape.Size.GetX(), 0.0, 0.0), orientation);
  const CVector3 alongY = Rotated(CVector3(0.0, 0.5 * shape.Size.GetY(), 0.0), orientation);
  for (UInt32 i = 0; i < 3; ++i) {
    half[i] = std::abs(alongX[i]) + std::abs(alongY[i]) + std::abs(alongZ[i]);
  }
  return {-half, half};
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

SShapeDescription SShapeDescription::Prism(std::vector<CVector2> vertices, Real height,
                                           const CVector3& offset) {
  RequirePositive(height, "height");
  vertices = MakeConvexPolygon(std::move(vertices));
  CVector2 low = vertices.front();
  CVector2 high = low;
  for (const CVector2& vertex : vertices) {
    low.Set(std::min(low.GetX(), vertex.GetX()), std::min(low.GetY(), vertex.GetY()));
    high.Set(std::max(high.GetX(), vertex.GetX()), std::max(high.GetY(), vertex.GetY()));
  }
  RequirePositive(high.GetX() - low.GetX(), "length");
  RequirePositive(high.GetY() - low.GetY(), "width");
  const CVector2 centre = (low + high) * 0.5;
  SShapeDescription shape;
  shape.Kind = EKind::Prism;
  shape.Offset = offset + CVector3(centre.GetX(), centre.GetY(), 0.0);
  shape.Size = CVector3(high.GetX() - low.GetX(), high.GetY() - low.GetY(), height);
  for (CVector2& vertex : vertices) {
    vertex -= centre;
    shape.Radius = std::max(shape.Radius, vertex.Length());
  }
  shape.Vertices = std::make_shared<const std::vector<CVector2>>(std::move(vertices));
  return shape;
}

SShapeDescription SShapeDescription::Hull(std::vector<CVector3> points, const CVector3& offset) {
  if (points.empty()) {
    THROW_ARGOSEXCEPTION("a convex hull needs at least four points that span a volume, found none");
  }
  CVector3 low = points.front();
  CVector3 high = low;
  for (const CVector3& point : points) {
    if (!std::isfinite(point.SquareLength())) {
      THROW_ARGOSEXCEPTION("the points of a convex hull must be finite, not (" << point << ")");
    }
    for (UInt32 axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  const CVector3 base(0.5 * (low.GetX() + high.GetX()), 0.5 * (low.GetY() + high.GetY()),
                      low.GetZ());
  SShapeDescription shape;
  shape.Kind = EKind::Hull;
  shape.Offset = offset + base;
  shape.Size = high - low;
  for (CVector3& point : points) {
    point -= base;
    shape.Radius = std::max(shape.Radius, HorizontalDistance(point));
  }
  shape.Solid = std::make_shared<const CConvexSolid>(points);
  for (UInt32 axis = 0; axis < 3; ++axis) {
    RequirePositive(shape.Size[axis], "extent");
  }
  return shape;
}

CVector3 SShapeDescription::ComputeMiddle() const {
  return InBody(*this, 0.0, 0.0, 0.5 * Size.GetZ());
}

CVector3 SShapeDescription::ComputeCentroid() const {
  if (Kind == EKind::Hull) {
    const CVector3& centroid = Solid->GetCentroid();
    return InBody(*this, centroid.GetX(), centroid.GetY(), centroid.GetZ());
  }
  if (Kind != EKind::Prism) {
    return ComputeMiddle();
  }
  const CVector2 base = ComputeMoments(CornersOf(*this)).Centroid;
  return InBody(*this, base.GetX(), base.GetY(), 0.5 * Size.GetZ());
}

Real SShapeDescription::ComputeVolume() const {
  switch (Kind) {
    case EKind::Box:
      return Size.GetX() * Size.GetY() * Size.GetZ();
    case EKind::Cylinder:
      return ARGOS_PI * Radius * Radius * Size.GetZ();
    case EKind::Prism:
      return ComputeMoments(CornersOf(*this)).Area * Size.GetZ();
    case EKind::Hull:
      return Solid->GetVolume();
    case EKind::Sphere:
      break;
  }
  return 4.0 / 3.0 * ARGOS_PI * Radius * Radius * Radius;
}

Real SShapeDescription::ComputeBaseWidth() const {
  return Kind == EKind::Prism ? ComputeLeastWidth(CornersOf(*this))
                              : std::min(Size.GetX(), Size.GetY());
}

// Source: tables of homogeneous cuboids, cylinders and balls, e.g. Goldstein, Classical Mechanics,
// ch. 5; of a prism: the sums of the mean squares of the coordinates.
SUnitInertia ComputeUnitInertia(const SShapeDescription& shape) {
  using EKind = SShapeDescription::EKind;
  const Real xx = shape.Size.GetX() * shape.Size.GetX();
  const Real yy = shape.Size.GetY() * shape.Size.GetY();
  const Real zz = shape.Size.GetZ() * shape.Size.GetZ();
  const Real rr = shape.Radius * shape.Radius;
  switch (shape.Kind) {
    case EKind::Box:
      return {(yy + zz) / 12.0, (xx + zz) / 12.0, (xx + yy) / 12.0, 0.0};
    case EKind::Cylinder:
      return {(3.0 * rr + zz) / 12.0, (3.0 * rr + zz) / 12.0, 0.5 * rr, 0.0};
    case EKind::Prism: {
      const SPolygonMoments base = ComputeMoments(CornersOf(shape));
      return {base.MeanYY + zz / 12.0, base.MeanXX + zz / 12.0, base.MeanXX + base.MeanYY,
              base.MeanXY};
    }
    case EKind::Hull: {
      const CVector3& squares = shape.Solid->GetSquares();
      const CVector3& products = shape.Solid->GetProducts();
      return {squares.GetY() + squares.GetZ(),
              squares.GetX() + squares.GetZ(),
              squares.GetX() + squares.GetY(),
              products.GetZ(),
              products.GetY(),
              products.GetX()};
    }
    case EKind::Sphere:
      break;
  }
  return {0.4 * rr, 0.4 * rr, 0.4 * rr, 0.0};
}

Real SBodyDescription::AssumeWheelRadius() const {
  constexpr Real kShare = 0.2;  // share of the height, or of the shortest distance to a side
  const SBoundingBox box = ComputeBoundingBox(CVector3(), CQuaternion());
  return kShare * std::min({box.MaxCorner.GetX(), -box.MinCorner.GetX(), box.MaxCorner.GetY(),
                            -box.MinCorner.GetY(), box.MaxCorner.GetZ() - box.MinCorner.GetZ()});
}

Real SBodyDescription::ComputeBoundingRadius() const {
  Real radius = 0.0;
  for (const SShapeDescription& shape : Shapes) {
    radius = std::max(radius, HorizontalReach(shape));
  }
  return radius;
}

std::vector<Real> SBodyDescription::ComputeWeights() const {
  std::vector<Real> weights;
  Real given = 0.0;
  Real volume = 0.0;
  for (const SShapeDescription& shape : Shapes) {
    weights.push_back(shape.Mass > 0.0 ? shape.Mass : shape.ComputeVolume());
    given += shape.Mass;
    volume += shape.Mass > 0.0 ? 0.0 : weights.back();
  }
  for (size_t i = 0; given > 0.0 && i < Shapes.size(); ++i) {
    if (!(Shapes[i].Mass > 0.0)) {
      weights[i] *= std::max(Mass - given, 0.0) / volume;
    }
  }
  return weights;
}

CVector3 SBodyDescription::ComputeCentreOfMass() const {
  const std::vector<Real> weights = ComputeWeights();
  Real sum = 0.0;
  CVector3 weighted;
  for (size_t i = 0; i < Shapes.size(); ++i) {
    weighted += Shapes[i].ComputeCentroid() * weights[i];
    sum += weights[i];
  }
  return sum > 0.0 ? weighted * (1.0 / sum) : CVector3();
}

Real SBodyDescription::ComputePlanarInertia() const {
  const std::vector<Real> weights = ComputeWeights();
  Real sum = 0.0;
  Real weighted = 0.0;
  for (size_t i = 0; i < Shapes.size(); ++i) {
    // the vertical in the frame of the solid
    const CVector3 up = Rotated(CVector3(0.0, 0.0, 1.0), Shapes[i].Orientation.Inverse());
    const SUnitInertia inertia = ComputeUnitInertia(Shapes[i]);
    Real moment = 0.0;
    moment += inertia.XX * up.GetX() * up.GetX();
    moment += inertia.YY * up.GetY() * up.GetY();
    moment += inertia.ZZ * up.GetZ() * up.GetZ();
    moment -= 2.0 * inertia.XY * up.GetX() * up.GetY();
    moment -= 2.0 * inertia.XZ * up.GetX() * up.GetZ();
    moment -= 2.0 * inertia.YZ * up.GetY() * up.GetZ();
    // parallel axis theorem
    const Real distance = HorizontalDistance(Shapes[i].ComputeCentroid());
    sum += weights[i];
    weighted += weights[i] * (moment + distance * distance);
  }
  return sum > 0.0 ? Mass * weighted / sum : 0.0;
}

SBoundingBox SBodyDescription::ComputeBoundingBox(const CVector3& position,
                                                  const CQuaternion& orientation,
                                                  const SBodyPose* links) const {
  const SBodyPose origin{position, orientation};
  SBoundingBox box;
  for (size_t i = 0; i < Shapes.size(); ++i) {
    const SShapeDescription& shape = Shapes[i];
    const SBodyPose pose = links != nullptr ? Compose(origin, links[shape.Link]) : origin;
    const CVector3 middle = pose.Position + Rotated(shape.ComputeMiddle(), pose.Orientation);
    const SBoundingBox extents = ComputeExtents(shape, pose.Orientation * shape.Orientation);
    for (UInt32 axis = 0; axis < 3; ++axis) {
      const Real low = middle[axis] + extents.MinCorner[axis];
      const Real high = middle[axis] + extents.MaxCorner[axis];
      box.MinCorner[axis] = i == 0 ? low : std::min(box.MinCorner[axis], low);
      box.MaxCorner[axis] = i == 0 ? high : std::max(box.MaxCorner[axis], high);
    }
  }
  return box;
}

}  // namespace argos
