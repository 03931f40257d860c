#include <argos3/plugins/simulator/physics_engines/planar/separation.h>

#include <argos3/core/simulator/geometry/convex_polygon.h>
#include <argos3/core/utility/math/ray_span.h>

#include <algorithm>

namespace argos {

namespace {

/** A point of the shape and the position of the disc's centre when that point is nearest. */
struct SNearest {
  SPlanarVector Point, Centre;
  Real SquaredDistance;
};

/** A disc with a planned step, in the frame of a shape. */
struct SDiscAtShape {
  SPlanarVector Centre, Step;
  Real Radius;

  // the centre after a share of the step
  SPlanarVector ComputeCentre(Real share) const { return Centre + share * Step; }
  // to a point of the shape, if that is nearest to the disc after a share of the step
  SNearest MeasureTo(const SPlanarVector& point, Real share) const {
    const SPlanarVector centre = ComputeCentre(share);
    return {point, centre, SquareLength(point - centre)};
  }
};

/** An axis-aligned rectangle around the origin, and a disc. */
struct SDiscAtBox : SDiscAtShape {
  Real HalfX, HalfY;

  SNearest FindNearestAt(Real share) const {
    const SPlanarVector centre = ComputeCentre(share);
    return MeasureTo({std::clamp(centre.X, -HalfX, HalfX), std::clamp(centre.Y, -HalfY, HalfY)},
                     share);
  }
  template <typename VISIT>
  void ForCorners(VISIT&& visit) const {
    for (const Real signX : {-1.0, 1.0}) {
      for (const Real signY : {-1.0, 1.0}) {
        visit(SPlanarVector{signX * HalfX, signY * HalfY});
      }
    }
  }
};

/** A convex polygon, and a disc. */
struct SDiscAtPolygon : SDiscAtShape {
  const std::vector<CVector2>& Corners;

  SPolygonNearest FindNearestOfCentre(Real share) const {
    const SPlanarVector centre = ComputeCentre(share);
    return FindNearest(Corners, CVector2(centre.X, centre.Y));
  }
  SNearest FindNearestAt(Real share) const {
    // m; a centre that is less outside counts as on the border, like in a polygon's own numbers
    constexpr Real kOnBorder = 1e-12;
    const SPolygonNearest nearest = FindNearestOfCentre(share);
    if (nearest.Distance <= kOnBorder) {
      return MeasureTo(ComputeCentre(share), share);
    }
    return MeasureTo({nearest.Point.GetX(), nearest.Point.GetY()}, share);
  }
  template <typename VISIT>
  void ForCorners(VISIT&& visit) const {
    for (const CVector2& corner : Corners) {
      visit(SPlanarVector{corner.GetX(), corner.GetY()});
    }
  }
};

// The share of a step after which a point enters a rectangle; kNoHit: not in this step.
Real EnterBox(const SPlanarVector& point, const SPlanarVector& step, Real halfX, Real halfY) {
  const bool isBeside = (step.X == 0.0 && std::abs(point.X) >= halfX) ||
                        (step.Y == 0.0 && std::abs(point.Y) >= halfY);
  SRaySpan inside = {0.0, 1.0};
  inside.ClipToSlab(point.X, step.X, -halfX, halfX);
  inside.ClipToSlab(point.Y, step.Y, -halfY, halfY);
  return !isBeside && inside.First < inside.Last ? inside.First : kNoHit;
}

// the same for a circle around the origin that the point approaches
Real EnterCircle(const SPlanarVector& point, const SPlanarVector& step, Real radius) {
  const Real approach = Dot(point, step);
  const SRaySpan inside =
      FindNegative(SquareLength(step), approach, SquareLength(point) - radius * radius);
  return approach < 0.0 && inside.First < inside.Last ? std::max(0.0, inside.First) : kNoHit;
}

// The share of its step after which the disc first touches a side, other than at a corner; kNoHit:
// it touches none.
Real EnterSides(const SDiscAtBox& scene) {
  return std::min(EnterBox(scene.Centre, scene.Step, scene.HalfX + scene.Radius, scene.HalfY),
                  EnterBox(scene.Centre, scene.Step, scene.HalfX, scene.HalfY + scene.Radius));
}

Real EnterSides(const SDiscAtPolygon& scene) {
  Real share = kNoHit;
  const CVector2 centre(scene.Centre.X, scene.Centre.Y);
  const CVector2 step(scene.Step.X, scene.Step.Y);
  for (size_t i = 0; i < scene.Corners.size(); ++i) {
    const CVector2 normal = ComputeSideNormal(scene.Corners, i);
    const Real gap = normal.DotProduct(centre - scene.Corners[i]) - scene.Radius;
    const Real approach = -normal.DotProduct(step);
    if (gap < 0.0 || approach <= 0.0 || gap >= share * approach) {
      continue;
    }
    const CVector2 side = NextCorner(scene.Corners, i) - scene.Corners[i];
    const Real along = side.DotProduct(centre + step * (gap / approach) - scene.Corners[i]);
    if (along >= 0.0 && along <= side.SquareLength()) {
      share = gap / approach;
    }
  }
  return share;
}

// The share of its step after which the disc first touches the shape; > 1: not in this step.
template <typename SCENE>
Real FindFirstTouch(const SCENE& scene) {
  Real share = EnterSides(scene);
  scene.ForCorners([&](const SPlanarVector& corner) {
    share = std::min(share, EnterCircle(scene.Centre - corner, scene.Step, scene.Radius));
  });
  return share;
}

// The nearest points of a step and a shape that it does not cross.
template <typename SCENE>
SNearest FindNearestOnWay(const SCENE& scene) {
  SNearest nearest = scene.FindNearestAt(0.0);
  const SNearest atEnd = scene.FindNearestAt(1.0);
  if (atEnd.SquaredDistance < nearest.SquaredDistance) {
    nearest = atEnd;
  }
  const Real squaredPath = SquareLength(scene.Step);
  scene.ForCorners([&](const SPlanarVector& corner) {
    const Real share = std::clamp(Dot(corner - scene.Centre, scene.Step) / squaredPath, 0.0, 1.0);
    const SNearest measured = scene.MeasureTo(corner, share);
    if (measured.SquaredDistance < nearest.SquaredDistance) {
      nearest = measured;
    }
  });
  return nearest;
}

// For a disc with its centre inside the shape, or on its border: along the shortest way out.
SSeparation SeparateFromInside(const SDiscAtBox& scene) {
  SSeparation separation;
  const Real depthX = scene.HalfX - std::abs(scene.Centre.X);
  const Real depthY = scene.HalfY - std::abs(scene.Centre.Y);
  if (depthX < depthY) {
    separation.NormalX = scene.Centre.X > 0.0 ? -1.0 : 1.0;
    separation.Gap = -depthX - scene.Radius;
    separation.PointX = -separation.NormalX * scene.HalfX;
    separation.PointY = scene.Centre.Y;
  } else {
    separation.NormalY = scene.Centre.Y > 0.0 ? -1.0 : 1.0;
    separation.Gap = -depthY - scene.Radius;
    separation.PointX = scene.Centre.X;
    separation.PointY = -separation.NormalY * scene.HalfY;
  }
  return separation;
}

SSeparation SeparateFromInside(const SDiscAtPolygon& scene) {
  const SPolygonNearest nearest = scene.FindNearestOfCentre(0.0);
  return {-nearest.Normal.GetX(), -nearest.Normal.GetY(), nearest.Distance - scene.Radius,
          nearest.Point.GetX(), nearest.Point.GetY()};
}

template <typename SCENE>
SSeparation SeparateFromShape(const SCENE& scene) {
  SNearest nearest = scene.FindNearestAt(0.0);
  if (nearest.SquaredDistance == 0.0) {
    return SeparateFromInside(scene);
  }
  const Real squaredPath = SquareLength(scene.Step);
  const Real gap = std::sqrt(nearest.SquaredDistance) - scene.Radius;
  if (gap > 0.0 && gap * gap < squaredPath) {
    const Real touch = FindFirstTouch(scene);
    const SNearest better = touch <= 1.0 ? scene.FindNearestAt(touch) : FindNearestOnWay(scene);
    if (better.SquaredDistance > 0.0) {
      nearest = better;
    }
  }
  const Real distance = std::sqrt(nearest.SquaredDistance);
  SSeparation separation;
  separation.NormalX = (nearest.Point.X - nearest.Centre.X) / distance;
  separation.NormalY = (nearest.Point.Y - nearest.Centre.Y) / distance;
  separation.Gap = Dot(separation.GetNormal(), nearest.Point - scene.Centre) - scene.Radius;
  separation.PointX = nearest.Point.X;
  separation.PointY = nearest.Point.Y;
  return separation;
}

// Of gaps that differ by less, m, the first one counts.
constexpr Real kSameGap = 1e-12;

/** Two shapes with corners, seen along a side of one of them. */
struct SSide {
  bool IsFirst = true;  // true for a side of the first shape
  SPlanarVector Point = {};  // on the line across the middle of the side
  SPlanarVector Normal = {};  // outwards
  Real Half = 0.0;  // from that point to the side
  Real HalfAlong = 0.0;  // half of the side's length
  Real Gap = -HUGE_VAL;
};

// Selects the side of a that is farthest from b, if it is farther than the best one so far.
void ConsiderSides(const SFootprint& a, const SFootprint& b, bool isFirst, SSide& best) {
  const SPlanarVector offset = {b.X - a.X, b.Y - a.Y};
  for (int axis = 0; axis < 2; ++axis) {
    const SPlanarVector direction = {axis == 0 ? a.Cos : -a.Sin, axis == 0 ? a.Sin : a.Cos};
    const Real half = axis == 0 ? a.HalfX : a.HalfY;
    const Real along = Dot(offset, direction);
    const Real gap = std::abs(along) - half - ComputeHalfWidth(b, direction.X, direction.Y);
    if (gap > best.Gap + kSameGap) {
      const Real sign = along < 0.0 ? -1.0 : 1.0;
      best = {isFirst, {a.X, a.Y}, sign * direction, half, axis == 0 ? a.HalfY : a.HalfX, gap};
    }
  }
}

/** The corners of a rectangle or polygon, world frame, counter-clockwise. */
class CCorners {
 public:
  explicit CCorners(const SFootprint& shape) : m_shape(shape) {}
  size_t GetSize() const { return m_shape.Polygon != nullptr ? m_shape.Polygon->size() : 4; }
  size_t GetNext(size_t corner) const { return corner + 1 < GetSize() ? corner + 1 : 0; }
  // in the frame of the shape
  SPlanarVector GetLocal(size_t corner) const {
    if (m_shape.Polygon != nullptr) {
      const CVector2& local = (*m_shape.Polygon)[corner];
      return {local.GetX(), local.GetY()};
    }
    return {corner == 0 || corner == 3 ? m_shape.HalfX : -m_shape.HalfX,
            corner < 2 ? m_shape.HalfY : -m_shape.HalfY};
  }
  SPlanarVector Get(size_t corner) const {
    const SPlanarVector local = GetLocal(corner);
    return SPlanarVector{m_shape.X, m_shape.Y} + RotateOutOfFrame(m_shape, local.X, local.Y);
  }

 private:
  const SFootprint& m_shape;
};

// the same for any shapes with corners
void ConsiderSides(const CCorners& a, const CCorners& b, bool isFirst, SSide& best) {
  for (size_t i = 0; i < a.GetSize(); ++i) {
    const SPlanarVector start = a.Get(i);
    const SPlanarVector side = a.Get(a.GetNext(i)) - start;
    const Real length = std::sqrt(SquareLength(side));
    const SPlanarVector normal = {side.Y / length, -side.X / length};
    Real gap = HUGE_VAL;
    for (size_t j = 0; j < b.GetSize() && gap > best.Gap + kSameGap; ++j) {
      gap = std::min(gap, Dot(normal, b.Get(j) - start));
    }
    if (gap > best.Gap + kSameGap) {
      best = {isFirst, start + 0.5 * side, normal, 0.0, 0.5 * length, gap};
    }
  }
}

SSide FindBestSide(const SFootprint& a, const SFootprint& b) {
  SSide best;
  if (a.Polygon != nullptr || b.Polygon != nullptr) {
    ConsiderSides(CCorners(a), CCorners(b), true, best);
    ConsiderSides(CCorners(b), CCorners(a), false, best);
  } else {
    ConsiderSides(a, b, true, best);
    ConsiderSides(b, a, false, best);
  }
  return best;
}

// The ends of the side of a polygon that faces a direction most directly; first the one with the
// greater coordinate in its frame, as of a rectangle.
void FindIncidentSide(const CCorners& polygon, const SPlanarVector& direction,
                      SPlanarVector (&ends)[2]) {
  Real least = HUGE_VAL;
  size_t incident = 0;
  for (size_t i = 0; i < polygon.GetSize(); ++i) {
    const SPlanarVector side = polygon.Get(polygon.GetNext(i)) - polygon.Get(i);
    const Real along = Cross(direction, side) / std::sqrt(SquareLength(side));
    if (along < least) {
      least = along;
      incident = i;
    }
  }
  size_t first = incident;
  size_t second = polygon.GetNext(incident);
  const SPlanarVector side = polygon.GetLocal(second) - polygon.GetLocal(first);
  if ((std::abs(side.X) > std::abs(side.Y) ? side.X : side.Y) > 0.0) {
    std::swap(first, second);
  }
  ends[0] = polygon.Get(first);
  ends[1] = polygon.Get(second);
}

// The ends of the side of a shape that faces a direction most directly.
void FindIncidentSide(const SFootprint& box, const SPlanarVector& direction,
                      SPlanarVector (&ends)[2]) {
  if (box.Polygon != nullptr) {
    FindIncidentSide(CCorners(box), direction, ends);
    return;
  }
  const SPlanarVector along = RotateIntoFrame(box, direction.X, direction.Y);
  Real localX[2] = {box.HalfX, -box.HalfX};
  Real localY[2] = {box.HalfY, -box.HalfY};
  if (std::abs(along.X) > std::abs(along.Y)) {
    localX[0] = localX[1] = along.X > 0.0 ? -box.HalfX : box.HalfX;
  } else {
    localY[0] = localY[1] = along.Y > 0.0 ? -box.HalfY : box.HalfY;
  }
  for (int end = 0; end < 2; ++end) {
    ends[end].X = box.X + box.Cos * localX[end] - box.Sin * localY[end];
    ends[end].Y = box.Y + box.Sin * localX[end] + box.Cos * localY[end];
  }
}

// Clips a line to the points beside a side. @return false if none is.
bool Clip(SPlanarVector (&ends)[2], const SSide& side) {
  const SPlanarVector tangent = {-side.Normal.Y, side.Normal.X};
  for (const Real sign : {-1.0, 1.0}) {
    const Real beyond[2] = {sign * Dot(ends[0] - side.Point, tangent) - side.HalfAlong,
                            sign * Dot(ends[1] - side.Point, tangent) - side.HalfAlong};
    if (beyond[0] > 0.0 && beyond[1] > 0.0) {
      return false;
    }
    for (int end = 0; end < 2; ++end) {
      if (beyond[end] > 0.0) {
        const Real share = beyond[end] / (beyond[end] - beyond[1 - end]);
        ends[end] = ends[end] + share * (ends[1 - end] - ends[end]);
      }
    }
  }
  return true;
}

int FindContactsOfSides(const SFootprint& a, const SFootprint& b, SSeparation* contacts) {
  const SSide side = FindBestSide(a, b);
  SPlanarVector ends[2];
  FindIncidentSide(side.IsFirst ? b : a, side.Normal, ends);
  const SPlanarVector whole[2] = {ends[0], ends[1]};
  const auto gapOf = [&side](const SPlanarVector& end) {
    return Dot(end - side.Point, side.Normal) - side.Half;
  };
  int count = 2;
  if (!Clip(ends, side)) {
    // corner to corner
    ends[0] = gapOf(whole[0]) < gapOf(whole[1]) ? whole[0] : whole[1];
    count = 1;
  }
  const Real sign = side.IsFirst ? 1.0 : -1.0;
  for (int i = 0; i < count; ++i) {
    contacts[i] = {sign * side.Normal.X, sign * side.Normal.Y, gapOf(ends[i]), ends[i].X,
                   ends[i].Y};
  }
  return count;
}

}  // namespace

SSeparation SeparateFromFootprint(Real x, Real y, Real radius, const SPlanarVector& step,
                                  const SFootprint& footprint) {
  const SPlanarVector offset = {footprint.X - x, footprint.Y - y};
  if (footprint.Radius > 0.0) {
    SSeparation separation = SeparateDiscs(offset, {-step.X, -step.Y}, radius + footprint.Radius);
    separation.PointX = footprint.X - footprint.Radius * separation.NormalX;
    separation.PointY = footprint.Y - footprint.Radius * separation.NormalY;
    return separation;
  }
  const Real cosine = footprint.Cos;
  const Real sine = footprint.Sin;
  const SDiscAtShape disc = {RotateIntoFrame(footprint, -offset.X, -offset.Y),
                             RotateIntoFrame(footprint, step.X, step.Y), radius};
  const SSeparation local =
      footprint.Polygon != nullptr
          ? SeparateFromShape(SDiscAtPolygon{disc, *footprint.Polygon})
          : SeparateFromShape(SDiscAtBox{disc, footprint.HalfX, footprint.HalfY});
  return {cosine * local.NormalX - sine * local.NormalY,
          sine * local.NormalX + cosine * local.NormalY, local.Gap,
          footprint.X + cosine * local.PointX - sine * local.PointY,
          footprint.Y + sine * local.PointX + cosine * local.PointY};
}

int FindContacts(const SFootprint& a, const SFootprint& b, SSeparation* contacts) {
  if (a.Radius > 0.0) {
    contacts[0] = SeparateFromFootprint(a.X, a.Y, a.Radius, SPlanarVector{}, b);
    return 1;
  }
  if (b.Radius > 0.0) {
    const SSeparation back = SeparateFromFootprint(b.X, b.Y, b.Radius, SPlanarVector{}, a);
    contacts[0] = {-back.NormalX, -back.NormalY, back.Gap, back.PointX, back.PointY};
    return 1;
  }
  return FindContactsOfSides(a, b, contacts);
}

Real ComputeGap(const SFootprint& a, const SFootprint& b) {
  if (a.Radius > 0.0) {
    return SeparateFromFootprint(a.X, a.Y, a.Radius, SPlanarVector{}, b).Gap;
  }
  if (b.Radius > 0.0) {
    return SeparateFromFootprint(b.X, b.Y, b.Radius, SPlanarVector{}, a).Gap;
  }
  return FindBestSide(a, b).Gap;
}

}  // namespace argos
