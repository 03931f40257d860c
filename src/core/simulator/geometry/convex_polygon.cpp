#include <argos3/core/simulator/geometry/convex_polygon.h>

#include <argos3/core/simulator/geometry/region_geometry.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/angles.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace argos {

namespace {

constexpr Real kMinSide = 1e-6;  // m
constexpr Real kMinWidth = 1e-5;  // m
// m; farther than this inside the line through its neighbours, a point is a dent
constexpr Real kStraight = 1e-9;

const CVector2& CornerBefore(const TPolygon& polygon, size_t corner) {
  return polygon[corner > 0 ? corner - 1 : polygon.size() - 1];
}

Real ComputeSignedArea(const TPolygon& polygon) {
  Real twice = 0.0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    twice += (polygon[i] - polygon[0]).CrossProduct(NextCorner(polygon, i) - polygon[0]);
  }
  return 0.5 * twice;
}

void RemoveDoublePoints(TPolygon& polygon) {
  for (size_t i = polygon.size(); i-- > 0 && polygon.size() > 1;) {
    if ((polygon[i] - CornerBefore(polygon, i)).Length() < kMinSide) {
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

// distance of a corner outside the line through its neighbours, m
Real ComputeBulge(const TPolygon& polygon, size_t corner) {
  const CVector2& before = CornerBefore(polygon, corner);
  const CVector2 along = NextCorner(polygon, corner) - before;
  const Real length = along.Length();
  return length > 0.0 ? (polygon[corner] - before).CrossProduct(along) / length : 0.0;
}

void RemoveStraightCorners(TPolygon& polygon) {
  for (size_t i = 0; i < polygon.size() && polygon.size() > 3;) {
    if (std::abs(ComputeBulge(polygon, i)) > kStraight) {
      ++i;
      continue;
    }
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
    // its neighbours have new neighbours
    i = 0;
  }
}

void CheckConvex(const TPolygon& polygon) {
  Real turn = 0.0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    if (ComputeBulge(polygon, i) <= 0.0) {
      THROW_ARGOSEXCEPTION("the polygon is not convex: the corner at ("
                           << polygon[i] << ") is a dent; divide it into convex solids");
    }
    const CVector2 before = polygon[i] - CornerBefore(polygon, i);
    const CVector2 after = NextCorner(polygon, i) - polygon[i];
    turn += std::atan2(before.CrossProduct(after), before.DotProduct(after));
  }
  // corners of a star turn to the left, too, but more than once around
  if (turn > 3.0 * ARGOS_PI) {
    THROW_ARGOSEXCEPTION("the sides of the polygon intersect: give its corners in order");
  }
}

}  // namespace

TPolygon MakeConvexPolygon(TPolygon points) {
  for (const CVector2& point : points) {
    if (!std::isfinite(point.GetX()) || !std::isfinite(point.GetY())) {
      THROW_ARGOSEXCEPTION("the corners of a polygon must be finite numbers of metres, not ("
                           << point << ")");
    }
  }
  RemoveDoublePoints(points);
  if (points.size() < 3) {
    THROW_ARGOSEXCEPTION("a polygon needs at least 3 corners that are "
                         << kMinSide << " m apart, found " << points.size());
  }
  if (ComputeSignedArea(points) < 0.0) {
    std::reverse(points.begin(), points.end());
  }
  RemoveStraightCorners(points);
  const CVector2 diagonal = points[0] - points[1];
  const bool isFlat = std::all_of(points.begin(), points.end(), [&](const CVector2& point) {
    return std::abs(diagonal.CrossProduct(point - points[1])) <= kMinWidth * diagonal.Length();
  });
  if (isFlat) {
    THROW_ARGOSEXCEPTION("the corners of the polygon are in a line");
  }
  CheckConvex(points);
  const Real width = ComputeLeastWidth(points);
  if (width < kMinWidth) {
    THROW_ARGOSEXCEPTION("the polygon is too narrow: its width must be at least "
                         << kMinWidth << " m, found " << width);
  }
  return points;
}

size_t FindFarthestCorner(const TPolygon& polygon, const CVector2& direction) {
  size_t farthest = 0;
  Real greatest = -std::numeric_limits<Real>::infinity();
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Real along = polygon[i].DotProduct(direction);
    if (along > greatest) {
      greatest = along;
      farthest = i;
    }
  }
  return farthest;
}

// Sums over the triangles of a fan. Source: C. Steger, On the calculation of arbitrary moments of
// polygons, TU Muenchen FGBV-96-05 (1996), with the first corner as the origin.
SPolygonMoments ComputeMoments(const TPolygon& polygon) {
  SPolygonMoments moments;
  const CVector2 origin = polygon[0];
  CVector2 sum;
  Real xx = 0.0;
  Real yy = 0.0;
  Real xy = 0.0;
  for (size_t i = 1; i + 1 < polygon.size(); ++i) {
    const CVector2 a = polygon[i] - origin;
    const CVector2 b = polygon[i + 1] - origin;
    const Real area = 0.5 * a.CrossProduct(b);
    moments.Area += area;
    sum += (a + b) * (area / 3.0);
    xx += area / 6.0 * (a.GetX() * a.GetX() + a.GetX() * b.GetX() + b.GetX() * b.GetX());
    yy += area / 6.0 * (a.GetY() * a.GetY() + a.GetY() * b.GetY() + b.GetY() * b.GetY());
    xy += area / 12.0 *
          (2.0 * a.GetX() * a.GetY() + 2.0 * b.GetX() * b.GetY() + a.GetX() * b.GetY() +
           a.GetY() * b.GetX());
  }
  const CVector2 mean = sum / moments.Area;
  moments.Centroid = origin + mean;
  moments.MeanXX = xx / moments.Area - mean.GetX() * mean.GetX();
  moments.MeanYY = yy / moments.Area - mean.GetY() * mean.GetY();
  moments.MeanXY = xy / moments.Area - mean.GetX() * mean.GetY();
  return moments;
}

// the narrowest strip has a side of the polygon on its border
Real ComputeLeastWidth(const TPolygon& polygon) {
  Real least = std::numeric_limits<Real>::infinity();
  for (size_t i = 0; i < polygon.size(); ++i) {
    const CVector2 inwards = -ComputeSideNormal(polygon, i);
    const CVector2& opposite = polygon[FindFarthestCorner(polygon, inwards)];
    least = std::min(least, inwards.DotProduct(opposite - polygon[i]));
  }
  return least;
}

// Source: M. Cyrus and J. Beck, Generalized two- and three-dimensional clipping, Computers &
// Graphics 3 (1978).
SRaySpan IntersectPolygon(const TPolygon& polygon, const CVector2& start,
                          const CVector2& direction) {
  SRaySpan span;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const CVector2 side = NextCorner(polygon, i) - polygon[i];
    const Real inside = side.CrossProduct(start - polygon[i]);
    const Real change = side.CrossProduct(direction);
    if (change > 0.0) {
      span.First = std::max(span.First, -inside / change);
    } else if (change < 0.0) {
      span.Last = std::min(span.Last, -inside / change);
    } else if (inside < 0.0) {
      return SRaySpan::None();
    }
  }
  return span;
}

SPolygonNearest FindNearest(const TPolygon& polygon, const CVector2& point) {
  SPolygonNearest nearest;
  nearest.Distance = -std::numeric_limits<Real>::infinity();
  Real squared = std::numeric_limits<Real>::infinity();
  for (size_t i = 0; i < polygon.size(); ++i) {
    const CVector2 normal = ComputeSideNormal(polygon, i);
    const CVector2 offset = point - polygon[i];
    const Real above = normal.DotProduct(offset);
    if (above <= 0.0) {
      // the nearest side counts if the point is inside of all
      if (above > nearest.Distance && nearest.Distance <= 0.0) {
        nearest = {point - normal * above, normal, above};
      }
      continue;
    }
    const CVector2 side = NextCorner(polygon, i) - polygon[i];
    const Real share = std::clamp<Real>(offset.DotProduct(side) / side.SquareLength(), 0.0, 1.0);
    const CVector2 foot = polygon[i] + side * share;
    const Real square = (point - foot).SquareLength();
    if (square < squared) {
      squared = square;
      const Real distance = std::sqrt(square);
      const bool isCorner = share == 0.0 || share == 1.0;
      nearest = {foot, isCorner ? (point - foot) / distance : normal, isCorner ? distance : above};
    }
  }
  return nearest;
}

}  // namespace argos
