#ifndef ARGOS3_COMPAT_CORE_UTILITY_MATH_POSE2_H
#define ARGOS3_COMPAT_CORE_UTILITY_MATH_POSE2_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/**
 * A position in m and an orientation in the plane, or equivalently the motion that maps the origin
 * to it: first rotate, then translate. Poses compose as the group SE(2). Orientations add up
 * without normalisation.
 */
class CPose2 {
 public:
  /** The origin, facing along x. */
  constexpr CPose2() = default;

  constexpr CPose2(const CPose2& other) = default;
  constexpr CPose2& operator=(const CPose2& other) = default;

  constexpr CPose2(const CVector2& position, const CRadians& orientation)
      : m_position(position), m_orientation(orientation) {}

  /** @param theta in radians. */
  constexpr CPose2(const Real x, const Real y, const Real theta)
      : m_position(x, y), m_orientation(CRadians(theta)) {}

  /** Takes x, y and the Euler angle about z of a pose in space. */
  CPose2(const CVector3& position, const CQuaternion& orientation);

  constexpr const CVector2& GetPosition() const { return m_position; }
  constexpr const CRadians& GetOrientation() const { return m_orientation; }

  /** Rotates in place, counter-clockwise. */
  constexpr void Rotate(const CRadians& angle) { m_orientation += angle; }

  /** Translates by a vector in the frame of the pose: x is forward, y is left. */
  void Translate(const CVector2& translation) { m_position = *this * translation; }

  /** Returns the pose of the origin in the frame of this pose. */
  CPose2 Inverse() const;

  /** Converts a pose from the frame of this pose to the outer frame. */
  CPose2 operator*(const CPose2& other) const;

  /** Converts a point from the frame of this pose to the outer frame. */
  CVector2 operator*(const CVector2& point) const;

  CPose2& operator*=(const CPose2& other) { return *this = *this * other; }

  /** Exact comparison; orientations that differ by a whole turn differ. */
  constexpr bool operator==(const CPose2& other) const {
    return m_position == other.m_position && m_orientation == other.m_orientation;
  }

  constexpr bool operator!=(const CPose2& other) const { return !(*this == other); }

 private:
  CVector2 m_position;
  CRadians m_orientation;
};

}  // namespace argos

#endif
