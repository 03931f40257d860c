#include <argos3/plugins/simulator/visualizations/scene/scene_parts.h>

#include <argos3/core/simulator/entity/anchor.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/pose_grid.h>
#include <argos3/core/utility/math/eigen_bridge.h>

namespace argos {

namespace {

constexpr char kOriginAnchor[] = "origin";

}  // namespace

SPose ToPose(const CVector3& position, const CQuaternion& orientation) {
  return {ToEigen(orientation).toRotationMatrix(), ToEigen(position)};
}

SPose ToVisiblePose(const SBodyPose& pose) {
  const SBodyPose snapped = SnapToPoseGrid(pose);
  return ToPose(snapped.Position, snapped.Orientation);
}

SPose ComputeAnchorPose(const SAnchor& anchor) {
  return ToVisiblePose(ComputeVisiblePose(anchor));
}

SPose ComputeAnchorPose(const std::string& anchor, CEmbodiedEntity* body, const SPose& origin) {
  if (body == nullptr || anchor == kOriginAnchor) {
    return origin;
  }
  const auto found = body->GetAnchors().find(anchor);
  return found == body->GetAnchors().end() ? origin : ComputeAnchorPose(*found->second);
}

SRgba ToRgba(const CColor& color) {
  return {color.GetRed(), color.GetGreen(), color.GetBlue(), color.GetAlpha()};
}

std::array<float, 3> ToFloats(const Eigen::Vector3d& vector) {
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()),
          static_cast<float>(vector.z())};
}

std::array<std::array<float, 4>, 3> ToRows(const SPose& pose, const Eigen::Vector3d& scale) {
  std::array<std::array<float, 4>, 3> rows;
  for (int row = 0; row < 3; ++row) {
    std::array<float, 4>& entries = rows[static_cast<std::size_t>(row)];
    for (int column = 0; column < 3; ++column) {
      entries[static_cast<std::size_t>(column)] =
          static_cast<float>(pose.Rotation(row, column) * scale[column]);
    }
    entries[3] = static_cast<float>(pose.Translation[row]);
  }
  return rows;
}

SMeshInstance MakeSolid(const SPose& pose, const Eigen::Vector3d& scale, const CColor& color) {
  SMeshInstance instance;
  instance.ToWorld = ToRows(pose, scale);
  instance.Color = ToRgba(color);
  return instance;
}

}  // namespace argos
