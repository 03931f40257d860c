#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_REGION_GEOMETRY_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_REGION_GEOMETRY_H

#include <argos3/core/utility/math/ray2.h>

#include <optional>
#include <string>
#include <vector>

namespace argos {

/** Corners in m, counter-clockwise seen from above. */
using TPolygon = std::vector<CVector2>;

/**
 * Computes on which side of a border a point is.
 *
 * The two regions on either side of a border list it in opposite directions. The ends are sorted
 * first, so that the two results are exactly opposite and no point is lost between regions.
 */
class CBorderSide {
 public:
  CBorderSide(const CVector2& start, const CVector2& end)
      : m_isTurned(end.GetX() < start.GetX() ||
                   (end.GetX() == start.GetX() && end.GetY() < start.GetY())),
        m_first(m_isTurned ? end : start),
        m_along(m_isTurned ? start - end : end - start) {}

  /** Positive if @p point is on the left of the border, m^2: its length times the distance. */
  Real Compute(const CVector2& point) const {
    const Real side = m_along.GetX() * (point.GetY() - m_first.GetY()) -
                      m_along.GetY() * (point.GetX() - m_first.GetX());
    return m_isTurned ? -side : side;
  }

 private:
  bool m_isTurned;
  CVector2 m_first;  // m
  CVector2 m_along;  // m
};

/** The same for one point. */
inline Real ComputeSide(const CVector2& start, const CVector2& end, const CVector2& point) {
  return CBorderSide(start, end).Compute(point);
}

/** Twice the signed area, m^2: positive if the corners run counter-clockwise. */
Real ComputeTwiceArea(const TPolygon& polygon);

/** The intersection of two convex polygons; empty, or without an area, if they only touch. */
TPolygon Intersect(const TPolygon& a, const TPolygon& b);

/** The part of a segment inside a convex polygon that is @p margin m larger; none if it is outside.
 */
std::optional<CRay2> Clip(const CRay2& segment, const TPolygon& polygon, Real margin);

/** The point of the segment that is nearest to @p point. */
CVector2 FindNearest(const CRay2& segment, const CVector2& point);

/** Distance from a point to a convex polygon, m; 0 inside. */
Real ComputeDistance(const TPolygon& polygon, const CVector2& point);

/** A point where two sides without a common corner cross; sides are numbered by first corner. */
struct SCrossing {
  size_t First, Second;
  CVector2 Point;
};
/** Finds two sides of a polygon, of any shape, that cross. */
std::optional<SCrossing> FindCrossing(const TPolygon& polygon);

/** "(0,0), (1,0), (1,1)". */
std::string ListCorners(const TPolygon& polygon);

}  // namespace argos

#endif
