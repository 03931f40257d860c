#include <argos3/testing/support/overlap.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace argos::testing {

namespace {

constexpr size_t kNoRobot = std::numeric_limits<size_t>::max();

// a robot as a cylinder, which may be tilted
struct SUpright {
  UInt32 Body;  // number in the index
  CVector3 Base, Top;  // ends of its axis, m
  Real Radius;  // m
};

SUpright Describe(const CEmbodiedEntity& body) {
  const SBodyDescription& description = *body.GetBodyDescription();
  const SAnchor& origin = body.GetOriginAnchor();
  Real height = 0.0;
  for (const SShapeDescription& shape : description.Shapes) {
    height = std::max(height, shape.Offset.GetZ() + shape.Size.GetZ());
  }
  CVector3 axis(0.0, 0.0, height);
  axis.Rotate(origin.Orientation);
  return {body.GetBodyNumber(), origin.Position, origin.Position + axis,
          description.ComputeBoundingRadius()};
}

Real DistanceFromAbove(const CVector3& a, const CVector3& b) {
  return std::hypot(a.GetX() - b.GetX(), a.GetY() - b.GetY());
}

// depth of the overlap of two robots at their bases or at their tops, m; negative: a gap
Real DepthInRobot(const SUpright& robot, const SUpright& other) {
  return robot.Radius + other.Radius -
         std::min(DistanceFromAbove(robot.Base, other.Base),
                  DistanceFromAbove(robot.Top, other.Top));
}

Real DepthInDisc(const SUpright& robot, const SIndexedShape& disc) {
  return robot.Radius + disc.HalfX -
         std::hypot(robot.Base.GetX() - disc.X, robot.Base.GetY() - disc.Y);
}

// depth of a disc inside a rectangle, m; 0 outside
Real DepthInBox(const SIndexedShape& box, const CVector3& centre, Real radius) {
  const Real dx = centre.GetX() - box.X;
  const Real dy = centre.GetY() - box.Y;
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
  const auto last = static_cast<Real>(sample.size() - 1);
  const auto quantile = sample.begin() + static_cast<SInt64>(std::ceil(q * last));
  std::nth_element(sample.begin(), quantile, sample.end());
  return *quantile;
}

void MeasureOverlaps(CSpace& space, SOverlaps& overlaps) {
  const CBodyIndex& index = space.GetBodyIndex();
  std::vector<SUpright> robots;
  std::vector<size_t> robotOfBody(0);
  for (CControllableEntity* robot : space.GetControllableEntities()) {
    const auto& body = robot->GetParent().GetComponent<CEmbodiedEntity>("body");
    if (body.GetBodyNumber() >= robotOfBody.size()) {
      robotOfBody.resize(body.GetBodyNumber() + 1, kNoRobot);
    }
    robotOfBody[body.GetBodyNumber()] = robots.size();
    robots.push_back(Describe(body));
  }
  for (const SUpright& robot : robots) {
    const Real lean = DistanceFromAbove(robot.Base, robot.Top);
    const Real reach = (1.0 + SOverlaps::kTouchingGap) * robot.Radius + lean;
    Real withRobots = -reach;  // negative: a gap
    Real withWalls = 0.0;
    const auto measure = [&](const SIndexedShape& shape) {
      if (shape.Body == robot.Body) {
        return;
      }
      if (shape.Kind == SIndexedShape::EKind::Box) {
        withWalls = std::max(withWalls, DepthInBox(shape, robot.Base, robot.Radius));
        withWalls = std::max(withWalls, DepthInBox(shape, robot.Top, robot.Radius));
        return;
      }
      const CEmbodiedEntity& other = index.GetBody(shape.Body);
      const bool isRobot = shape.Body < robotOfBody.size() && robotOfBody[shape.Body] != kNoRobot;
      // the index has only bounds of tilted bodies, so overlaps with tilted boxes are not measured
      if (!isRobot && shape.Kind == SIndexedShape::EKind::Bounds) {
        const SShapeDescription& solid = other.GetBodyDescription()->Shapes[shape.Shape];
        if (solid.Kind == SShapeDescription::EKind::Cylinder) {
          withRobots = std::max(withRobots, DepthInRobot(robot, Describe(other)));
        }
        return;
      }
      const Real depth = isRobot && (lean > 0.0 || shape.Kind == SIndexedShape::EKind::Bounds)
                             ? DepthInRobot(robot, robots[robotOfBody[shape.Body]])
                             : DepthInDisc(robot, shape);
      withRobots = std::max(withRobots, depth);
    };
    index.ForShapesNear(robot.Base.GetX(), robot.Base.GetY(), reach, measure);
    const Real share = withRobots / robot.Radius;
    overlaps.WithRobots.push_back(std::max(share, 0.0));
    if (share > -SOverlaps::kTouchingGap) {
      overlaps.Touching.push_back(std::max(share, 0.0));
    }
    overlaps.WithWalls.push_back(withWalls / robot.Radius);
  }
}

}  // namespace argos::testing
