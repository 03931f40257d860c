#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/space/body_index.h>
#include <argos3/core/simulator/space/shape_overlap.h>

#include <limits>

namespace argos {

namespace {

// the ray in the frame of a solid: origin at the centre of its base
CRay3 ToSolidFrame(const CRay3& ray, const SAnchor& origin, const SShapeDescription& solid) {
  const auto toFrame = [&](CVector3 point) {
    point -= origin.Position;
    point.Rotate(origin.Orientation.Inverse());
    point -= solid.Offset;
    point.Rotate(solid.Orientation.Inverse());
    return point;
  };
  return CRay3(toFrame(ray.GetStart()), toFrame(ray.GetEnd()));
}

// fraction at which the ray enters a sphere of that radius that stands on the origin
Real IntersectSphere(Real radius, const CRay3& ray) {
  constexpr Real kMiss = 2.0;
  CVector3 p = ray.GetStart();
  p.SetZ(p.GetZ() - radius);
  const CVector3 d = ray.GetEnd() - ray.GetStart();
  const Real a = d.SquareLength();
  const Real b = p.DotProduct(d);
  const Real c = p.SquareLength() - radius * radius;
  if (c <= 0.0) {
    return 0.0;
  }
  const Real discriminant = b * b - a * c;
  if (a == 0.0 || discriminant < 0.0) {
    return kMiss;
  }
  const Real t = (-b - std::sqrt(discriminant)) / a;
  return t >= 0.0 && t <= 1.0 ? t : kMiss;
}

}  // namespace

Real CBodyIndex::Intersect(const SIndexedShape& shape, const CRay3& ray) const {
  if (shape.Kind != SIndexedShape::EKind::Tilted) {
    return IntersectRay(shape, ray);
  }
  const SBody& body = m_bodies[shape.Body];
  const SShapeDescription& solid = body.Description->Shapes[shape.Shape];
  const CRay3 local = ToSolidFrame(ray, body.Entity->GetOriginAnchor(), solid);
  if (solid.Kind == SShapeDescription::EKind::Sphere) {
    return IntersectSphere(solid.Radius, local);
  }
  SShapeDescription upright = solid;
  upright.Offset = CVector3();
  upright.Orientation = CQuaternion();
  return IntersectRay(Pack(upright, MakePose(CVector3(), CQuaternion()), CQuaternion()), local);
}

// visits every solid whose cells the ray comes near, row by row; wide solids perhaps repeatedly
template <typename VISIT>
void CBodyIndex::ForShapesAlongRay(const CRay3& ray, VISIT&& visit) const {
  const Real x0 = ray.GetStart().GetX();
  const Real y0 = ray.GetStart().GetY();
  const Real dx = ray.GetEnd().GetX() - x0;
  const Real dy = ray.GetEnd().GetY() - y0;
  const auto forRows = [&](Real margin, auto&& visitRow) {
    const int minJ = CellJ(std::min(y0, y0 + dy) - margin);
    const int maxJ = CellJ(std::max(y0, y0 + dy) + margin);
    for (int j = minJ; j <= maxJ; ++j) {
      // the part of the ray over this row, widened by the margin; border rows have no outer edge
      Real t0 = 0.0;
      Real t1 = 1.0;
      if (dy != 0.0) {
        const Real low = j == 0 ? -HUGE_VAL : m_minY + j * m_cell - margin;
        const Real high = j == m_numJ - 1 ? HUGE_VAL : m_minY + (j + 1) * m_cell + margin;
        const Real ta = (low - y0) / dy;
        const Real tb = (high - y0) / dy;
        t0 = std::max(t0, std::min(ta, tb));
        t1 = std::min(t1, std::max(ta, tb));
      }
      if (t0 > t1) {
        continue;
      }
      const Real xa = x0 + t0 * dx;
      const Real xb = x0 + t1 * dx;
      visitRow(j, CellI(std::min(xa, xb) - margin), CellI(std::max(xa, xb) + margin));
    }
  };
  // a rounding more than the radius, so that a touched border counts
  const Real margin = SmallReach() + 1e-9;
  if (!m_shapes.empty()) {
    forRows(margin, [&](int j, int minI, int maxI) { VisitSmallRow(j, minI, maxI, visit); });
  }
  if (!m_overlayCells.empty()) {
    forRows(margin, [&](int j, int minI, int maxI) { VisitOverlayRow(j, minI, maxI, visit); });
  }
  if (!m_overlayWide.empty()) {
    forRows(1e-9, [&](int j, int minI, int maxI) { VisitOverlayWide({minI, maxI, j, j}, visit); });
  }
  if (!m_wide.empty()) {
    forRows(1e-9, [&](int j, int minI, int maxI) { VisitWide({minI, maxI, j, j}, visit); });
  }
}

bool CBodyIndex::FindClosestHit(SEmbodiedEntityIntersectionItem& item, const CRay3& ray,
                                const CEmbodiedEntity* ignored) const {
  item = SEmbodiedEntityIntersectionItem();
  Real closest = std::numeric_limits<Real>::infinity();
  UInt32 closestBody = kNoBody;
  ForShapesAlongRay(ray, [&](const SIndexedShape& shape) {
    const Real t = Intersect(shape, ray);
    if (t > 1.0 || t > closest || (t == closest && shape.Body >= closestBody) ||
        m_bodies[shape.Body].Entity == ignored) {
      return;
    }
    closest = t;
    closestBody = shape.Body;
  });
  if (closestBody == kNoBody) {
    return false;
  }
  item.IntersectedEntity = m_bodies[closestBody].Entity;
  item.TOnRay = closest;
  return true;
}

void CBodyIndex::FindAllHits(TEmbodiedEntityIntersectionData& data, const CRay3& ray) const {
  ForShapesAlongRay(ray, [&](const SIndexedShape& shape) {
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

UInt32 CBodyIndex::FindOverlap(const SBodyDescription& description, const CVector3& position,
                               const CQuaternion& orientation, UInt32 ignored) const {
  UInt32 found = kNoBody;
  const SPose pose = MakePose(position, orientation);
  for (const SShapeDescription& solid : description.Shapes) {
    const SIndexedShape shape = Pack(solid, pose, orientation);
    ForShapesNear(shape.X, shape.Y, shape.Radius, [&](const SIndexedShape& other) {
      if (other.Body != ignored && other.Body < found && ShapesOverlap(shape, other)) {
        found = other.Body;
      }
    });
  }
  return found;
}

}  // namespace argos
