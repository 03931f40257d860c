#ifndef ARGOS3_PLUGINS_MEDIA_VIEW_VOLUME_H
#define ARGOS3_PLUGINS_MEDIA_VIEW_VOLUME_H

#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/vector3.h>

#include <cstddef>

namespace argos {

/** Lines of sight between two distances, through a rectangle that faces the eye. */
struct SFrustum {
  CVector3 Eye; /**< m, world frame */
  CVector3 Right, Down, Ahead; /**< axes of the view, of length 1, world frame */
  CRange<Real> Depth; /**< along Ahead, m */
  CRange<Real> SlopeRight, SlopeDown; /**< distance along Right and Down per distance ahead */
};

/**
 * A convex part of space that contains what a camera may see, enlarged by kMargin: the points that
 * are beyond none of six planes.
 */
class CViewVolume {
 public:
  /**
   * m; user code may have moved an entity since the update of its medium by up to so much without
   * its body, and cameras still find it.
   */
  static constexpr Real kMargin = 0.1;
  /** Number of points that are tested at once. */
  static constexpr size_t kBlock = 16;

  explicit CViewVolume(const SBoundingBox& box);
  explicit CViewVolume(const SFrustum& frustum);

  /** A box around the volume, m, world frame. */
  const SBoundingBox& GetBox() const { return m_box; }
  void Move(const CVector3& way); /**< by so much, m */
  /**
   * @param x, y, z  (kBlock) coordinates of points, m, world frame.
   * @return bit i is set if point i is inside.
   */
  UInt64 FindInside(const Real* x, const Real* y, const Real* z) const;

 private:
  static constexpr size_t kNumPlanes = 6;

  void SetPlane(size_t plane, const CVector3& outward, Real distance);

  SBoundingBox m_box;
  // outward normals of the planes, of length 1, and their distances from the origin along these, m
  Real m_normalX[kNumPlanes], m_normalY[kNumPlanes], m_normalZ[kNumPlanes];
  Real m_distance[kNumPlanes];
};

}  // namespace argos

#endif
