#include <argos3/core/utility/math/pose2.h>

namespace argos {

CPose2::CPose2(const CVector3& position, const CQuaternion& orientation)
    : m_position(position.GetX(), position.GetY()), m_orientation() {
  CRadians y;
  CRadians x;
  orientation.ToEulerAngles(m_orientation, y, x);
}

CPose2 CPose2::Inverse() const {
  return CPose2((-m_position).Rotate(-m_orientation), -m_orientation);
}

CPose2 CPose2::operator*(const CPose2& other) const {
  return CPose2(*this * other.m_position, m_orientation + other.m_orientation);
}

CVector2 CPose2::operator*(const CVector2& point) const {
  return m_position + CVector2(point).Rotate(m_orientation);
}

}  // namespace argos
