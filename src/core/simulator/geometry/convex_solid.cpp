#include <argos3/core/simulator/geometry/convex_solid.h>

#include <argos3/core/utility/math/ray_span.h>

#include <algorithm>
#include <limits>

namespace argos {

CConvexSolid::CConvexSolid(const std::vector<CVector3>& points)
    : m_faces(CConvexHull(points).GetFaces()) {
  // keeps the corners in the order of the points
  std::vector<UInt32> numbers(points.size(), 0);
  for (const CConvexHull::SFace& face : m_faces) {
    for (const UInt32 vertex : face.VertexIndices) {
      numbers[vertex] = 1;
    }
  }
  for (size_t i = 0; i < points.size(); ++i) {
    if (numbers[i] != 0) {
      numbers[i] = static_cast<UInt32>(m_corners.size());
      m_corners.push_back(points[i]);
    }
  }
  for (CConvexHull::SFace& face : m_faces) {
    for (UInt32& vertex : face.VertexIndices) {
      vertex = numbers[vertex];
    }
  }
  Integrate();
  m_innerRadius = std::numeric_limits<Real>::infinity();
  for (const CConvexHull::SFace& face : m_faces) {
    m_innerRadius = std::min(m_innerRadius, face.Direction - m_centroid.DotProduct(face.Normal));
  }
}

// Sums the tetrahedra between a corner and each face. Source: F. Tonon, Explicit exact formulas for
// the 3-D tetrahedron inertia tensor in terms of its vertex coordinates, J. Mathematics and
// Statistics 1 (2004): with the corners a, b, c and d = 0, the mean of x y is the sum over all
// pairs of corners of (x_i y_j + x_j y_i) / 40, plus that over corners of x_i y_i / 20.
void CConvexSolid::Integrate() {
  const CVector3 start = m_corners.front();
  CVector3 first;
  Real sums[3][3] = {};
  for (const CConvexHull::SFace& face : m_faces) {
    const CVector3 a = m_corners[face.VertexIndices[0]] - start;
    const CVector3 b = m_corners[face.VertexIndices[1]] - start;
    const CVector3 c = m_corners[face.VertexIndices[2]] - start;
    const Real volume = a.DotProduct(CVector3(b).CrossProduct(c)) / 6.0;
    const CVector3 sum = a + b + c;
    m_volume += volume;
    first += sum * (0.25 * volume);
    for (UInt32 i = 0; i < 3; ++i) {
      for (UInt32 j = 0; j < 3; ++j) {
        sums[i][j] += volume * (sum[i] * sum[j] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]) / 20.0;
      }
    }
  }
  const CVector3 mean = first / m_volume;
  const auto about = [&](UInt32 i, UInt32 j) { return sums[i][j] / m_volume - mean[i] * mean[j]; };
  m_centroid = start + mean;
  m_squares.Set(about(0, 0), about(1, 1), about(2, 2));
  m_products.Set(about(1, 2), about(0, 2), about(0, 1));
}

const CVector3& CConvexSolid::FindFarthest(const CVector3& direction) const {
  return *std::max_element(m_corners.begin(), m_corners.end(),
                           [&direction](const CVector3& a, const CVector3& b) {
                             return a.DotProduct(direction) < b.DotProduct(direction);
                           });
}

Real CConvexSolid::Intersect(const CRay3& ray) const {
  const CVector3& start = ray.GetStart();
  const CVector3 along = ray.GetEnd() - start;
  SRaySpan span;
  for (const CConvexHull::SFace& face : m_faces) {
    span.ClipToSlab(start.DotProduct(face.Normal), along.DotProduct(face.Normal), -HUGE_VAL,
                    face.Direction);
  }
  return span.FindEntry();
}

}  // namespace argos
