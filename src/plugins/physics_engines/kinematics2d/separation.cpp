#include <argos3/plugins/simulator/physics_engines/kinematics2d/separation.h>

#include <argos3/core/utility/math/ray_span.h>

#include <algorithm>

namespace argos {

namespace {

/** An axis-aligned rectangle around the origin, and a disc with a planned step. */
struct SDiscAtBox {
  Real HalfX, HalfY;
  Real X, Y, Radius;
  SStep Step;
};

/** A point of the rectangle and the position of the disc's centre when that point is nearest. */
struct SNearest {
  Real PointX, PointY;
  Real X, Y;
  Real SquaredDistance;
};

SNearest FindNearestAt(const SDiscAtBox& scene, Real share) {
  SNearest nearest;
  nearest.X = scene.X + share * scene.Step.X;
  nearest.Y = scene.Y + share * scene.Step.Y;
  nearest.PointX = std::clamp(nearest.X, -scene.HalfX, scene.HalfX);
  nearest.PointY = std::clamp(nearest.Y, -scene.HalfY, scene.HalfY);
  const Real dx = nearest.PointX - nearest.X;
  const Real dy = nearest.PointY - nearest.Y;
  nearest.SquaredDistance = dx * dx + dy * dy;
  return nearest;
}

// The share of a step after which a point enters a rectangle; kNoHit: not in this step.
Real EnterBox(Real x, Real y, const SStep& step, Real halfX, Real halfY) {
  const bool isBeside =
      (step.X == 0.0 && std::abs(x) >= halfX) || (step.Y == 0.0 && std::abs(y) >= halfY);
  SRaySpan inside = {0.0, 1.0};
  inside.ClipToSlab(x, step.X, -halfX, halfX);
  inside.ClipToSlab(y, step.Y, -halfY, halfY);
  return !isBeside && inside.First < inside.Last ? inside.First : kNoHit;
}

// the same for a circle around the origin that the point approaches
Real EnterCircle(Real x, Real y, const SStep& step, Real radius) {
  const Real approach = x * step.X + y * step.Y;
  const SRaySpan inside =
      FindNegative(step.X * step.X + step.Y * step.Y, approach, x * x + y * y - radius * radius);
  return approach < 0.0 && inside.First < inside.Last ? std::max(0.0, inside.First) : kNoHit;
}

// The share of its step after which the disc first touches the rectangle; > 1: not in this step.
Real FindFirstTouch(const SDiscAtBox& scene) {
  Real share =
      std::min(EnterBox(scene.X, scene.Y, scene.Step, scene.HalfX + scene.Radius, scene.HalfY),
               EnterBox(scene.X, scene.Y, scene.Step, scene.HalfX, scene.HalfY + scene.Radius));
  for (const Real signX : {-1.0, 1.0}) {
    for (const Real signY : {-1.0, 1.0}) {
      share = std::min(share, EnterCircle(scene.X - signX * scene.HalfX,
                                          scene.Y - signY * scene.HalfY, scene.Step, scene.Radius));
    }
  }
  return share;
}

// The nearest points of a step and a rectangle that it does not cross.
SNearest FindNearestOnWay(const SDiscAtBox& scene) {
  SNearest nearest = FindNearestAt(scene, 0.0);
  const SNearest atEnd = FindNearestAt(scene, 1.0);
  if (atEnd.SquaredDistance < nearest.SquaredDistance) {
    nearest = atEnd;
  }
  const Real squaredPath = scene.Step.X * scene.Step.X + scene.Step.Y * scene.Step.Y;
  for (const Real signX : {-1.0, 1.0}) {
    for (const Real signY : {-1.0, 1.0}) {
      SNearest corner;
      corner.PointX = signX * scene.HalfX;
      corner.PointY = signY * scene.HalfY;
      const Real share = std::clamp(
          ((corner.PointX - scene.X) * scene.Step.X + (corner.PointY - scene.Y) * scene.Step.Y) /
              squaredPath,
          0.0, 1.0);
      corner.X = scene.X + share * scene.Step.X;
      corner.Y = scene.Y + share * scene.Step.Y;
      const Real dx = corner.PointX - corner.X;
      const Real dy = corner.PointY - corner.Y;
      corner.SquaredDistance = dx * dx + dy * dy;
      if (corner.SquaredDistance < nearest.SquaredDistance) {
        nearest = corner;
      }
    }
  }
  return nearest;
}

// For a disc with its centre inside the rectangle, or on its border: along the shortest way out.
SSeparation SeparateFromInside(const SDiscAtBox& scene) {
  SSeparation separation;
  const Real depthX = scene.HalfX - std::abs(scene.X);
  const Real depthY = scene.HalfY - std::abs(scene.Y);
  if (depthX < depthY) {
    separation.NormalX = scene.X > 0.0 ? -1.0 : 1.0;
    separation.Gap = -depthX - scene.Radius;
    separation.PointX = -separation.NormalX * scene.HalfX;
    separation.PointY = scene.Y;
  } else {
    separation.NormalY = scene.Y > 0.0 ? -1.0 : 1.0;
    separation.Gap = -depthY - scene.Radius;
    separation.PointX = scene.X;
    separation.PointY = -separation.NormalY * scene.HalfY;
  }
  return separation;
}

SSeparation SeparateFromBox(const SDiscAtBox& scene) {
  SNearest nearest = FindNearestAt(scene, 0.0);
  if (nearest.SquaredDistance == 0.0) {
    return SeparateFromInside(scene);
  }
  const Real squaredPath = scene.Step.X * scene.Step.X + scene.Step.Y * scene.Step.Y;
  const Real gap = std::sqrt(nearest.SquaredDistance) - scene.Radius;
  if (gap > 0.0 && gap * gap < squaredPath) {
    const Real touch = FindFirstTouch(scene);
    const SNearest better = touch <= 1.0 ? FindNearestAt(scene, touch) : FindNearestOnWay(scene);
    if (better.SquaredDistance > 0.0) {
      nearest = better;
    }
  }
  const Real distance = std::sqrt(nearest.SquaredDistance);
  SSeparation separation;
  separation.NormalX = (nearest.PointX - nearest.X) / distance;
  separation.NormalY = (nearest.PointY - nearest.Y) / distance;
  separation.Gap = separation.NormalX * (nearest.PointX - scene.X) +
                   separation.NormalY * (nearest.PointY - scene.Y) - scene.Radius;
  separation.PointX = nearest.PointX;
  separation.PointY = nearest.PointY;
  return separation;
}

/** Two rectangles, seen along a side of the first. */
struct SSide {
  bool IsFirst = true;  // true for a side of the first rectangle
  Real NormalX = 0.0, NormalY = 0.0;  // outwards
  Real Half = 0.0;  // from the rectangle's centre to the side
  Real HalfAlong = 0.0;  // half of the side's length
  Real Gap = -HUGE_VAL;
};

// Selects the side of a that is farthest from b, if it is farther than the best one so far.
void ConsiderSides(const SFootprint& a, const SFootprint& b, bool isFirst, SSide& best) {
  const Real dx = b.X - a.X;
  const Real dy = b.Y - a.Y;
  for (int axis = 0; axis < 2; ++axis) {
    const Real axisX = axis == 0 ? a.Cos : -a.Sin;
    const Real axisY = axis == 0 ? a.Sin : a.Cos;
    const Real half = axis == 0 ? a.HalfX : a.HalfY;
    const Real along = dx * axisX + dy * axisY;
    const Real gap = std::abs(along) - half - ComputeHalfWidth(b, axisX, axisY);
    // of sides that are equal except for rounding: the first
    if (gap > best.Gap + 1e-12) {
      const Real sign = along < 0.0 ? -1.0 : 1.0;
      best = {isFirst, sign * axisX, sign * axisY, half, axis == 0 ? a.HalfY : a.HalfX, gap};
    }
  }
}

SSide FindBestSide(const SFootprint& a, const SFootprint& b) {
  SSide best;
  ConsiderSides(a, b, true, best);
  ConsiderSides(b, a, false, best);
  return best;
}

// The ends of the side of a rectangle that faces a direction most directly.
void FindIncidentSide(const SFootprint& box, Real x, Real y, SStep (&ends)[2]) {
  const Real alongX = box.Cos * x + box.Sin * y;
  const Real alongY = box.Cos * y - box.Sin * x;
  Real localX[2] = {box.HalfX, -box.HalfX};
  Real localY[2] = {box.HalfY, -box.HalfY};
  if (std::abs(alongX) > std::abs(alongY)) {
    localX[0] = localX[1] = alongX > 0.0 ? -box.HalfX : box.HalfX;
  } else {
    localY[0] = localY[1] = alongY > 0.0 ? -box.HalfY : box.HalfY;
  }
  for (int end = 0; end < 2; ++end) {
    ends[end].X = box.X + box.Cos * localX[end] - box.Sin * localY[end];
    ends[end].Y = box.Y + box.Sin * localX[end] + box.Cos * localY[end];
  }
}

// Clips a line to the points within half of the centre along the tangent. @return false if none is.
bool Clip(SStep (&ends)[2], const SFootprint& box, Real tangentX, Real tangentY, Real half) {
  const auto along = [&](const SStep& end) {
    return (end.X - box.X) * tangentX + (end.Y - box.Y) * tangentY;
  };
  for (const Real sign : {-1.0, 1.0}) {
    const Real beyond[2] = {sign * along(ends[0]) - half, sign * along(ends[1]) - half};
    if (beyond[0] > 0.0 && beyond[1] > 0.0) {
      return false;
    }
    for (int end = 0; end < 2; ++end) {
      if (beyond[end] > 0.0) {
        const Real share = beyond[end] / (beyond[end] - beyond[1 - end]);
        ends[end].X += share * (ends[1 - end].X - ends[end].X);
        ends[end].Y += share * (ends[1 - end].Y - ends[end].Y);
      }
    }
  }
  return true;
}

int FindContactsOfBoxes(const SFootprint& a, const SFootprint& b, SSeparation* contacts) {
  const SSide side = FindBestSide(a, b);
  const SFootprint& reference = side.IsFirst ? a : b;
  SStep ends[2];
  FindIncidentSide(side.IsFirst ? b : a, side.NormalX, side.NormalY, ends);
  const SStep whole[2] = {ends[0], ends[1]};
  const auto gapOf = [&](const SStep& end) {
    return (end.X - reference.X) * side.NormalX + (end.Y - reference.Y) * side.NormalY - side.Half;
  };
  int count = 2;
  if (!Clip(ends, reference, -side.NormalY, side.NormalX, side.HalfAlong)) {
    // corner to corner
    ends[0] = gapOf(whole[0]) < gapOf(whole[1]) ? whole[0] : whole[1];
    count = 1;
  }
  const Real sign = side.IsFirst ? 1.0 : -1.0;
  for (int i = 0; i < count; ++i) {
    contacts[i] = {sign * side.NormalX, sign * side.NormalY, gapOf(ends[i]), ends[i].X, ends[i].Y};
  }
  return count;
}

}  // namespace

SSeparation SeparateFromFootprint(Real x, Real y, Real radius, const SStep& step,
                                  const SFootprint& footprint) {
  const SStep offset = {footprint.X - x, footprint.Y - y};
  if (footprint.Radius > 0.0) {
    SSeparation separation = SeparateDiscs(offset, {-step.X, -step.Y}, radius + footprint.Radius);
    separation.PointX = footprint.X - footprint.Radius * separation.NormalX;
    separation.PointY = footprint.Y - footprint.Radius * separation.NormalY;
    return separation;
  }
  const Real cosine = footprint.Cos;
  const Real sine = footprint.Sin;
  const SDiscAtBox scene = {footprint.HalfX,
                            footprint.HalfY,
                            -cosine * offset.X - sine * offset.Y,
                            sine * offset.X - cosine * offset.Y,
                            radius,
                            {cosine * step.X + sine * step.Y, cosine * step.Y - sine * step.X}};
  const SSeparation local = SeparateFromBox(scene);
  return {cosine * local.NormalX - sine * local.NormalY,
          sine * local.NormalX + cosine * local.NormalY, local.Gap,
          footprint.X + cosine * local.PointX - sine * local.PointY,
          footprint.Y + sine * local.PointX + cosine * local.PointY};
}

int FindContacts(const SFootprint& a, const SFootprint& b, SSeparation* contacts) {
  if (a.Radius > 0.0) {
    contacts[0] = SeparateFromFootprint(a.X, a.Y, a.Radius, SStep(), b);
    return 1;
  }
  if (b.Radius > 0.0) {
    const SSeparation back = SeparateFromFootprint(b.X, b.Y, b.Radius, SStep(), a);
    contacts[0] = {-back.NormalX, -back.NormalY, back.Gap, back.PointX, back.PointY};
    return 1;
  }
  return FindContactsOfBoxes(a, b, contacts);
}

Real ComputeGap(const SFootprint& a, const SFootprint& b) {
  if (a.Radius > 0.0) {
    return SeparateFromFootprint(a.X, a.Y, a.Radius, SStep(), b).Gap;
  }
  if (b.Radius > 0.0) {
    return SeparateFromFootprint(b.X, b.Y, b.Radius, SStep(), a).Gap;
  }
  return FindBestSide(a, b).Gap;
}

}  // namespace argos
