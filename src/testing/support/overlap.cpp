#include <argos3/testing/support/overlap.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/core/simulator/space/body_index.h>

#include <algorithm>
#include <cmath>

namespace argos::testing {

namespace {

// how deep a disc is inside a rectangle, m; 0 if it is outside
Real DepthInBox(const SIndexedShape& box, Real x, Real y, Real radius) {
  const Real dx = x - box.X;
  const Real dy = y - box.Y;
  const Real outX = std::abs(box.Cos * dx + box.Sin * dy) - box.HalfX;
  const Real outY = std::abs(box.Cos * dy - box.Sin * dx) - box.HalfY;
  if (outX <= 0.0 && outY <= 0.0) {
    return radius - std::max(outX, outY);
  }
  return std::max(0.0, radius - std::hypot(std::max(outX, 0.0), std::max(outY, 0.0)));
}

}  // namespace

Real SOverlaps::Quantile(std::vector<Real>& sample, Real q) {
  if (sample.empty()) {
    return 0.0;
  }
  std::sort(sample.begin(), sample.end());
  const auto last = static_cast<Real>(sample.size() - 1);
  return sample[static_cast<size_t>(std::ceil(q * last))];
}

void MeasureOverlaps(CSpace& space, SOverlaps& overlaps) {
  const CBodyIndex& index = space.GetBodyIndex();
  for (CControllableEntity* robot : space.GetControllableEntities()) {
    const auto& body = robot->GetParent().GetComponent<CEmbodiedEntity>("body");
    const CVector3& position = body.GetOriginAnchor().Position;
    const Real radius = body.GetBodyDescription()->ComputeBoundingRadius();
    Real withRobots = 0.0;
    Real withWalls = 0.0;
    index.ForShapesNear(position.GetX(), position.GetY(), radius, [&](const SIndexedShape& shape) {
      if (shape.Body == body.GetBodyNumber()) {
        return;
      }
      if (shape.Kind == SIndexedShape::EKind::Box) {
        withWalls =
            std::max(withWalls, DepthInBox(shape, position.GetX(), position.GetY(), radius));
      } else {
        const Real distance = std::hypot(position.GetX() - shape.X, position.GetY() - shape.Y);
        withRobots = std::max(withRobots, radius + shape.HalfX - distance);
      }
    });
    overlaps.WithRobots.push_back(withRobots / radius);
    overlaps.WithWalls.push_back(withWalls / radius);
  }
}

}  // namespace argos::testing
