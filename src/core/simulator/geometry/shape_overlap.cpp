#include <argos3/core/simulator/geometry/shape_overlap.h>

#include <argos3/core/utility/spatial/rectangle.h>

#include <cmath>

namespace argos {

namespace {

// m; poses are rounded to far less than this, and bodies that are put side by side must fit
constexpr Real kTouch = 1e-9;

bool IsBox(const SIndexedShape& shape) {
  return shape.Kind == SIndexedShape::EKind::Box;
}

bool DiscsOverlap(const SIndexedShape& a, const SIndexedShape& b) {
  const Real dx = a.X - b.X;
  const Real dy = a.Y - b.Y;
  const Real reach = a.HalfX + b.HalfX - kTouch;
  return reach > 0.0 && dx * dx + dy * dy < reach * reach;
}

bool DiscOverlapsBox(const SIndexedShape& disc, const SIndexedShape& box) {
  const Real reach = disc.HalfX - kTouch;
  return ComputeSquareDistance(box, disc.X, disc.Y) < reach * reach;
}

// two rectangles are apart if and only if they are apart along one of their four axes
bool BoxesOverlap(const SIndexedShape& a, const SIndexedShape& b) {
  const Real axes[4][2] = {{a.Cos, a.Sin}, {-a.Sin, a.Cos}, {b.Cos, b.Sin}, {-b.Sin, b.Cos}};
  for (const auto& axis : axes) {
    const Real distance = std::abs((a.X - b.X) * axis[0] + (a.Y - b.Y) * axis[1]);
    const Real reach =
        ComputeHalfWidth(a, axis[0], axis[1]) + ComputeHalfWidth(b, axis[0], axis[1]);
    if (distance >= reach - kTouch) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool ShapesOverlap(const SIndexedShape& a, const SIndexedShape& b) {
  if (a.ZMin >= b.ZMax - kTouch || b.ZMin >= a.ZMax - kTouch) {
    return false;
  }
  if (IsBox(a)) {
    return IsBox(b) ? BoxesOverlap(a, b) : DiscOverlapsBox(b, a);
  }
  return IsBox(b) ? DiscOverlapsBox(a, b) : DiscsOverlap(a, b);
}

}  // namespace argos
