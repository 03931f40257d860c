#include <argos3/core/utility/math/cylinder.h>

#include <argos3/core/utility/math/ray_span.h>

#include <cmath>

namespace argos {

bool CCylinder::Intersects(Real& tOnRay, const CRay3& ray) const {
  // unit vectors perpendicular to the axis; the first is built from the coordinate axis that is
  // farthest from it
  const CVector3 axis = CVector3(m_axis).Normalize();
  CVector3 across = std::fabs(axis.GetX()) < 0.6 ? CVector3::X : CVector3::Y;
  across = (across - axis * across.DotProduct(axis)).Normalize();
  const CVector3 other = CVector3(axis).CrossProduct(across);

  const CVector3 start = ray.GetStart() - m_basePosition;
  const CVector3 direction = ray.GetEnd() - ray.GetStart();
  SRaySpan inside;
  inside.ClipToSlab(start.DotProduct(axis), direction.DotProduct(axis), 0.0, m_height);
  ClipToDisc(inside, start.DotProduct(across), start.DotProduct(other),
             direction.DotProduct(across), direction.DotProduct(other), m_radius);
  return inside.FindFirst(tOnRay);
}

}  // namespace argos
