#ifndef ARGOS3_CORE_UTILITY_MATH_PLANE_H
#define ARGOS3_CORE_UTILITY_MATH_PLANE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/** An infinite plane, given by a point and a normal of any length but zero. */
class CPlane {
 public:
  /** The xy plane. */
  constexpr CPlane() : m_position(), m_normal(CVector3::Z) {}

  constexpr CPlane(const CVector3& position, const CVector3& normal)
      : m_position(position), m_normal(normal) {}

  /** See SetFromThreePoints(). */
  constexpr CPlane(const CVector3& p1, const CVector3& p2, const CVector3& p3) : CPlane() {
    SetFromThreePoints(p1, p2, p3);
  }

  constexpr const CVector3& GetPosition() const { return m_position; }
  constexpr void SetPosition(const CVector3& position) { m_position = position; }
  constexpr const CVector3& GetNormal() const { return m_normal; }
  constexpr void SetNormal(const CVector3& normal) { m_normal = normal; }

  /** Sets the position to p2 and the normal to (p3 - p2) x (p1 - p2), whose length is twice the
   * triangle's area. */
  constexpr void SetFromThreePoints(const CVector3& p1, const CVector3& p2, const CVector3& p3) {
    m_position = p2;
    m_normal = (p3 - p2).CrossProduct(p1 - p2);
  }

  /**
   * @return true if the ray, ends included, meets the plane.
   *
   * @param tOnRay  set on success to the parameter of the common point: 0 at the start, 1 at the
   *   end. A ray inside the plane meets it at its start.
   */
  bool Intersects(Real& tOnRay, const CRay3& ray) const;

 private:
  CVector3 m_position;
  CVector3 m_normal;
};

}  // namespace argos

#endif
