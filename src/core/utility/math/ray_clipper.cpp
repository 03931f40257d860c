#include <argos3/core/utility/math/ray_clipper.h>

#include <algorithm>
#include <cmath>

namespace argos {

void CRayClipper::ClipToSlab(Real start, Real direction, Real min, Real max) {
  if (direction == 0.0) {
    if (!(min <= start && start <= max)) {
      KeepNothing();
    }
    return;
  }
  const Real atMin = (min - start) / direction;
  const Real atMax = (max - start) / direction;
  Keep(std::min(atMin, atMax), std::max(atMin, atMax));
}

void CRayClipper::ClipToDisc(Real startX, Real startY, Real directionX, Real directionY,
                             Real radius) {
  const Real squareStart = startX * startX + startY * startY - radius * radius;
  const Real squareDirection = directionX * directionX + directionY * directionY;
  if (squareDirection == 0.0) {
    if (!(squareStart <= 0.0)) {
      KeepNothing();
    }
    return;
  }

  // roots of a t^2 + 2 b t + c; the discriminant uses the cross product, since b^2 - a c would
  // cancel for a start far away
  const Real half = startX * directionX + startY * directionY;
  const Real cross = startX * directionY - startY * directionX;
  const Real discriminant = radius * radius * squareDirection - cross * cross;
  if (discriminant < 0.0) {
    KeepNothing();
    return;
  }
  // both roots without subtracting nearly equal numbers: Press et al., Numerical Recipes,
  // section 5.6
  const Real q = -(half + std::copysign(std::sqrt(discriminant), half));
  const Real oneRoot = q / squareDirection;
  const Real otherRoot = q == 0.0 ? oneRoot : squareStart / q;
  Keep(std::min(oneRoot, otherRoot), std::max(oneRoot, otherRoot));
}

bool CRayClipper::GetFirst(Real& t) const {
  if (m_first > m_last || m_last < 0.0) {
    return false;
  }
  t = std::max(m_first, 0.0);
  return true;
}

void CRayClipper::Keep(Real first, Real last) {
  m_first = std::max(m_first, first);
  m_last = std::min(m_last, last);
}

}  // namespace argos
