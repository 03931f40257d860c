#ifndef ARGOS3_CORE_UTILITY_MATH_CONVEX_HULL_H
#define ARGOS3_CORE_UTILITY_MATH_CONVEX_HULL_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector3.h>

#include <array>
#include <vector>

namespace argos {

/**
 * The convex hull of a set of points in space, as triangles.
 *
 * Incremental construction (O'Rourke, Computational Geometry in C, chapter 4), quadratic in the
 * number of points. Points closer to a face than 1e-10 of the size of the set count as on the face.
 * A planar side with more than three corners gives several triangles with the same normal.
 */
class CConvexHull {
 public:
  struct SFace {
    /** Unit outward normal. */
    CVector3 Normal;

    /**
     * Distance of the face's plane from the origin along Normal: points p of the solid satisfy
     * Normal.p <= Direction.
     */
    Real Direction;

    /** The corners, as indices of the input points, counter-clockwise as seen from outside. */
    std::array<UInt32, 3> VertexIndices;
  };

  /** @throws CARGoSException if there are fewer than four points, or if all lie in one plane. */
  CConvexHull(const std::vector<CVector3>& points);

  const std::vector<SFace>& GetFaces() const { return m_faces; }

 private:
  std::array<UInt32, 4> FindTetrahedron() const;
  void AddFace(UInt32 first, UInt32 second, UInt32 third);
  void AddPoint(UInt32 point);
  Real ComputeHeight(const SFace& face, UInt32 point) const;

  std::vector<CVector3> m_points;
  Real m_tolerance;
  std::vector<SFace> m_faces;
};

}  // namespace argos

#endif
