#include <argos3/plugins/simulator/visualizations/scene/camera.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace argos {

namespace {

constexpr double kHalfPictureHeight = 13.5;  // mm; the reference's 27 mm high picture
constexpr double kVerticalShare = 1e-9;  // far below any meaningful difference in aim

}  // namespace

bool IsVertical(const Eigen::Vector3d& forward) {
  return forward.head<2>().norm() <= kVerticalShare * forward.norm();
}

Eigen::Vector3d ComputeDefaultUp(const Eigen::Vector3d& forward) {
  Eigen::Vector3d left = Eigen::Vector3d::UnitY();
  if (!IsVertical(forward)) {
    left = Eigen::Vector3d(-forward.y(), forward.x(), 0.0);
  }
  return forward.cross(left).normalized();
}

std::array<SCameraPlacement, kNumPlacements> MakeDefaultPlacements(const SArenaBox& arena) {
  std::array<SCameraPlacement, kNumPlacements> placements;
  for (std::size_t i = 0; i < kNumPlacements; ++i) {
    const double angle = std::numbers::pi / 6.0 * static_cast<double>(i);
    const Eigen::Vector3d outward(std::cos(angle), std::sin(angle), 0.0);
    SCameraPlacement& placement = placements[i];
    placement.Position =
        arena.Center + Eigen::Vector3d(0.0, 0.0, arena.Size.z()) + arena.Size.norm() * outward;
    placement.LookAt = Eigen::Vector3d(arena.Center.x(), arena.Center.y(), 0.0);
    placement.Up = Eigen::Vector3d::UnitZ();
    placement.FocalLength = 57.5 + 7.5 * std::cos(4.0 * angle);
  }
  return placements;
}

SCameraPlacement Interpolate(const SCameraPlacement& from, const SCameraPlacement& to,
                             double share) {
  SCameraPlacement blend;
  blend.Position = from.Position + share * (to.Position - from.Position);
  blend.LookAt = from.LookAt + share * (to.LookAt - from.LookAt);
  blend.Up = from.Up + share * (to.Up - from.Up);
  blend.FocalLength = from.FocalLength + share * (to.FocalLength - from.FocalLength);
  blend.OrthographicHeight =
      from.OrthographicHeight + share * (to.OrthographicHeight - from.OrthographicHeight);
  return blend;
}

CCamera::CCamera(const SCameraPlacement& placement, double aspectRatio)
    : m_position(placement.Position),
      m_forward(placement.LookAt - placement.Position),
      m_isOrthographic(placement.OrthographicHeight != 0.0) {
  const double distance = m_forward.norm();
  if (!(distance > 0.0)) {
    THROW_ARGOSEXCEPTION("The camera's position and look_at are the same point ("
                         << m_position.x() << "," << m_position.y() << "," << m_position.z()
                         << "); they must differ");
  }
  if (!(placement.FocalLength > 0.0)) {
    THROW_ARGOSEXCEPTION("The camera's lens_focal_length is " << placement.FocalLength
                                                              << " mm; it must be positive");
  }
  if (!(placement.OrthographicHeight >= 0.0)) {
    THROW_ARGOSEXCEPTION("The camera's orthographic_height is "
                         << placement.OrthographicHeight
                         << " m; it must be positive, or 0 for a perspective view");
  }
  m_forward /= distance;
  m_right = m_forward.cross(placement.Up);
  // an upward direction along the line of sight is of no use: fall back on the derived one
  if (!(m_right.norm() > kVerticalShare * placement.Up.norm())) {
    m_right = m_forward.cross(ComputeDefaultUp(m_forward));
  }
  m_right.normalize();
  m_up = m_right.cross(m_forward);
  const double halfHeight = m_isOrthographic ? 0.5 * placement.OrthographicHeight
                                             : kHalfPictureHeight / placement.FocalLength;
  m_halfExtents = Eigen::Vector2d(halfHeight * aspectRatio, halfHeight);
}

Eigen::Matrix4d CCamera::ComputeViewMatrix() const {
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.block<1, 3>(0, 0) = m_right.transpose();
  view.block<1, 3>(1, 0) = m_up.transpose();
  view.block<1, 3>(2, 0) = -m_forward.transpose();
  view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * m_position;
  return view;
}

Eigen::Matrix4d CCamera::ComputeProjectionMatrix(double nearPlane, double farPlane) const {
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  projection(0, 0) = 1.0 / m_halfExtents.x();
  projection(1, 1) = 1.0 / m_halfExtents.y();
  if (m_isOrthographic) {
    projection(2, 2) = 2.0 / (nearPlane - farPlane);
    projection(2, 3) = (nearPlane + farPlane) / (nearPlane - farPlane);
    projection(3, 3) = 1.0;
    return projection;
  }
  projection(2, 2) = (nearPlane + farPlane) / (nearPlane - farPlane);
  projection(2, 3) = 2.0 * nearPlane * farPlane / (nearPlane - farPlane);
  projection(3, 2) = -1.0;
  return projection;
}

double CCamera::ComputeDepth(const Eigen::Vector3d& point) const {
  return m_forward.dot(point - m_position);
}

Eigen::Vector2d CCamera::Project(const Eigen::Vector3d& point) const {
  const double depth = ComputeDepth(point);
  if (!(depth > 0.0)) {
    return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  const Eigen::Vector3d offset = point - m_position;
  const double scale = m_isOrthographic ? 1.0 : depth;
  return Eigen::Vector2d(0.5 + 0.5 * m_right.dot(offset) / (scale * m_halfExtents.x()),
                         0.5 - 0.5 * m_up.dot(offset) / (scale * m_halfExtents.y()));
}

}  // namespace argos
