#include <argos3/core/utility/math/angles.h>

namespace argos {

namespace {

template <typename ANGLE>
std::istream& ReadAngle(std::istream& is, ANGLE& angle) {
  Real value = 0.0;
  if (is >> value) {
    angle.SetValue(value);
  }
  return is;
}

}  // namespace

std::ostream& operator<<(std::ostream& os, const CRadians& angle) {
  return os << "CRadians(" << angle.GetValue() << " -> " << ToDegrees(angle).GetValue()
            << " degrees)";
}

std::istream& operator>>(std::istream& is, CRadians& angle) {
  return ReadAngle(is, angle);
}

std::ostream& operator<<(std::ostream& os, const CDegrees& angle) {
  return os << "CDegrees(" << angle.GetValue() << ")";
}

std::istream& operator>>(std::istream& is, CDegrees& angle) {
  return ReadAngle(is, angle);
}

}  // namespace argos
