#include <argos3/core/simulator/geometry/region_geometry.h>

#include <argos3/core/utility/text/classic_locale.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace argos {

namespace {

// the part of a convex polygon on the left of a line
TPolygon KeepLeft(const TPolygon& polygon, const CVector2& start, const CVector2& end) {
  TPolygon kept;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const CVector2& here = polygon[i];
    const CVector2& next = polygon[(i + 1) % polygon.size()];
    const Real sideHere = ComputeSide(start, end, here);
    const Real sideNext = ComputeSide(start, end, next);
    if (sideHere >= 0.0) {
      kept.push_back(here);
    }
    if ((sideHere > 0.0 && sideNext < 0.0) || (sideHere < 0.0 && sideNext > 0.0)) {
      kept.push_back(here + (next - here) * (sideHere / (sideHere - sideNext)));
    }
  }
  return kept;
}

}  // namespace

Real ComputeTwiceArea(const TPolygon& polygon) {
  Real area = 0.0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    area += polygon[i].CrossProduct(polygon[(i + 1) % polygon.size()]);
  }
  return area;
}

// I. Sutherland, G. Hodgman, Reentrant Polygon Clipping, CACM 17 (1974)
TPolygon Intersect(const TPolygon& a, const TPolygon& b) {
  TPolygon shared = a;
  for (size_t i = 0; i < b.size() && !shared.empty(); ++i) {
    shared = KeepLeft(shared, b[i], b[(i + 1) % b.size()]);
  }
  return shared;
}

std::optional<CRay2> Clip(const CRay2& segment, const TPolygon& polygon, Real margin) {
  CVector2 along;
  segment.ToVector(along);
  Real first = 0.0;
  Real last = 1.0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const CVector2& start = polygon[i];
    const CVector2& end = polygon[(i + 1) % polygon.size()];
    const Real length = Distance(start, end);
    const Real from = ComputeSide(start, end, segment.GetStart()) / length + margin;
    const Real to = ComputeSide(start, end, segment.GetEnd()) / length + margin;
    if (from < 0.0 && to < 0.0) {
      return std::nullopt;
    }
    if (from < 0.0) {
      first = std::max(first, from / (from - to));
    } else if (to < 0.0) {
      last = std::min(last, from / (from - to));
    }
  }
  if (first > last) {
    return std::nullopt;
  }
  return CRay2(segment.GetStart() + along * first, segment.GetStart() + along * last);
}

CVector2 FindNearest(const CRay2& segment, const CVector2& point) {
  CVector2 along;
  segment.ToVector(along);
  const Real squared = along.SquareLength();
  if (!(squared > 0.0)) {
    return segment.GetStart();
  }
  const Real share = (point - segment.GetStart()).DotProduct(along) / squared;
  if (share >= 1.0) {
    // exactly, because the result is compared
    return segment.GetEnd();
  }
  return segment.GetStart() + along * std::max<Real>(share, 0.0);
}

Real ComputeDistance(const TPolygon& polygon, const CVector2& point) {
  Real nearest = HUGE_VAL;
  bool inside = true;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const CRay2 side(polygon[i], polygon[(i + 1) % polygon.size()]);
    inside = inside && ComputeSide(side.GetStart(), side.GetEnd(), point) >= 0.0;
    nearest = std::min(nearest, Distance(FindNearest(side, point), point));
  }
  return inside ? 0.0 : nearest;
}

std::optional<SCrossing> FindCrossing(const TPolygon& polygon) {
  const size_t count = polygon.size();
  for (size_t i = 0; i < count; ++i) {
    // consecutive sides share a corner
    for (size_t j = i + 2; j < count && !(i == 0 && j + 1 == count); ++j) {
      const CRay2 a(polygon[i], polygon[i + 1]);
      const CRay2 b(polygon[j], polygon[(j + 1) % count]);
      const Real fromA = ComputeSide(b.GetStart(), b.GetEnd(), a.GetStart());
      const Real toA = ComputeSide(b.GetStart(), b.GetEnd(), a.GetEnd());
      const Real fromB = ComputeSide(a.GetStart(), a.GetEnd(), b.GetStart());
      const Real toB = ComputeSide(a.GetStart(), a.GetEnd(), b.GetEnd());
      if (fromA * toA < 0.0 && fromB * toB < 0.0) {
        CVector2 point;
        a.GetPoint(point, fromA / (fromA - toA));
        return SCrossing{i, j, point};
      }
    }
  }
  return std::nullopt;
}

std::string ListCorners(const TPolygon& polygon) {
  CTextOutput text;
  for (size_t i = 0; i < polygon.size(); ++i) {
    text << (i > 0 ? ", (" : "(") << polygon[i] << ')';
  }
  return text.str();
}

}  // namespace argos
