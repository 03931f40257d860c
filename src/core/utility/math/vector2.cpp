#include <argos3/core/utility/math/vector2.h>

#include <argos3/core/utility/math/text_input.h>

namespace argos {

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
