#include <argos3/testing/support/solid_reference.h>

#include <argos3/core/simulator/geometry/convex_solid.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

using TVector = Eigen::Vector3d;
using TFrame = Eigen::Isometry3d;

struct SSpan {
  Real First = 0.0;
  Real Last = 1.0;

  void Clip(Real first, Real last) {
    First = std::max(First, std::min(first, last));
    Last = std::min(Last, std::max(first, last));
  }
  void Empty() { Last = -1.0; }
};

TVector ToEigen(const CVector3& v) {
  return TVector(v.GetX(), v.GetY(), v.GetZ());
}

TFrame Frame(const CVector3& position, const CQuaternion& q) {
  TFrame frame = TFrame::Identity();
  frame.translate(ToEigen(position));
  frame.rotate(Eigen::Quaterniond(q.GetW(), q.GetX(), q.GetY(), q.GetZ()).normalized());
  return frame;
}

TFrame FrameOf(const SReferenceBody& body, const SShapeDescription& solid) {
  return Frame(body.Position, body.Orientation) * Frame(solid.Offset, solid.Orientation);
}

// restricts t to low <= component of p + t d <= high
void ClipToSlab(SSpan& span, Real p, Real d, Real low, Real high) {
  if (d != 0.0) {
    span.Clip((low - p) / d, (high - p) / d);
  } else if (p < low || p > high) {
    span.Empty();
  }
}

// restricts t to |p + t d|^2 <= radius^2, for the first components only
void ClipToRound(SSpan& span, const TVector& p, const TVector& d, int components, Real radius) {
  const Real a = d.head(components).squaredNorm();
  const Real b = 2.0 * p.head(components).dot(d.head(components));
  const Real c = p.head(components).squaredNorm() - radius * radius;
  const Real discriminant = b * b - 4.0 * a * c;
  if (a == 0.0) {
    if (c > 0.0) {
      span.Empty();
    }
  } else if (discriminant < 0.0) {
    span.Empty();
  } else {
    span.Clip((-b - std::sqrt(discriminant)) / (2.0 * a),
              (-b + std::sqrt(discriminant)) / (2.0 * a));
  }
}

// restricts t to the inner side of every side of an upright prism: a slab that is open on one side
void ClipToSides(SSpan& span, const TVector& p, const TVector& d,
                 const std::vector<CVector2>& base) {
  for (size_t i = 0; i < base.size(); ++i) {
    const CVector2& a = base[i];
    const CVector2& b = base[(i + 1) % base.size()];
    const TVector outwards(b.GetY() - a.GetY(), a.GetX() - b.GetX(), 0.0);
    ClipToSlab(span, outwards.dot(p), outwards.dot(d), -1e6,
               outwards.dot(TVector(a.GetX(), a.GetY(), 0.0)));
  }
}

}  // namespace

std::optional<Real> ReferenceHit(const SReferenceBody& body, const CRay3& ray) {
  std::optional<Real> closest;
  for (const SShapeDescription& solid : body.Description->Shapes) {
    const TFrame toSolid = FrameOf(body, solid).inverse();
    const TVector p = toSolid * ToEigen(ray.GetStart());
    const TVector d = toSolid * ToEigen(ray.GetEnd()) - p;
    SSpan span;
    switch (solid.Kind) {
      case SShapeDescription::EKind::Box:
        ClipToSlab(span, p.x(), d.x(), -0.5 * solid.Size.GetX(), 0.5 * solid.Size.GetX());
        ClipToSlab(span, p.y(), d.y(), -0.5 * solid.Size.GetY(), 0.5 * solid.Size.GetY());
        ClipToSlab(span, p.z(), d.z(), 0.0, solid.Size.GetZ());
        break;
      case SShapeDescription::EKind::Cylinder:
        ClipToRound(span, p, d, 2, solid.Radius);
        ClipToSlab(span, p.z(), d.z(), 0.0, solid.Size.GetZ());
        break;
      case SShapeDescription::EKind::Prism:
        ClipToSides(span, p, d, *solid.Vertices);
        ClipToSlab(span, p.z(), d.z(), 0.0, solid.Size.GetZ());
        break;
      case SShapeDescription::EKind::Sphere:
        ClipToRound(span, p - TVector(0.0, 0.0, solid.Radius), d, 3, solid.Radius);
        break;
      case SShapeDescription::EKind::Hull:
        for (const CConvexHull::SFace& face : solid.Solid->GetFaces()) {
          const TVector normal = ToEigen(face.Normal);
          ClipToSlab(span, normal.dot(p), normal.dot(d), -1e6, face.Direction);
        }
        break;
    }
    if (span.First <= span.Last && (!closest || span.First < *closest)) {
      closest = span.First;
    }
  }
  return closest;
}

std::vector<CVector3> SurfacePoints(const SReferenceBody& body, size_t solidNumber) {
  const SShapeDescription& solid = body.Description->Shapes[solidNumber];
  const TFrame frame = FrameOf(body, solid);
  std::vector<CVector3> points;
  const auto add = [&](Real x, Real y, Real z) {
    const TVector point = frame * TVector(x, y, z);
    points.emplace_back(point.x(), point.y(), point.z());
  };
  constexpr int kSteps = 16;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Real u = static_cast<Real>(i) / kSteps;
      const Real v = static_cast<Real>(j) / kSteps;
      const Real angle = 2.0 * M_PI * u;
      const Real height = solid.Size.GetZ();
      if (solid.Kind == SShapeDescription::EKind::Box) {
        const Real x = (u - 0.5) * solid.Size.GetX();
        const Real y = (v - 0.5) * solid.Size.GetY();
        add(x, y, 0.0);
        add(x, y, height);
      } else if (solid.Kind == SShapeDescription::EKind::Cylinder) {
        add(solid.Radius * std::cos(angle), solid.Radius * std::sin(angle), v * height);
      } else if (solid.Kind == SShapeDescription::EKind::Prism) {
        // around the base, corners included
        const auto& base = *solid.Vertices;
        for (size_t corner = 0; corner < base.size(); ++corner) {
          const CVector2 point = base[corner] * (1.0 - u) + base[(corner + 1) % base.size()] * u;
          add(point.GetX(), point.GetY(), v * height);
        }
      } else {
        const Real inclination = M_PI * v;
        add(solid.Radius * std::sin(inclination) * std::cos(angle),
            solid.Radius * std::sin(inclination) * std::sin(angle),
            solid.Radius * (1.0 + std::cos(inclination)));
      }
    }
  }
  return points;
}

}  // namespace argos
