#include <argos3/core/simulator/geometry/solid_overlap.h>

#include <argos3/core/simulator/geometry/convex_polygon.h>
#include <argos3/core/simulator/geometry/convex_solid.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace argos {

namespace {

// m; solids are shrunk by this on all sides, so that touching ones are apart by more than rounding
// errors
constexpr Real kSkin = 1e-7;
// m; a simplex at this distance or less contains the origin
constexpr Real kInside = 1e-9;
// each step comes nearer to the origin; more than ten steps are rare
constexpr int kMaxSteps = 100;

CVector3 Cross(CVector3 a, const CVector3& b) {
  return a.CrossProduct(b);
}

Real Sign(Real value) {
  return value < 0.0 ? -1.0 : 1.0;
}

// a corner of a polygon all of whose sides are moved inwards by the skin
CVector2 ComputeShrunkCorner(const std::vector<CVector2>& polygon, size_t corner) {
  const CVector2 before =
      ComputeSideNormal(polygon, (corner + polygon.size() - 1) % polygon.size());
  const CVector2 after = ComputeSideNormal(polygon, corner);
  return polygon[corner] - (before + after) * (kSkin / (1.0 + before.DotProduct(after)));
}

/** A convex solid, by its farthest point in any direction. */
class CConvex {
 public:
  explicit CConvex(const SPlacedSolid& solid) : m_shape(*solid.Shape) {
    const CQuaternion orientation = solid.Orientation * m_shape.Orientation;
    m_axes = {CVector3::X, CVector3::Y, CVector3::Z};
    for (CVector3& axis : m_axes) {
      axis.Rotate(orientation);
    }
    CVector3 offset = m_shape.Offset;
    offset.Rotate(solid.Orientation);
    m_centre = solid.Position + offset + m_axes[2] * (0.5 * m_shape.Size.GetZ());
    m_half = m_shape.Size * 0.5 - CVector3(kSkin, kSkin, kSkin);
    m_radius = m_shape.Radius - kSkin;
    m_inside = m_centre;
    if (m_shape.Kind == SShapeDescription::EKind::Prism) {
      const CVector2 base = ComputeMoments(*m_shape.Vertices).Centroid;
      m_inside += m_axes[0] * base.GetX() + m_axes[1] * base.GetY();
    } else if (m_shape.Kind == SShapeDescription::EKind::Hull) {
      m_inside = FromHull(m_shape.Solid->GetCentroid());
      // moves each face inwards by the skin at least
      m_scale = std::max(0.0, 1.0 - kSkin / m_shape.Solid->GetInnerRadius());
    }
  }

  const CVector3& GetInnerPoint() const { return m_inside; }

  CVector3 FindFarthest(const CVector3& direction) const {
    const Real x = direction.DotProduct(m_axes[0]);
    const Real y = direction.DotProduct(m_axes[1]);
    const Real z = direction.DotProduct(m_axes[2]);
    switch (m_shape.Kind) {
      case SShapeDescription::EKind::Box:
        return m_centre + m_axes[0] * (Sign(x) * m_half.GetX()) +
               m_axes[1] * (Sign(y) * m_half.GetY()) + m_axes[2] * (Sign(z) * m_half.GetZ());
      case SShapeDescription::EKind::Cylinder: {
        const Real across = std::hypot(x, y);
        const Real scale = across > 0.0 ? m_radius / across : 0.0;
        return m_centre + m_axes[0] * (x * scale) + m_axes[1] * (y * scale) +
               m_axes[2] * (Sign(z) * m_half.GetZ());
      }
      case SShapeDescription::EKind::Prism: {
        const std::vector<CVector2>& base = *m_shape.Vertices;
        const CVector2 corner = ComputeShrunkCorner(base, FindFarthestCorner(base, CVector2(x, y)));
        return m_centre + m_axes[0] * corner.GetX() + m_axes[1] * corner.GetY() +
               m_axes[2] * (Sign(z) * m_half.GetZ());
      }
      case SShapeDescription::EKind::Hull: {
        const CVector3 corner = FromHull(m_shape.Solid->FindFarthest(CVector3(x, y, z)));
        return m_inside + (corner - m_inside) * m_scale;
      }
      case SShapeDescription::EKind::Sphere:
        break;
    }
    const Real length = direction.Length();
    return length > 0.0 ? m_centre + direction * (m_radius / length) : m_centre;
  }

 private:
  // a point of a hull, world frame
  CVector3 FromHull(const CVector3& point) const {
    return m_centre + m_axes[0] * point.GetX() + m_axes[1] * point.GetY() +
           m_axes[2] * (point.GetZ() - 0.5 * m_shape.Size.GetZ());
  }

  const SShapeDescription& m_shape;
  std::array<CVector3, 3> m_axes;  // have unit length
  CVector3 m_centre;  // m, half-way up the axis
  CVector3 m_inside;  // m
  CVector3 m_half;  // m, of a box; its z also of a cylinder or prism
  Real m_radius;  // m, of a cylinder or sphere
  Real m_scale = 1.0;  // scale of a hull, about the inner point
};

/** Up to four points; keeps those between which the nearest point to the origin is. */
class CSimplex {
 public:
  void Add(const CVector3& point) { m_points[m_count++] = point; }
  size_t GetCount() const { return m_count; }

  /** @return the nearest point to the origin; 0 if that is inside a tetrahedron. */
  CVector3 Reduce() {
    switch (m_count) {
      case 1:
        return m_points[0];
      case 2:
        return ReduceTo(NearestOnLine(0, 1));
      case 3:
        return ReduceTo(NearestOnTriangle({0, 1, 2}));
      default:
        return ReduceTetrahedron();
    }
  }

 private:
  // a feature of the simplex, and its nearest point to the origin
  struct SNearest {
    CVector3 Point;
    std::array<size_t, 3> Corners{};
    size_t Count = 0;
  };

  CVector3 ReduceTo(const SNearest& nearest) {
    std::array<CVector3, 3> kept;
    for (size_t i = 0; i < nearest.Count; ++i) {
      kept[i] = m_points[nearest.Corners[i]];
    }
    std::copy_n(kept.begin(), nearest.Count, m_points.begin());
    m_count = nearest.Count;
    return nearest.Point;
  }

  SNearest NearestOnLine(size_t start, size_t end) const {
    const CVector3& a = m_points[start];
    const CVector3 along = m_points[end] - a;
    const Real t = -a.DotProduct(along);
    const Real length = along.SquareLength();
    if (t <= 0.0 || !(length > 0.0)) {
      return {a, {start}, 1};
    }
    if (t >= length) {
      return {m_points[end], {end}, 1};
    }
    return {a + along * (t / length), {start, end}, 2};
  }

  static void Improve(SNearest& best, const SNearest& other) {
    if (best.Count == 0 || other.Point.SquareLength() < best.Point.SquareLength()) {
      best = other;
    }
  }

  SNearest NearestOnTriangle(const std::array<size_t, 3>& corners) const {
    const CVector3& a = m_points[corners[0]];
    const CVector3& b = m_points[corners[1]];
    const CVector3& c = m_points[corners[2]];
    const CVector3 normal = Cross(b - a, c - a);
    const Real square = normal.SquareLength();
    // true if the projection of the origin is on the inner side of all three sides
    if (square > 0.0 && Cross(b - a, normal).DotProduct(a) > 0.0 &&
        Cross(c - b, normal).DotProduct(b) > 0.0 && Cross(a - c, normal).DotProduct(c) > 0.0) {
      return {normal * (a.DotProduct(normal) / square), corners, 3};
    }
    SNearest best;
    Improve(best, NearestOnLine(corners[0], corners[1]));
    Improve(best, NearestOnLine(corners[1], corners[2]));
    Improve(best, NearestOnLine(corners[2], corners[0]));
    return best;
  }

  CVector3 ReduceTetrahedron() {
    SNearest best;
    bool isInside = true;
    for (size_t opposite = 0; opposite < 4; ++opposite) {
      const std::array<size_t, 3> face = {(opposite + 1) % 4, (opposite + 2) % 4,
                                          (opposite + 3) % 4};
      const CVector3& a = m_points[face[0]];
      const CVector3 normal = Cross(m_points[face[1]] - a, m_points[face[2]] - a);
      const Real origin = -a.DotProduct(normal);
      const Real inner = (m_points[opposite] - a).DotProduct(normal);
      if (origin * inner < 0.0 || inner == 0.0) {
        isInside = false;
        Improve(best, NearestOnTriangle(face));
      }
    }
    return isInside ? CVector3() : ReduceTo(best);
  }

  std::array<CVector3, 4> m_points;
  size_t m_count = 0;
};

}  // namespace

// The solids overlap if and only if the set of differences of their points contains the origin.
// Each step adds the farthest point of that set in the direction of the origin; the solids are
// apart if a plane separates the set from the origin.
bool SolidsOverlap(const SPlacedSolid& a, const SPlacedSolid& b) {
  const CConvex first(a);
  const CConvex second(b);
  CSimplex simplex;
  CVector3 nearest = first.GetInnerPoint() - second.GetInnerPoint();
  if (nearest.Length() < kInside) {
    return true;
  }
  Real before = HUGE_VAL;
  for (int step = 0; step < kMaxSteps; ++step) {
    const CVector3 farthest = first.FindFarthest(-nearest) - second.FindFarthest(nearest);
    if (nearest.DotProduct(farthest) > 0.0) {
      return false;
    }
    simplex.Add(farthest);
    nearest = simplex.Reduce();
    const Real distance = nearest.Length();
    // no progress: the distance is 0 but for rounding errors
    if (distance < kInside || distance >= before) {
      return true;
    }
    before = distance;
  }
  return true;
}

}  // namespace argos
