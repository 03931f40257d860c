#include <argos3/plugins/simulator/visualizations/scene/ray_lines.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/geometry/pose_grid.h>
#include <argos3/core/utility/math/eigen_bridge.h>

namespace argos {

namespace {

constexpr SRgba kFreeRay = {36, 122, 196, 170};
constexpr SRgba kObstructedRay = {214, 52, 58, 230};
constexpr SRgba kHitPoint = {232, 40, 34, 255};
constexpr float kRayWidth = 1.4f;  // pixels
constexpr float kHitPointRadius = 0.004f;  // m
// m; a hit is computed from its ray, and both are rounded as all that views draw
constexpr double kOnRay = 4e-6;

// on the grid, so that a replay of a recording draws the same
Eigen::Vector3d ToVisible(const CVector3& point) {
  return ToEigen(SnapToPoseGrid(point));
}

bool IsOnRay(const Eigen::Vector3d& point, const Eigen::Vector3d& start,
             const Eigen::Vector3d& end) {
  const double length = (end - start).norm();
  if (length == 0.0) {
    return (point - start).norm() <= kOnRay;
  }
  const Eigen::Vector3d direction = (end - start) / length;
  const double reach = (point - start).dot(direction);
  return reach >= -kOnRay && reach <= length + kOnRay &&
         (point - start - reach * direction).norm() <= kOnRay;
}

}  // namespace

void AddRayLines(CControllableEntity& robot, SScene& scene) {
  const std::vector<CVector3>& hits = robot.GetIntersectionPoints();
  // sensors record hits in the order of their rays, but not one for each
  size_t next = 0;
  for (const auto& [obstructed, ray] : robot.GetCheckedRays()) {
    SLine line;
    const Eigen::Vector3d start = ToVisible(ray.GetStart());
    const Eigen::Vector3d end = ToVisible(ray.GetEnd());
    line.Start = ToFloats(start);
    line.End = ToFloats(end);
    line.Color = obstructed ? kObstructedRay : kFreeRay;
    line.Width = kRayWidth;
    if (obstructed && next < hits.size() && IsOnRay(ToVisible(hits[next]), start, end)) {
      line.End = ToFloats(ToVisible(hits[next]));
      ++next;
    }
    scene.Lines.push_back(line);
  }
  for (const CVector3& point : hits) {
    SGlow dot;
    dot.Position = ToFloats(ToVisible(point));
    dot.Radius = kHitPointRadius;
    dot.Color = kHitPoint;
    scene.Glows.push_back(dot);
  }
}

}  // namespace argos
