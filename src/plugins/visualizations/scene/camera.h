#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_CAMERA_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_CAMERA_H

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace argos {

constexpr std::size_t kNumPlacements = 12;  // experiment files number them 0 to 11, keys F1 to F12

/** Position, direction and lens of the camera. World frame, m. */
struct SCameraPlacement {
  Eigen::Vector3d Position = Eigen::Vector3d(0.0, -1.0, 1.0);
  Eigen::Vector3d LookAt = Eigen::Vector3d::Zero();
  /** Roughly upwards on the picture: only its part across the line of sight counts. */
  Eigen::Vector3d Up = Eigen::Vector3d::UnitZ();
  double FocalLength = 20.0; /**< mm, > 0, of a 36 mm x 27 mm picture */
  /** Height of what the picture shows, m, in orthographic projection; 0: perspective. */
  double OrthographicHeight = 0.0;
};

/** The arena as cameras see it: an upright box. World frame, m. */
struct SArenaBox {
  Eigen::Vector3d Center = Eigen::Vector3d::Zero();
  Eigen::Vector3d Size = Eigen::Vector3d::Ones();
};

/**
 * The upward direction of a camera for which none is given: across the line of sight, in the
 * vertical plane that holds it.
 *
 * A camera that looks straight up or down has no such plane; its left is then the world's +y.
 * @param forward  direction of sight, any length but 0, world frame.
 * @return unit vector.
 */
Eigen::Vector3d ComputeDefaultUp(const Eigen::Vector3d& forward);

/** True if the horizontal part of @p forward is below 1e-9 of its length. */
bool IsVertical(const Eigen::Vector3d& forward);

/** The placements of slots that the file does not set: a circle around the arena. */
std::array<SCameraPlacement, kNumPlacements> MakeDefaultPlacements(const SArenaBox& arena);

/**
 * Blends eye, target, up and lens linearly. @param share 0 gives @p from, 1 @p to.
 * Both must have the same projection.
 */
SCameraPlacement Interpolate(const SCameraPlacement& from, const SCameraPlacement& to,
                             double share);

/**
 * A camera ready to draw: its frame and its projection, perspective or orthographic.
 *
 * The camera frame is OpenGL's: x right, y up, -z ahead.
 */
class CCamera {
 public:
  /**
   * @param aspectRatio  width of the picture over its height, > 0.
   * @throws CARGoSException if the eye and the target coincide or the focal length is not > 0,
   *         or if the orthographic height is negative.
   */
  CCamera(const SCameraPlacement& placement, double aspectRatio);

  const Eigen::Vector3d& GetPosition() const { return m_position; }
  const Eigen::Vector3d& GetRight() const { return m_right; }
  const Eigen::Vector3d& GetUp() const { return m_up; }
  const Eigen::Vector3d& GetForward() const { return m_forward; }
  bool IsOrthographic() const { return m_isOrthographic; }
  /**
   * Half the width and half the height of what the picture shows: at depth 1 in perspective, which
   * are the tangents of half the angles of view; at any depth, m, in orthographic projection.
   */
  const Eigen::Vector2d& GetHalfExtents() const { return m_halfExtents; }

  /** World to camera frame. */
  Eigen::Matrix4d ComputeViewMatrix() const;
  /** Camera frame to OpenGL's clip space. @param nearPlane, farPlane  m, 0 < near < far. */
  Eigen::Matrix4d ComputeProjectionMatrix(double nearPlane, double farPlane) const;

  /** Distance of a point from the eye along the line of sight, m; negative behind the eye. */
  double ComputeDepth(const Eigen::Vector3d& point) const;

  /**
   * Projects a point of the world onto the picture.
   * @return x to the right and y *down* from the top left corner, as shares of the picture's width
   *         and height; not a number for points that are not ahead of the eye.
   */
  Eigen::Vector2d Project(const Eigen::Vector3d& point) const;

 private:
  Eigen::Vector3d m_position;
  Eigen::Vector3d m_right;
  Eigen::Vector3d m_up;
  Eigen::Vector3d m_forward;
  Eigen::Vector2d m_halfExtents;
  bool m_isOrthographic;
};

}  // namespace argos

#endif
