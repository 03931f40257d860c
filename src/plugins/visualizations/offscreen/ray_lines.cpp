#include <argos3/plugins/simulator/visualizations/offscreen/ray_lines.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/utility/math/eigen_bridge.h>

namespace argos {

namespace {

constexpr SRgba kFreeRay = {36, 122, 196, 170};
constexpr SRgba kObstructedRay = {214, 52, 58, 230};
constexpr SRgba kHitPoint = {232, 40, 34, 255};
constexpr float kRayWidth = 1.4f;  // pixels
constexpr float kHitPointRadius = 0.004f;  // m
constexpr double kOnRay = 1e-9;  // of a ray's length: a hit is computed from its ray

bool IsOnRay(const CVector3& point, const CRay3& ray) {
  const Eigen::Vector3d start = ToEigen(ray.GetStart());
  const Eigen::Vector3d along = ToEigen(ray.GetEnd()) - start;
  const Eigen::Vector3d toPoint = ToEigen(point) - start;
  const double squaredLength = along.squaredNorm();
  const double share = squaredLength > 0.0 ? toPoint.dot(along) / squaredLength : 0.0;
  return share >= -kOnRay && share <= 1.0 + kOnRay &&
         (toPoint - share * along).norm() <= kOnRay * (1.0 + std::sqrt(squaredLength));
}

}  // namespace

void AddRayLines(CControllableEntity& robot, SScene& scene) {
  const std::vector<CVector3>& hits = robot.GetIntersectionPoints();
  // sensors record hits in the order of their rays, but not one for each
  size_t next = 0;
  for (const auto& [obstructed, ray] : robot.GetCheckedRays()) {
    SLine line;
    line.Start = ToFloats(ToEigen(ray.GetStart()));
    line.End = ToFloats(ToEigen(ray.GetEnd()));
    line.Color = obstructed ? kObstructedRay : kFreeRay;
    line.Width = kRayWidth;
    if (obstructed && next < hits.size() && IsOnRay(hits[next], ray)) {
      line.End = ToFloats(ToEigen(hits[next]));
      ++next;
    }
    scene.Lines.push_back(line);
  }
  for (const CVector3& point : hits) {
    SGlow dot;
    dot.Position = ToFloats(ToEigen(point));
    dot.Radius = kHitPointRadius;
    dot.Color = kHitPoint;
    scene.Glows.push_back(dot);
  }
}

}  // namespace argos
