#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_CONVEX_SOLID_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_CONVEX_SOLID_H

#include <argos3/core/utility/math/convex_hull.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/math/vector3.h>

#include <vector>

namespace argos {

/**
 * The convex hull of points in space as a homogeneous solid. Immutable; all lengths in m, in the
 * frame of the points.
 */
class CConvexSolid {
 public:
  /** @throws CARGoSException if the points do not span a volume. */
  explicit CConvexSolid(const std::vector<CVector3>& points);

  /** The corners only. */
  const std::vector<CVector3>& GetCorners() const { return m_corners; }
  /** Triangles; their indices are those of corners. */
  const std::vector<CConvexHull::SFace>& GetFaces() const { return m_faces; }
  const CVector3& GetCentroid() const { return m_centroid; }
  Real GetVolume() const { return m_volume; } /**< m^3 */
  /** Mean of the products of the coordinates from the centroid, m^2: (xx, yy, zz). */
  const CVector3& GetSquares() const { return m_squares; }
  /** (yz, xz, xy). */
  const CVector3& GetProducts() const { return m_products; }
  /** Least distance of a face from the centroid, m. */
  Real GetInnerRadius() const { return m_innerRadius; }

  /** The corner that is farthest in a direction of any length. */
  const CVector3& FindFarthest(const CVector3& direction) const;
  /** Fraction at which a ray enters the solid, 0 if it starts inside; kNoHit if it misses. */
  Real Intersect(const CRay3& ray) const;

 private:
  void Integrate();

  std::vector<CVector3> m_corners;
  std::vector<CConvexHull::SFace> m_faces;
  CVector3 m_centroid;
  CVector3 m_squares;
  CVector3 m_products;
  Real m_volume = 0.0;
  Real m_innerRadius = 0.0;
};

}  // namespace argos

#endif
