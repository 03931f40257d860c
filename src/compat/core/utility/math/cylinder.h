#ifndef ARGOS3_COMPAT_CORE_UTILITY_MATH_CYLINDER_H
#define ARGOS3_COMPAT_CORE_UTILITY_MATH_CYLINDER_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/** A solid cylinder: a disc about the base position, swept along the axis. Lengths in m. */
class CCylinder {
 public:
  /** @param axis  direction from the base to the top, of any length but zero. */
  CCylinder(Real radius, Real height, const CVector3& basePosition = CVector3(),
            const CVector3& axis = CVector3::Z)
      : m_radius(radius), m_height(height), m_basePosition(basePosition), m_axis(axis) {}

  Real GetRadius() const { return m_radius; }
  void SetRadius(Real radius) { m_radius = radius; }
  Real GetHeight() const { return m_height; }
  void SetHeight(Real height) { m_height = height; }
  const CVector3& GetBasePosition() const { return m_basePosition; }
  void SetBasePosition(const CVector3& basePosition) { m_basePosition = basePosition; }
  const CVector3& GetAxis() const { return m_axis; }
  void SetAxis(const CVector3& axis) { m_axis = axis; }

  /**
   * @return true if the ray, extended beyond its end, meets the solid; touching counts.
   *
   * @param tOnRay  set on success to the parameter of the first common point: 0 at the start of the
   *   ray (also if the start is inside), 1 at its end, more beyond it; to test the segment only,
   *   compare with 1.
   */
  bool Intersects(Real& tOnRay, const CRay3& ray) const;

 private:
  Real m_radius;
  Real m_height;
  CVector3 m_basePosition;
  CVector3 m_axis;
};

}  // namespace argos

#endif
