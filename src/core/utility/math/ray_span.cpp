#include <argos3/core/utility/math/ray_span.h>

namespace argos {

void ClipToDisc(SRaySpan& span, Real startX, Real startY, Real directionX, Real directionY,
                Real radius) {
  const Real squareStart = startX * startX + startY * startY - radius * radius;
  const Real squareDirection = directionX * directionX + directionY * directionY;
  if (squareDirection == 0.0) {
    if (!(squareStart <= 0.0)) {
      span = SRaySpan::None();
    }
    return;
  }

  // roots of a t^2 + 2 b t + c; the discriminant through the cross product, since b^2 - a c would
  // cancel when the start is far away
  const Real half = startX * directionX + startY * directionY;
  const Real cross = startX * directionY - startY * directionX;
  const Real discriminant = radius * radius * squareDirection - cross * cross;
  if (discriminant < 0.0) {
    span = SRaySpan::None();
    return;
  }
  // both roots without subtracting nearly equal numbers
  const Real q = -(half + std::copysign(std::sqrt(discriminant), half));
  const Real oneRoot = q / squareDirection;
  const Real otherRoot = q == 0.0 ? oneRoot : squareStart / q;
  span.Clip(oneRoot, otherRoot);
}

}  // namespace argos
