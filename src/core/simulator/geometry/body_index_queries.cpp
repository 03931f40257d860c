#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/geometry/convex_polygon.h>
#include <argos3/core/simulator/geometry/convex_solid.h>
#include <argos3/core/simulator/geometry/shape_overlap.h>
#include <argos3/core/simulator/geometry/solid_overlap.h>
#include <argos3/core/utility/memory/load_ahead.h>

namespace argos {

namespace {

// the ray in the frame of a solid: origin at the centre of its base
CRay3 ToSolidFrame(const CRay3& ray, const SBodyPose& origin, const SShapeDescription& solid) {
  const auto toFrame = [&](CVector3 point) {
    point -= origin.Position;
    point.Rotate(origin.Orientation.Inverse());
    point -= solid.Offset;
    point.Rotate(solid.Orientation.Inverse());
    return point;
  };
  return CRay3(toFrame(ray.GetStart()), toFrame(ray.GetEnd()));
}

// fraction at which the ray enters a sphere with its lowest point at the origin, or kNoHit
Real IntersectSphere(Real radius, const CRay3& ray) {
  CVector3 p = ray.GetStart();
  p.SetZ(p.GetZ() - radius);
  const CVector3 d = ray.GetEnd() - ray.GetStart();
  return FindNegative(d.SquareLength(), p.DotProduct(d), p.SquareLength() - radius * radius)
      .FindEntry();
}

// the same for a prism with the centre of its base at the origin
Real IntersectPrism(const SShapeDescription& prism, const CRay3& ray) {
  const CVector3& p = ray.GetStart();
  const CVector3 d = ray.GetEnd() - p;
  SRaySpan span =
      IntersectPolygon(*prism.Vertices, CVector2(p.GetX(), p.GetY()), CVector2(d.GetX(), d.GetY()));
  span.ClipToSlab(p.GetZ(), d.GetZ(), 0.0, prism.Size.GetZ());
  return span.FindEntry();
}

}  // namespace

// exact, because both numbers are computed in the same way
CVector3 CBodyIndex::FindDisplacement(const SIndexedShape& shape) const {
  if (!m_period.IsOn()) {
    return CVector3();
  }
  const SIndexedShape own = Pack(shape.Body, shape.Shape);
  return CVector3(m_period.X.RoundToPeriods(shape.X - own.X),
                  m_period.Y.RoundToPeriods(shape.Y - own.Y), 0.0);
}

Real CBodyIndex::Intersect(const SIndexedShape& shape, const CRay3& ray) const {
  if (shape.Kind != SIndexedShape::EKind::Bounds) {
    return IntersectRay(shape, ray);
  }
  const SBody& body = m_bodies[shape.Body];
  const SShapeDescription& solid = body.Description->Shapes[shape.Shape];
  SBodyPose pose = PoseOf(body, solid);
  pose.Position += FindDisplacement(shape);
  const CRay3 local = ToSolidFrame(ray, pose, solid);
  if (solid.Kind == SShapeDescription::EKind::Sphere) {
    return IntersectSphere(solid.Radius, local);
  }
  if (solid.Kind == SShapeDescription::EKind::Prism) {
    return IntersectPrism(solid, local);
  }
  if (solid.Kind == SShapeDescription::EKind::Hull) {
    return solid.Solid->Intersect(local);
  }
  SShapeDescription upright = solid;
  upright.Offset = CVector3();
  upright.Orientation = CQuaternion();
  return IntersectRay(Pack(upright, MakePose(CVector3(), CQuaternion()), CQuaternion()), local);
}

bool CBodyIndex::FindClosestHit(SEmbodiedEntityIntersectionItem& item, const CRay3& ray,
                                const CEmbodiedEntity* ignored) const {
  item = SEmbodiedEntityIntersectionItem();
  UInt32 closestBody = kNoBody;
  ForShapesAlongRay(ray, SRayReach(), [&](const SIndexedShape& shape) {
    const Real t = Intersect(shape, ray);
    if (t > item.TOnRay || (t == item.TOnRay && shape.Body >= closestBody) ||
        m_bodies[shape.Body].Entity == ignored) {
      return;
    }
    item = {m_bodies[shape.Body].Entity, t};
    closestBody = shape.Body;
  });
  return closestBody != kNoBody;
}

void CBodyIndex::FindAllHits(TEmbodiedEntityIntersectionData& data, const CRay3& ray) const {
  ForShapesAlongRay(ray, SRayReach(), [&](const SIndexedShape& shape) {
    const Real t = Intersect(shape, ray);
    if (t > 1.0) {
      return;
    }
    CEmbodiedEntity* const body = m_bodies[shape.Body].Entity;
    for (SEmbodiedEntityIntersectionItem& known : data) {
      if (known.IntersectedEntity == body) {
        known.TOnRay = std::min(known.TOnRay, t);
        return;
      }
    }
    data.emplace_back(body, t);
  });
}

// finds any solid that the segment meets and that belongs to neither body
bool CBodyIndex::FindOccluder(SIndexedShape& found, const CRay3& segment, UInt32 start,
                              UInt32 end) const {
  const Real x = segment.GetStart().GetX();
  const Real y = segment.GetStart().GetY();
  const Real dx = segment.GetEnd().GetX() - x;
  const Real dy = segment.GetEnd().GetY() - y;
  // skips solids that are farther from the line than their radius, seen from above; tolerates
  // rounding, because the exact test decides
  const Real squareLength = (dx * dx + dy * dy) * (1.0 + 1e-9);
  bool isFound = false;
  ForShapesAlongRays(
      std::array{segment}, SRayReach(),
      [&](const SIndexedShape& shape) {
        const bool isNear = IsCircleOnLine(shape.X - x, shape.Y - y, dx, dy,
                                           shape.Radius * shape.Radius, squareLength);
        if (!isFound && isNear && shape.Body != start && shape.Body != end &&
            Intersect(shape, segment) <= 1.0) {
          found = shape;
          isFound = true;
        }
      },
      [&isFound] { return isFound; });
  return isFound;
}

// fraction at which the ray enters a body, in the image nearest to the ray's end, or kNoHit
Real CBodyIndex::IntersectBody(UInt32 body, const CRay3& ray) const {
  Real first = kNoHit;
  if (body != kNoBody) {
    const CVector3& end = ray.GetEnd();
    VisitBody(body, [&](const SIndexedShape& shape) {
      const SIndexedShape nearest = Displace(shape, m_period.X.RoundToPeriods(end.GetX() - shape.X),
                                             m_period.Y.RoundToPeriods(end.GetY() - shape.Y));
      first = std::min(first, Intersect(nearest, ray));
    });
  }
  return first;
}

bool CBodyIndex::IsBlocked(const CRay3& segment, UInt32 start, UInt32 end) const {
  SIndexedShape occluder{};
  if (!FindOccluder(occluder, segment, start, end)) {
    return false;
  }
  // robots in contact overlap a little: the part of a solid inside either body occludes nothing
  const Real enter = IntersectBody(end, segment);
  const Real leave = IntersectBody(start, CRay3(segment.GetEnd(), segment.GetStart()));
  const Real first = leave > 1.0 ? 0.0 : 1.0 - leave;
  const Real last = std::min(enter, 1.0);
  if (first >= last) {
    return false;
  }
  const CVector3 from = segment.GetStart();
  const CVector3 way = segment.GetEnd() - from;
  const CRay3 between(from + first * way, from + last * way);
  return Intersect(occluder, between) <= 1.0 || FindOccluder(occluder, between, start, end);
}

Real CBodyIndex::ComputeReach(UInt32 number, Real x, Real y) const {
  if (number == kNoBody || m_bodies[number].Entity == nullptr) {
    return 0.0;
  }
  const SBody& body = m_bodies[number];
  if (body.Links != nullptr) {
    return HUGE_VAL;
  }
  const SPose& pose = m_poses[number];
  const Real dx = m_period.X.Shorten(pose.X - x);
  const Real dy = m_period.Y.Shorten(pose.Y - y);
  return std::sqrt(dx * dx + dy * dy) + (pose.Upright ? body.Reach : body.TiltedReach);
}

UInt32 CBodyIndex::FindOverlap(const SBodyDescription& description, const CVector3& position,
                               const CQuaternion& orientation, UInt32 ignored,
                               const SBodyPose* links) const {
  UInt32 found = kNoBody;
  const SBodyPose origin{position, orientation};
  const auto place = [this](const SIndexedShape& shape) {
    const SBody& body = m_bodies[shape.Body];
    const SShapeDescription& solid = body.Description->Shapes[shape.Shape];
    const SBodyPose pose = PoseOf(body, solid);
    return SPlacedSolid{&solid, pose.Position + FindDisplacement(shape), pose.Orientation};
  };
  for (const SShapeDescription& solid : description.Shapes) {
    const SBodyPose placed = links != nullptr ? Compose(origin, links[solid.Link]) : origin;
    const SIndexedShape shape =
        Pack(solid, MakePose(placed.Position, placed.Orientation), placed.Orientation);
    ForShapesNear(shape.X, shape.Y, shape.Radius, [&](const SIndexedShape& other) {
      if (other.Body == ignored || other.Body >= found || !ShapesOverlap(shape, other)) {
        return;
      }
      // ShapesOverlap() has tested only the bounds of other solids
      const bool isExact =
          shape.Kind != SIndexedShape::EKind::Bounds && other.Kind != SIndexedShape::EKind::Bounds;
      if (isExact || SolidsOverlap({&solid, placed.Position, placed.Orientation}, place(other))) {
        found = other.Body;
      }
    });
  }
  return found;
}

void CBodyIndex::LoadListsAhead(Real x, Real y, Real reach) const {
  if (m_shapes.empty()) {
    return;
  }
  // the radius of this body and that of the other one are both at most SmallReach()
  const SCellRange cells = m_grid.CellsAround(x, y, reach + 2.0 * SmallReach());
  m_grid.ForRows(cells, [this](UInt32 first, UInt32 last) {
    const UInt32 begin = m_sort.Begin(first);
    LoadAhead(m_shapes.data() + begin, (m_sort.End(last) - begin) * sizeof(SPackedShape));
  });
}

}  // namespace argos
