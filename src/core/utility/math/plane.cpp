#include <argos3/core/utility/math/plane.h>

namespace argos {

bool CPlane::Intersects(Real& tOnRay, const CRay3& ray) const {
  // heights above the plane, in units of the normal's length
  const Real start = (ray.GetStart() - m_position).DotProduct(m_normal);
  const Real end = (ray.GetEnd() - m_position).DotProduct(m_normal);
  if (start == 0.0) {
    tOnRay = 0.0;
    return true;
  }
  if (end == 0.0) {
    tOnRay = 1.0;
    return true;
  }
  if ((start > 0.0) == (end > 0.0)) {
    return false;
  }
  tOnRay = start / (start - end);
  return true;
}

}  // namespace argos
