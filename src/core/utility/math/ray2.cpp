#include <argos3/core/utility/math/ray2.h>

namespace argos {

namespace {

// sine of the angle below which two segments count as parallel; far above the rounding of a cross
// product (1e-16), far below any angle of practical interest
constexpr Real kParallelSine = 1e-10;

constexpr bool IsInUnitInterval(Real value) {
  return 0.0 <= value && value <= 1.0;
}

}  // namespace

bool CRay2::Intersects(const CRay2& other) const {
  // solve start + t direction = other.start + s other.direction by Cramer's rule
  const CVector2 direction = m_end - m_start;
  const CVector2 otherDirection = other.m_end - other.m_start;
  const Real determinant = direction.CrossProduct(otherDirection);
  if (std::fabs(determinant) <= kParallelSine * direction.Length() * otherDirection.Length()) {
    return false;
  }
  const CVector2 offset = other.m_start - m_start;
  return IsInUnitInterval(offset.CrossProduct(otherDirection) / determinant) &&
         IsInUnitInterval(offset.CrossProduct(direction) / determinant);
}

std::ostream& operator<<(std::ostream& os, const CRay2& ray) {
  return os << ray.GetStart() << " -> " << ray.GetEnd();
}

}  // namespace argos
