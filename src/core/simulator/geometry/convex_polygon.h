#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_CONVEX_POLYGON_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_CONVEX_POLYGON_H

#include <argos3/core/utility/math/ray_span.h>
#include <argos3/core/utility/math/vector2.h>

#include <vector>

/**
 * @file
 * Polygons in the plane: corners in m, counter-clockwise, strictly convex, at least three.
 * MakeConvexPolygon() makes one; all other functions need one.
 */

namespace argos {

/**
 * Makes a convex polygon of @p points, in either order; removes double points (closer than 1e-6 m)
 * and points on a straight side (within 1e-9 m).
 * @throws CARGoSException if the points are not finite, not the corners of a convex polygon in
 *         order, or if the polygon is narrower than 1e-5 m.
 */
std::vector<CVector2> MakeConvexPolygon(std::vector<CVector2> points);

/** The next corner after number @p corner. */
inline const CVector2& NextCorner(const std::vector<CVector2>& polygon, size_t corner) {
  return polygon[corner + 1 < polygon.size() ? corner + 1 : 0];
}

/** The unit normal, outwards, of the side from number @p corner to the next one. */
inline CVector2 ComputeSideNormal(const std::vector<CVector2>& polygon, size_t corner) {
  const CVector2 side = NextCorner(polygon, corner) - polygon[corner];
  return CVector2(side.GetY(), -side.GetX()) / side.Length();
}

/** The number of the corner that is farthest along a direction of any length. */
size_t FindFarthestCorner(const std::vector<CVector2>& polygon, const CVector2& direction);

/** A homogeneous area. */
struct SPolygonMoments {
  Real Area = 0.0; /**< m^2 */
  CVector2 Centroid; /**< m */
  /** Mean squares and product of the coordinates from the centroid, m^2. */
  Real MeanXX = 0.0, MeanYY = 0.0, MeanXY = 0.0;
};
SPolygonMoments ComputeMoments(const std::vector<CVector2>& polygon);

/** The least distance between two parallel lines that enclose the polygon, m. */
Real ComputeLeastWidth(const std::vector<CVector2>& polygon);

/** The part of the line @p start + t @p direction inside the polygon, border included. */
SRaySpan IntersectPolygon(const std::vector<CVector2>& polygon, const CVector2& start,
                          const CVector2& direction);

/** The nearest point of the border of a polygon. */
struct SPolygonNearest {
  CVector2 Point; /**< m */
  CVector2 Normal; /**< has unit length: outwards, along the line to an outer point */
  Real Distance = 0.0; /**< m; negative inside */
};
SPolygonNearest FindNearest(const std::vector<CVector2>& polygon, const CVector2& point);

}  // namespace argos

#endif
