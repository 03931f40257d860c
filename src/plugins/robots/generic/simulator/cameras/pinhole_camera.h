#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_PINHOLE_CAMERA_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_PINHOLE_CAMERA_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/media/view_volume.h>

#include <array>

namespace argos {

class CEmbodiedEntity;
struct SAnchor;

/**
 * A pinhole camera without distortion, fixed to an anchor of a body.
 *
 * In its frame z is the direction of the view; a point (x,y,z) appears at the pixel
 *
 *     u = fx x / z + cx,   v = fy y / z + cy
 *
 * with the focal length (fx,fy) and the principal point (cx,cy) in pixels. It is in the image if
 * z is in the range, and u in [0,width), v in [0,height).
 *
 * Source: R. Hartley and A. Zisserman, "Multiple View Geometry in Computer Vision" (2004), ch. 6.
 */
class CPinholeCamera {
 public:
  /**
   * Reads `anchor`, `position`, `orientation`, `range`, `focal_length`, `principal_point` and
   * `resolution`.
   * @throws CARGoSException if one is missing or out of range, or the anchor is unknown.
   */
  CPinholeCamera(TConfigurationNode& tree, CEmbodiedEntity& body);

  /** Engines update the anchor's pose only while the camera is in use. */
  void SetInUse(bool inUse);
  /** Copies the current pose of the anchor. */
  void Update();

  /** The following functions refer to the pose copied by Update(). m, world frame. */
  const CVector3& GetPosition() const { return m_position; }
  const CQuaternion& GetOrientation() const { return m_orientation; }
  /** @return false if the point, m, world frame, is not in the image; else writes its pixel. */
  bool Project(const CVector3& point, CVector2& pixel) const {
    const CVector3 toPoint = point - m_position;
    const Real depth = m_ahead.DotProduct(toPoint);
    if (depth <= 0.0 || depth < m_range.GetMin() || depth > m_range.GetMax()) {
      return false;
    }
    pixel.Set(m_focalLength.GetX() * m_right.DotProduct(toPoint) / depth + m_principalPoint.GetX(),
              m_focalLength.GetY() * m_down.DotProduct(toPoint) / depth + m_principalPoint.GetY());
    return pixel.GetX() >= 0.0 && pixel.GetX() < m_resolution.GetX() && pixel.GetY() >= 0.0 &&
           pixel.GetY() < m_resolution.GetY();
  }
  /** Contains the field of view; as of Update(). */
  const CViewVolume& GetVolume() const { return m_volume; }
  /**
   * The corners of the view, m, world frame: the four at the near end of the range, around the
   * image from pixel (0,0) along u first, then the four at the far end.
   */
  std::array<CVector3, 8> ComputeCorners() const;

 private:
  SAnchor* m_anchor;
  bool m_inUse = false;
  CVector3 m_offset;  // anchor's frame, m
  CQuaternion m_mount;  // anchor's frame
  CRange<Real> m_range;  // m
  CVector2 m_focalLength;  // pixels
  CVector2 m_principalPoint;  // pixels
  CVector2 m_resolution;  // pixels
  // written by Update()
  CVector3 m_position;  // m, world frame
  CQuaternion m_orientation;  // world frame
  CVector3 m_right, m_down, m_ahead;  // its axes x, y and z, world frame
  CViewVolume m_volume{SBoundingBox()};
};

}  // namespace argos

#endif
