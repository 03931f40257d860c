#ifndef ARGOS3_COMPAT_CORE_UTILITY_MATH_BOX_H
#define ARGOS3_COMPAT_CORE_UTILITY_MATH_BOX_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/**
 * A solid box. The origin of its frame is the centre of the base: x and y extend half a size to
 * either side, z from 0 to the full size. Lengths in m.
 */
class CBox {
 public:
  CBox(const CVector3& size, const CVector3& basePosition = CVector3(),
       const CQuaternion& orientation = CQuaternion())
      : m_size(size), m_basePosition(basePosition), m_orientation(orientation) {}

  const CVector3& GetSize() const { return m_size; }
  void SetSize(const CVector3& size) { m_size = size; }
  const CVector3& GetBasePosition() const { return m_basePosition; }
  void SetBasePosition(const CVector3& basePosition) { m_basePosition = basePosition; }
  const CQuaternion& GetOrientation() const { return m_orientation; }
  void SetOrientation(const CQuaternion& orientation) { m_orientation = orientation; }

  /**
   * @return true if the ray, extended beyond its end, meets the solid; touching counts.
   *
   * @param tOnRay  set on success to the parameter of the first common point: 0 at the start of the
   *   ray (also if the start is inside), 1 at its end, more beyond it; to test the segment only,
   *   compare with 1.
   */
  bool Intersects(Real& tOnRay, const CRay3& ray) const;

 private:
  CVector3 m_size;
  CVector3 m_basePosition;
  CQuaternion m_orientation;
};

}  // namespace argos

#endif
