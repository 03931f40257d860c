#include <argos3/core/utility/math/vector2.h>

#include <argos3/core/utility/math/matrix/matrix.h>
#include <argos3/core/utility/math/text_input.h>

namespace argos {

CVector2::operator CMatrix<1, 2>() const {
  const Real values[] = {m_x, m_y};
  return CMatrix<1, 2>(values);
}

CVector2::operator CMatrix<2, 1>() const {
  const Real values[] = {m_x, m_y};
  return CMatrix<2, 1>(values);
}

std::ostream& operator<<(std::ostream& os, const CVector2& vector) {
  return os << vector.GetX() << "," << vector.GetY();
}

std::istream& operator>>(std::istream& is, CVector2& vector) {
  if (is) {
    std::array<Real, 2> coordinates;
    ReadNumbers(is, coordinates.data(), 2, "a 2D vector (x,y)");
    vector.Set(coordinates);
  }
  return is;
}

}  // namespace argos
