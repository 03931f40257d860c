#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>

#include <argos3/core/utility/spatial/planar_grid.h>

#include <algorithm>
#include <cmath>

namespace argos {

using EKind = SShapeDescription::EKind;

bool IsUpright(const SShapeDescription& shape) {
  return shape.Kind == EKind::Sphere ||
         (shape.Orientation.GetX() == 0.0 && shape.Orientation.GetY() == 0.0);
}

bool IsDisc(const SShapeDescription& shape) {
  return shape.Kind == EKind::Sphere || (shape.Kind == EKind::Cylinder && IsUpright(shape));
}

Real ComputeYaw(const SShapeDescription& shape) {
  return 2.0 * std::atan2(shape.Orientation.GetZ(), shape.Orientation.GetW());
}

// The rectangle around a tilted solid seen from above, in the frame of its body; its x axis points
// where the solid leans.
SFootprint EncloseTilted(const SShapeDescription& shape) {
  CVector3 up = CVector3::Z;
  up.Rotate(shape.Orientation);
  const Real lean = std::hypot(up.GetX(), up.GetY());
  const Real cosine = lean > 0.0 ? up.GetX() / lean : 1.0;
  const Real sine = lean > 0.0 ? up.GetY() / lean : 0.0;
  SPlanarArea area = SPlanarArea::Empty();
  for (UInt32 i = 0; i < 8; ++i) {
    CVector3 corner(((i & 1U) != 0 ? 0.5 : -0.5) * shape.Size.GetX(),
                    ((i & 2U) != 0 ? 0.5 : -0.5) * shape.Size.GetY(),
                    (i & 4U) != 0 ? shape.Size.GetZ() : 0.0);
    corner.Rotate(shape.Orientation);
    area.Include(cosine * corner.GetX() + sine * corner.GetY(),
                 cosine * corner.GetY() - sine * corner.GetX());
  }
  const Real x = 0.5 * (area.MinX + area.MaxX);
  const Real y = 0.5 * (area.MinY + area.MaxY);
  return {shape.Offset.GetX() + cosine * x - sine * y,
          shape.Offset.GetY() + sine * x + cosine * y,
          cosine,
          sine,
          0.5 * (area.MaxX - area.MinX),
          0.5 * (area.MaxY - area.MinY),
          0.0};
}

SFootprint PlaceFootprint(const SFootprint& footprint, Real x, Real y, Real cosine, Real sine) {
  SFootprint placed = footprint;
  placed.X = x + cosine * footprint.X - sine * footprint.Y;
  placed.Y = y + sine * footprint.X + cosine * footprint.Y;
  placed.Cos = cosine * footprint.Cos - sine * footprint.Sin;
  placed.Sin = sine * footprint.Cos + cosine * footprint.Sin;
  return placed;
}

void AppendFootprints(const SBodyDescription& description, const SPlanarPose& pose,
                      std::vector<SFootprint>& footprints) {
  const Real bodyYaw = pose.ComputeYaw();
  const Real cosine = std::cos(bodyYaw);
  const Real sine = std::sin(bodyYaw);
  for (const SShapeDescription& shape : description.Shapes) {
    const Real x = shape.Offset.GetX();
    const Real y = shape.Offset.GetY();
    SFootprint footprint = {
        pose.X + cosine * x - sine * y, pose.Y + sine * x + cosine * y, 1.0, 0.0, 0.0, 0.0, 0.0};
    if (IsDisc(shape)) {
      footprint.Radius = shape.Radius;
    } else if (IsUpright(shape)) {
      const Real yaw = bodyYaw + ComputeYaw(shape);
      footprint.Cos = std::cos(yaw);
      footprint.Sin = std::sin(yaw);
      footprint.HalfX = 0.5 * shape.Size.GetX();
      footprint.HalfY = 0.5 * shape.Size.GetY();
      footprint.Polygon = shape.Vertices.get();
    } else {
      footprint = PlaceFootprint(EncloseTilted(shape), pose.X, pose.Y, cosine, sine);
    }
    footprints.push_back(footprint);
  }
}

std::vector<SFootprint> DescribeFootprints(const SBodyDescription& description,
                                           const SPlanarPose& pose) {
  std::vector<SFootprint> footprints;
  AppendFootprints(description, pose, footprints);
  return footprints;
}

bool IsCentredDisc(const SBodyDescription& description) {
  return description.Shapes.size() == 1 && IsDisc(description.Shapes.front()) &&
         description.Shapes.front().Offset.GetX() == 0.0 &&
         description.Shapes.front().Offset.GetY() == 0.0;
}

Real ComputeNarrowestHalf(const SBodyDescription& description) {
  Real narrowest = HUGE_VAL;
  for (const SShapeDescription& shape : description.Shapes) {
    if (IsDisc(shape)) {
      narrowest = std::min(narrowest, shape.Radius);
    } else {
      narrowest = std::min(narrowest, 0.5 * shape.ComputeBaseWidth());
      if (!IsUpright(shape)) {
        narrowest = std::min(narrowest, 0.5 * shape.Size.GetZ());
      }
    }
  }
  return narrowest;
}

void AppendImages(const SPeriodicity& period, std::vector<SFootprint>& footprints) {
  if (!period.IsOn()) {
    return;
  }
  const size_t count = footprints.size();
  for (size_t i = 0; i < count; ++i) {
    const SFootprint footprint = footprints[i];
    const SPlanarVector half = ComputeHalfBounds(footprint);
    SPlanarArea bounds = SPlanarArea::Empty();
    bounds.Include(footprint.X, footprint.Y, half.X + footprint.Radius, half.Y + footprint.Radius);
    period.ForDisplacements(bounds, [&](Real dx, Real dy) {
      if (dx != 0.0 || dy != 0.0) {
        footprints.push_back(Displace(footprint, dx, dy));
      }
    });
  }
}

}  // namespace argos
