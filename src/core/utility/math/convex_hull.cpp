#include <argos3/core/utility/math/convex_hull.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace argos {

namespace {

// tolerance of a point on a face, relative to the size of the set: far above the rounding of a
// plane equation (1e-16), far below any detail of a shape
constexpr Real kRelativeTolerance = 1e-10;

UInt32 FindFarthest(const std::vector<CVector3>& points,
                    const std::function<Real(const CVector3&)>& measure) {
  UInt32 farthest = 0;
  for (UInt32 i = 1; i < points.size(); ++i) {
    if (measure(points[i]) > measure(points[farthest])) {
      farthest = i;
    }
  }
  return farthest;
}

}  // namespace

CConvexHull::CConvexHull(const std::vector<CVector3>& points) : m_points(points), m_tolerance(0.0) {
  if (points.size() < 4) {
    THROW_ARGOSEXCEPTION("A 3D convex hull needs at least 4 points, but there are " << points.size()
                                                                                    << ".");
  }
  for (const CVector3& point : points) {
    m_tolerance = std::max(m_tolerance, kRelativeTolerance * Distance(point, points.front()));
  }
  const std::array<UInt32, 4> corners = FindTetrahedron();
  AddFace(corners[0], corners[1], corners[2]);
  AddFace(corners[0], corners[3], corners[1]);
  AddFace(corners[1], corners[3], corners[2]);
  AddFace(corners[2], corners[3], corners[0]);
  for (UInt32 point = 0; point < m_points.size(); ++point) {
    AddPoint(point);
  }
}

// four points that span a solid, the last one behind the triangle of the other three
std::array<UInt32, 4> CConvexHull::FindTetrahedron() const {
  const UInt32 first = 0;
  const CVector3& origin = m_points[first];
  const UInt32 second =
      FindFarthest(m_points, [&](const CVector3& point) { return SquareDistance(point, origin); });
  const CVector3 edge = m_points[second] - origin;
  const UInt32 third = FindFarthest(m_points, [&](const CVector3& point) {
    return CVector3(edge).CrossProduct(point - origin).SquareLength();
  });
  const CVector3 normal = CVector3(edge).CrossProduct(m_points[third] - origin);
  const UInt32 fourth = FindFarthest(m_points, [&](const CVector3& point) {
    return std::fabs(normal.DotProduct(point - origin));
  });

  const Real height = normal.DotProduct(m_points[fourth] - origin);
  if (!(std::fabs(height) > m_tolerance * normal.Length()) ||
      !(normal.Length() > m_tolerance * edge.Length())) {
    THROW_ARGOSEXCEPTION("A 3D convex hull needs points that are not all in one plane; all "
                         << m_points.size() << " of them are.");
  }
  return height < 0.0 ? std::array<UInt32, 4>{first, second, third, fourth}
                      : std::array<UInt32, 4>{first, third, second, fourth};
}

void CConvexHull::AddFace(UInt32 first, UInt32 second, UInt32 third) {
  const CVector3& corner = m_points[first];
  const CVector3 normal =
      (m_points[second] - corner).CrossProduct(m_points[third] - corner).Normalize();
  m_faces.push_back({normal, normal.DotProduct(corner), {first, second, third}});
}

Real CConvexHull::ComputeHeight(const SFace& face, UInt32 point) const {
  // relative to a corner, which is more accurate than the distance from a far origin
  return face.Normal.DotProduct(m_points[point] - m_points[face.VertexIndices[0]]);
}

void CConvexHull::AddPoint(UInt32 point) {
  // the faces visible from the point are inside the new hull
  const auto firstSeen = std::stable_partition(
      m_faces.begin(), m_faces.end(),
      [&](const SFace& face) { return ComputeHeight(face, point) <= m_tolerance; });

  // their outline consists of the edges of exactly one of them; adjacent faces traverse a shared
  // edge in opposite directions
  std::vector<std::pair<UInt32, UInt32> > outline;
  for (auto face = firstSeen; face != m_faces.end(); ++face) {
    for (size_t i = 0; i < 3; ++i) {
      const UInt32 from = face->VertexIndices[i];
      const UInt32 to = face->VertexIndices[(i + 1) % 3];
      const auto opposite = std::find(outline.begin(), outline.end(), std::make_pair(to, from));
      if (opposite != outline.end()) {
        outline.erase(opposite);
      } else {
        outline.emplace_back(from, to);
      }
    }
  }

  m_faces.erase(firstSeen, m_faces.end());
  for (const auto& edge : outline) {
    AddFace(edge.first, edge.second, point);
  }
}

}  // namespace argos
