#include <argos3/core/utility/math/box.h>

#include <argos3/core/utility/math/ray_clipper.h>
#include <argos3/core/utility/math/transforms.h>

namespace argos {

bool CBox::Intersects(Real& tOnRay, const CRay3& ray) const {
  const CVector3 start = GlobalToLocal(ray.GetStart(), m_basePosition, m_orientation);
  const CVector3 direction = (ray.GetEnd() - ray.GetStart()).Rotate(m_orientation.Inverse());
  const Real halfX = 0.5 * m_size.GetX();
  const Real halfY = 0.5 * m_size.GetY();
  CRayClipper clipper;
  clipper.ClipToSlab(start.GetX(), direction.GetX(), -halfX, halfX);
  clipper.ClipToSlab(start.GetY(), direction.GetY(), -halfY, halfY);
  clipper.ClipToSlab(start.GetZ(), direction.GetZ(), 0.0, m_size.GetZ());
  return clipper.GetFirst(tOnRay);
}

}  // namespace argos
