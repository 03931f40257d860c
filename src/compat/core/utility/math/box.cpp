#include <argos3/core/utility/math/box.h>

#include <argos3/core/utility/math/ray_span.h>
#include <argos3/core/utility/math/transforms.h>

namespace argos {

bool CBox::Intersects(Real& tOnRay, const CRay3& ray) const {
  const CVector3 start = GlobalToLocal(ray.GetStart(), m_basePosition, m_orientation);
  const CVector3 direction = (ray.GetEnd() - ray.GetStart()).Rotate(m_orientation.Inverse());
  const Real halfX = 0.5 * m_size.GetX();
  const Real halfY = 0.5 * m_size.GetY();
  SRaySpan inside;
  inside.ClipToSlab(start.GetX(), direction.GetX(), -halfX, halfX);
  inside.ClipToSlab(start.GetY(), direction.GetY(), -halfY, halfY);
  inside.ClipToSlab(start.GetZ(), direction.GetZ(), 0.0, m_size.GetZ());
  return inside.FindFirst(tOnRay);
}

}  // namespace argos
