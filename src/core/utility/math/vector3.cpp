#include <argos3/core/utility/math/vector3.h>

#include <argos3/core/utility/math/text_input.h>

namespace argos {

void CVector3::ToSphericalCoords(Real& radius, CRadians& inclination, CRadians& azimuth) const {
  const Real radiusInPlane = std::sqrt(m_x * m_x + m_y * m_y);
  radius = Length();
  // acos(z / radius) would lose half of the digits near the poles
  inclination = radius > 0.0 ? ATan2(radiusInPlane, m_z) : CRadians();
  azimuth = radiusInPlane > 0.0 ? ATan2(m_y, m_x) : CRadians();
}

CRadians CVector3::GetAngleWith(const CVector3& other) const {
  CVector3 cross = *this;
  const Real sine = cross.CrossProduct(other).Length();
  const Real cosine = DotProduct(other);
  return sine == 0.0 && cosine == 0.0 ? CRadians() : ATan2(sine, cosine);
}

Real& CVector3::RejectIndex(UInt32 index) {
  THROW_ARGOSEXCEPTION("Index " << index
                                << " is out of range: a 3D vector has components 0, 1 and 2.");
}

std::ostream& operator<<(std::ostream& os, const CVector3& vector) {
  return os << vector.GetX() << "," << vector.GetY() << "," << vector.GetZ();
}

std::istream& operator>>(std::istream& is, CVector3& vector) {
  if (is) {
    std::array<Real, 3> coordinates;
    ReadNumbers(is, coordinates.data(), 3, "a 3D vector (x,y,z)");
    vector.Set(coordinates);
  }
  return is;
}

}  // namespace argos
