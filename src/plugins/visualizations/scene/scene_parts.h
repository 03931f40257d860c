#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_SCENE_PARTS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_SCENE_PARTS_H

#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/plugins/simulator/visualizations/scene/scene.h>

#include <Eigen/Core>

namespace argos {

class CEmbodiedEntity;
struct SAnchor;

/** A rigid pose in the world frame, m. */
struct SPose {
  Eigen::Matrix3d Rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d Translation = Eigen::Vector3d::Zero();

  /** A pose given in this pose's frame, in the world frame. */
  SPose operator*(const SPose& inner) const {
    return {Rotation * inner.Rotation, Translation + Rotation * inner.Translation};
  }
  /** A point given in this pose's frame, in the world frame. */
  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return Translation + Rotation * point;
  }
};

SPose ToPose(const CVector3& position, const CQuaternion& orientation);

/** Rounded to the grid of all that views draw, so that a replay draws the same. */
SPose ToVisiblePose(const SBodyPose& pose);

/** Visible pose of an anchor; if not enabled, it keeps its place on the body. */
SPose ComputeAnchorPose(const SAnchor& anchor);
/** The same by its id; @p origin if the body is null or has no such anchor. */
SPose ComputeAnchorPose(const std::string& anchor, CEmbodiedEntity* body, const SPose& origin);

SRgba ToRgba(const CColor& color);
std::array<float, 3> ToFloats(const Eigen::Vector3d& vector);

/** Rows of the 3 x 4 matrix of a pose. @param scale  along the axes of its frame. */
std::array<std::array<float, 4>, 3> ToRows(const SPose& pose, const Eigen::Vector3d& scale);

/** A solid of the scene. @param scale  of the unit mesh, along its axes, m. */
SMeshInstance MakeSolid(const SPose& pose, const Eigen::Vector3d& scale, const CColor& color);

}  // namespace argos

#endif
