#include <argos3/core/utility/math/ray3.h>

#include <argos3/core/utility/math/plane.h>

namespace argos {

bool CRay3::Intersects(const CPlane& plane, CVector3& point) const {
  Real t = 0.0;
  if (!plane.Intersects(t, *this)) {
    return false;
  }
  GetPoint(point, t);
  return true;
}

std::ostream& operator<<(std::ostream& os, const CRay3& ray) {
  return os << ray.GetStart() << " -> " << ray.GetEnd();
}

}  // namespace argos
